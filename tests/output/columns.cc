// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// doc/columns.json is what the program writes: columns of the tables and places of summary.json and
// lumped.json. Former names, which it lists too, are read. The pages are compared with it by
// contrib/check_pages, the report's scripts by their tests. After a change:
// build/release/tests/output/columns.release/columns.release --list > doc/columns.json
#include "../gear/paper_pair.h"
#include "../lumped/pair.h"
#include "../read_files.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/column_names.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/fem/modes/campbell.h>
#include <vfife/fem/pair/coupled_modes.h>
#include <vfife/gear/flank_points.h>
#include <vfife/gear/measurement/measuring_grid.h>
#include <vfife/gear/measurement/settings_fit.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/gear/unloaded_contact/tooth_form.h>
#include <vfife/gear/unloaded_contact/unequal_teeth.h>
#include <vfife/lumped/speed_sweep.h>
#include <vfife/mesh/gear/gear_meridian.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/run_figures.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/measures/order_tracking.h>
#include <vfife/output/measures/root_stress.h>
#include <vfife/output/observers/bearing_writer.h>
#include <vfife/output/observers/history_writer.h>
#include <vfife/output/observers/pattern_writer.h>
#include <vfife/output/observers/probe_writer.h>
#include <vfife/output/observers/rim_writer.h>
#include <vfife/output/observers/teeth_writer.h>
#include <vfife/reduced/resonance/contact_meetings.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/damping_figures.h>
#include <vfife/study/compare/comparison.h>
#include <vfife/study/conventional/linear_static_study.h>
#include <vfife/study/conventional/loaded_contact_tables.h>
#include <vfife/study/conventional/loaded_probes.h>
#include <vfife/study/gear/lumped_study.h>
#include <vfife/study/pressure/pressure_tables.h>
#include <vfife/study/reduced/pair_speed_sweep.h>
#include <vfife/study/reduced/speed_ranges.h>
#include <vfife/study/stress_waves/stress_wave_writers.h>
#include <vfife/study/sweep/sweep_tables.h>
#include <vfife/study/waves/wave_line_tables.h>

#include <filesystem>

using namespace vfife;

/** A file and of which case; the columns that it has. */
struct ListedTable
{
  std::string file, of;
  Table       table;
};

Model make_pair_model(const unsigned int driver)
{
  Model model;
  for (const char *name : {"pinion", "gear"})
    model.add_body(Body(name, make_ring(20, 30, 5, {{2, 24, 2}}), Material()));
  Transmission pair;
  pair.driver         = driver;
  pair.driven         = 1 - driver;
  pair.driven_teeth   = 79;
  pair.driven_rim     = {0, 1, 2, 3};
  model.transmissions = {pair};
  return model;
}

void list_run_tables(const OutputFolder &folder, std::vector<ListedTable> &tables)
{
  const Model        pair = make_pair_model(0), led = make_pair_model(1);
  const HertzContact hertz(Vector2(.01, .1), 1e5);
  Model              general;
  general.add_body(Body("body", make_ring(20, 30, 5, {{2, 24, 2}}), Material()));
  general.probes.push_back({"NAME", 0, 0});
  Constraint support;
  support.name = "NAME";
  general.constraints.push_back(support);
  general.walls.emplace_back();
  general.walls[0].name = "NAME";

  const auto history = [&folder](const Model &model) {
    return HistoryWriter(folder, model, 1, [] { return ContactImpulse(); }).table();
  };
  tables.push_back({"history.csv", "gear pair", history(pair)});
  tables.push_back({"history.csv", "gear pair, gear driving", history(led)});
  tables.push_back({"history.csv", "general model", history(general)});
  general.probes[0].fixed_axes = true;
  tables.push_back({"history.csv", "general model, probe in fixed axes", history(general)});
  tables.push_back({"teeth.csv", "gear pair", TeethWriter(folder, pair, 1, hertz).table()});
  tables.push_back({"probes.csv", "gear pair", ProbeWriter(folder, 1).table()});
  tables.push_back({"rim.csv", "gear pair", RimWriter(folder, pair, 1).table()});
  tables.push_back({"orders.csv", "gear pair", make_order_table()});
  tables.push_back({"rim_orders.csv", "gear pair", make_rim_order_table()});
  const auto over_time = [](const auto &columns) { return columns.make_table(column::time, "s"); };
  tables.push_back({"root_stress.csv", "run", over_time(list_root_stress_columns())});
  tables.push_back({"gauges.csv", "run", over_time(list_gauge_columns())});
  tables.push_back({"probe_waves.csv", "gear pair", over_time(list_probe_wave_columns())});
  tables.push_back({"fillet_waves.csv", "gear pair", over_time(list_fillet_wave_columns())});
  tables.push_back({"pressure.csv", "run", make_pressure_table(PressureRows::instants)});
  tables.push_back(
    {"pressure_field.csv", "run", make_pressure_field_table(PressureRows::instants)});
  tables.push_back({"bearings.csv", "run", BearingWriter(folder, 1).table()});
  tables.push_back({"bearing_curves.csv", "pair or model in bearings", make_bearing_curves({})});
  tables.push_back({"misalignment.csv", "gear pair on shafts", over_time(list_mounting_columns())});
  PatternWriter(folder, pair, 0., 1).finish(pair, State());
  tables.push_back({"pattern.csv", "gear pair", read_result_table(folder.file("pattern.csv"))});
}

std::vector<ListedTable> list_tables(const OutputFolder &folder)
{
  std::vector<ListedTable> tables;
  list_run_tables(folder, tables);
  const auto add = [&tables](const std::string &file, const std::string &kind, const Table &t) {
    tables.push_back({file, kind, t});
  };
  const std::string loaded = "loaded tooth contact analysis", modal = "modal";
  add("loaded_contact.csv", loaded, make_loaded_contact_table());
  add("loaded_teeth.csv", loaded, make_loaded_teeth_table());
  add("bearings.csv", loaded, make_loaded_bearing_table());
  add("misalignment.csv", loaded, make_loaded_misalignment_table());
  add("pattern.csv", loaded, ContactPattern(make_pair_model(0)).table(make_pair_model(0)));
  add("loaded_probes.csv", loaded, LoadedProbes(make_pair_model(0)).table());
  add("root_stress.csv", loaded, make_loaded_root_stress_table());
  add("gauges.csv", loaded, make_loaded_gauge_table());
  add("pressure.csv", loaded, make_pressure_table(PressureRows::positions));
  add("pressure_field.csv", loaded, make_pressure_field_table(PressureRows::positions));
  add("fillet_envelope.csv", loaded, make_fillet_envelope_table());
  add("root_sections.csv", loaded, make_root_section_table());
  add("coupled_modes.csv", loaded, make_coupled_mode_table());
  add("adaptive_refinement.csv", "linear static", make_adaptive_table());
  add("reactions.csv", "linear static", make_reaction_table());
  add("modes.csv", modal, make_mode_table());
  add("campbell.csv", modal, make_campbell_table());
  add("resonances.csv", modal, make_resonance_table());
  add("lumped.csv", "lumped", make_motion_table(LumpedModel(linear_pair())));
  add("resonance.csv", "lumped", make_resonance_response_table());
  add("resonance.csv", "reduced", make_resonance_response_table());
  add("wave_response.csv", "reduced", make_wave_response_table());
  add("stress_response.csv", "reduced", make_stress_response_table());
  add("exceedances.csv", "reduced", make_exceedance_table());
  add("waves_lines.csv", "waves", make_wave_line_table());
  add("waves_frequencies.csv", "waves", make_wave_frequency_table());
  add("waves_in_contact.csv", "waves", make_contact_meeting_table({}, {}, 1., 1));
  add("waves_response.csv", "waves", make_wave_motion_table());
  add("waves_build_up.csv", "waves", make_build_up_table());
  add("waves_stress.csv", "waves", make_wave_stress_table());
  add("speeds_to_avoid.csv", "waves", make_avoided_speed_table({}, 1., 0.));
  add("mesh.csv", "mesh", body_figures_table({}));
  add("meridian.csv", "mesh", make_meridian_table());
  const GearPair    gears(paper::options());
  const std::string unloaded = "tooth contact analysis";
  add("tca.csv", unloaded, lag_table(gears, {}, ContactAnalysisOptions()));
  add("path.csv", unloaded, path_table(gears, {}));
  add("transmission.csv", unloaded, transmission_table(gears, ContactAnalysisOptions()));
  add("transmission_meshes.csv",
      unloaded,
      transmission_of_meshes(gears, ContactAnalysisOptions(), 0));
  add("ease_off.csv", unloaded, ease_off_table(gears));
  add("flank_points_BODY.csv", "mesh", compute_flank_points(gears.gear(), 2, 2));
  add("grid_MEMBER_FLANK.csv",
      "flank fit",
      compute_measuring_grid(gears.gear(), FlankSide::convex, 0, MeasuringGrid()));
  add("flank_fit.csv", "flank fit", fit_table(SettingsFitResult()));
  add("comparison.csv", "compare", comparison_table({}));
  // A run that does not exist has the same figures as any other.
  NamedFigures figures = read_run_figures("").figures;
  for (const char *of_histories : {"FIGURE", "FIGURE error", "FIGURE order"})
    figures.push_back({of_histories, {0., "-"}});
  add("sweep.csv", "sweep", make_sweep_table({"PARAMETER"}, figures));
  const ErrorTables errors = make_error_tables({"PARAMETER"});
  add("error_bars.csv", "sweep", errors.bars);
  add("differences.csv", "sweep", errors.differences);
  return tables;
}

/** A run that has something at every place. */
RunSummary make_summary()
{
  using namespace figure_name;
  RunSummary summary;
  summary.study           = "run";
  summary.failure         = "energy error";
  summary.nearest_wave    = "n = 3";
  summary.bodies          = {{"pinion", 1, 8, 1., 1., 1., 1.}};
  summary.instruction_set = "scalar";
  summary.timers          = {{"SECTION", {1, "s"}}};
  summary.traffic         = {{"SECTION",
                              {{"messages", {1, "-"}},
                               {"bytes of messages", {1, "B"}},
                               {"reductions", {1, "-"}},
                               {"bytes of reductions", {1, "B"}},
                               {"most messages of a rank", {1, "-"}},
                               {"most bytes of messages of a rank", {1, "B"}}}}};
  summary.figures         = {{mesh_frequency, {1, "Hz"}},
                             {torsional_frequency, {1, "Hz"}},
                             {speed_of("pinion"), {1, "rpm"}},
                             {torque_of("gear"), {1, "N m"}},
                             {force_on_arm, {1, "N"}}};
  Transmission gears;
  gears.driver_teeth = 27;
  gears.driver_rate  = 1.;
  DynamicsOptions dynamics;
  dynamics.damping_ratio     = 1e-3;
  dynamics.damping_frequency = 1.;
  std::ostringstream screen;
  Log                log(screen, false);
  for (const auto &figure : list_damping(dynamics, &gears, log))
    summary.figures.push_back(figure);
  using namespace error_part;
  for (const char *part : {total,
                           teeth_and_rest,
                           web_windup,
                           rim_tilt_and_shift,
                           rim_bending,
                           centrifugal_shift,
                           bearings,
                           shaft_bending})
    summary.transmission_error.push_back({part, {1, "arcsec"}});
  summary.misalignment = {{column::offset, {1, "um"}},
                          {column::pinion_axial_shift, {1, "um"}},
                          {column::gear_axial_shift, {1, "um"}},
                          {column::shaft_angle_error, {1, "arcmin"}}};
  summary.steady       = SteadyPart();
  summary.steady->columns.push_back({"COLUMN", "UNIT"});
  summary.probes.push_back(make_probe_record(
    "PROBE", {0., 1.}, {1., 2.}, 1., {2., 1.}, [](const double time) { return time; }, .5));
  summary.energy         = EnergyLedger();
  summary.energy->scale  = 1.;
  summary.damping        = {{"pinion"}};
  summary.contact_losses = {1, 1., 1.};
  summary.contradictions = summary.warnings = {"a text"};
  return summary;
}

/** Of a study that has lost contact on its sweep. */
Json make_lumped_results()
{
  const LumpedModel model(linear_pair());
  LumpedResponse    apart;
  apart.time_apart = 1.;
  Table resonance  = make_resonance_response_table();
  add_response("up", 1., 20, apart, resonance);
  return make_lumped_json(model, apart, 1., resonance);
}

/** Adds the places at and below @p place; of lists their first member stands for all. */
void add_places(const Json &json, const std::string &place, Json &places)
{
  if (json.is_object() && json.contains("value"))
    places.push_back({{"place", place}, {"unit", json["unit"]}});
  else if (json.is_object())
    for (const auto &[name, value] : json.items())
      add_places(value, (Json::json_pointer(place) / name).to_string(), places);
  else if (json.is_array())
    add_places(json[0], place + "/0", places);
  else
    places.push_back({{"place", place}});
}

/** Objects of one key a line. */
void write_list(std::ostream &out, const Json &list, const std::string &indent)
{
  for (std::size_t i = 0; i < list.size(); ++i)
    out << (i == 0 ? "" : ",") << "\n" << indent << list[i].dump();
}

/** Tables, then the places of .json files by their names. */
std::string make_text(const std::vector<ListedTable>                  &tables,
                      const std::vector<std::pair<std::string, Json>> &files)
{
  std::ostringstream text;
  text << "{\"tables\": [";
  for (std::size_t i = 0; i < tables.size(); ++i)
    {
      text << (i == 0 ? "" : ",") << "\n  {\"file\": " << Json(tables[i].file)
           << ", \"of\": " << Json(tables[i].of) << ", \"columns\": [";
      write_list(text, tables[i].table.json()["columns"], "    ");
      text << "]}";
    }
  for (const auto &[name, json] : files)
    {
      Json places = Json::array();
      add_places(json, "", places);
      text << "],\n" << Json(name) << ": [";
      write_list(text, places, "  ");
    }
  text << "]}\n";
  return text.str();
}

/** The first line in which they differ; empty where there is none. */
std::string find_difference(const std::string &page, const std::string &written)
{
  std::istringstream one(page), two(written);
  std::string        a, b;
  for (unsigned int number = 1; one || two; ++number)
    {
      a.clear();
      b.clear();
      std::getline(one, a);
      std::getline(two, b);
      if (a != b)
        return "doc/columns.json, line " + std::to_string(number) + ": " + a + "\nwritten is: " + b;
    }
  return "";
}

void check_table_files(const OutputFolder &folder)
{
  Table table;
  table.add_column(column::time, "s");
  table.add_row({.1});
  write_tables(folder, "times", table);
  check("table read back",
        read_result_table(folder.file("times.csv")).numbers(column::time) ==
          std::vector<double>{.1});
  std::ifstream file(folder.file("times.json"));
  check("its json", Json::parse(file) == table.json());
}

/** Results and a checkpoint of the previous version. */
void check_former_names(const OutputFolder &folder)
{
  const auto write = [&folder](const std::string &file, const std::string &text) {
    std::ofstream(folder.file(file)) << text;
    return folder.file(file);
  };
  check("a former column is read by its present name",
        read_result_table(write("history.csv", "taken by the driven speed damping [mJ]\n3\n"))
            .numbers("removed by the driven speed damping") == std::vector<double>{3.});
  check("columns of numbered waves",
        read_result_table(write("wave_response.csv", "running wave 12 [um]\n3\n"))
            .numbers("travelling wave 12") == std::vector<double>{3.});
  const Table words = read_result_table(
    write("differences.csv", "quantity,verdict\nnode A median of a turn,not told apart\n"));
  check("words in cells",
        words.column("quantity").texts[0] == "node A median per revolution" &&
          words.column("verdict").texts[0] == "not significant");
  check("the names of another file stay",
        read_result_table(write("other.csv", "time apart [-]\n3\n")).columns()[0].name ==
          "time apart");
  const std::string summary =
    write("summary.json",
          R"({"figures": {"swing frequency, estimated": {"value": 7, "unit": "Hz"}},
          "probes": {"arm": {"median of a turn": {"value": 5, "unit": "MPa"}}}, "warnings": ["a"]})");
  check("members of .json files",
        read_figure(summary, summary_place::figure(figure_name::torsional_frequency)) == 7 &&
          read_figure(summary, "/probes/arm/median per revolution") == 5);
  const NamedFigures own = read_own_figures({folder.path()})[0];
  check("also for tables of runs",
        own.size() == 1 && own[0].first == "arm median per revolution" && own[0].second.value == 5);

  Table before, now;
  for (Table *const table : {&before, &now})
    {
      table->add_column(column::time, "s");
      table->add_column(table == &now ? "removed by the driven speed damping"
                                      : "taken by the driven speed damping",
                        "mJ");
    }
  before.add_row({1., 3.});
  ByteStream out;
  before.serialize_rows(out);
  ByteStream in(out.bytes());
  now.serialize_rows(in);
  check("rows of a checkpoint",
        now.numbers("removed by the driven speed damping") == std::vector<double>{3.});
}

void check_places(const OutputFolder &folder)
{
  RunSummary summary = make_summary();
  summary.time       = .25;
  for (const char *name :
       {column::contact_force_total, column::dte, column::rim_dte, "beam/end displacement x"})
    summary.steady->columns.push_back({name, "mm", 3., 2., 1.});
  summary.steady->found = true;
  write_summary(folder, summary);
  const std::string path = folder.file("summary.json");
  check("a figure, a number and a switch are read back",
        read_figure(path, summary_place::time) == .25 &&
          read_figure(path, summary_place::n_contact_losses) == 1 &&
          read_figure(path, summary_place::is_steady) == 1 &&
          read_figure(path, summary_place::figure(figure_name::torsional_frequency)) == 1);
  check("a column of any name",
        read_figure(path, summary_place::steady_mean("beam/end displacement x")) == 3 &&
          read_figure(path, summary_place::steady_peak_to_peak("beam/end displacement x")) == 2);
  check("nothing at other places",
        std::isnan(read_figure(path, summary_place::steady_mean("no column"))) &&
          std::isnan(read_figure(path, summary_place::figures)));
  bool all_known = true;
  for (const auto &figure : read_run_figures(folder.path()).figures)
    all_known = all_known && std::isfinite(figure.second.value);
  check("all columns of a table of runs", all_known);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all("columns_results");
  const OutputFolder folder("columns_results", session.world());
  const std::string  written =
    make_text(list_tables(folder),
              {{"summary.json", Json::parse(make_summary_text(make_summary()))},
               {"lumped.json", make_lumped_results()}});
  if (argc > 1 && std::string(argv[1]) == "--list")
    {
      std::cout << written;
      std::filesystem::remove_all(folder.path());
      return 0;
    }
  const std::string difference =
    find_difference(read_text(tree_folder() + "/doc/columns.json"), written);
  if (!difference.empty())
    std::cerr << difference << std::endl;
  check("doc/columns.json is what is written", difference.empty());
  check_table_files(folder);
  check_places(folder);
  check_former_names(folder);
  return 0;
}
