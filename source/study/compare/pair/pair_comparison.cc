// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/sample_measures.h>
#include <vfife/base/text/column_names.h>
#include <vfife/output/files/result_places.h>
#include <vfife/study/compare/nearest_mode.h>
#include <vfife/study/compare/pair/bearing_comparison.h>
#include <vfife/study/compare/pair/pair_comparison.h>
#include <vfife/study/compare/pair/pair_run.h>
#include <vfife/study/compare/pair/probe_passages.h>
#include <vfife/study/compare/pair/quasi_static.h>
#include <vfife/study/compare/pair/reduced_comparison.h>
#include <vfife/study/compare/spectrum_lines.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /**
     * Arms of the contact force of a run, as its summary states them. The mean force is the torque
     * over a mean of the arms at which tooth pairs carry, and these lie along the path of contact:
     * how far they are from the arm of the mean contact is no fault of a run.
     */
    class ArmRange
    {
    public:
      explicit ArmRange(const ComparedCase &run)
        : mean_(figure(run, figure_name::effective_arm))
        , least_(figure(run, figure_name::least_arm))
        , largest_(figure(run, figure_name::largest_arm))
      {
        known_ = std::isfinite(mean_ + least_ + largest_) && least_ > 0;
      }

      /** Largest part by which torque over an arm of the path is off that over the mean contact's;
       * 0 without arms in the summary. */
      double spread() const
      {
        return known_ ? std::max(mean_ / least_ - 1, 1 - mean_ / largest_) : 0.;
      }

      /** The end of a sentence; empty where nothing is known. */
      std::string describe() const
      {
        if (!known_)
          return "";
        std::ostringstream text;
        text << ", " << mean_ << " mm; along the path of contact it is " << least_ << " to "
             << largest_ << " mm, which the tolerance includes";
        return text.str();
      }

    private:
      static double figure(const ComparedCase &run, const char *name)
      {
        return run.number("summary.json", summary_place::figure(name));
      }

      bool   known_;
      double mean_, least_, largest_; ///< [mm]
    };

    /** How much the transmission error swings over a mesh cycle, and how far the run is from the
     * static @p curve anywhere, both at those of its positions that the run passes. */
    void add_static_curve(const PairRun             &run,
                          const std::vector<double> &positions,
                          const std::vector<double> &curve,
                          const ComparedCase        *coupled,
                          ComparisonRows            &rows)
    {
      // 1. Where both have a value: a steady part shorter than a mesh cycle passes some positions
      // only.
      const auto          cycle = run.at_positions(column::dte, positions);
      std::vector<double> passed, reference, off = {0.};
      for (std::size_t i = 0; i < curve.size(); ++i)
        if (cycle[i])
          {
            passed.push_back(*cycle[i]);
            reference.push_back(curve[i]);
            off.push_back(std::abs(*cycle[i] - curve[i]));
          }
      const std::string where =
        "mean mesh cycle of the run at " +
        (passed.size() == curve.size() ? "the positions"
                                       : std::to_string(passed.size()) + " of the " +
                                           std::to_string(curve.size()) + " positions") +
        " of the static curve";
      const double swing =
        coupled == nullptr ? 0.
                           : estimate_swing(curve,
                                            run.mesh_frequency,
                                            TurningModes(coupled->table("coupled_modes.csv"), 0.));

      // 2. The rows.
      ComparisonRow row{"dte over the mesh cycle, peak to peak",
                        "arcsec",
                        peak_to_peak_of(passed),
                        peak_to_peak_of(reference),
                        "FEM",
                        {},
                        where + "; tolerance of the mean on both ends"};
      // The largest and the least value may each be off, to opposite sides.
      run.judge_slow_ripple(2 * run.tolerances.error * std::abs(mean_of(curve)), row, 2 * swing);
      rows.push_back(row);

      row = {"dte over the mesh cycle, largest distance from the static curve",
             "arcsec",
             passed.empty() ? peak_to_peak_of({}) : peak_to_peak_of(off), // from 0 on
             0.,
             "FEM",
             {},
             where + "; tolerance of the mean"};
      run.judge_slow(run.tolerances.error * std::abs(mean_of(curve)), row, swing);
      rows.push_back(row);
    }

    /** The run beside the pair at rest in the same positions: mean, swing, distance, force. */
    void add_static_pair(const PairRun      &run,
                         const ComparedCase &loaded,
                         const ComparedCase *coupled,
                         ComparisonRows     &rows)
    {
      const Table                table     = loaded.table("loaded_contact.csv");
      const std::vector<double> &positions = table.numbers(column::position);
      const std::vector<double> &curve     = table.numbers(column::transmission_error);

      ComparisonRow row{
        "mean dte", "arcsec", run.steady_mean(column::dte), mean_of(curve), "FEM", {}, ""};
      row.reason = "loaded contact analysis at rest, mean over " +
                   std::to_string(positions.size()) + " positions";
      run.judge_slow(run.tolerances.error * std::abs(row.reference), row);
      rows.push_back(row);

      // The whole curve: how much it swings, and how far the run is from it anywhere.
      if (positions.size() > 1)
        add_static_curve(run, positions, curve, coupled, rows);

      row = {"mean contact force",
             "N",
             run.steady_mean(column::contact_force_total),
             mean_of(table.numbers(column::contact_force_total)),
             "FEM",
             {},
             ""};
      row.reason =
        "sum of the forces of tooth pairs; their mean follows from the torque at any speed";
      run.judge_steady(run.tolerances.force * row.reference, row);
      rows.push_back(row);
    }

    /** Stresses of the probes as their teeth pass the mesh. */
    void add_probes(const PairRun &run, const ComparedCase &loaded, ComparisonRows &rows)
    {
      // Two rows a probe: its largest stress, and how far the run is from the static curve
      // anywhere.
      const auto passages = compare_passages(
        run.table("probes.csv"),
        loaded.table("loaded_probes.csv"),
        [&](const std::string &probe) { return run.summary(summary_place::passage_of(probe)); },
        run.mesh_frequency,
        run.start);
      for (const ProbePassage &passage : passages)
        {
          const double  tolerance = run.tolerances.stress * passage.reference_peak;
          ComparisonRow row{passage.probe + " von mises, largest",
                            "MPa",
                            passage.peak,
                            passage.reference_peak,
                            "FEM",
                            {},
                            ""};
          row.reason = "loaded contact analysis at " + std::to_string(passage.instants) +
                       " instants of the steady part";
          run.judge_slow(tolerance, row);
          rows.push_back(row);

          row        = {passage.probe + " von mises, largest distance from the static curve",
                        "MPa",
                        passage.distance,
                        0.,
                        "FEM",
                        {},
                        ""};
          row.reason = "at the same instants; tolerance of the largest stress";
          run.judge_slow(tolerance, row);
          rows.push_back(row);
        }
    }

    /** Mean force and torque of the contact against the load: holds at any speed. */
    void add_balance(const PairRun &run, ComparisonRows &rows)
    {
      ComparisonRow row{"mean contact force",
                        "N",
                        run.steady_mean(column::contact_force_total),
                        run.summary(summary_place::figure(figure_name::force_on_arm)),
                        "balance",
                        {},
                        ""};
      row.reason = "torque over the arm of the unloaded mean contact";
      const ArmRange arms(run.folder());
      row.reason += arms.describe();
      run.judge_steady((run.tolerances.force + arms.spread()) * row.reference, row);
      rows.push_back(row);

      row        = {"mean contact torque on the gear",
                    "N m",
                    run.steady_mean(column::contact_torque_on("gear")),
                    run.summary(summary_place::figure(figure_name::torque_of("gear"))),
                    "balance",
                    {},
                    ""};
      row.reason = "in the steady state the contact torque equals the load torque";
      run.judge_steady(run.tolerances.force * std::abs(row.reference), row);
      rows.push_back(row);
    }

    /** Lines of the DTE beside the modes that take part in its static turn with more than 2 %. */
    void add_lines(const PairRun &run, const ComparedCase &coupled, ComparisonRows &rows)
    {
      const std::vector<double> modes =
        TurningModes(coupled.table("coupled_modes.csv"), .02).frequencies;
      std::vector<double> time, dte;
      run.cut(column::dte, time, dte);
      if (modes.empty() || time.size() < 8)
        return;
      // Lines that are harmonics of the mesh (whole orders, within the resolution 1.5/length of the
      // record) say nothing about modes; the three strongest others are looked up.
      const double length  = time.back() - time.front();
      const double highest = 1.2 * *std::max_element(modes.begin(), modes.end());
      unsigned int n       = 0;
      for (const SpectrumLine &line : find_spectrum_lines(time, dte, highest, .1))
        {
          const double order = line.frequency / run.mesh_frequency;
          const bool   is_harmonic =
            std::abs(order - std::round(order)) * run.mesh_frequency * length < 1.5 && order > .5;
          if (is_harmonic || n++ >= 3)
            continue;
          ComparisonRow row = compare_with_modes("line " + std::to_string(n) + " of the dte, " +
                                                   rounded_text(line.amplitude) + " arcsec",
                                                 line.frequency,
                                                 length,
                                                 modes,
                                                 run.tolerances.frequency);
          row.reason        = "nearest coupled mode with hub rotation; " + row.reason;
          rows.push_back(row);
        }
    }

    /** The lumped model's numbers, stated without a verdict. */
    void add_lumped(const PairRun &run, const ComparedCase &lumped, ComparisonRows &rows)
    {
      const auto response = [&](const char *column) {
        return lumped.number("lumped.json", lumped_place::response_figure(column));
      };
      // Damping, stiffness and inertia of the lumped model are data of their own.
      const std::string why = "the lumped model has no tilt of rim and web: for information";
      const auto        add =
        [&](const char *quantity, const char *unit, const auto &value, const auto &by) {
          rows.push_back({quantity, unit, value, by, "lumped", {}, why});
        };
      add("torsional mode frequency",
          "Hz",
          run.summary(summary_place::figure(figure_name::torsional_frequency)),
          lumped.number("lumped.json", lumped_place::first_frequency()));
      add("mean dte", "arcsec", run.steady_mean(column::dte), response(column::mean_dte));
      add("dte, peak to peak",
          "arcsec",
          run.summary(summary_place::steady_peak_to_peak(column::dte)),
          response(column::peak_to_peak_dte));
      add("contact force, peak to peak",
          "N",
          run.summary(summary_place::steady_peak_to_peak(column::contact_force_total)),
          response(column::peak_to_peak_force));
    }
  } // namespace

  ComparisonRows compare_pair(const ComparedCases &cases, const ComparisonTolerances &tolerances)
  {
    ComparisonRows rows;
    // Without a run the reduced pair is judged as one.
    const ComparedCase *const reduced = find_case(cases, "reduced", "history.csv");
    const ComparedCase       *run     = find_case(cases, "run", "summary.json");
    if (run == nullptr)
      run = reduced;
    if (run == nullptr || !run->is_pair)
      return rows;
    // Each reference that there is, from the strongest (the pair at rest) to a second opinion.
    const PairRun             pair(*run, tolerances);
    const std::string         analysis = "loaded tooth contact analysis";
    const ComparedCase *const loaded   = find_case(cases, analysis, "loaded_contact.csv");
    const ComparedCase *const coupled  = find_case(cases, analysis, "coupled_modes.csv");
    const ComparedCase *const lumped   = find_case(cases, "lumped", "lumped.json");
    if (loaded != nullptr)
      {
        add_static_pair(pair, *loaded, coupled, rows);
        add_supports(pair, *loaded, rows);
      }
    if (loaded != nullptr && loaded->has("loaded_probes.csv") && pair.has("probes.csv"))
      add_probes(pair, *loaded, rows);
    add_balance(pair, rows);
    if (coupled != nullptr)
      add_lines(pair, *coupled, rows);
    if (lumped != nullptr)
      add_lumped(pair, *lumped, rows);
    if (reduced != nullptr && reduced != run)
      add_reduced(pair, PairRun(*reduced, tolerances), rows);
    return rows;
  }
} // namespace vfife
