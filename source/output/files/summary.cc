// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/json.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
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

    /** The member of the summary that stands at a place of result_places.h. */
    Json &at(const char *place, Json &json)
    {
      return json[Json::json_pointer(place)];
    }

    void add_run(const RunSummary &summary, Json &json)
    {
      Json &run                     = json["run"];
      at(summary_place::time, json) = figure_json(summary.time, "s");
      if (summary.dt > 0) // at many speeds there are many
        run["step"] = figure_json(summary.dt, "s");
      at(summary_place::steps, json)    = summary.steps;
      at(summary_place::run_time, json) = figure_json(summary.run_time, "s");
      // Of kinds that step elements.
      if (summary.study == "run" || summary.study == "static")
        run["element-steps per second"] = figure_json(summary.element_steps_per_second(), "1/s");
      run["ranks"]                    = summary.ranks;
      run["memory of the first rank"] = figure_json(largest_memory(), "MB");
      if (!summary.instruction_set.empty())
        run["instruction set"] = summary.instruction_set;
      if (!summary.timers.empty())
        run["timers"] = figures_json(summary.timers);
      for (const auto &[section, figures] : summary.traffic)
        run["sent in a step"][section] = figures_json(figures);
    }

    Json ripple_json(const Ripple &ripple)
    {
      Json columns = Json::object();
      for (const RippleChange &column : ripple.columns)
        columns[column.name] = {
          {"peak to peak of the first half", figure_json(column.peak_to_peak_before, column.unit)},
          {"peak to peak of the second half", figure_json(column.peak_to_peak_after, column.unit)},
          {"largest change", figure_json(column.change, "-")}};
      return {{"judged", ripple.judged}, {"explanation", ripple.explain()}, {"columns", columns}};
    }

    void add_steady_part(const SteadyPart &part, Json &json)
    {
      Json &steady       = json["steady part"];
      steady["compared"] = part.by_cycles ? "single mesh cycles" : "periods of the torsional mode";
      at(summary_place::is_steady, json)        = part.found;
      steady["explanation"]                     = part.explain();
      at(summary_place::steady_start, json)     = figure_json(part.start_time, "s");
      steady["end"]                             = figure_json(part.end_time, "s");
      steady["mesh cycles"]                     = part.cycles;
      steady["torsional mode period"]           = figure_json(part.period, "mesh cycles");
      steady["largest change of the means"]     = figure_json(part.largest_change, "-");
      steady["ripple"]                          = ripple_json(part.ripple);
      at(summary_place::is_ripple_steady, json) = part.ripple.steady;
      Json &columns = at(summary_place::steady_columns, json) = Json::object();
      for (const ColumnStatistics &column : part.columns)
        columns[column.name] = {{"mean", column.mean},
                                {"peak to peak", column.peak_to_peak},
                                {"standard deviation", column.standard_deviation},
                                {"unit", column.unit}};
    }

    Json probe(const ProbeRecord &record)
    {
      Json json;
      json[summary_place::passes_mesh]           = figure_json(record.passes_mesh, "s");
      json["largest of the record"]              = figure_json(record.peak, "MPa");
      json["at"]                                 = figure_json(record.peak_time, "s");
      json["least of the record"]                = figure_json(record.least, "MPa");
      json[summary_place::largest_of_revolution] = figure_json(record.largest, "MPa");
      json[column::after_mean_contact] = figure_json(record.largest_after_mesh, "mesh cycles");
      json[summary_place::median_of_revolution] = figure_json(record.median, "MPa");
      json["the record has the peak"]           = record.has_peak;
      json["the record has the median"]         = record.has_median;
      json["explanation"]                       = record.explain();
      return json;
    }

    void add_energy(const EnergyLedger &ledger, Json &json)
    {
      Json &energy      = json["energy"];
      energy["kinetic"] = figure_json(ledger.kinetic, "mJ");
      energy["kinetic, relative to the turning bodies"] =
        figure_json(ledger.kinetic_relative, "mJ");
      energy["strain"]                              = figure_json(ledger.strain, "mJ");
      energy["contact"]                             = figure_json(ledger.contact, "mJ");
      energy["start"]                               = figure_json(ledger.start, "mJ");
      energy["work of the drive"]                   = figure_json(ledger.drive_work, "mJ");
      energy["work of the torques"]                 = figure_json(ledger.torque_work, "mJ");
      energy["damping loss"]                        = figure_json(ledger.damping_loss, "mJ");
      energy["removed by the driven speed damping"] = figure_json(ledger.mesh_damping_uptake, "mJ");
      energy["removed by the driven speed damping from the torsional mode"] =
        figure_json(ledger.swing_loss, "mJ");
      energy["contact loss"]                = figure_json(ledger.contact_loss, "mJ");
      energy["contact loss by friction"]    = figure_json(ledger.friction_loss, "mJ");
      energy["residual"]                    = figure_json(ledger.residual(), "mJ");
      at(summary_place::energy_error, json) = figure_json(ledger.error(), "-");
    }

    Json damping(const std::vector<DampingAudit> &audits)
    {
      Json json = Json::array();
      for (const DampingAudit &audit : audits)
        json.push_back({{"body", audit.body},
                        {"net torque", figure_json(1e-3 * audit.net_torque, "N m")},
                        {"power", figure_json(1e-3 * audit.power, "W")},
                        {"drift of rotation speed", figure_json(audit.spin_drift * 30 / pi, "rpm")},
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

  std::string RunSummary::fail(const std::string &message)
  {
    status  = "failed";
    failure = cause.empty() ? message : cause + "; " + message;
    return failure;
  }

  std::string make_summary_text(const RunSummary &summary)
  {
    Json json;
    // How it ended, and of what.
    at(summary_place::status, json) = summary.status;
    if (!summary.failure.empty())
      at(summary_place::failure, json) = summary.failure;
    json["study"]          = summary.study;
    json["parameter file"] = summary.parameter_file;
    for (const auto &[entry, digest] : summary.input_digests)
      json["input files"][entry] = digest;
    json["version"]  = summary.version;
    json["revision"] = summary.revision;
    json["mesh"]     = mesh(summary);
    add_run(summary, json);

    // What it found.
    if (!summary.figures.empty())
      at(summary_place::figures, json) = figures_json(summary.figures);
    if (summary.steady)
      add_steady_part(*summary.steady, json);
    if (!summary.transmission_error.empty())
      at(summary_place::transmission_error, json) = figures_json(summary.transmission_error);
    if (!summary.misalignment.empty())
      at(summary_place::misalignment, json) = figures_json(summary.misalignment);
    for (const ProbeRecord &record : summary.probes)
      at(summary_place::probes, json)[record.name] = probe(record);

    if (!summary.nearest_wave.empty())
      at(summary_place::nearest_wave, json) = summary.nearest_wave;

    // What speaks for it or against it.
    if (summary.energy)
      add_energy(*summary.energy, json);
    if (!summary.damping.empty())
      json["damping audit"] = damping(summary.damping);
    const ContactLosses &losses               = summary.contact_losses;
    at(summary_place::n_contact_losses, json) = losses.count;
    json["contact losses"]["first"] = losses.count > 0 ? figure_json(losses.first, "s") : Json();
    json["contact losses"]["time without contact"] = figure_json(losses.duration, "s");
    json["input conflicts"]                        = summary.contradictions;
    json["warnings"]                               = summary.warnings;
    return json_text(json);
  }

  void write_summary(const OutputFolder &folder, const RunSummary &summary)
  {
    if (!folder.is_writer())
      return;
    const std::string text = make_summary_text(summary);
    folder.write_file("summary.json", [&text](std::ostream &out) { out << text; });
  }

  void write_summary(const OutputFolder &folder, RunSummary summary, const Log &log)
  {
    for (const Log::Warning &warning : log.warnings())
      summary.warnings.push_back(warning.text);
    write_summary(folder, summary);
  }
} // namespace vfife
