// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Vibrations of a pair in contact: stiff bodies against one spring and one inertia; shapes that
// stand in space against waves of the turning gear; tangent stiffness; the study writes them.
#include "../../model_sections.h"
#include "../../parts.h"
#include "../../refusal.h"
#include "../../vtu_file.h"
#include "../gear_model.h"
#include "../quick_pair.h"

#include <vfife/fem/modes/rotating_body.h>
#include <vfife/fem/pair/coupled_modes.h>

#include <filesystem>

using namespace vfife;

/** The pair without what a run asks for besides. */
Model make_model(const std::string &gear_body,
                 const std::string &gear_mesh,
                 const std::string &more,
                 Communicator      &world)
{
  const std::string all = quick_pair(gear_body, gear_mesh, "1e-5");
  std::ofstream("coupled.prm") << all.substr(0, all.find("subsection Dynamics")) << more;
  return make_gear_model("coupled.prm", world);
}

FemOptions lumped_masses()
{
  FemOptions fem;
  fem.mass = MassKind::lumped;
  return fem;
}

void stiff_bodies(Communicator &world)
{
  const Model        model = make_model("set body type = rim only",
                                 "set elements through rim = 2",
                                 "subsection Operation\n set bore rotation = rigid\nend\n"
                                        "subsection Material steel\n set Young's modulus = 2.06e8\nend\n"
                                        "subsection Contact\n set penalty = 3e4\nend\n",
                                 world);
  const FemOptions   fem   = lumped_masses();
  Compliance         compliance(model, fem, false, world);
  PairEquilibrium    equilibrium(model, compliance, {0.});
  const auto         at_rest = equilibrium.solve(0., 1.);
  const CoupledModes modes = find_coupled_modes(compliance, fem, false, at_rest.ties, {}, 3, world);

  const Transmission &t = *model.only_transmission();
  const double        turn =
    at_rest.turn_slope +
    mean_rotation(compliance.space(), t.driven, t.driven_bore, at_rest.displacement_slope);
  const double stiffness = 8e5 / std::abs(turn);
  // Directions of the springs are those of the loaded place there and here; arms are not.
  check_ratio("tangent stiffness of the equilibrium", modes.stiffness / stiffness, 1e-3);
  const double frequency = std::sqrt(stiffness / model.bodies[t.driven].axial_inertia()) / (2 * pi);
  // Steel a thousand times as stiff still gives way by some thousandths of the contact.
  check_ratio("one inertia on one spring", modes.turning[0].frequency / frequency, 1e-2);
  check_ratio("it is the whole turn", modes.turning[0].share_of_turn, 1e-2);
  check_ratio("of the gear alone", modes.turning[0].driven_energy, 1e-2);
  check("modes are counted", modes.counted);
  double shares = 0;
  for (const CoupledMode &mode : modes.turning)
    shares += mode.share_of_turn;
  check("shares of the turn are not more than all", shares < 1 + 1e-9);

  const std::string refusal = entry_and_message_of(
    [&] { find_coupled_modes(compliance, fem, false, at_rest.ties, {}, 100000, world); });
  check("too many coupled modes are refused",
        has_text(refusal, "100000 coupled modes require 200010 modes in the rotating frame"));
  check("in the name of their entry", has_text(refusal, "Loaded contact/coupled modes: "));
}

void standing_waves(Communicator &world)
{
  const Model     model = make_model("set body type = conical web",
                                 coarse_web,
                                 "subsection Contact\n set penalty = 6e5\nend\n",
                                 world);
  FemOptions      fem   = lumped_masses();
  Compliance      compliance(model, fem, true, world);
  PairEquilibrium equilibrium(model, compliance, {0.});
  auto            ties = equilibrium.solve(0., 1.).ties;
  // A contact so weak that it only keeps the hub from turning away: the bodies alone.
  for (ContactTie &tie : ties)
    tie.stiffness *= 1e-7;
  const CoupledModes modes = find_coupled_modes(compliance, fem, true, ties, {}, 9, world);

  fem.n_modes               = 9;
  fem.coriolis              = true;
  const unsigned int driven = model.only_transmission()->driven;
  const double       rate   = model.bodies[driven].rate;
  const RotatingBody body(model, driven, fem, world);
  unsigned int       compared = 0;
  double             largest  = 0;
  for (const RotatingMode &wave : body.find_modes(rate).modes)
    {
      const ModeDescription &d = wave.description;
      if (wave.frequency < 100 || wave.frequency > 2000 || d.nodal_diameter > 2)
        continue;
      // Waves with the spin are faster in space.
      const double sense    = d.nodal_diameter == 0 ? 0. : d.forward > .5 ? 1. : -1.;
      const double in_space = wave.frequency + sense * d.nodal_diameter * std::abs(rate) / (2 * pi);
      double       nearest  = 1;
      for (const CoupledMode &mode : modes.standing)
        nearest = std::min(nearest, std::abs(mode.frequency / in_space - 1));
      raise_to(largest, nearest);
      ++compared;
    }
  check("waves were compared", compared >= 4);
  // All turn is that of the hub against the weak tie: one motion that is no wave of the body.
  double turn = 0;
  for (const CoupledMode &mode : modes.standing)
    raise_to(turn, mode.share_of_turn);
  check_ratio("the static turn is the hub's against the contact", turn, 1e-3);
  // Derivatives over 79 sectors, two waves: (2 h)^4/30 = 2e-5; the basis of 28 modes; the weak
  // tie.
  check_below("standing shapes are the waves of the turning gear", largest, 1e-3);
}

void study(Communicator &world)
{
  std::filesystem::remove_all("coupled_modes_results");
  std::ofstream("coupled.prm") << quick_pair("set body type = rim only",
                                             "set elements through rim = 2",
                                             "1e-5")
                               << model_text::loaded_contact(1, "set coupled modes = 4\n");
  run_pair("coupled.prm", "coupled_modes_results", world);
  const Table modes = read_result_table("coupled_modes_results/coupled_modes.csv");
  const auto &axes  = modes.column("axes").texts;
  check("four modes each, in turning axes and standing",
        modes.n_rows() == 8 && std::count(axes.begin(), axes.end(), "rotating") == 4 &&
          std::count(axes.begin(), axes.end(), "fixed") == 4);
  // The pair swings as the gear on the mesh, the pinion held at its bore: without a web the gear
  // is nearly rigid beside the contact. The stiffness is that of the loaded equilibrium.
  auto         positions = read_columns("coupled_modes_results/loaded_contact.csv");
  const double stiffness = positions["tangent stiffness"][0]; // [N m/rad]
  const Model  model =
    make_model("set body type = rim only", "set elements through rim = 2", "", world);
  const double inertia =
    1e-3 * model.bodies[model.only_transmission()->driven].axial_inertia(); // [kg m^2]
  double shares = 0, apart = 1;
  for (std::size_t i = 0; i < 4; ++i)
    {
      check("numbered", modes.numbers("mode")[i] == i + 1);
      shares += modes.numbers("share of the static rotation")[i];
      if (modes.numbers("share of the static rotation")[i] > .5)
        apart = modes.numbers("frequency")[i] / (std::sqrt(stiffness / inertia) / (2 * pi)) - 1;
    }
  check_below("swing over one inertia on one spring, less one", apart, .1);
  check("shares of the turn: less than all", shares > .8 && shares < 1);
  // Real parts of the standing shapes are drawn, scaled over both bodies.
  const VtuFile gear("coupled_modes_results/modes/coupled_gear.vtu"),
    pinion("coupled_modes_results/modes/coupled_pinion.vtu");
  for (unsigned int k = 1; k <= 4; ++k)
    {
      double largest = 0;
      for (const VtuFile *file : {&gear, &pinion})
        for (std::size_t i = 0; i < file->n_points(); ++i)
          raise_to(largest, file->vector(file->find("mode " + std::to_string(k) + ","), i).norm());
      check("shapes of at most 1 mm", largest > .1 && largest < 1 + 1e-6);
    }
}

/** Made-up modes whose numbers all differ. */
void table(Communicator &)
{
  CoupledModes modes;
  modes.turning.resize(2);
  modes.standing.resize(1);
  CoupledMode &mode           = modes.turning[1];
  mode.frequency              = 101;
  mode.share_of_turn          = .02;
  mode.driven_energy          = .03;
  mode.driven.nodal_diameter  = 4;
  mode.driven.share           = .05;
  mode.driven.axial           = .06;
  mode.driven.radial          = .07;
  mode.driven.tangential      = .08;
  modes.standing[0].frequency = 109;
  Table table                 = make_coupled_mode_table();
  add_coupled_modes(modes, table);
  const auto value = [&table](const char *name) { return table.numbers(name)[1]; };
  check("table: rows",
        table.column("axes").texts == std::vector<std::string>({"rotating", "rotating", "fixed"}) &&
          table.numbers("mode") == std::vector<double>({1, 2, 1}));
  check("table: each number in its column",
        value("frequency") == 101 && value("share of the static rotation") == .02 &&
          value("energy in the gear") == .03 && value("nodal diameter of the gear") == 4 &&
          value("share of the diameter") == .05 && value("axial") == .06 &&
          value("radial") == .07 && value("tangential") == .08 &&
          table.numbers("frequency")[2] == 109);
}

int main(int argc, char **argv)
{
  run_parts(argc, argv, {stiff_bodies, standing_waves, study, table});
  return 0;
}
