// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/load_torque.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/measures/order_tracking.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/observers/bearing_writer.h>
#include <vfife/output/observers/pattern_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/output/observers/teeth_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/run_length.h>
#include <vfife/study/cases/torque_pressure.h>
#include <vfife/study/fillets/root_submodels.h>
#include <vfife/study/pressure/instant_options.h>
#include <vfife/study/run/pair_results.h>
#include <vfife/study/run/run_observers.h>
#include <vfife/study/stress_waves/stress_wave_writers.h>

#include <algorithm>
#include <set>
#include <utility>

namespace vfife
{
  PairResults::PairResults(const Model         &model,
                           const HertzContact  &hertz,
                           const OutputOptions &output,
                           const std::uint64_t  history_steps,
                           const double         end_time)
    : model_(model)
    , hertz_(hertz)
    , output_(output)
    , history_steps_(history_steps)
    , end_time_(end_time)
  {
  }

  void PairResults::add_observers(RunObservers      &observers,
                                  RimWriter::Measure measure_rim,
                                  RingMotions        motion_of)
  {
    teeth_ = &observers.add<TeethWriter>(model_, history_steps_, hertz_).table();
    observers.add<PatternWriter>(model_, last_mesh(), history_steps_);
    probes_ = &observers.add<ProbeWriter>(history_steps_).table();
    rim_    = &observers.add<RimWriter>(model_, history_steps_, std::move(measure_rim)).table();
    if (PairMounting::changes(model_))
      observers.add<MisalignmentWriter>(model_, history_steps_, std::move(motion_of));
  }

  void PairResults::record_fillets(const FilletOptions       &options,
                                   const RootSubmodels *const submodels,
                                   const MakeFilletMeasure   &measure,
                                   RunObservers              &observers)
  {
    if (!options.records())
      return;
    fillets_.emplace(submodels != nullptr ? submodels->fine() : model_, options);
    strains_       = measure(*fillets_, submodels);
    records_teeth_ = options.teeth != RecordedTeeth::none;
    if (records_teeth_)
      observers.add<RootStressWriter>(history_steps_, *fillets_, strains_);
    if (!options.gauges.empty())
      observers.add<GaugeWriter>(history_steps_, *fillets_, strains_);
  }

  void PairResults::record_stress_waves(ProbeMeasure measure, RunObservers &observers)
  {
    const std::vector<unsigned int> diameters = parse_diameters(output_.stress_waves);
    if (diameters.empty())
      return;
    const unsigned int most = RimWriter::count_diameters(model_);
    if (*std::max_element(diameters.begin(), diameters.end()) > most)
      throw InputError("Output/stress wave diameters",
                       "expected at most " + std::to_string(most) + " nodal diameters");
    wave_places_.emplace(model_, records_teeth_ ? &*fillets_ : nullptr);
    observers.add<ProbeWaveWriter>(
      history_steps_, last_mesh(), diameters, *wave_places_, std::move(measure));
    if (records_teeth_)
      observers.add<FilletWaveWriter>(
        history_steps_, last_mesh(), diameters, *wave_places_, strains_);
  }

  void PairResults::record_parts(const DynamicsOptions &dynamics, RunObservers &observers)
  {
    // The deformation stands in space, and bodies turn by a sector in a mesh cycle: a few positions
    // of it have its largest stresses.
    constexpr unsigned int looks = 4;
    const std::uint64_t    every = std::max(1u, output_.history_every / looks);
    parts_                       = &observers.add<PartStressWatch>(model_,
                                             every * history_steps_,
                                             dynamics.stiffness,
                                             dynamics.frame);
  }

  void PairResults::record_pressures(const InstantOptions &options,
                                     const FemOptions     &elements,
                                     const PairRun        &run,
                                     const FlankReader    &read_flanks,
                                     Log                  &log,
                                     RunObservers         &observers)
  {
    if (options.asked_for())
      pressures_ = &observers.add<PressureWriter>(options, elements, run, read_flanks, log);
  }

  NamedFigures PairResults::list_figures(const double                  penalty,
                                         const std::optional<Vector2> &arm_range) const
  {
    // Of the case, not of its motion: known before the first step, and stated after a failure too.
    const Transmission &t      = *model_.transmission;
    const double        torque = load_torque(model_);
    // What changes in the run has no single number: it is stated for the start, by another name.
    const std::string speed_when  = t.has_constant_rate() ? "" : " at the start",
                      torque_when = has_constant_torque() ? "" : " at the start";
    NamedFigures figures = {{figure_name::mesh_frequency + speed_when, {t.mesh_frequency(), "Hz"}},
                            {figure_name::speed_of(model_.bodies[t.driver].name()) + speed_when,
                             {t.driver_rate * 30. / pi, "rpm"}},
                            {figure_name::torque_of(model_.bodies[t.driven].name()) + torque_when,
                             {1e-3 * torque, "N m"}},
                            {figure_name::torque_of(model_.bodies[t.driver].name()) + torque_when,
                             {1e-3 * torque * t.driver_teeth / t.driven_teeth, "N m"}},
                            {figure_name::effective_arm, {t.arm, "mm"}},
                            {figure_name::force_on_arm + torque_when, {torque / t.arm, "N"}},
                            {"contact penalty", {penalty, "N/mm^3"}}};
    if (arm_range)
      {
        figures.push_back({figure_name::least_arm, {t.arm * (*arm_range)[0], "mm"}});
        figures.push_back({figure_name::largest_arm, {t.arm * (*arm_range)[1], "mm"}});
      }
    return figures;
  }

  void PairResults::write_edges(const Case &pair_case, const OutputFolder &folder, Log &log) const
  {
    write_edge_contact(pair_case.edges_under_load(),
                       *teeth_,
                       column::time,
                       1. / model_.transmission->mesh_frequency(),
                       folder,
                       log);
  }

  void PairResults::write_orders(const OutputFolder &folder, const Table &history) const
  {
    const Transmission &t      = *model_.transmission;
    const unsigned int  orders = output_.count_tracked_orders();
    if (t.has_constant_rate() || orders == 0)
      return;
    write_csv(folder, "orders.csv", track_mesh_orders(history, t, output_.order_window, orders));
    write_csv(folder,
              "rim_orders.csv",
              track_rim_waves(*rim_,
                              t,
                              compute_sector_sense(model_.bodies[t.driven]) * t.driven_sense,
                              output_.order_window,
                              orders));
  }

  double PairResults::last_mesh() const
  {
    const Transmission &pair = *model_.transmission;
    return std::max(0.,
                    pair.has_constant_rate() ? end_time_ - 1. / pair.mesh_frequency()
                                             : pair.time_of(pair.meshes(end_time_) - 1.));
  }

  bool PairResults::has_constant_torque() const
  {
    return std::all_of(model_.torques.begin(), model_.torques.end(), [](const Torque &torque) {
      return torque.history.is_constant();
    });
  }

  void PairResults::find_steady(const Table           &history,
                                const double           swing_frequency,
                                const DynamicsOptions &dynamics,
                                RunSummary            &summary,
                                Log                   &log) const
  {
    if (!model_.transmission->has_constant_rate() || !has_constant_torque())
      {
        log.line("no search for a steady part: speed or torque changes during the run");
        return;
      }
    double ramp_end = 0;
    for (const Torque &torque : model_.torques)
      ramp_end = std::max(ramp_end, torque.ramp_time);
    // Means are compared over swing periods, here in mesh cycles: f_mesh/f_swing. Under a growing
    // torque nothing is steady.
    const double period = model_.transmission->mesh_frequency() / swing_frequency;
    summary.steady      = find_steady_part(history, output_.history_every, period, ramp_end);
    log.line(summary.steady->explain());
    const unsigned int needed =
      count_steady_meshes(model_.transmission->mesh_frequency(), period, dynamics);
    if (needed > 0)
      {
        summary.figures.push_back({figure_name::steady_meshes, {double(needed), "-"}});
        log.line("a steady ripple requires at least ",
                 needed,
                 " mesh cycles: vibrations decay to a tenth in the first half, the second half is "
                 "judged");
      }
    else
      log.line("vibrations do not decay without mass proportional damping and driven speed "
               "damping: the ripple remains transient");
    for (const char *name : {column::contact_force_total, column::dte, column::rim_dte})
      {
        const ColumnStatistics &c = summary.steady->column(name);
        log.line("  ",
                 name,
                 ": mean ",
                 c.mean,
                 " ",
                 c.unit,
                 ", peak to peak ",
                 c.peak_to_peak,
                 " ",
                 c.unit,
                 !summary.steady->ripple.judged  ? " (ripple not judged)"
                 : summary.steady->ripple.steady ? ""
                                                 : " (ripple still transient)");
      }
  }

  void PairResults::add_contact(const double      penalty_lag,
                                const std::size_t n_samples,
                                RunSummary       &summary,
                                Log              &log) const
  {
    if (parts_ != nullptr)
      {
        parts_->stresses().write_to(log);
        for (const auto &figure : parts_->stresses().list_figures())
          summary.figures.push_back(figure);
      }
    // The springs let the gear lag: negative, as the part in which it is contained.
    summary.transmission_error.push_back(
      {"penalty compliance, in teeth and rest", {-penalty_lag / arcsecond, "arcsec"}});
    summary.figures.push_back(
      {"hertz pressure of one tooth pair", {TorquePressure(hertz_, model_).largest, "MPa"}});

    if (fillets_ && records_teeth_)
      for (const auto &figure : list_root_figures(*fillets_))
        summary.figures.push_back(figure);
    if (pressures_ != nullptr)
      for (const auto &figure : pressures_->list_figures())
        summary.figures.push_back(figure);

    // How often the other side of the teeth touched.
    // Rows are of single tooth pairs: an instant counts once, however many of them touch.
    std::set<double> coast;
    for (std::size_t i = 0; i < teeth_->n_rows(); ++i)
      if (teeth_->column(column::side).texts[i] == "coast")
        coast.insert(teeth_->numbers(column::time)[i]);
    const double share = n_samples > 0 ? static_cast<double>(coast.size()) / n_samples : 0.;
    summary.figures.push_back({"samples with contact on the coast side", {share, "-"}});
  }
} // namespace vfife
