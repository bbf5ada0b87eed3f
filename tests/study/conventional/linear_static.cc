// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Study kind linear static against closed forms: loads, springs, histories, reactions, prescribed
// displacements, spin; what it refuses; a gear pair's members in their turning axes. Of kind
// static, what its message says where one step is too large.
#include "../../parts.h"
#include "../../refusal.h"
#include "../../vtu_file.h"
#include "../gear_model.h"
#include "../prescribed_ring.h"
#include "../quick_pair.h"

#include <vfife/output/files/run_figures.h>

#include <filesystem>

using namespace vfife;

using Columns = std::map<std::string, std::vector<double>>;

Columns run_static(const std::string &name, const std::string &text, Communicator &world)
{
  return run_text(name, model_text::study("linear static") + text, world);
}

constexpr double E = 206000, length = 100, side = 10;

/** A bar of 100 x 10 x 10 mm, nu = 0, with loads on its end; @p support: of the other end. */
std::string bar(const std::string &support, const std::string &load, const std::string &more = "")
{
  return R"(
subsection Model
  set bodies      = bar
  set constraints = foot
  set loads       = load
  set probes      = tip, corner
)" + model_text::block("bar", {{100, 10, 10}}, {{10, 2, 2}}) +
         model_text::section("Constraint foot", "set nodes = x-\n" + support + "\n") +
         model_text::section("Load load", "set nodes = x+\n" + load + "\n") +
         model_text::probe("tip", "100, 5, 5 mm") + model_text::probe("corner", "50, 5, 10 mm") +
         more + "end\n" + model_text::no_contraction() + quiet_output();
}

void pulled(Communicator &world)
{
  const double stretch = 1000. * length / (E * side * side);
  const auto   check_pulled =
    [&](const std::string &name, const std::string &text, const double factor) {
      auto h = run_static("linear_bar", text, world);
      // The solver's tolerance is 1e-10.
      check_close(name + ": displacement over F L/(E A)",
                  h["tip displacement x"].back() / stretch,
                  factor,
                  1e-8);
      check_close(name + ": stress [MPa]", h["corner stress x"].back(), 10. * factor, 1e-6);
    };
  const std::string fixed = "set kind = fixed",
                    force = "set kind = force\nset force = 1000, 0, 0 N";
  check_pulled("force", bar(fixed, force), 1.);
  check_pulled("pressure", bar(fixed, "set kind = pressure\nset pressure = -10 MPa"), 1.);
  check_pulled("history",
               bar(fixed, force + "\nset history = 3*t") +
                 "subsection Linear static\n set loads = at time\n set time = 0.5 s\nend\n",
               1.5);
  check_pulled(
    "quadratic elements, direct solver",
    bar(fixed, "set kind = pressure\nset pressure = -10 MPa") +
      "subsection Fem\n set linear solver = direct\n set element type = quadratic\nend\n",
    1.);

  auto h = run_static("linear_bar",
                      bar("set kind = spring\nset stiffness = 5000, 5000, 5000 N/mm", force),
                      world);
  check_ratio("spring: displacement over F/k + F L/(E A)",
              h["tip displacement x"].back() / (1000. / 5000 + stretch),
              1e-8);
  check_ratio("spring: energy over that of spring and bar",
              h["strain energy"].back() / (500. * (1000. / 5000 + stretch)),
              1e-8);
}

/** Bent to the curvature @p k about -y, nu = 0: u_z = k x^2/2, u_x = -k x (z - 5), sigma_x = -E k
 * (z - 5), which is told in cylindrical axes about the line along z
 * through the middle. */
void check_bent_fields(const VtuFile &fields, const double k)
{
  double displacement = 0, stress = 0, mises = 0, principal = 0;
  for (std::size_t i = 0; i < fields.n_points(); ++i)
    {
      const Vector3 x = fields.point(i), u(-k * x[0] * (x[2] - 5), 0., k * x[0] * x[0] / 2);
      raise_to(displacement, (fields.vector("displacement", i) - u).norm());
      const double s = -E * k * (x[2] - 5);
      raise_to(mises, std::abs(fields.number("von mises", i) - std::abs(s)));
      principal        = largest_of({principal,
                                     std::abs(fields.number("principal stress 1", i) - std::max(s, 0.)),
                                     std::abs(fields.number("principal stress 2", i)),
                                     std::abs(fields.number("principal stress 3", i) - std::min(s, 0.)),
                                     std::abs(fields.values("stress", i)[0] - s)});
      const double phi = std::atan2(x[1] - side / 2, x[0] - length / 2), c = std::cos(phi),
                   d = std::sin(phi);
      if (std::hypot(x[0] - length / 2, x[1] - side / 2) < 1e-6)
        continue; // no direction r
      stress = largest_of({stress,
                           std::abs(fields.number("stress r", i) - s * c * c),
                           std::abs(fields.number("stress theta", i) - s * d * d),
                           std::abs(fields.number("stress r theta", i) + s * c * d),
                           std::abs(fields.number("stress z", i)),
                           std::abs(fields.number("stress theta z", i)),
                           std::abs(fields.number("stress z r", i))});
    }
  check("fields: points that 40 cells share, twelve arrays",
        fields.n_cells() == 40 && fields.n_points() == 99 && fields.n_arrays() == 12);
  // Single precision of 0.6 mm and 120 MPa.
  check_below("fields: displacement [mm]", displacement, 1e-7);
  check_below("fields: stresses [MPa]", stress, 2e-5);
  check_below("fields: von mises [MPa]", mises, 2e-5);
  check_below("fields: principal stresses, stress along the bar [MPa]", principal, 2e-5);
}

void bent(Communicator &world)
{
  // Plane sections and a linear field of strains: exact with incompatible modes.
  auto         h   = run_static("linear_bent",
                      bar("set kind = fixed", "set kind = moment\nset moment = 0, -20000, 0 N mm"),
                      world);
  const double I   = side * side * side * side / 12;
  const double sag = 20000. * length * length / (2 * E * I);
  check_ratio("moment: deflection over M L^2/(2 E I)", h["tip displacement z"].back() / sag, 1e-8);
  check_ratio("moment: stress over M z/I", h["corner stress x"].back() / (-20000. * 5 / I), 1e-8);
  check_bent_fields(VtuFile("linear_bent/fields/bar.vtu"), 20000. / (E * I));
  // Work of the moment on the turn of the end.
  const std::string summary = "linear_bent/summary.json", figures = "/figures/";
  check_ratio("moment: strain energy over M^2 L/(2 E I)",
              read_figure(summary, figures + "strain energy") /
                (20000. * 20000. * length / (2 * E * I)),
              1e-8);
  // At the upper and lower edges of the end: sag and turn.
  check_close("moment: largest displacement [um]",
              read_figure(summary, figures + "largest displacement"),
              1e3 * std::hypot(sag, 20000. * length / (E * I) * 5),
              1e-6);
  check_close("moment: largest von mises [MPa]",
              read_figure(summary, figures + "largest von mises"),
              20000. * 5 / I,
              1e-6);

  // About the bar's axis, along z through its centre: both forces of 200 N have an arm of 50 mm.
  run_static("linear_bent",
             bar("set kind = fixed", "set kind = force\nset force = 0, 200, 0 N"),
             world);
  const auto reactions = read_columns("linear_bent/reactions.csv");
  check_close("reaction y [N]", reactions.at("force y").front(), -200., 1e-5);
  check_below("reaction x [N]", reactions.at("force x").front(), 1e-5);
  check_close("reaction about the axis [N m]",
              reactions.at("torque about the axis").front(),
              -10.,
              1e-6);
}

void spun(Communicator &world)
{
  std::filesystem::remove_all("linear_spun");
  CommandLine line;
  line.parameter_file = tree_folder() + "/prm/verification/rotating_bar.prm";
  line.output_folder  = "linear_spun";
  line.overrides      = {"Study/kind=linear static",
                         "Output/verbosity=quiet",
                         "Fem/mass=consistent",
                         "Linear static/stress stiffness=no"};
  std::ostringstream nothing;
  Log                log(nothing, world.is_root(), Verbosity::quiet);
  run_study(line, world, log);
  // L (tan(kL)/(kL) - 1); 100 elements: (kL)^2/(12 100^2) of it.
  check_close("spinning bar, load on the moved mass [mm]",
              read_columns("linear_spun/history.csv")["end displacement x"].back(),
              15.1572,
              2e-4);
  line.overrides.back() = "Linear static/spin softening=no";
  line.overrides.push_back("Linear static/stress stiffness=no");
  run_study(line, world, log);
  check_close("spinning bar, linear [mm]",
              read_columns("linear_spun/history.csv")["end displacement x"].back(),
              14.6250,
              2e-4);
}

void prescribed_ring_cases(Communicator &world)
{
  auto         ring = run_static("linear_ring", prescribed_ring() + quiet_output(), world);
  const double a = 20, b = 40, nu = 0.29;
  // Lame, plane stress; chords of 6 degrees, ten cells: some 1e-3.
  const double grown = 0.01 * ((1 - nu) * b + (1 + nu) * b) / ((1 - nu) * a + (1 + nu) * b * b / a);
  check_ratio("prescribed radius: growth outside over Lame's",
              ring["outer displacement r"].back() / grown,
              5e-3);
  check_ratio("prescribed angle: way outside over r phi",
              ring["outer displacement theta"].back() / (40 * pi / 360),
              1e-8);
}

/** The gear alone at 20,000 rpm of the pinion: energy against the work of the centrifugal force,
 * probes against the fields. */
void check_spun_gear(Communicator &world)
{
  const Model   model = make_gear_model("linear_pair_case.prm", world);
  const Body   &gear  = model.bodies[model.only_transmission()->driven];
  const VtuFile fields("linear_pair/fields/gear.vtu");
  // Points of a file are the nodes.
  double places = 0;
  for (unsigned int n = 0; n < gear.n_nodes(); ++n)
    raise_to(places, (fields.point(n) - gear.placement(gear.node_positions()[n])).norm());
  check_below("pair: places of the nodes [mm]", places, 2e-5);

  // The load grows with the displacement: the energy is half of sum m Omega^2 r . u.
  const double rate = 20000. * 2 * pi / 60 * 27 / 79;
  double       work = 0;
  for (unsigned int n = 0; n < gear.n_nodes(); ++n)
    {
      const Vector3 x = gear.placement(gear.node_positions()[n]) - gear.axis.point,
                    r = x - x.dot(gear.axis.direction) * gear.axis.direction;
      work += gear.node_masses()[n] * rate * rate * r.dot(fields.vector("displacement", n));
    }
  check_ratio("pair: strain energy over half the work of the spin",
              read_figure("linear_pair/summary.json", "/figures/strain energy") / (work / 2),
              1e-6);
  // Figures are the largest of the fields.
  double displacement = 0, mises = 0;
  for (std::size_t i = 0; i < fields.n_points(); ++i)
    {
      raise_to(displacement, fields.vector("displacement", i).norm());
      raise_to(mises, fields.number("von mises", i));
    }
  check_ratio("pair: largest displacement [um]",
              read_figure("linear_pair/summary.json", "/figures/largest displacement") /
                (1e3 * displacement),
              1e-6);
  check_ratio("pair: largest von mises",
              read_figure("linear_pair/summary.json", "/figures/largest von mises") / mises,
              1e-6);

  const Table                     probes = read_result_table("linear_pair/probes.csv");
  const std::vector<std::string> &names  = probes.column("probe").texts;
  check("a row for each probe of the pair", names.size() == model.probes.size());
  double of_displacement = 0, of_stress = 0;
  for (std::size_t p = 0; p < names.size(); ++p)
    {
      const Probe      &probe = model.probes[p];
      const std::size_t i     = probe.node;
      const Vector3     x     = gear.placement(gear.node_positions()[probe.node]) - gear.axis.point,
                    z = gear.axis.direction, r = (x - x.dot(z) * z).normalized();
      const Vector3 axes[]  = {r, z.cross(r), z};
      const char   *along[] = {"r", "theta", "z"};
      check("probe " + names[p] + ": on the gear",
            names[p] == probe.name && probe.body == model.only_transmission()->driven);
      for (unsigned int c = 0; c < 3; ++c)
        {
          raise_to(of_displacement,
                   std::abs(probes.numbers(std::string("displacement ") + along[c])[p] -
                            1e3 * axes[c].dot(fields.vector("displacement", i))));
          for (const std::string &stress :
               {std::string("stress ") + along[c],
                std::string("stress ") + along[c] + " " + along[(c + 1) % 3]})
            raise_to(of_stress, std::abs(probes.numbers(stress)[p] - fields.number(stress, i)));
        }
      raise_to(of_stress, std::abs(probes.numbers("von mises")[p] - fields.number("von mises", i)));
    }
  // Single precision of some 50 um and 300 MPa.
  check_below("probes and fields: displacement [um]", of_displacement, 1e-5);
  check_below("probes and fields: stresses [MPa]", of_stress, 1e-4);
}

void pair(Communicator &world)
{
  std::filesystem::remove_all("linear_pair");
  // The model that the study makes, for what it is given.
  const std::string all = quick_pair("set body type = conical web", coarse_web, "1e-5");
  std::ofstream("linear_pair_case.prm") << all.substr(0, all.find("subsection Dynamics"));
  std::ofstream("linear_pair.prm")
    << quick_pair("set body type = conical web", coarse_web, "1e-5")
    << model_text::study("linear static")
    << "subsection Fem\n set bodies = gear\nend\nsubsection Linear static\n set spin softening = "
       "no\n set stress stiffness = "
       "no\nend\n";
  run_pair("linear_pair.prm", "linear_pair", world);
  check_spun_gear(world);
}

void refused(const std::string &text, Communicator &world)
{
  print_refusal([&] { run_static("linear_refused", text, world); });
}

void errors(Communicator &world)
{
  const std::string force = "set kind = force\nset force = 1, 0, 0 N";
  refused(bar("set kind = fixed",
              force,
              "set contacts = floor\nsubsection Contact floor\nset kind = wall\nset nodes = z-\n"
              "set wall normal = 0, 0, 1\nend\n"),
          world);
  refused(bar("set kind = displacement\nset directions = x", force), world);
  refused(bar("set kind = fixed", force) + "subsection Linear static\nset time = 1 s\nend\n",
          world);
  refused(bar("set kind = fixed", force) + "subsection Fem\nset cyclic symmetry = yes\nend\n",
          world);
  // Nothing is left to be solved for, whatever solves.
  std::string       held  = bar("set kind = fixed", force);
  const std::string nodes = "set nodes = x-";
  held.replace(held.find(nodes), nodes.size(), "set nodes = all");
  for (const char *solver : {"direct", "multigrid"})
    refused(held + "subsection Fem\nset linear solver = " + solver + "\nend\n", world);
}

/** A bar of 50 mm whose foot turns by half a turn about its middle: the tip moves by its length.
 */
void half_turn(Communicator &world)
{
  const auto text = [](const unsigned int steps) {
    return model_text::study("static") + R"(
subsection Model
  set bodies      = bar
  set constraints = foot
  set probes      = tip
)" + model_text::block("bar", {{50, 5, 5}}, {{10, 2, 2}}) +
           model_text::section("Constraint foot",
                               "set nodes = x-\nset kind = angle\nset angle = 180 deg\n") +
           model_text::probe("tip", "50, 0, 0 mm") + "end\n" +
           "subsection Dynamics\n  subsection Relaxation\n    set load steps = " +
           std::to_string(steps) + "\n  end\nend\n" + quiet_output(1);
  };
  check("half a turn at once: load steps are named",
        has_text(message_of<NumericalError>([&] { run_text("half_turn", text(1), world); }),
                 "Dynamics/Relaxation/load steps = 4"));
  auto h = run_text("half_turn", text(4), world);
  check_close("half a turn in four steps [mm]", h["tip displacement x"].back(), -50., 1e-5);
  check_below("half a turn, across [mm]", std::abs(h["tip displacement z"].back()), 1e-5);
}

int main(int argc, char **argv)
{
  run_parts(argc, argv, {pulled, bent, spun, prescribed_ring_cases, pair, errors, half_turn});
  return 0;
}
