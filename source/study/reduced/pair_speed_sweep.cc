// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/run_signals.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/types.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/reduced/fillet_readings.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/reduced/speed_response.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Decay times in a step of the slow mesh cycle, and steps in it: a vibration is gone within a
     * few of them. What acts is the mean of the forces at both ends of a step: in steps of several
     * decay times the load alone would turn the gear far, and forces go to and fro. */
    constexpr double       slow_decay_times = .5;
    constexpr unsigned int slow_steps       = 300;

    /** Where the pair starts, in mesh cycles after the start of the slow one: that is the second
     * one, the first one settles. */
    constexpr double slow_mesh_start = -1;

    /** Samples in a period of the highest frequency, where there are as many steps. */
    constexpr double samples_a_period = 4;

    /** Energy error of a speed above which it is told, as of a run (doc/verification/dynamics.md)
     * [-].
     */
    constexpr double largest_energy_error = 0.005;

    void stop_if_asked(const RunSignals     &signals,
                       const PairSpeedSweep &sweep,
                       const Communicator   &communicator)
    {
      std::vector<double> signal = {static_cast<double>(signals.stop_signal())};
      communicator.max(signal);
      if (signal[0] > 0)
        throw Interrupted("stopped on request after " + std::to_string(sweep.resonance().n_rows()) +
                          " speeds (resonance.csv). To continue, start a sweep at the next speed");
    }

    NamedFigures list_figures(const PairSpeedSweepSetup &setup, const Table &resonance)
    {
      constexpr double rpm = 30. / pi;
      return {{"cut-off frequency", {setup.cutoff, "Hz"}},
              {"highest frequency of what is stated", {setup.highest_frequency(), "Hz"}},
              {"speeds", {double(resonance.n_rows()), "-"}},
              {figure_name::lowest_speed, {rpm * setup.speeds.lowest_speed, "rpm"}},
              {figure_name::highest_speed, {rpm * setup.speeds.highest_speed, "rpm"}},
              {figure_name::counted_meshes, {double(setup.reduced.counted_meshes), "-"}}};
    }

    /** Warns of speeds whose energies do not balance. */
    void judge_energy(const Table &resonance, Log &log)
    {
      const std::vector<double> &errors = resonance.numbers(column::energy_error);
      std::size_t                worst = 0, n_above = 0;
      for (std::size_t i = 0; i < errors.size(); ++i)
        {
          n_above += errors[i] > largest_energy_error ? 1 : 0;
          worst = errors[i] > errors[worst] ? i : worst;
        }
      if (n_above > 0)
        log.warning("the energy error exceeds ",
                    1e2 * largest_energy_error,
                    " % at ",
                    n_above,
                    " of ",
                    errors.size(),
                    " speeds, with the largest value at ",
                    resonance.numbers(column::speed)[worst],
                    " rpm: ",
                    1e2 * errors[worst],
                    " %. Increase Reduced/steps per mesh cycle, Reduced/steps per mode");
    }
  } // namespace

  void PairSpeedSweepOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_number(prm,
                   "settling decay times",
                   settling_decay_times,
                   "Minimum settling time at each speed of a sweep, in decay times: one lets a "
                   "vibration decay to 1/e by Dynamics/mass proportional damping",
                   Range::not_negative());
    declare_number(prm,
                   "allowed amplification",
                   allowed_amplification,
                   "Limit of the amplification in a sweep: contact force divided by its mean, "
                   "stress divided by stress without vibration; exceedances.csv lists the speeds "
                   "above it; none: no limit",
                   Range::positive().or_word("none"));
    declare_quantity(prm,
                     "highest frequency",
                     highest_frequency,
                     "Hz",
                     "Highest frequency of transmission error, force and stress that a sweep "
                     "evaluates; vibrations near the cutoff frequency are not physical; auto: half "
                     "the cutoff frequency",
                     Range::positive().or_word("auto"));
  }

  double PairSpeedSweepSetup::highest_frequency() const
  {
    return options.highest_frequency > 0 ? options.highest_frequency : .5 * cutoff;
  }

  unsigned int PairSpeedSweepSetup::find_stride(const double       mesh_frequency,
                                                const unsigned int steps) const
  {
    const double       enough = samples_a_period * highest_frequency() / mesh_frequency;
    const unsigned int most   = steps / samples;
    unsigned int       stride = most;
    while (stride > 1 && (most % stride != 0 || steps / stride < enough))
      --stride;
    return stride;
  }

  unsigned int PairSpeedSweepSetup::find_settling_meshes(const double mesh_frequency) const
  {
    if (options.settling_decay_times == 0)
      return reduced.settling_meshes;
    // Amplitudes fall as exp(-damping t/2).
    const double meshes = options.settling_decay_times * 2. / damping * mesh_frequency;
    return std::max(reduced.settling_meshes, static_cast<unsigned int>(std::ceil(meshes)));
  }

  double PairSpeedSweepSetup::resonance_width(const unsigned int order,
                                              const unsigned int driver_teeth) const
  {
    // Between half-power points a mode has a width of zeta [rad/s]; a mesh order passes it with
    // order times teeth times the rate of the driver.
    return damping / (order * driver_teeth);
  }

  std::string PairSpeedSweepSetup::find_wide_steps(const unsigned int driver_teeth) const
  {
    const double range = speeds.highest_speed - speeds.lowest_speed,
                 step = range / (speeds.n_speeds - 1), rpm = 30. / pi,
                 narrowest = resonance_width(judged_orders, driver_teeth);
    if (step <= narrowest)
      return "";
    std::ostringstream text;
    set_figure_digits(text, 4);
    text << "the speeds are " << rpm * step << " rpm apart, more than the width of ";
    if (!(damping > 0))
      text << "resonances without damping, which is zero";
    else
      {
        text << "a resonance between its half-power points: ";
        for (unsigned int order = 1; order <= judged_orders; ++order)
          text << (order > 1 ? ", " : "") << rpm * resonance_width(order, driver_teeth)
               << " rpm with mesh order " << order;
        text << "; Reduced/speeds = " << std::ceil(range / narrowest) + 1
             << " resolves all of them";
      }
    text << ". Values between the speeds may be larger than the stated maxima";
    return text.str();
  }

  Table make_swept_teeth_table()
  {
    return {{column::position, "mesh cycles"},
            {column::side},
            {column::tooth_of("pinion"), "-"},
            {column::force, "N"}};
  }

  Table make_wave_response_table()
  {
    Table table{{column::direction}, {column::speed, "rpm"}};
    for (unsigned int n = 1; n <= SpeedResponse::largest_wave; ++n)
      {
        table.add_column("stationary wave " + std::to_string(n), "um");
        table.add_column("travelling wave " + std::to_string(n), "um");
      }
    return table;
  }

  Table make_stress_response_table()
  {
    return {{column::direction},
            {column::speed, "rpm"},
            {column::place},
            {"stress without vibration", "MPa"},
            {"largest stress", "MPa"},
            {column::amplification, "-"}};
  }

  PairSpeedSweep::PairSpeedSweep(const Model            &model,
                                 PairSpeedSweepSetup     setup,
                                 const StressWavePlaces &places,
                                 ReducedPair            &pair)
    : model_(model)
    , setup_(std::move(setup))
    , places_(places)
    , pair_(pair)
    , near_cutoff_(setup_.cutoff)
    , slow_mesh_(model.only_transmission()->driven_sense *
                 pair.sector_sense(model.only_transmission()->driven))
    , resonance_(make_resonance_response_table())
    , waves_(make_wave_response_table())
    , stresses_(make_stress_response_table())
  {
  }

  double PairSpeedSweep::mesh_frequency_at(const double speed) const
  {
    return speed * model_.only_transmission()->driver_teeth / (2. * pi);
  }

  unsigned int PairSpeedSweep::set_speed(const double speed)
  {
    const double       frequency = mesh_frequency_at(speed);
    const unsigned int steps = setup_.reduced.find_steps(frequency, setup_.cutoff, setup_.samples);
    pair_.set_speed(speed, 1. / (frequency * steps));
    return steps;
  }

  Eigen::MatrixXd PairSpeedSweep::read_stresses() const
  {
    const ProbeMeasure probes = [this](const std::vector<Probe> &copies) {
      return pair_.reader().read_probes(copies);
    };
    if (places_.fillets().empty())
      return places_.read(probes, nullptr);
    const FilletStrains strains = measure_fillet_readings(pair_)(State());
    return places_.read(probes, &strains);
  }

  void PairSpeedSweep::record_slow_mesh()
  {
    if (!(setup_.damping > 0))
      return; // nothing comes to rest
    const double step = slow_decay_times * 2. / setup_.damping;
    pair_.set_speed(2. * pi / (model_.only_transmission()->driver_teeth * slow_steps * step), step);
    pair_.start();
    for (unsigned int s = 1; s <= 2 * slow_steps; ++s)
      {
        pair_.step();
        if (s >= slow_steps)
          slow_mesh_.add(read_stresses());
      }
  }

  std::vector<double> PairSpeedSweep::find_stresses_at_rest(const double speed)
  {
    std::vector<double> largest(places_.names().size(), slow_mesh_.empty() ? not_known : 0.);
    if (slow_mesh_.empty())
      return largest;
    set_speed(speed);
    pair_.start();
    // What the spin adds is the same in all sectors.
    const Eigen::RowVectorXd spin =
      (read_stresses() - slow_mesh_.at(slow_mesh_start)).colwise().mean();
    for (unsigned int s = 0; s <= slow_steps; ++s)
      {
        const double              place = double(s) / slow_steps;
        const std::vector<double> now = places_.find_largest(slow_mesh_.at(place).rowwise() + spin);
        for (std::size_t p = 0; p < now.size(); ++p)
          largest[p] = std::max(largest[p], now[p]);
      }
    return largest;
  }

  void PairSpeedSweep::run(const std::function<void()> &report, Log &log)
  {
    const std::vector<double> speeds = list_speeds(setup_.speeds, true);
    record_slow_mesh();
    std::vector<std::vector<double>> at_rest;
    for (const double speed : speeds)
      at_rest.push_back(find_stresses_at_rest(speed));
    const std::string wide = setup_.find_wide_steps(model_.only_transmission()->driver_teeth);
    if (!wide.empty())
      log.warning(wide);
    set_speed(speeds.front());
    log.line("equilibrium at the lowest speed: ", pair_.start().iterations, " iterations");

    const auto pass = [&](const std::size_t i, const std::string &direction) {
      turn_at(speeds[i], direction, at_rest[i], log);
      report();
    };
    for (std::size_t i = 0; i < speeds.size(); ++i)
      pass(i, "up");
    if (setup_.speeds.kind == SweepKind::up_and_down)
      for (std::size_t i = speeds.size(); i-- > 0;)
        pass(i, "down");
  }

  SpeedSample PairSpeedSweep::take_sample(State &state) const
  {
    pair_.measure(state);
    const Transmission &t = *model_.only_transmission();
    const Measurements &m = state.measured;
    // In turning axes a wave is Re(w exp(i n alpha)). What stands in space has w ~ exp(i n psi),
    // psi what the driven body has turned in the drive direction about the axis of its sectors.
    const double turned =
      t.driven_sense * pair_.sector_sense(t.driven) * (m.driven_angle - t.driven_start);
    const std::vector<double> rim = pair_.reader().read_rim(SpeedResponse::largest_wave);

    SpeedSample sample;
    sample.error = m.transmission_error;
    sample.force = m.contact_force;
    sample.coast = std::any_of(m.teeth.begin(), m.teeth.end(), [](const auto &tooth) {
      return tooth.contact != 0; // the flanks that do not transmit the torque
    });
    for (unsigned int n = 1; n <= SpeedResponse::largest_wave; ++n)
      sample.waves.push_back(find_rim_wave(rim, 2, n) * std::polar(1., -(n * turned)));
    const double meshes = std::abs(m.driver_angle - t.driver_start) * t.driver_teeth / (2. * pi);
    sample.vibration    = read_stresses();
    sample.slow_stresses.setZero(sample.vibration.rows(), sample.vibration.cols());
    if (!slow_mesh_.empty())
      sample.slow_stresses = slow_mesh_.at(meshes + slow_mesh_start);
    sample.vibration -= sample.slow_stresses;
    return sample;
  }

  void PairSpeedSweep::add_teeth(const State &state, Table &teeth) const
  {
    const Transmission &t = *model_.only_transmission();
    const double        meshes =
      (state.measured.driver_angle - t.driver_start) * t.driver_teeth / (2. * pi);
    for (const ToothContact &tooth : state.measured.teeth)
      teeth.add_row(
        {meshes, model_.contacts[tooth.contact].side, tooth.slave_group, tooth.force.norm()});
  }

  void PairSpeedSweep::turn_at(const double               speed,
                               const std::string         &direction,
                               const std::vector<double> &at_rest,
                               Log                       &log)
  {
    const unsigned int steps    = set_speed(speed);
    const unsigned int settling = setup_.find_settling_meshes(mesh_frequency_at(speed));
    for (unsigned int i = 0; i < settling * steps; ++i)
      pair_.step();
    const unsigned int stride = setup_.find_stride(mesh_frequency_at(speed), steps);
    SpeedResponse      response(
      LowPass(setup_.highest_frequency() * stride / (mesh_frequency_at(speed) * steps)),
      [this](const Eigen::MatrixXd &stresses) { return places_.find_largest(stresses); });
    State              state;
    Table              teeth = make_swept_teeth_table();
    const unsigned int n_samples =
      setup_.reduced.counted_meshes * steps / stride + 2 * response.n_around();
    for (unsigned int i = 0; i < n_samples; ++i)
      {
        for (unsigned int s = 0; s < stride; ++s)
          pair_.step();
        response.add(take_sample(state));
        add_teeth(state, teeth);
      }
    if (setup_.edges)
      setup_.edges->observe(teeth, column::position, 1.);

    const unsigned int n_steps = settling * steps + n_samples * stride;
    n_steps_ += n_steps;
    time_ += n_steps / (mesh_frequency_at(speed) * steps);

    const double         rpm    = speed * 30. / pi;
    const LumpedResponse found  = response.response(std::abs(state.measured.energy.error()));
    std::vector<double>  errors = response.errors();
    for (double &error : errors)
      error /= arcsecond;
    near_cutoff_.look(
      errors, steps / stride, mesh_frequency_at(speed), rpm, found.pp_error / arcsecond);
    add_response(direction, speed, model_.only_transmission()->driver_teeth, found, resonance_);
    std::vector<Table::Cell> row = {direction, rpm};
    for (unsigned int n = 1; n <= SpeedResponse::largest_wave; ++n)
      {
        row.emplace_back(response.wave(n).first);
        row.emplace_back(response.wave(n).second);
      }
    waves_.add_row(row);
    for (std::size_t p = 0; p < places_.names().size(); ++p)
      {
        const double largest = response.largest_stress(p);
        stresses_.add_row(
          {direction, rpm, places_.names()[p], at_rest[p], largest, largest / at_rest[p]});
      }
    log.line(direction,
             " ",
             rpm,
             " rpm: transmission error ",
             found.mean_error / arcsecond,
             " arcsec, peak to peak ",
             found.pp_error / arcsecond,
             " arcsec, largest force ",
             found.largest_force,
             " N, ",
             settling,
             " mesh cycles to settle, ",
             steps,
             " steps per mesh cycle");
  }

  void run_speed_sweep(PairSpeedSweep &sweep, RunSummary &summary, OutputFolder &folder, Log &log)
  {
    const auto start = WallClock::now();
    RunSignals signals;
    const auto write = [&]() {
      write_csv(folder, "resonance.csv", sweep.resonance());
      write_csv(folder, "wave_response.csv", sweep.waves());
      write_csv(folder, "stress_response.csv", sweep.stresses());
      stop_if_asked(signals, sweep, folder.communicator());
    };
    try
      {
        sweep.run(write, log);
      }
    catch (const NumericalError &error)
      {
        summary.fail(error.what());
      }
    const PairSpeedSweepSetup &setup = sweep.setup();
    if (setup.options.allowed_amplification > 0)
      {
        Table exceedances = make_exceedance_table();
        add_exceedances(sweep.resonance(),
                        sweep.stresses(),
                        setup.options.allowed_amplification,
                        exceedances);
        write_csv(folder, "exceedances.csv", exceedances);
      }
    summary.run_time = seconds_since(start);
    summary.time     = sweep.time();
    summary.steps    = sweep.n_steps();
    for (const auto &figure : list_figures(setup, sweep.resonance()))
      summary.figures.push_back(figure);
    sweep.near_cutoff().tell(summary.figures, log);
    judge_energy(sweep.resonance(), log);
    // All samples have been looked at.
    write_edge_contact(setup.edges, make_swept_teeth_table(), column::position, 1., folder, log);
    write_summary(folder, summary, log);
    if (summary.status == "failed")
      throw NumericalError(summary.failure);
    log.line(sweep.resonance().n_rows(), " speeds in ", duration_text(summary.run_time));
  }
} // namespace vfife
