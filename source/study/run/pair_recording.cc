// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/pair_measures.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/measures/order_tracking.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/observers/bearing_writer.h>
#include <vfife/output/observers/pattern_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/observers/teeth_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/cases/run_length.h>
#include <vfife/study/cases/torque_pressure.h>
#include <vfife/study/fillets/root_submodels.h>
#include <vfife/study/pressure/instant_options.h>
#include <vfife/study/run/pair_recording.h>
#include <vfife/study/run/steady_swing.h>
#include <vfife/study/stress_waves/stress_wave_writers.h>

#include <algorithm>
#include <set>
#include <utility>

namespace vfife
{
  PairRecording::PairRecording(const PairCase        &pair_case,
                               const DynamicsOptions &dynamics,
                               const OutputOptions   &output,
                               PairReadings           readings,
                               const Table           &history,
                               Stepping              &stepping)
    : case_(pair_case)
    , dynamics_(dynamics)
    , output_(output)
    , readings_(std::move(readings))
    , history_(history)
    , stepping_(stepping)
    , times_(stepping.times())
    , model_(stepping.model())
    , observers_(stepping.observers())
    , summary_(stepping.summary())
    , log_(stepping.log())
    , hertz_(pair_case.hertz_contact())
    , copies_(stepping.model(),
              readings_.probes,
              log_,
              count_meshes(*model_.only_transmission(), times_.whole))
  {
    const std::uint64_t steps = times_.sample_steps;
    teeth_                    = &observers_.add<TeethWriter>(model_, steps, hertz_).table();
    observers_.add<PatternWriter>(model_, last_mesh(), steps);
    probes_ = &observers_.add<ProbeWriter>(steps).table();
    rim_    = &observers_.add<RimWriter>(model_, steps, readings_.rim).table();
    if (PairMounting::changes(model_))
      observers_.add<MisalignmentWriter>(model_, steps, readings_.bores);
    summary_.figures = list_figures();
  }

  void PairRecording::record_stresses(const FilletOptions       &fillets,
                                      const RootSubmodels *const submodels,
                                      const InstantOptions      &instants,
                                      const FemOptions          &elements)
  {
    if (fillets.records())
      record_fillets(fillets, submodels);
    if (!readings_.rim)
      record_parts();
    if (instants.asked_for())
      pressures_ = &observers_.add<PressureWriter>(
        instants, elements, describe_run(case_, model_, times_.whole), readings_.flanks, log_);
    record_stress_waves();
  }

  void PairRecording::record_fillets(const FilletOptions       &options,
                                     const RootSubmodels *const submodels)
  {
    fillets_.emplace(submodels != nullptr ? submodels->fine() : model_, options);
    strains_       = readings_.fillets(*fillets_, submodels);
    records_teeth_ = options.teeth != RecordedTeeth::none;
    if (records_teeth_)
      observers_.add<RootStressWriter>(times_.sample_steps, *fillets_, strains_);
    if (!options.gauges.empty())
      observers_.add<GaugeWriter>(times_.sample_steps, *fillets_, strains_);
  }

  void PairRecording::record_parts()
  {
    // The deformation stands in space, and bodies turn by a sector in a mesh cycle: a few positions
    // of it have its largest stresses.
    constexpr unsigned int looks = 4;
    const std::uint64_t    every = std::max(1u, output_.history_every / looks);
    parts_                       = &observers_.add<PartStressWatch>(model_,
                                              every * times_.sample_steps,
                                              dynamics_.stiffness,
                                              dynamics_.frame);
  }

  void PairRecording::record_stress_waves()
  {
    const std::vector<unsigned int> diameters = parse_diameters(output_.stress_waves);
    if (diameters.empty())
      return;
    const unsigned int most = RimWriter::count_diameters(model_);
    if (*std::max_element(diameters.begin(), diameters.end()) > most)
      throw InputError("Output/stress wave diameters",
                       "expected at most " + std::to_string(most) + " nodal diameters");
    wave_places_.emplace(model_, records_teeth_ ? &*fillets_ : nullptr);
    observers_.add<ProbeWaveWriter>(
      times_.sample_steps, last_mesh(), diameters, *wave_places_, readings_.probes);
    if (records_teeth_)
      observers_.add<FilletWaveWriter>(
        times_.sample_steps, last_mesh(), diameters, *wave_places_, strains_);
  }

  void PairRecording::prepare()
  {
    // With a ramp the torque is still to come, and with it what the copies would tell.
    if (dynamics_.start != Start::ramp)
      copies_.choose();
    copies_.log_passages();
  }

  NamedFigures PairRecording::list_figures() const
  {
    // Of the case, not of its motion: known before the first step, and stated after a failure too.
    const Transmission &t      = *model_.only_transmission();
    const double        torque = load_torque(model_);
    // What changes in the run has no single number: it is stated for the start, by another name.
    const std::string speed_when  = t.has_constant_rate() ? "" : " at the start",
                      torque_when = has_constant_torque() ? "" : " at the start";
    NamedFigures  figures = {{figure_name::mesh_frequency + speed_when, {t.mesh_frequency(), "Hz"}},
                             {figure_name::speed_of(model_.bodies[t.driver].name()) + speed_when,
                              {t.driver_rate * 30. / pi, "rpm"}},
                             {figure_name::torque_of(model_.bodies[t.driven].name()) + torque_when,
                              {1e-3 * torque, "N m"}},
                             {figure_name::torque_of(model_.bodies[t.driver].name()) + torque_when,
                              {1e-3 * torque * t.driver_teeth / t.driven_teeth, "N m"}},
                             {figure_name::effective_arm, {t.arm, "mm"}},
                             {figure_name::force_on_arm + torque_when, {torque / t.arm, "N"}},
                             {"contact penalty",
                              {model_.contacts.front().mean_penalty(), "N/mm^3"}}};
    const Vector2 arm_range = case_.arm_range();
    figures.push_back({figure_name::least_arm, {t.arm * arm_range[0], "mm"}});
    figures.push_back({figure_name::largest_arm, {t.arm * arm_range[1], "mm"}});
    return figures;
  }

  void PairRecording::add_motion(const PairPreload &preload)
  {
    // Zero where the run has failed before its equilibrium was found.
    const double swing = preload.swing.frequency();
    if (!(swing > 0))
      return;
    add_preload(preload, PairMounting::changes(model_), summary_);
    add_spring_excitation(model_, preload.swing, dynamics_.mesh_damping, summary_, log_);
    if (history_.n_rows() > 1)
      find_steady(swing);
  }

  void PairRecording::add_results(const PairPreload &preload)
  {
    write_orders();
    if (summary_.status == "failed")
      return;
    add_contact(preload.penalty_lag);
    write_edge_contact(case_.edges_under_load(),
                       *teeth_,
                       column::time,
                       1. / model_.only_transmission()->mesh_frequency(),
                       stepping_.folder(),
                       log_);
    summary_.probes = copies_.judge(stepping_.state().time, *probes_);
  }

  void PairRecording::write_orders() const
  {
    const Transmission &t      = *model_.only_transmission();
    const unsigned int  orders = output_.count_tracked_orders();
    // A run that has failed may have too few samples.
    if (t.has_constant_rate() || orders == 0 || history_.n_rows() < 4)
      return;
    write_csv(stepping_.folder(),
              "orders.csv",
              track_mesh_orders(history_, t, output_.order_window, orders));
    write_csv(stepping_.folder(),
              "rim_orders.csv",
              track_rim_waves(*rim_,
                              t,
                              compute_sector_sense(model_.bodies[t.driven]) * t.driven_sense,
                              output_.order_window,
                              orders));
  }

  double PairRecording::last_mesh() const
  {
    const Transmission &pair = *model_.only_transmission();
    return std::max(0.,
                    pair.has_constant_rate() ? times_.end - 1. / pair.mesh_frequency()
                                             : pair.time_of(pair.meshes(times_.end) - 1.));
  }

  bool PairRecording::has_constant_torque() const
  {
    return std::all_of(model_.torques.begin(), model_.torques.end(), [](const Torque &torque) {
      return torque.history.is_constant();
    });
  }

  void PairRecording::find_steady(const double swing_frequency)
  {
    if (!model_.only_transmission()->has_constant_rate() || !has_constant_torque())
      {
        log_.line("no search for a steady part: speed or torque changes during the run");
        return;
      }
    double ramp_end = 0;
    for (const Torque &torque : model_.torques)
      ramp_end = std::max(ramp_end, torque.ramp_time);
    // Means are compared over swing periods, here in mesh cycles: f_mesh/f_swing. Under a growing
    // torque nothing is steady.
    const double period = model_.only_transmission()->mesh_frequency() / swing_frequency;
    summary_.steady     = find_steady_part(history_, output_.history_every, period, ramp_end);
    log_.line(summary_.steady->explain());
    const unsigned int needed =
      count_steady_meshes(model_.only_transmission()->mesh_frequency(), period, dynamics_);
    if (needed > 0)
      {
        summary_.figures.push_back({figure_name::steady_meshes, {double(needed), "-"}});
        log_.line("a steady ripple requires at least ",
                  needed,
                  " mesh cycles: vibrations decay to a tenth in the first half, the second half is "
                  "judged");
      }
    else
      log_.line("vibrations do not decay without mass proportional damping and driven speed "
                "damping: the ripple remains transient");
    for (const char *name : {column::contact_force_total, column::dte, column::rim_dte})
      {
        const ColumnStatistics &c = summary_.steady->column(name);
        log_.line("  ",
                  name,
                  ": mean ",
                  c.mean,
                  " ",
                  c.unit,
                  ", peak to peak ",
                  c.peak_to_peak,
                  " ",
                  c.unit,
                  !summary_.steady->ripple.judged  ? " (ripple not judged)"
                  : summary_.steady->ripple.steady ? ""
                                                   : " (ripple still transient)");
      }
  }

  void PairRecording::add_contact(const double penalty_lag)
  {
    if (parts_ != nullptr)
      {
        parts_->stresses().write_to(log_);
        for (const auto &figure : parts_->stresses().list_figures())
          summary_.figures.push_back(figure);
      }
    // The springs let the gear lag: negative, as the part in which it is contained.
    summary_.transmission_error.push_back(
      {"penalty compliance, in teeth and rest", {-penalty_lag / arcsecond, "arcsec"}});
    summary_.figures.push_back(
      {"hertz pressure of one tooth pair", {TorquePressure(hertz_, model_).largest, "MPa"}});

    if (fillets_ && records_teeth_)
      for (const auto &figure : list_root_figures(*fillets_))
        summary_.figures.push_back(figure);
    if (pressures_ != nullptr)
      for (const auto &figure : pressures_->list_figures())
        summary_.figures.push_back(figure);

    // How often the other side of the teeth touched.
    // Rows are of single tooth pairs: an instant counts once, however many of them touch.
    std::set<double> coast;
    for (std::size_t i = 0; i < teeth_->n_rows(); ++i)
      if (teeth_->column(column::side).texts[i] == "coast")
        coast.insert(teeth_->numbers(column::time)[i]);
    const double share =
      history_.n_rows() > 0 ? static_cast<double>(coast.size()) / history_.n_rows() : 0.;
    summary_.figures.push_back({"samples with contact on the coast side", {share, "-"}});
  }
} // namespace vfife
