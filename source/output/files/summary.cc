// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/json.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/summary.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <ostream>

namespace vfife
{
  namespace
  {
    /** Sizes of the model and of each body, in the units of a reader: kg, kg m^2, rpm. */
    Json mesh(const RunSummary &summary)
    {
      std::uint64_t cells = 0, nodes = 0;
      Json          bodies = Json::array();
      for (const BodySummary &body : summary.bodies)
        {
          cells += body.cells;
          nodes += body.nodes;
          Json json;
          json["name"]               = body.name;
          json["cells"]              = body.cells;
          json["nodes"]              = body.nodes;
          json["mass"]               = figure_json(1e3 * body.mass, "kg");
          json["axial inertia"]      = figure_json(1e-3 * body.inertia, "kg m^2");
          json["speed at the start"] = figure_json(body.rate * 30 / pi, "rpm");
          if (body.added > 0)
            json["added mass"] = figure_json(1e3 * body.added, "kg");
          bodies.push_back(json);
        }
      Json json;
      json["cells"]  = cells;
      json["nodes"]  = nodes;
      json["bodies"] = bodies;
      return json;
    }

    /** Largest memory of this process so far [MB]. */
    double largest_memory()
    {
      dealii::Utilities::System::MemoryStats stats;
      dealii::Utilities::System::get_memory_stats(stats);
      return 1e-3 * static_cast<double>(stats.VmHWM);
    }

    Json run(const RunSummary &summary)
    {
      Json json;
      json["time"]                     = figure_json(summary.time, "s");
      json["step"]                     = figure_json(summary.dt, "s");
      json["steps"]                    = summary.steps;
      json["run time"]                 = figure_json(summary.run_time, "s");
      json["element-steps per second"] = figure_json(summary.element_steps_per_second(), "1/s");
      json["ranks"]                    = summary.ranks;
      json["memory of the first rank"] = figure_json(largest_memory(), "MB");
      if (!summary.instruction_set.empty())
        json["instruction set"] = summary.instruction_set;
      if (!summary.timers.empty())
        json["timers"] = figures_json(summary.timers);
      return json;
    }

    /** Where figures are from, why, and what each column of the history does there. */
    Json steady_part(const SteadyPart &part)
    {
      Json json;
      json["compared"]                    = part.by_cycles ? "single mesh cycles" : "swing periods";
      json["found"]                       = part.found;
      json["explanation"]                 = part.explain();
      json["start"]                       = figure_json(part.start_time, "s");
      json["end"]                         = figure_json(part.end_time, "s");
      json["mesh cycles"]                 = part.cycles;
      json["swing period"]                = figure_json(part.period, "mesh cycles");
      json["largest change of the means"] = figure_json(part.largest_change, "-");
      Json columns                        = Json::object();
      for (const ColumnStatistics &column : part.columns)
        columns[column.name] = {{"mean", column.mean},
                                {"peak to peak", column.peak_to_peak},
                                {"standard deviation", column.standard_deviation},
                                {"unit", column.unit}};
      json["columns"] = columns;
      return json;
    }

    /** Entry for entry the sums of the ledger, so that the residual can be checked by hand. */
    Json energy(const EnergyLedger &ledger)
    {
      Json json;
      json["kinetic"]                                 = figure_json(ledger.kinetic, "mJ");
      json["kinetic, relative to the turning bodies"] = figure_json(ledger.kinetic_relative, "mJ");
      json["strain"]                                  = figure_json(ledger.strain, "mJ");
      json["contact"]                                 = figure_json(ledger.contact, "mJ");
      json["start"]                                   = figure_json(ledger.start, "mJ");
      json["work of the drive"]                       = figure_json(ledger.drive_work, "mJ");
      json["work of the torques"]                     = figure_json(ledger.torque_work, "mJ");
      json["damping loss"]                            = figure_json(ledger.damping_loss, "mJ");
      json["mesh damping loss"]                       = figure_json(ledger.mesh_damping_loss, "mJ");
      json["contact loss"]                            = figure_json(ledger.contact_loss, "mJ");
      json["residual"]                                = figure_json(ledger.residual(), "mJ");
      json["error"]                                   = figure_json(ledger.error(), "-");
      return json;
    }

    Json damping(const std::vector<DampingAudit> &audits)
    {
      Json json = Json::array();
      for (const DampingAudit &audit : audits)
        json.push_back({{"body", audit.body},
                        {"net torque", figure_json(1e-3 * audit.net_torque, "N m")},
                        {"power", figure_json(1e-3 * audit.power, "W")},
                        {"spin drift", figure_json(audit.spin_drift * 30 / pi, "rpm")},
                        {"mean speed rate minus momentum rate",
                         figure_json(audit.rate_difference * 30 / pi, "rpm")}});
      return json;
    }
  } // namespace

  double RunSummary::element_steps_per_second() const
  {
    double cells = 0;
    for (const BodySummary &body : bodies)
      cells += body.cells;
    return run_time > 0 ? cells * static_cast<double>(steps) / run_time : 0.;
  }

  std::string make_summary_text(const RunSummary &summary)
  {
    Json json;
    json["status"] = summary.status;
    if (!summary.failure.empty())
      json["failure"] = summary.failure;
    json["study"]          = summary.study;
    json["parameter file"] = summary.parameter_file;
    json["version"]        = summary.version;
    json["revision"]       = summary.revision;
    json["mesh"]           = mesh(summary);
    json["run"]            = run(summary);
    // Sections without content are left out; who reads takes a missing one for "not known".
    if (!summary.figures.empty())
      json["figures"] = figures_json(summary.figures);
    if (summary.steady)
      json["steady part"] = steady_part(*summary.steady);
    if (!summary.transmission_error.empty())
      json["transmission error"] = figures_json(summary.transmission_error);
    if (summary.energy)
      json["energy"] = energy(*summary.energy);
    if (!summary.damping.empty())
      json["damping audit"] = damping(summary.damping);
    json["contact losses"] = {
      {"count", summary.contact_losses.count},
      {"first",
       summary.contact_losses.count > 0 ? figure_json(summary.contact_losses.first, "s") : Json()},
      {"time without contact", figure_json(summary.contact_losses.duration, "s")}};
    json["contradictions"] = summary.contradictions;
    json["warnings"]       = summary.warnings;
    return json_text(json);
  }

  void write_summary(const OutputFolder &folder, const RunSummary &summary)
  {
    if (!folder.is_writer())
      return;
    const std::string text = make_summary_text(summary);
    folder.write_file("summary.json", [&text](std::ostream &out) { out << text; });
  }
} // namespace vfife
