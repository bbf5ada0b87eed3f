// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// pattern.csv and teeth.csv of made-up contact, read back: every number against a closed form of
// what was put in.
#include "../made_state.h"
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_reader.h>
#include <vfife/output/observers/pattern_writer.h>
#include <vfife/output/observers/teeth_writer.h>

#include <filesystem>

using namespace vfife;

const std::string folder_name = "contact_tables_results";

/** Rings of 24 teeth: the outer surface of the one slides on the inner one of the other. */
Model make_model()
{
  Model model = model_of(Body("pinion", make_ring(20, 30, 5, {{2, 24, 2}}), Material()));
  model.add_body(Body("gear", make_ring(30, 40, 8, {{2, 24, 1}}), Material()));
  model.contacts.push_back(contact_of("drive", {0, "outer"}, {1, "inner"}));
  model.contacts.push_back(contact_of("coast", {1, "inner"}, {0, "outer"}));
  Transmission pair;
  pair.driver         = 0;
  pair.driven         = 1;
  model.transmissions = {pair};
  return model;
}

/** The node of tooth @p k (at 15 k degrees) at radius and height. */
unsigned int node_at(
  const Model &model, const unsigned int b, const double r, const unsigned int k, const double z)
{
  const Body   &body = model.bodies[b];
  const Vector3 place(r * std::cos(k * pi / 12), r * std::sin(k * pi / 12), z);
  for (unsigned int i = 0; i < body.n_nodes(); ++i)
    if ((body.node_positions()[i] - place).norm() < 1e-9)
      return body.first_node + i;
  throw std::runtime_error("no such node");
}

void pattern(const OutputFolder &folder)
{
  const Model   model = make_model();
  PatternWriter writer(folder, model, 2e-3, 10);
  State         state = undeformed_state(model);
  state.dt            = 1e-5;
  const auto show     = [&](const double                                         time,
                        const std::uint64_t                                  step,
                        const std::vector<std::pair<unsigned int, Vector3>> &forces) {
    for (std::size_t i = 0; i < model.n_nodes(); ++i)
      state.contact_force.set(i, Vector3::Zero());
    for (const auto &force : forces)
      state.contact_force.set(force.first, force.second);
    state.time = time;
    state.step = step;
    writer.observe(model, state);
  };
  const unsigned int low = node_at(model, 0, 30, 3, 0.), other = node_at(model, 0, 30, 7, 0.),
                     middle  = node_at(model, 0, 30, 5, 2.5),
                     of_gear = node_at(model, 1, 30, 11, 8.);
  // Before the last mesh cycle and between samples nothing counts.
  show(1.99e-3, 190, {{low, Vector3(1e6, 0., 0.)}});
  show(2.05e-3, 205, {{low, Vector3(1e6, 0., 0.)}});
  // Round-off of the time does not cost the first sample.
  show(2e-3 - 4e-6, 200, {{low, Vector3(2., 3., 6.)}, {middle, Vector3(0., -40., 30.)}});
  show(2.1e-3, 210, {{other, Vector3(8., -4., 8.)}, {of_gear, Vector3(0., 0., -11.)}});
  show(2.2e-3, 220, {{low, Vector3(0., 10., 0.)}, {middle, Vector3(0., 0., 20.)}});
  writer.finish(model, state);

  const Table table = read_result_table(folder.file("pattern.csv"));
  // Facets are chords of 15 degrees; a node at a rim has two quarters of one, one between has
  // four.
  const double chord = 2 * 30 * std::sin(pi / 24);
  // The largest at each place over all teeth and instants: 12 N of tooth 7 against 10 and 7 N.
  const std::map<std::pair<std::string, double>, double> expected = {
    {{"pinion", 0.}, 12. / (chord * 2.5 / 2)},
    {{"pinion", 2.5}, 50. / (chord * 2.5)},
    {{"pinion", 5.}, 0.},
    {{"gear", 0.}, 0.},
    {{"gear", 8.}, 11. / (chord * 8 / 2)}};
  check("pattern: a row for each place of a tooth and side", table.n_rows() == 2 * 5);
  unsigned int n_drive = 0;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    {
      const std::string &body = table.column("body").texts[i];
      const double       z    = table.numbers("z")[i];
      n_drive += table.column("side").texts[i] == "drive";
      check_close("pattern: radius", table.numbers("r")[i], 30., 1e-12);
      // Both sides share the surfaces here, and what they carry.
      const auto found = expected.find({body, z});
      check_close("pattern: " + body + ", height " + std::to_string(z),
                  table.numbers("largest pressure")[i],
                  found == expected.end() ? NAN : found->second,
                  1e-12);
    }
  check("pattern: both sides", n_drive == 5);

  // Of 12 N at the end and 50 N in the middle of a tooth.
  ContactPattern whole(model);
  whole.add([&](const unsigned int b, const unsigned int node) {
    const unsigned int global = model.bodies[b].first_node + node;
    return global == low ? 12. : global == middle ? 50. : 0.;
  });
  const Vector2 centre = whole.flanks()[0].centre();
  check_close("pattern: radius of its centre", centre[0], 30., 1e-12);
  check_close("pattern: height of its centre", centre[1], 2.5 * 50 / 62, 1e-12);
  check("pattern: no centre where nothing is carried", std::isnan(whole.flanks()[1].centre()[0]));
}

void teeth(const OutputFolder &folder)
{
  const Model  model = make_model();
  const double R = 50, modulus = 1.1e5;
  TeethWriter  writer(folder, model, 20, HertzContact(Vector2(1 / R, 1 / R), modulus));
  State        state;
  state.time = .25e-3;
  state.step = 40;
  ToothContact tooth;
  tooth.slave_group      = 3;
  tooth.master_group     = 17;
  tooth.force            = Vector3(2, -3, 6);
  tooth.torque           = 2500;
  tooth.normal_force     = 6.5;
  tooth.largest_pressure = 41;
  tooth.area             = 2.5;
  state.measured.teeth.push_back(tooth);
  tooth.contact      = 1;
  tooth.slave_group  = 12;
  tooth.master_group = 5;
  tooth.area         = 0; // nothing to share it
  state.measured.teeth.push_back(tooth);
  writer.observe(model, state);
  writer.finish(model, state);
  const Table table = read_result_table(folder.file("teeth.csv"));
  const auto  value = [&table](const char *name, const unsigned int row) {
    return table.numbers(name).at(row);
  };
  check("teeth: time", value("time", 0) == .25e-3);
  // The driver's tooth first: the gear is the slave on the coast side.
  check("teeth: which ones",
        value("pinion tooth", 0) == 3 && value("gear tooth", 0) == 17 &&
          value("pinion tooth", 1) == 5 && value("gear tooth", 1) == 12 &&
          table.column("side").texts == std::vector<std::string>({"drive", "coast"}));
  check_close("teeth: force [N]", value("force", 0), 7., 1e-14);
  check_close("teeth: torque [N m]", value("torque", 0), 2.5, 1e-14);
  check_close("teeth: largest pressure [MPa]", value("largest pressure", 0), 41., 0.);
  check_close("teeth: area [mm^2]", value("area", 0), 2.5, 0.);
  check_close("teeth: mean pressure [MPa]", value("mean pressure", 0), 2.6, 1e-14);
  check_close("teeth: without area none", value("mean pressure", 1), 0., 0.);
  // A sphere of radius R: p0^3 = 6 F E*^2/(pi^3 R^2) under the normal force.
  check_ratio("teeth: hertz pressure [MPa]",
              value("hertz pressure", 0) /
                std::cbrt(6 * 6.5 * modulus * modulus / (pi * pi * pi * R * R)),
              1e-9);
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  std::filesystem::remove_all(folder_name);
  const OutputFolder folder(folder_name, session.world());
  pattern(folder);
  teeth(folder);
  return 0;
}
