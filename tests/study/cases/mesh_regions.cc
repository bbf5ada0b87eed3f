// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies from the regions of one mesh file: the same as from a file for each, in all formats that
// tell regions; volumes that nothing joins are no body unless that is asked for.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../quick_pair.h"
#include "region_meshes.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/files/mesh_import.h>

using namespace vfife;
using region_meshes::Box;

const Box lower = {1, "lower", Vector3(0, 0, 0), Vector3(6, 6, 4), {{3, 3, 2}}, 11, 12};
const Box upper = {2, "upper", Vector3(1, 1, 4), Vector3(4, 4, 4), {{2, 2, 2}}, 13, 14};

bool same_mesh(const BodyMesh &one, const BodyMesh &other)
{
  const auto &cells = one.triangulation, &others = other.triangulation;
  bool        same = cells.n_active_cells() == others.n_active_cells() &&
              cells.get_vertices() == others.get_vertices() && one.node_sets == other.node_sets &&
              one.regions == other.regions && one.boundaries == other.boundaries &&
              one.surfaces.size() == other.surfaces.size();
  auto at = others.begin_active();
  for (const auto &cell : cells.active_cell_iterators())
    {
      if (!same)
        return false;
      for (const unsigned int v : cell->vertex_indices())
        same = same && cell->vertex_index(v) == at->vertex_index(v);
      ++at;
    }
  for (const auto &[name, surface] : one.surfaces)
    same = same && other.surfaces.count(name) == 1 && !surface.facets.empty() &&
           surface.facets == other.surfaces.at(name).facets &&
           surface.nodes == other.surfaces.at(name).nodes;
  return same;
}

/** Either of two boxes in one file against the file of that box. */
void compare_files(const std::string &format)
{
  const bool joined_names   = has_text(format, "msh");
  const auto both           = "both." + format;
  const auto meshes         = {std::make_pair(lower, 1), std::make_pair(upper, 2)};
  bool       same_by_number = true, same_by_name = true;
  region_meshes::write(both, region_meshes::make({lower, upper}));
  for (const auto &[box, number] : meshes)
    {
      const auto alone = box.name + "." + format;
      region_meshes::write(alone, region_meshes::make({box}));
      const auto name = joined_names ? box.name : "region " + std::to_string(number);
      const auto mesh = read_body(alone);
      same_by_number =
        same_by_number && same_mesh(*read_body(both, {std::to_string(number)}), *mesh);
      same_by_name = same_by_name && same_mesh(*read_body(both, {name}), *mesh);
    }
  check(format + ": regions by number", same_by_number);
  check(format + ": regions by name", same_by_name);
  check(format + ": parts",
        count_parts(*read_body(both)) == 2 && count_parts(*read_body(both, {"2"})) == 1);
  print_refusal([&] { read_body(both, {"middle"}); });

  // Boxes with common nodes: the interface is a surface of both, and what belongs to the other
  // box is of none although it has nodes of it.
  Box on_top       = upper;
  on_top.corner    = {2, 2, 4};
  on_top.bottom    = 15;
  Box        below = lower;
  const auto file  = "joined." + format;
  region_meshes::write(file, region_meshes::make({below, on_top}, true));
  if (format == "unv") // deal.II has ids of faces on the boundary alone
    return print_refusal([&] { read_body(file, {"1"}); });
  const auto one = read_body(file, {"1"}), other = read_body(file, {"2"});
  const auto interface = joined_names ? "upper bottom" : "boundary 15";
  check(format + ": the interface is of both",
        one->surfaces.count(interface) == 1 && one->surfaces.at(interface).facets.size() == 4 &&
          other->surfaces.at(interface).facets.size() == 4);
  const auto top = joined_names ? "lower top" : "boundary 12";
  check(format + ": what is above alone is not below",
        one->surfaces.at(top).facets.size() == 9 && one->surfaces.size() == 3 &&
          one->triangulation.n_active_cells() == 18);
  check(format + ": one part", count_parts(*read_body(file, {"1", "2"})) == 1);
}

/** The upper box falls on the lower one, which lies on its bottom. */
std::string model(const std::string &of_lower, const std::string &of_upper)
{
  using model_text::section;
  const auto body = [](const std::string &name, const std::string &entries) {
    return section("Body " + name, "set mesh = file\n" + entries);
  };
  return section("Model",
                 "set bodies = anvil, hammer\nset constraints = ground\nset contacts = face\n"
                 "set probes = corner\n" +
                   body("anvil", of_lower) +
                   body("hammer", of_upper + "set velocity = 0.1, 0, -2 m/s\n") +
                   section("Constraint ground",
                           "set kind = fixed\nset body = anvil\nset nodes = lower bottom\n") +
                   section("Contact face",
                           "set slave body = hammer\nset slave surface = upper bottom\n"
                           "set master body = anvil\nset master surface = lower top\n") +
                   section("Probe corner", "set body = hammer\nset point = 1, 1, 8 mm\n")) +
         section("Dynamics", "set end time = 8 us\n") + quiet_output(1);
}

void compare_runs(Communicator &world)
{
  const auto apart =
    run_text("apart", model("set file = lower.msh\n", "set file = upper.msh\n"), world);
  const auto together = run_text("together",
                                 model("set file = both.msh\nset regions = lower\n",
                                       "set file = both.msh\nset regions = 2\n"),
                                 world);
  check("the boxes meet",
        largest_size(together.at("face contact force z")) > 100 && together.at("time").size() > 20);
  check("two regions of a file: the histories of two files", apart == together);
}

void refuse(const std::string &of_lower, const std::string &of_upper, Communicator &world)
{
  print_refusal([&] { run_text("refused", model(of_lower, of_upper), world); });
}

int main(int argc, char **argv)
{
  MpiSession    session(argc, argv);
  Communicator &world = session.world();
  for (const char *format : {"msh", "gmsh4.msh", "vtk", "ucd", "unv"})
    compare_files(format);
  compare_runs(world);
  refuse("set file = both.msh\n", "set file = upper.msh\n", world);
  refuse("set file = both.vtk\n", "set file = upper.msh\n", world);
  refuse("set file = both.msh\nset regions = lower\n",
         "set file = both.msh\nset regions = uper\n",
         world);
  // Whoever lists them all has one body of two parts.
  const std::string both = "set file = both.msh\nset regions = lower, upper\n";
  std::cout << "both as one body: "
            << (message_of([&] {
                  run_text("one",
                           model(both, "set file = upper.msh\nset position = 0, 0, 4.1 mm\n"),
                           world);
                }).empty()
                  ? "ok"
                  : "FAILED")
            << std::endl;
  return 0;
}
