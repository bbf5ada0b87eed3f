// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Export and import of meshes: what is written reads back with the same volume, sets and surfaces;
// a mesh of another program; files that cannot be used.

#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include "paper_members.h"

#include <vfife/gear/flank_points.h>
#include <vfife/mesh/files/mesh_export.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/mesh_quality.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/primitives/primitives.h>

#include <deal.II/grid/grid_out.h>

#include <fstream>
#include <limits>
#include <sstream>

using namespace vfife;

// 15 digits are written
constexpr double round_off = 1e-12;

ExportedBody exported(const BodyMesh &mesh, const Vector3 &shift = Vector3::Zero())
{
  ExportedBody body;
  body.name                  = mesh.name;
  body.mesh                  = &mesh;
  body.placement.translation = shift;
  body.material              = "steel";
  body.density               = 7.85e-9;
  body.youngs_modulus        = 206000.;
  body.poissons_ratio        = .29;
  return body;
}

void write(const std::string &path, const std::vector<ExportedBody> &bodies)
{
  std::ofstream out(path);
  write_meshes(out, path.substr(path.rfind('.') + 1), bodies);
}

double volume(const BodyMesh &mesh)
{
  return compute_mesh_quality(mesh.triangulation).volume;
}

/** Sorted by coordinates, rounded so that 15 digits do not change the order. */
using Places = std::vector<Eigen::VectorXd>;

Places sorted(Places places)
{
  std::sort(places.begin(), places.end(), [](const auto &a, const auto &b) {
    for (Eigen::Index c = 0; c < a.size(); ++c)
      if (std::abs(a[c] - b[c]) > 1e-7)
        return a[c] < b[c];
    return false;
  });
  return places;
}

/** Of the nodes of a set, from the mesh itself [mm]. */
Places places(const BodyMesh &mesh, const std::vector<unsigned int> &nodes)
{
  Places list;
  for (const unsigned int node : nodes)
    {
      const auto &x = mesh.triangulation.get_vertices()[node];
      list.emplace_back(Vector3(x[0], x[1], x[2]));
    }
  return sorted(list);
}

/** Middle and vector area of each facet: which way it looks is part of a surface. */
Places vector_areas(const FacetSurface &surface)
{
  Places list;
  for (const auto &facet : surface.facets)
    {
      const auto      at = [&](const unsigned int i) { return surface.positions[facet[i]]; };
      Eigen::VectorXd both(6);
      both << (at(0) + at(1) + at(2) + at(3)) / 4, (at(2) - at(0)).cross(at(3) - at(1)) / 2;
      list.push_back(both);
    }
  return sorted(list);
}

/** Largest difference of two lists, infinity where one is longer. */
double apart(const Places &one, const Places &other)
{
  if (one.size() != other.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    raise_to(largest, (one[i] - other[i]).norm());
  return largest;
}

/** The message's last part names the file; nothing but InputError may come. */
std::string message_of(const std::string &path)
{
  return ::message_of([&] { read_body(path); });
}

void check_pinion()
{
  const auto pinion = make_gear_body(paper::pinion(), coarse(pinion_body_defaults()));
  write("pinion.inp", {exported(*pinion)});
  write("pinion.msh", {exported(*pinion)});

  const auto inp = read_body("pinion.inp"), msh = read_body("pinion.msh");
  check_ratio("inp: volume", volume(*inp) / volume(*pinion), round_off);
  check_ratio("msh: volume", volume(*msh) / volume(*pinion), round_off);
  bool   sets      = true;
  double inp_nodes = 0, msh_nodes = 0;
  for (const auto &set : pinion->node_sets)
    {
      const auto &nodes = inp->node_sets.at(abaqus_name("pinion " + set.first));
      sets              = sets && nodes.size() == set.second.size();
      raise_to(inp_nodes, apart(places(*pinion, set.second), places(*inp, nodes)));
    }
  check("inp: node sets", sets);
  check_below("inp: places of the sets' nodes [mm]", inp_nodes, 1e-9);
  bool point_sets = true;
  for (const auto &set : pinion->node_sets)
    {
      const auto found = msh->node_sets.find("pinion " + set.first);
      point_sets =
        point_sets && found != msh->node_sets.end() && found->second.size() == set.second.size();
      if (found != msh->node_sets.end())
        raise_to(msh_nodes, apart(places(*pinion, set.second), places(*msh, found->second)));
    }
  check("msh: node sets", point_sets);
  check_below("msh: places of the sets' nodes [mm]", msh_nodes, 1e-9);
  bool surfaces = true;
  for (const char *side : {surface_name::concave, surface_name::convex})
    surfaces =
      surfaces &&
      inp->surfaces.at(abaqus_name(std::string("pinion ") + side) + "_SURFACE").facets.size() ==
        pinion->surfaces.at(side).facets.size() &&
      msh->surfaces.at(std::string("pinion ") + side).facets.size() ==
        pinion->surfaces.at(side).facets.size();
  check("inp and msh: surfaces", surfaces);
  double facets = 0;
  for (const char *side : {surface_name::concave, surface_name::convex})
    for (const FacetSurface *read :
         {&inp->surfaces.at(abaqus_name(std::string("pinion ") + side) + "_SURFACE"),
          &msh->surfaces.at(std::string("pinion ") + side)})
      raise_to(facets, apart(vector_areas(pinion->surfaces.at(side)), vector_areas(*read)));
  check_below("inp and msh: facets' middles and areas [mm, mm^2]", facets, 1e-9);
  check("inp and msh: regions",
        inp->regions.size() >= 2 && inp->node_sets.count("PINION_TEETH") == 1 &&
          msh->regions.size() == 2 && msh->node_sets.count("pinion rim") == 1);
}

/** Numbers of an array in the text of a .vtu file, by what stands in its tag. */
std::vector<double> read_array(const std::string &text, const std::string &tag)
{
  const std::size_t   at = text.find(tag);
  std::vector<double> numbers;
  if (at == std::string::npos)
    return numbers;
  const std::size_t  begin = text.find('>', at) + 1;
  std::istringstream words(text.substr(begin, text.find("</DataArray>", begin) - begin));
  for (double number; words >> number;)
    numbers.push_back(number);
  return numbers;
}

/** The block of 1 x 2 x 3 mm and the ring about (10, 0): volumes of the cells, corners of faces
 * and sets of points where they belong. */
void check_vtu(const std::string &text)
{
  const auto points  = read_array(text, "NumberOfComponents=\"3\""),
             corners = read_array(text, "Name=\"connectivity\""),
             body = read_array(text, "Name=\"body\""), region = read_array(text, "Name=\"region\""),
             inner = read_array(text, "Name=\"surface ring inner\""),
             upper = read_array(text, "Name=\"set block y+\"");
  const auto point = [&points](const double node) {
    return Vector3(Eigen::Map<const Vector3>(points.data() + 3 * static_cast<std::size_t>(node)));
  };
  double volumes[] = {0, 0};
  for (unsigned int cell = 0; cell < 14; ++cell)
    {
      // Corners go round the bottom, then round the top; prisms have the determinant of their
      // middle.
      const auto    x      = [&](const unsigned int i) { return point(corners[8 * cell + i]); };
      const Vector3 along  = x(1) + x(2) + x(5) + x(6) - x(0) - x(3) - x(4) - x(7),
                    across = x(2) + x(3) + x(6) + x(7) - x(0) - x(1) - x(4) - x(5),
                    up     = x(4) + x(5) + x(6) + x(7) - x(0) - x(1) - x(2) - x(3);
      volumes[body[cell] == 0 ? 0 : 1] += along.cross(across).dot(up) / 64;
    }
  check_close("vtu: volume of the block", volumes[0], 6., 1e-12);
  // Eight chords: 8 sin(pi/4)/2 (2^2 - 1^2).
  check_close("vtu: volume of the ring", volumes[1], 12 * std::sin(pi / 4), 1e-12);
  unsigned int n_faces = 0, n_points = 0;
  bool         on_face = true, in_set = true;
  for (unsigned int cell = 14; cell < inner.size(); ++cell)
    for (unsigned int i = 0; inner[cell] == 1 && i < 4; ++i)
      {
        const Vector3 x = point(corners[8 * 14 + 4 * (cell - 14) + i]);
        on_face         = on_face && std::abs(std::hypot(x[0] - 10, x[1]) - 1) < 1e-12;
        n_faces += i == 0;
      }
  for (unsigned int node = 0; node < upper.size(); ++node)
    if (upper[node] == 1)
      {
        in_set = in_set && point(node)[1] == 2.;
        ++n_points;
      }
  check("vtu: faces of a surface", on_face && n_faces == 8);
  // The block's cells are the first region, the ring's the second, faces are in none.
  bool numbered = region.size() == body.size();
  for (unsigned int cell = 0; numbered && cell < region.size(); ++cell)
    numbered = region[cell] == (cell < 14 ? 1 + body[cell] : 0);
  check("vtu: regions from 1 on, 0 on faces", numbered);
  check("vtu: points of a set", in_set && n_points == 8);
}

void check_assembly()
{
  const auto block = make_block({1., 2., 3.}, {{1, 2, 3}}),
             ring  = make_ring(1., 2., 1., {{1, 8, 1}});
  write("assembly.inp", {exported(*block), exported(*ring, {10., 0., 0.})});
  const auto both = read_body("assembly.inp");
  check_close("assembly: volume", volume(*both), volume(*block) + volume(*ring), 1e-11);
  check("assembly: sets of both bodies",
        both->node_sets.at("BLOCK_X_MINUS").size() == 12 &&
          both->node_sets.at("RING_OUTER").size() == 16 && both->node_sets.at("RING").size() == 32);
  // The ring stands 10 mm aside; both bodies' nodes are where they were.
  bool   on_side = true;
  double radii   = 0;
  for (const unsigned int node : both->node_sets.at("BLOCK_X_MINUS"))
    on_side = on_side && both->triangulation.get_vertices()[node][0] == 0.;
  for (const unsigned int node : both->node_sets.at("RING_OUTER"))
    {
      const auto &x = both->triangulation.get_vertices()[node];
      raise_to(radii, std::abs(std::hypot(x[0] - 10., x[1]) - 2.));
    }
  check("assembly: block's side at x = 0", on_side);
  check_below("assembly: outer radius about x = 10 mm", radii, 1e-12);

  write("assembly.vtu", {exported(*block), exported(*ring, {10., 0., 0.})});
  std::ifstream     in("assembly.vtu");
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  check("vtu: counts", has_text(text, "NumberOfPoints=\"56\" NumberOfCells=\"68\""));
  check("vtu: named arrays",
        has_text(text, "Name=\"surface ring inner\"") && has_text(text, "Name=\"set block y+\""));
  check_vtu(text);

  for (const std::string end : {"vtk", "ucd"})
    {
      dealii::GridOut           grid_out;
      dealii::GridOutFlags::Ucd ucd(true, true, true);
      grid_out.set_flags(ucd);
      dealii::GridOutFlags::Vtk vtk(true, true, true, true);
      grid_out.set_flags(vtk);
      {
        std::ofstream out("ring." + end);
        grid_out.write(ring->triangulation,
                       out,
                       end == "vtk" ? dealii::GridOut::vtk : dealii::GridOut::ucd);
      }
      const auto again = read_body("ring." + end);
      // deal.II writes six digits
      check_close(end + ": volume", volume(*again), volume(*ring), 1e-4);
      const auto outer = again->surfaces.find("boundary 2");
      check(end + ": outer surface",
            outer != again->surfaces.end() && outer->second.facets.size() == 8);
    }
}

/** Quarter plate with a hole, made by Gmsh: meshes/plate_with_hole.geo. */
void check_foreign()
{
  const auto plate = read_body(tree_folder() + "/meshes/plate_with_hole.msh");
  check("plate: elements", plate->triangulation.n_active_cells() == 480);
  // 16 chords around the quarter hole: its area is too small by sin(a)/a
  const double a = pi / 32.;
  check_close("plate: volume",
              volume(*plate),
              4. * (1600. - 25. * pi * std::sin(a) / a),
              1e-9 * 6000.);
  check("plate: named surfaces",
        plate->surfaces.at("hole").facets.size() == 48 &&
          plate->surfaces.at("symmetry x").facets.size() == 30 &&
          plate->surfaces.at("bottom").facets.size() == 160 &&
          plate->node_sets.at("plate").size() == plate->triangulation.n_vertices());
  bool on_hole = true;
  for (const Vector3 &x : plate->surfaces.at("hole").positions)
    on_hole = on_hole && std::abs(std::hypot(x[0], x[1]) - 10.) < 1e-6;
  check("plate: hole", on_hole);
}

void check_refusals()
{
  const auto says = [](const std::string &path, const std::string &words) {
    const std::string message = message_of(path);
    return has_text(message, path) && has_text(message, words) &&
           message.find('\n') == std::string::npos;
  };
  const auto put = [](const std::string &path, const std::string &text) {
    std::ofstream(path) << text;
  };
  const std::string corners = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n"
                              "5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";
  put("good.inp",
      corners + "*ELEMENT, TYPE=C3D8, ELSET=EB1\n7, 1,2,3,4,\n5,6,7,8\n"
                "*SURFACE, NAME=SS1\n7, S1\n*NSET, NSET=few, GENERATE\n1,7,2\n");
  const auto good = read_body("good.inp");
  check("one element over two lines",
        std::abs(volume(*good) - 1.) < round_off && good->node_sets.at("few").size() == 4 &&
          good->node_sets.at("EB1").size() == 8 && good->surfaces.at("SS1").facets.size() == 1);
  put("tetrahedra.inp", corners + "*ELEMENT, TYPE=C3D4\n1, 1,2,3,5\n");
  put("inverted.inp", corners + "*ELEMENT, TYPE=C3D8\n1, 5,6,7,8,1,2,3,4\n");
  put("no_node.inp", corners + "*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6,7,9\n");
  put("letters.inp", "*NODE\n1, 0., zero, 0.\n");
  put("empty.inp", "");
  put("letters.msh", "no mesh at all\n");
  put("tetrahedra.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
      "$EndNodes\n$Elements\n1\n1 4 2 0 0 1 2 3 4\n$EndElements\n");
  check("refuses a missing file", says("nowhere.msh", "cannot be opened"));
  check("refuses another format", says("good.inp.step", "cannot be opened"));
  put("mesh.step", "");
  check("refuses an unknown format", says("mesh.step", ".msh, .inp"));
  check("refuses tetrahedra (inp)", says("tetrahedra.inp", "C3D4"));
  check("refuses an inverted element", says("inverted.inp", "inverted"));
  check("refuses an unknown node", says("no_node.inp", ":11: node 9 does not exist"));
  check("refuses letters (inp)", says("letters.inp", ":2: expected a number, got \"zero\""));
  check("refuses an empty file", says("empty.inp", "expected hexahedra, got an empty file"));
  check("refuses letters (msh)", says("letters.msh", "cannot be read"));
  check("refuses tetrahedra (msh)", says("tetrahedra.msh", "hexahedra"));
}

void check_flank_points()
{
  const GearMember member = paper::gear();
  const Table      table  = compute_flank_points(member, 3, 4);
  // the pitch cone coordinates of a point say where it is
  bool right = table.n_rows() == 24;
  for (unsigned i = 0; i < table.n_rows(); ++i)
    {
      const auto    value = [&](const char *name) { return table.numbers(name)[i]; };
      const Vector2 L_h =
        member.blank().cone_coordinates({std::hypot(value("x"), value("y")), value("z")});
      right = right && (L_h - Vector2(value("L"), value("h"))).norm() < 1e-9;
    }
  check("flank points", right);
}

/** CalculiX reads the first twenty characters of a number: an exponent beyond them would be lost.
 */
void check_number_lengths()
{
  const auto block = make_block(Vector3(1., 2., 3.), {{1, 1, 1}});
  write("small.inp",
        {exported(*block, Vector3(-5.15672612069196e-05, -1.2345678901234567e-100, 0.))});
  std::ifstream file("small.inp");
  std::size_t   longest = 0;
  for (std::string line; std::getline(file, line);)
    {
      std::istringstream fields(line);
      if (line.find('*') == std::string::npos)
        for (std::string field; std::getline(fields, field, ',');)
          longest = std::max(longest, field.substr(field.find_first_not_of(' ')).size());
    }
  check("inp: numbers of twenty characters at most", longest <= 20 && longest > 15);
  double     x    = 1.;
  const auto body = read_body("small.inp");
  for (const auto &vertex : body->triangulation.get_vertices())
    x = std::min(x, vertex[0]);
  check_ratio("inp: a small coordinate", x / -5.15672612069196e-05, 1e-12);
}

/** Hanging nodes would be cracks in another program. */
void check_hanging_nodes()
{
  auto pinion = make_gear_body(paper::pinion(), coarse(pinion_body_defaults()));
  pinion->triangulation.begin_active()->set_refine_flag();
  pinion->triangulation.execute_coarsening_and_refinement();
  for (const char *path : {"hanging.inp", "hanging.msh", "hanging.vtu"})
    {
      const std::string message = ::message_of([&] { write(path, {exported(*pinion)}); });
      check(std::string("refuses to export hanging nodes: ") + path,
            has_text(message, "hanging nodes"));
    }
}

int main()
{
  return run_parts({check_pinion,
                    check_assembly,
                    check_foreign,
                    check_refusals,
                    check_flank_points,
                    check_number_lengths,
                    check_hanging_nodes});
}
