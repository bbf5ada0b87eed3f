// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind `waves` on the coarsest pair: prediction, a wave driven on its line and around it by
// the reduced pair and by runs, what is refused.
#include "../../parts.h"
#include "../../read_files.h"
#include "../../refusal.h"
#include "../few_teeth.h"

#include <vfife/output/files/run_figures.h>

#include <filesystem>

using namespace vfife;

void write_file(const std::string &name, const std::string &pair)
{
  std::ofstream(name) << pair << R"(
subsection Study
  set kind = waves
end
subsection Dynamics
  set mass proportional damping = 800
  set driven speed damping = 6000
end
subsection Reduced
  set settling mesh cycles = 20
  set recorded mesh cycles = 4
end
subsection Waves
  set lowest speed  = 7000 rpm
  set highest speed = 8300 rpm
  set nodal diameters = 4
  set mesh harmonics = 1
  set settling decay times  = 4
  set allowed amplification = 1.05
end
subsection Operation
  set speed  = 10000 rpm
  set torque = 800 N m
end
subsection Output
  set samples per mesh cycle = 30
  set report        = false
  set verbosity     = quiet
end
)";
}

/** Bodies of predictions, shared within the test alone. */
constexpr char plain_bodies[] = "Reduced/store=plain_bodies";

/** Frequencies that `modal` finds at the speeds where the lines are said to be. */
void prediction(Communicator &world)
{
  run_pair("waves.prm",
           "predicted",
           world,
           {plain_bodies,
            "Waves/simulate response=no",
            "Waves/nodal diameters=3, 4",
            "Waves/highest speed=12000 rpm"});
  const Columns lines = read_columns("predicted/waves_lines.csv");
  check("two waves of four diameters, none of three between the speeds",
        lines.at("speed").size() == 2 && lines.at("nodal diameter")[0] == 4);
  check("not driven, not measured",
        std::isnan(lines.at("peak speed")[0]) &&
          !std::filesystem::exists("predicted/waves_response.csv"));
  const NamedFigures         figures = read_own_figures({"predicted"})[0];
  const std::vector<double> &contact = lines.at("speed in contact");
  check("speeds of the lines are figures",
        figures.size() >= 3 && figures[0].second.value == contact[0] &&
          figures[1].second.value == contact[1] && figures[2].second.unit == "%");
  double distance = 100;
  for (const double speed : read_columns("predicted/waves_in_contact.csv").at("speed"))
    distance = std::min(distance, 100 * std::abs(speed / 10000 - 1));
  check_close("distance to the nearest resonance [%]", figures[2].second.value, distance, .1);
  const auto   summary = read_json("predicted/summary.json");
  const double named =
    summary.at("figures").at("speed of the nearest wave").at("value").get<double>();
  check_close("as the speed in the summary", 100 * std::abs(named / 10000 - 1), distance, .1);
  check("and its words",
        has_text(summary.at("nearest wave").get<std::string>(),
                 std::to_string(std::lround(named)) + " rpm of the pinion, "));
  for (std::size_t k = 0; k < 2; ++k)
    {
      // Against the spin 79 + 4 times the gear's speed, with it 79 - 4 times.
      const double gear = lines.at("speed")[k] * 27 / 79, turns = k == 0 ? 83 : 75;
      check_ratio("frequency over that of the force",
                  lines.at("frequency")[k] / (turns * gear / 60),
                  1e-9);
      check_close("damping ratio",
                  lines.at("damping ratio")[k],
                  800 / (4 * 3.14159265 * lines.at("frequency")[k]),
                  2e-3 * lines.at("damping ratio")[k]);
      run_pair("waves.prm",
               "modal",
               world,
               {"Study/kind=modal",
                "Fem/bodies=gear",
                "Fem/speeds=" + std::to_string(gear) + " rpm",
                "Fem/modes=4",
                "Fem/mass=lumped",
                "Fem/coriolis=yes",
                "Fem/cyclic symmetry=yes",
                "Fem/maximum nodal diameter=4"});
      const Columns modes = read_columns("modal/modes.csv");
      double        least = 1.;
      for (std::size_t m = 0; m < modes.at("frequency").size(); ++m)
        if (modes.at("nodal diameter")[m] == 4)
          least =
            std::min(least, std::abs(modes.at("frequency")[m] / lines.at("frequency")[k] - 1.));
      check_below("a mode of the whole gear at that speed", least, 1e-4);
    }
}

/** Lines are chosen by the speed in contact. */
void choice(Communicator &world)
{
  const Columns all  = read_columns("predicted/waves_lines.csv");
  const double  free = all.at("speed")[0], contact = all.at("speed in contact")[0],
               near  = .4 * std::abs(free - contact);
  const auto predict = [&](const std::string &folder, const double speed) {
    run_pair("waves.prm",
             folder,
             world,
             {plain_bodies,
              "Waves/simulate response=no",
              "Waves/lowest speed=" + std::to_string(speed - near) + " rpm",
              "Waves/highest speed=" + std::to_string(speed + near) + " rpm"});
    return read_columns(folder + "/waves_lines.csv");
  };
  const Columns around = predict("contact", contact);
  check("a line around its speed in contact", around.at("speed").size() == 1);
  check_ratio("the same one", around.at("speed in contact")[0] / contact, 1e-3);
  check("none around the free gear's speed", predict("free", free).at("speed").empty());

  // All poles of these waves, by all orders; an umbrella is one vibration.
  run_pair("waves.prm",
           "orders",
           world,
           {plain_bodies,
            "Waves/simulate response=no",
            "Waves/lowest speed=0 rpm",
            "Waves/highest speed=10000 rpm",
            "Waves/nodal diameters=0, 3, 4",
            "Waves/mesh harmonics=3"});
  const Table   lines  = read_result_table("orders/waves_lines.csv");
  const Columns met    = read_columns("orders/waves_in_contact.csv");
  const auto   &speeds = lines.numbers("speed in contact");
  check("ascending by the speed in contact", std::is_sorted(speeds.begin(), speeds.end()));
  check("between the speeds", speeds.front() > 0 && speeds.back() <= 10000);
  std::size_t poles = 0, found = 0;
  for (std::size_t m = 0; m < met.at("speed").size(); ++m)
    {
      const double n = met.at("nodal diameter")[m];
      if ((n != 0 && n != 3 && n != 4) || met.at("order")[m] != 1 ||
          met.at("share of the wave")[m] < .9)
        continue;
      ++poles;
      for (std::size_t k = 0; k < lines.n_rows(); ++k)
        found += std::abs(speeds[k] / met.at("speed")[m] - 1) < 1e-9 &&
                 lines.numbers("nodal diameter")[k] == n &&
                 lines.numbers("mesh order")[k] == met.at("mesh order")[m];
    }
  check("every pole that is nearly all of a wave is a line", poles > 6 && found == poles);
  bool   no_direction = true;
  double worst = 0, umbrellas = 0;
  for (std::size_t k = 0; k < lines.n_rows(); ++k)
    if (lines.numbers("nodal diameter")[k] == 0)
      {
        ++umbrellas;
        no_direction = no_direction && lines.column("wave").texts[k] == "-";
        raise_to(worst,
                 std::abs(lines.numbers("frequency")[k] /
                            (lines.numbers("mesh order")[k] * 27 * lines.numbers("speed")[k] / 60) -
                          1.));
      }
  check("an umbrella has no direction", umbrellas > 0 && no_direction);
  check_below("its frequency is that of the order at the free gear's speed", worst, 1e-9);
}

/** Meetings in contact: lines are among them, and the swing, whose frequency hardly changes with
 * the speed. */
void in_contact(Communicator &world)
{
  const Columns lines = read_columns("predicted/waves_lines.csv"),
                met   = read_columns("predicted/waves_in_contact.csv");
  for (std::size_t k = 0; k < 2; ++k)
    {
      const double line  = lines.at("speed in contact")[k];
      std::size_t  found = 0;
      for (std::size_t m = 0; m < met.at("speed").size(); ++m)
        if (std::abs(met.at("speed")[m] - line) < std::abs(met.at("speed")[found] - line))
          found = m;
      check_ratio("a line in contact", met.at("speed")[found] / line, 1e-12);
      check("of four diameters at the first order",
            met.at("nodal diameter")[found] == 4 && met.at("mesh order")[found] == 1 &&
              met.at("share of the wave")[found] > .9);
      check_ratio("its width", met.at("width")[found] / lines.at("predicted width")[k], 1e-9);
      check_ratio("its amplitude",
                  met.at("amplitude")[found] / lines.at("predicted amplitude")[k],
                  1e-9);
    }

  run_pair("waves.prm",
           "swing",
           world,
           {plain_bodies,
            "Waves/simulate response=no",
            "Waves/lowest speed=1500 rpm",
            "Waves/highest speed=6000 rpm"});
  const Columns         low = read_columns("swing/waves_in_contact.csv");
  std::map<int, double> swing;
  for (std::size_t m = 0; m < low.at("speed").size(); ++m)
    if (low.at("share of the rotation")[m] > .5)
      swing[int(low.at("mesh order")[m])] = low.at("speed")[m];
  check("the torsional mode meets the first and the second order",
        swing.count(1) == 1 && swing.count(2) == 1);
  check_close("at speeds in the ratio of the orders", swing[1] / swing[2], 2., 2e-2);
}

/** Tensions in the equilibrium are those that a reduced pair at the same speed has. */
void check_fillets(const Columns &lines, const Columns &stress, Communicator &world)
{
  run_pair("waves.prm",
           "fillets",
           world,
           {"Study/kind=reduced",
            "Fillets/teeth=all",
            "Fillets/source=elements",
            "Operation/speed=" + std::to_string(lines.at("speed in contact")[0]) + " rpm",
            "Operation/mesh cycles=1"});
  const Table roots = read_result_table("fillets/root_stress.csv");
  const auto &time = roots.numbers("time"), &tension = roots.numbers("tension");
  for (const std::size_t place : {2, 3})
    {
      const std::string side  = place == 2 ? "concave" : "convex";
      double            start = 0;
      for (std::size_t m = 0; m < roots.n_rows(); ++m)
        if (roots.column("body").texts[m] == "gear" && roots.column("fillet").texts[m] == side)
          start = std::max(start, time[m] == 0 ? tension[m] : 0.);
      const double still = stress.at("stress without waves")[8 + place],
                   wave  = stress.at("stress of the wave")[8 + place];
      check_ratio(side + " fillets in the equilibrium", still / start, 2e-3);
      check(side + " fillets: the wave's tension is a part of it",
            wave > .01 * still && wave < still);
    }
  check("roots beside the web",
        lines.at("root amplification")[0] > 1 && lines.at("web amplification")[0] > 1 &&
          lines.at("stress amplification")[0] ==
            std::max(lines.at("root amplification")[0], lines.at("web amplification")[0]));
}

/** The wave that runs against the spin. */
void driven(Communicator &world)
{
  run_pair("waves.prm", "driven", world, {"Fillets/teeth=all"});
  const Columns lines  = read_columns("driven/waves_lines.csv"),
                waves  = read_columns("driven/waves_response.csv"),
                growth = read_columns("driven/waves_build_up.csv"),
                stress = read_columns("driven/waves_stress.csv");
  check("a row a speed", waves.at("speed").size() == 5);
  check("a row a speed, probe and fillet", stress.at("stress of the wave").size() == 5 * 4);
  const auto over = [&lines](const char *value, const char *reference) {
    return lines.at(value)[0] / lines.at(reference)[0];
  };
  check_ratio("speed in contact over that of the free gear",
              over("speed in contact", "speed"),
              2e-2);
  check_ratio("speed of the peak over its prediction",
              over("peak speed", "speed in contact"),
              1e-2);
  check_ratio("width over its prediction", over("width", "predicted width"), .1);
  check_ratio("width over twice the damping ratio",
              over("damping ratio of the width", "damping ratio"),
              .1);
  check_ratio("build-up", over("damping ratio of the build-up", "damping ratio"), .1);
  check_ratio("amplitude over its prediction", over("amplitude", "predicted amplitude"), .1);
  check_ratio("amplitude by the forces", over("amplitude by the forces", "amplitude"), .1);
  check_below("misfit of the curve", lines.at("misfit")[0], 5e-2);
  // Linear theory at five speeds has the pole that it is said to have.
  check_ratio("fit of linear theory over its pole: amplitude",
              over("predicted amplitude by the fit", "predicted amplitude"),
              3e-2);
  check_ratio("fit of linear theory over its pole: width",
              over("predicted width of one resonance", "predicted width"),
              3e-2);
  // Stresses are linear in the amplitude, at the predicted speed and 1 % above.
  const auto &of_wave = stress.at("stress of the wave");
  for (const std::size_t place : {0, 2})
    check_ratio(place == 0 ? "stress of the wave over its amplitude, probe" : "fillet",
                of_wave[12 + place] / of_wave[8 + place] * waves.at("amplitude")[2] /
                  waves.at("amplitude")[3],
                3e-2);
  check_fillets(lines, stress, world);
  check("the wave grows", growth.at("amplitude")[0] < .5 * growth.at("amplitude")[20]);
  check_below("energy", waves.at("energy error")[2], 1e-2);
  check("summary", read_json("driven/summary.json").at("status") == "finished");
  const Columns avoided = read_columns("driven/speeds_to_avoid.csv");
  const double  peak    = lines.at("peak speed")[0];
  check("the speed is to be avoided, with margins",
        lines.at("stress amplification")[0] > 1.05 && avoided.at("from").size() == 1 &&
          avoided.at("from")[0] < .98 * peak && avoided.at("to")[0] > 1.02 * peak);
}

/** Three diameters of a pair of few teeth, whose steps are long and cheap. More points than
 * other tests have keep the ripple of its contact small, which excites both pairs unlike. */
const std::vector<std::string> by_runs = {"Waves/solver=run",
                                          "Reduced/store=bodies_of_runs",
                                          "Waves/nodal diameters=3",
                                          "Waves/lowest speed=22500 rpm",
                                          "Waves/highest speed=23500 rpm",
                                          "Contact/points per facet=12",
                                          "Contact/penalty=300000",
                                          "Fillets/teeth=all",
                                          "Dynamics/mass proportional damping=3000",
                                          "Reduced/settling mesh cycles=10",
                                          "Reduced/recorded mesh cycles=2",
                                          "Waves/settling decay times=1.5",
                                          "Waves/speed offsets=-4 %, 0 %, 4 %",
                                          "Waves/allowed amplification=1.02"};

/** The largest tension of the gear's teeth at the start by another file of the run. */
double tension_at_start(const std::string &folder, const std::string &side)
{
  const Table roots   = read_result_table(folder + "/root_stress.csv");
  double      tension = 0;
  for (std::size_t m = 0; m < roots.n_rows(); ++m)
    if (roots.numbers("time")[m] == 0 && roots.column("body").texts[m] == "gear" &&
        roots.column("fillet").texts[m] == side)
      tension = std::max(tension, roots.numbers("tension")[m]);
  return tension;
}

/** Runs of whole bodies beside reduced pairs: three speeds over the wave's width, twelve tooth
 * meshes each. */
void driven_by_runs(Communicator &world)
{
  run_pair("runs.prm", "runs", world, by_runs);
  const Table   table  = read_result_table("runs/waves_lines.csv");
  const Columns lines  = read_columns("runs/waves_lines.csv"),
                waves  = read_columns("runs/waves_response.csv"),
                stress = read_columns("runs/waves_stress.csv"),
                growth = read_columns("runs/waves_build_up.csv");
  check("a row of the line by each solver, runs first",
        table.n_rows() == 2 && table.column("solver").texts[0] == "run" &&
          table.column("solver").texts[1] == "reduced");
  check("and of speeds, places and meshes",
        waves.at("speed").size() == 6 && stress.at("speed").size() == 24 &&
          growth.at("speed").size() == 24);
  for (const char *name : {"peak speed",
                           "width",
                           "amplitude",
                           "damping ratio of the build-up",
                           "stress amplification",
                           "root amplification",
                           "web amplification"})
    check_ratio(std::string("run over reduced: ") + name,
                lines.at(name)[0] / lines.at(name)[1],
                2e-2);
  check_ratio("width of the run over its prediction",
              lines.at("width")[0] / lines.at("predicted width")[0],
              5e-2);
  check("forces on modes are not known of runs",
        std::isnan(lines.at("amplitude by the forces")[0]));
  const std::vector<double> times = read_columns("runs/line_1_speed_2/probe_waves.csv").at("time");
  const auto                first = std::find_if(times.begin(), times.end(), [](const double t) {
    return t > 0; // what there is at the start is of the equilibrium
  });
  const double              seen  = (times.back() - *first) * lines.at("mesh frequency")[0];
  check("waves of stress are those of the last mesh cycle", seen > .9 && seen < 1. + 1e-9);
  for (const std::size_t k : {0, 1, 2})
    {
      check_ratio("run over reduced: amplitude at a speed",
                  waves.at("amplitude")[k] / waves.at("amplitude")[3 + k],
                  2e-2);
      check_close("phases [deg]", waves.at("phase")[k], waves.at("phase")[3 + k], 2.);
    }
  // At the line: places are two probes and two fillets.
  for (const std::size_t p : {0, 1, 2, 3})
    {
      check_ratio("stress without waves, run over reduced",
                  stress.at("stress without waves")[4 + p] /
                    stress.at("stress without waves")[16 + p],
                  4e-2);
      check_ratio("stress of the wave",
                  stress.at("stress of the wave")[4 + p] / stress.at("stress of the wave")[16 + p],
                  2e-2);
    }
  for (const std::size_t p : {2, 3})
    check_ratio("tension of a fillet in the equilibrium by root_stress.csv",
                stress.at("stress without waves")[4 + p] /
                  tension_at_start("runs/line_1_speed_2", p == 2 ? "concave" : "convex"),
                1e-12);
  const Columns avoided = read_columns("runs/speeds_to_avoid.csv");
  check("speeds to avoid", avoided.at("from").size() == 1);
}

/** Of the runs one is finished, and one has lost its end but has a checkpoint. */
void runs_go_on(Communicator &world)
{
  namespace fs           = std::filesystem;
  const std::string kept = "runs/line_1_speed_1/summary.json",
                    lost = "runs/line_1_speed_2/summary.json";
  const auto    time     = fs::last_write_time(kept);
  const Columns before   = read_columns("runs/waves_response.csv");
  fs::remove(lost);
  fs::remove("runs/waves_response.csv");
  run_pair("runs.prm", "runs", world, by_runs, true);
  check("a finished run is kept", fs::last_write_time(kept) == time);
  check("the other one goes on to its end", fs::exists(lost));
  check("with the same results",
        read_columns("runs/waves_response.csv").at("amplitude") == before.at("amplitude"));
  const std::string log = read_text("runs/run.log");
  check("one was finished, one has gone on from its checkpoint",
        has_text(log, "line_1_speed_1 finished: was finished before") &&
          has_text(log, "line_1_speed_2 finished: continued from a checkpoint"));
}

void refusals(Communicator &world)
{
  const auto refuse = [&](const std::string &entry, const std::string &value) {
    print_refusal([&]() { run_pair("waves.prm", "refused", world, {entry + "=" + value}); });
  };
  refuse("Waves/lowest speed", "12000 rpm");
  refuse("Waves/nodal diameters", "-1");
  refuse("Waves/nodal diameters", "2.5");
  refuse("Waves/nodal diameters", "20");
  refuse("Waves/speed offsets", "0, 1 %");
  refuse("Waves/speed offsets", "0, 60 %, 1 %");
  refuse("Waves/speed offsets", "0, 1 %, 1 %");
  refuse("Waves/diameter", "3");
  refuse("Fillets/teeth", "in contact");
  refuse("Fillets/teeth", "named");
  refuse("Dynamics/mass proportional damping", "0");
  refuse("Operation/driving member", "gear");
  refuse("Waves/solver", "explicit");
  print_refusal([&]() {
    run_pair("waves.prm", "refused", world, {"Waves/solver=run", "Dynamics/start=ramp"});
  });
  print_refusal([&]() {
    run_pair("waves.prm", "refused", world, {"Waves/solver=run", "Reduced/settling mesh cycles=2"});
  });
  print_refusal([&]() { run_pair("waves.prm", "driven", world, {}, true); });
}

int main(int argc, char **argv)
{
  for (const char *folder : {"plain_bodies", "bodies_of_runs"})
    std::filesystem::remove_all(folder);
  write_file("waves.prm", coarse_pair("set body type = conical web", coarse_web));
  write_file("runs.prm", few_teeth("set body type = conical web", coarse_web));
  run_parts(argc,
            argv,
            {prediction, choice, in_contact, driven, driven_by_runs, runs_go_on, refusals});
  return 0;
}
