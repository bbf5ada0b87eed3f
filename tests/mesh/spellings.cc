// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One body in many spellings of the formats: each gives the same volume, counts, sets and surfaces
// as the plainest one.
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/types.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/mesh_quality.h>

#include <boost/algorithm/string.hpp>

#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>

using namespace vfife;

/** 3 x 2 x 1 cells of 2 x 3 x 4 mm; nodes are numbered from 1 along x, y, z. */
constexpr unsigned int n[3] = {3, 2, 1};

Vector3 place(const unsigned int node)
{
  return {2. * (node % 4), 3. * (node / 4 % 3), 4. * (node / 12)};
}

/** In the order of VTK, Gmsh and Abaqus, from 0. */
std::vector<unsigned int> cell_nodes(const unsigned int cell)
{
  const unsigned int first = cell % n[0] + 4 * (cell / n[0]);
  return {first, first + 1, first + 5, first + 4, first + 12, first + 13, first + 17, first + 16};
}

std::string
numbers(const std::vector<unsigned int> &list, const unsigned int from, const std::string &divider)
{
  std::string text;
  for (const unsigned int number : list)
    text += (text.empty() ? "" : divider) + std::to_string(number + from);
  return text;
}

std::string coordinates(const Vector3 &x, const std::string &divider)
{
  std::ostringstream text;
  text << x[0] << divider << x[1] << divider << x[2];
  return text.str();
}

std::string inp_nodes(const std::function<Vector3(unsigned int)> &at = place)
{
  std::string text;
  for (unsigned int i = 0; i < 24; ++i)
    text += std::to_string(i + 1) + ", " + coordinates(at(i), ", ") + "\n";
  return text;
}

std::string inp_cells(const unsigned int begin = 0, const unsigned int end = 6)
{
  std::string text;
  for (unsigned int e = begin; e < end; ++e)
    text += std::to_string(e + 1) + ", " + numbers(cell_nodes(e), 1, ", ") + "\n";
  return text;
}

const std::string inp_sets = "*NSET, NSET=FIX\n1, 5, 9, 13, 17, 21\n*ELSET, ELSET=HALF\n1, 2, 3\n"
                             "*SURFACE, NAME=TOP\n1, S2\n2, S2\n3, S2\n4, S2\n5, S2\n6, S2\n";

std::string plain_inp()
{
  return "*NODE\n" + inp_nodes() + "*ELEMENT, TYPE=C3D8, ELSET=EALL\n" + inp_cells() + inp_sets;
}

/** What a body is: names in capitals, surfaces with their area along x, y, z. */
std::string describe(const BodyMesh &mesh)
{
  std::ostringstream text;
  text << std::setprecision(9) << mesh.triangulation.n_active_cells() << " cells, "
       << mesh.triangulation.n_vertices() << " nodes, "
       << compute_mesh_quality(mesh.triangulation).volume << " mm^3";
  std::map<std::string, std::string> parts;
  for (const auto &[name, nodes] : mesh.node_sets)
    parts[boost::to_upper_copy(name)] += " " + std::to_string(nodes.size());
  for (const auto &[name, surface] : mesh.surfaces)
    {
      Vector3 area = Vector3::Zero();
      for (const auto &f : surface.facets)
        area += .5 * (surface.positions[f[2]] - surface.positions[f[0]])
                       .cross(surface.positions[f[3]] - surface.positions[f[1]]);
      std::ostringstream of;
      of << std::setprecision(9) << " (" << surface.facets.size() << " facets, "
         << area.cwiseAbs().sum() << ")";
      parts[boost::to_upper_copy(name)] += of.str();
    }
  for (const auto &[name, part] : parts)
    text << "; " << name << part;
  return text.str();
}

std::string read(const std::string &end, const std::string &text)
{
  const std::string path = "spelling." + end;
  std::ofstream(path, std::ios::binary) << text;
  return describe(*read_body(path));
}

void same(const std::string &name,
          const std::string &end,
          const std::string &text,
          const std::string &wanted)
{
  std::string found;
  const auto  refusal = message_of([&] { found = read(end, text); });
  if (found == wanted)
    check(name, true);
  else
    std::cout << name << ": FAILED, " << found << refusal << "\n  instead of " << wanted
              << std::endl;
}

std::string replaced(std::string text, const std::string &what, const std::string &by)
{
  boost::replace_all(text, what, by);
  return text;
}

void lines_and_numbers()
{
  const std::string plain = plain_inp(), wanted = read("inp", plain);
  check("the block",
        wanted == "6 cells, 24 nodes, 144 mm^3; EALL 24; FIX 6; HALF 16; TOP 12 (6 facets, 36)");
  same("CR LF", "inp", replaced(plain, "\n", "\r\n"), wanted);
  same("CR", "inp", replaced(plain, "\n", "\r"), wanted);
  same("byte order mark", "inp", "\xEF\xBB\xBF" + plain, wanted);
  same("small letters", "inp", boost::to_lower_copy(plain), wanted);
  same("blanks", "inp", replaced(replaced(plain, ",", " , "), "\n", "  \n  "), wanted);
  same("comments, empty lines", "inp", replaced(plain, "\n", "\n** 1, 2\n\n"), wanted);
  same("continued keyword", "inp", replaced(plain, "C3D8,", "C3D8,\n"), wanted);
  same("exponents with D", "inp", replaced(plain, "2, 3, 4\n", "0.2D+01, 3.d0, 4D0\n"), wanted);
  same("zeros left out", "inp", replaced(plain, "\n2, 2, 0, 0\n", "\n2, 2\n"), wanted);
  same("elements over lines", "inp", replaced(plain, "1, 2, 6, 5,", "1, 2, 6, 5,\n"), wanted);
  same("in a part",
       "inp",
       "*Heading\n A part\n*Part, name=P\n" + plain +
         "*End Part\n*Assembly, name=A\n"
         "*Instance, name=I, part=p\n*End Instance\n*End Assembly\n*Material, name=M\n*Elastic\n"
         "2e5, .3\n*Step\n*Static\n*Cload\nTOP, 3, 1.\n*End Step\n",
       replaced(wanted, "; TOP", "; I 24; TOP"));
}

void sets_and_generation()
{
  const std::string wanted = read("inp", plain_inp());
  const std::string mesh =
    "*NODE\n" + inp_nodes() + "*ELEMENT, TYPE=C3D8, ELSET=EALL\n" + inp_cells();
  const std::string half = "*ELSET, ELSET=HALF, GENERATE\n1, 3\n", top = "*SURFACE, NAME=TOP\n";
  same("sets of sets in any letters",
       "inp",
       mesh + half +
         "*NSET, NSET=Low, INTERNAL\n1, 5, 9\n*NSET, NSET=Fix, UNSORTED\n21, 17, 13\n"
         "LOW,\n" +
         top + "eall, s2\n",
       wanted);
  same("nodes of elements",
       "inp",
       mesh + half + "*ELSET, ELSET=FIRST, INTERNAL\n1, 4\n*NSET, NSET=FIX, ELSET=FIRST\n" + top +
         "EALL, S2\n",
       replaced(wanted, "FIX 6", "FIX 12"));
  same("surface of nodes",
       "inp",
       replaced(plain_inp(),
                "*NSET, NSET=FIX\n1, 5, 9, 13, 17, 21\n",
                "*SURFACE, NAME=FIX, TYPE=NODE\n1, 1.\n5\n9\n13\n17\n21\n"),
       wanted);
  same(
    "4-node elements as faces",
    "inp",
    mesh + half + "*NSET, NSET=FIX\n1, 5, 9, 13, 17, 21\n*ELEMENT, TYPE=S4, ELSET=TOP\n" +
      [] {
        std::string quads;
        for (unsigned int e = 0; e < 6; ++e)
          {
            const auto nodes = cell_nodes(e);
            quads += std::to_string(e + 101) + ", " +
                     numbers({nodes[4], nodes[5], nodes[6], nodes[7]}, 1, ", ") + "\n";
          }
        return quads;
      }(),
    wanted);
  same("generated",
       "inp",
       "*NODE\n1, 0, 0, 0\n4, 6, 0, 0\n5, 0, 3, 0\n8, 6, 3, 0\n9, 0, 6, 0\n12, 6, 6, 0\n13, 0, "
       "0, 4\n"
       "16, 6, 0, 4\n17, 0, 3, 4\n20, 6, 3, 4\n21, 0, 6, 4\n24, 6, 6, 4\n*NGEN\n1, 4\n5, 8, "
       "1\n9, 12\n"
       "13, 16\n17, 20\n21, 24\n*ELEMENT, TYPE=C3D8\n" +
         inp_cells(0, 1) + "*ELGEN, ELSET=EALL\n1, 3, 1, 1, 2, 4, 3\n" + inp_sets,
       wanted);
  same("copied elements",
       "inp",
       "*NODE\n" + inp_nodes() + "*ELEMENT, TYPE=C3D8, ELSET=HALF\n" + inp_cells(0, 3) +
         "*ELCOPY, OLD SET=half, CHANGE NUMBER=3, SHIFT NODES=4, NEW SET=REST\n"
         "*ELSET, ELSET=EALL\nHALF, REST\n*ELSET, ELSET=REST, INTERNAL\n" +
         replaced(inp_sets, "*ELSET, ELSET=HALF\n1, 2, 3\n", ""),
       wanted);
  for (const char *type : {"C3D8RH", "C3D8T", "SC8R", "C3D8IH"})
    same(type, "inp", replaced(plain_inp(), "C3D8", type), wanted);
  // A node set, an element set and a surface of one name are three things.
  same("node set and region of one name",
       "inp",
       replaced(plain_inp(), "ELSET=HALF", "ELSET=FIX"),
       replaced(wanted, "HALF 16; ", ""));
  const auto all_round = read("inp", mesh + "*SURFACE, NAME=SKIN\nEALL,\n");
  check("surface without sides",
        all_round == "6 cells, 24 nodes, 144 mm^3; EALL 24; SKIN 24 (22 facets, 0)");
}

void places()
{
  // A quarter of a ring in cylinder coordinates and in its own.
  const auto polar = [](const unsigned int i) {
    return Vector3(10 + place(i)[0], 15 * place(i)[1], place(i)[2]);
  };
  const auto cartesian = [&](const unsigned int i) {
    const Vector3 p = polar(i);
    return Vector3(p[0] * std::cos(p[1] * degree), p[0] * std::sin(p[1] * degree), p[2]);
  };
  const std::string cells = "*ELEMENT, TYPE=C3D8, ELSET=EALL\n" + inp_cells() + inp_sets;
  const auto        box   = [](const std::string &text) {
    const std::string path = "place.inp";
    std::ofstream(path) << text;
    const auto         body = read_body(path);
    std::ostringstream all;
    all << std::setprecision(5);
    for (const auto &x : body->triangulation.get_vertices())
      all << std::round(1e4 * x[0]) << ' ' << std::round(1e4 * x[1]) << ' '
          << std::round(1e4 * x[2]) << ' ';
    return boost::replace_all_copy(all.str(), "-0 ", "0 ");
  };
  check("cylinder coordinates",
        box("*NODE, SYSTEM=C\n" + inp_nodes(polar) + cells) ==
          box("*NODE\n" + inp_nodes(cartesian) + cells));
  // x' along y, y' along -x, origin (1, 2, 3).
  const auto moved = [](const unsigned int i) {
    return Vector3(1 - place(i)[1], 2 + place(i)[0], 3 + place(i)[2]);
  };
  const std::string wanted = box("*NODE\n" + inp_nodes(moved) + cells);
  check("*SYSTEM",
        box("*SYSTEM\n1, 2, 3, 1, 5, 3\n0, 2, 3\n*NODE\n" + inp_nodes() + cells) == wanted);
  const std::string part =
    "*PART, NAME=P\n*NODE\n" + inp_nodes() + cells + "*END PART\n*ASSEMBLY\n";
  // First moved by (2, -1, 3), then turned by 90 deg about the line x = y = 0: (x, y) to (-y, x).
  check("instance moved, then turned",
        box(part + "*INSTANCE, NAME=I, PART=P\n2, -1, 3\n0, 0, 0, 0, 0, 1, 90.\n*END INSTANCE\n") ==
          wanted);
  const auto twice = read("inp",
                          part + "*INSTANCE, NAME=one, PART=P\n*END INSTANCE\n*INSTANCE, NAME=two, "
                                 "PART=P\n100\n*END INSTANCE\n*NSET, NSET=ENDS, INSTANCE=ONE\nFIX\n"
                                 "*NSET, NSET=ENDS, INSTANCE=two\n1, 2\n*NSET, NSET=OTHER\n"
                                 "two.Fix, one.1\n*END ASSEMBLY\n");
  check("a part twice",
        twice ==
          "12 cells, 48 nodes, 288 mm^3; ENDS 8; ONE 24; ONE.EALL 24; ONE.FIX 6; ONE.HALF 16; "
          "ONE.TOP 12 (6 facets, 36); OTHER 7; TWO 24; TWO.EALL 24; TWO.FIX 6; TWO.HALF 16; "
          "TWO.TOP 12 (6 facets, 36)");
}

/** Of VTK's legacy format, cells with @p ids behind their types. */
std::string vtk(const std::string &head, const std::string &cells, const std::string &ids)
{
  std::string points = "POINTS 24 double\n";
  for (unsigned int i = 0; i < 24; ++i)
    points += coordinates(place(i), " ") + "\n";
  return head + "DATASET UNSTRUCTURED_GRID\n" + points + cells + ids;
}

void vtk_files()
{
  std::string old_cells = "CELLS 7 59\n", nodes;
  for (unsigned int e = 0; e < 6; ++e)
    {
      old_cells += "8 " + numbers(cell_nodes(e), 0, " ") + "\n";
      nodes += numbers(cell_nodes(e), 0, " ") + "\n";
    }
  const std::string types = "CELL_TYPES 7\n12 12 12 12 12 12 9\n";
  old_cells += "4 0 4 5 1\n" + types;
  const std::string new_cells =
    "CELLS 8 52\nOFFSETS vtktypeint64\n0 8 16 24 32 40 48 52\nCONNECTIVITY vtktypeint64\n" + nodes +
    "0 4 5 1\n" + types;
  const std::string head = "# vtk DataFile Version 3.0\na block\nASCII\n", id = "1 1 1 2 2 2 5\n";
  const std::string material = "CELL_DATA 7\nSCALARS MaterialID int 1\nLOOKUP_TABLE default\n" + id;
  const std::string wanted   = read("vtk", vtk(head, old_cells, material));
  check("vtk: the block",
        wanted ==
          "6 cells, 24 nodes, 144 mm^3; BOUNDARY 5 4 (1 facets, 6); REGION 1 16; REGION 2 16");
  same("vtk: version 5.1",
       "vtk",
       vtk("# vtk DataFile Version 5.1\nvtk output\nASCII\n", new_cells, material),
       wanted);
  same("vtk: empty title",
       "vtk",
       vtk("# vtk DataFile Version 3.0\n\nASCII\n", old_cells, material),
       wanted);
  same("vtk: small letters", "vtk", boost::to_lower_copy(vtk(head, old_cells, material)), wanted);
  same("vtk: CR LF", "vtk", replaced(vtk(head, old_cells, material), "\n", "\r\n"), wanted);
  for (const std::string name : {"mat_id", "material", "RegionId", "gmsh:physical"})
    {
      same("vtk: ids " + name + " in a field, behind data of points",
           "vtk",
           vtk(head,
               old_cells,
               "POINT_DATA 24\nVECTORS u double\n" + replaced(std::string(72, 'a'), "a", "0.5 ") +
                 "\nMETADATA\nINFORMATION 0\n\nCELL_DATA 7\nFIELD FieldData 2\nother 2 7 double\n" +
                 replaced(std::string(14, 'a'), "a", "nan ") + "\n" + name + " 1 7 double\n" + id),
           wanted);
      same("vtk: ids " + name + " as scalars without a table",
           "vtk",
           vtk(head, old_cells, "CELL_DATA 7\nSCALARS " + name + " long\n" + id),
           wanted);
    }
  // Names with blanks are written with their codes; further arrays are passed over.
  const std::string pairs = replaced(std::string(7, 'a'), "a", "0.25 0.75\n");
  same("vtk: ids with a blank, behind other arrays",
       "vtk",
       vtk(head,
           old_cells,
           "CELL_DATA 7\nTEXTURE_COORDINATES map 2 float\n" + pairs + "COLOR_SCALARS shade 2\n" +
             pairs + "LOOKUP_TABLE shades 2\n0 0 0 1\n1 1 1 1\nSCALARS mat%20id int 1\n" + id),
       wanted);
  same("vtk: a description between the arrays of a field",
       "vtk",
       vtk(head,
           old_cells,
           "CELL_DATA 7\nFIELD FieldData 2\nother 1 7 double\n" + id +
             "METADATA\nINFORMATION 0\n\nmat_id 1 7 int\n" + id),
       wanted);
  std::string voxels = "CELLS 7 59\n";
  for (unsigned int e = 0; e < 6; ++e)
    {
      const auto c = cell_nodes(e);
      voxels += "8 " + numbers({c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]}, 0, " ") + "\n";
    }
  same("vtk: voxels and pixels",
       "vtk",
       vtk(head, voxels + "4 0 1 4 5\nCELL_TYPES 7\n11 11 11 11 11 11 8\n", material),
       wanted);
}

void ucd_and_gmsh()
{
  // UCD begins with the corners of a side: 1 2 6 5 of VTK are its 1 2 3 4.
  std::string ucd = "24 7 0 0 0\n";
  for (unsigned int i = 0; i < 24; ++i)
    ucd += std::to_string(i + 1) + " " + coordinates(place(i), " ") + "\n";
  for (unsigned int e = 0; e < 6; ++e)
    {
      const auto c = cell_nodes(e);
      ucd += std::to_string(e + 1) + (e < 3 ? " 1" : " 2") + " hex " +
             numbers({c[0], c[1], c[5], c[4], c[3], c[2], c[6], c[7]}, 1, " ") + "\n";
    }
  ucd += "7 5 quad 1 5 6 2\n";
  const std::string wanted = read("ucd", ucd);
  check("ucd: the block",
        wanted ==
          "6 cells, 24 nodes, 144 mm^3; BOUNDARY 5 4 (1 facets, 6); REGION 1 16; REGION 2 16");
  same("ucd named .inp", "inp", "# by another program\n" + ucd, wanted);
  same("Abaqus named .ucd", "ucd", plain_inp(), read("inp", plain_inp()));

  std::string nodes = "$Nodes\n24\n";
  for (unsigned int i = 0; i < 24; ++i)
    nodes += std::to_string(i + 1) + " " + coordinates(place(i), " ") + "\n";
  nodes += "$EndNodes\n";
  std::string elements;
  unsigned    number = 0;
  for (const unsigned int group : {1, 2})
    for (unsigned int e = 0; e < (group == 1 ? 6 : 3); ++e)
      elements += std::to_string(++number) + " 5 2 " + std::to_string(group) + " 1 " +
                  numbers(cell_nodes(e), 1, " ") + "\n";
  elements += "10 1 2 3 1 1 2\n11 1 2 3 1 2 3\n";
  const std::string msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n3 1 \"whole\"\n"
                          "3 2 \"loaded half\"\n1 3 \"edge\"\n$EndPhysicalNames\n" +
                          nodes + "$Elements\n11\n" + elements + "$EndElements\n";
  check("msh: a volume in two groups, an edge",
        read("msh", msh) == "6 cells, 24 nodes, 144 mm^3; EDGE 3; LOADED HALF 16; WHOLE 24");
  same("msh: CR LF, byte order mark",
       "msh",
       "\xEF\xBB\xBF" + replaced(msh, "\n", "\r\n"),
       read("msh", msh));
}

/** Both skins of one layer: its sides are no part of them, though all their nodes are. */
void faces()
{
  const std::string mesh =
    "*NODE\n" + inp_nodes() + "*ELEMENT, TYPE=C3D8, ELSET=EALL\n" + inp_cells();
  check("both skins of a layer",
        read("inp", mesh + "*SURFACE, NAME=SKINS\nEALL, S1\nEALL, S2\n") ==
          "6 cells, 24 nodes, 144 mm^3; EALL 24; SKINS 24 (12 facets, 0)");
  std::ofstream("inside.inp") << mesh
                              << "*SURFACE, NAME=ALONG\nEALL, S4\n*SURFACE, NAME=FIX\n"
                                 "EALL, S6\n*NSET, NSET=FIX\n1, 2\n";
  const auto body = read_body("inside.inp");
  check("faces between elements make no surface", body->surfaces.empty());
  for (const auto &surface : body->unusable_surfaces)
    std::cout << surface.second << std::endl;
}

/** Positive at the Gauss points and negative at a corner, and negative at one of these. */
void corners()
{
  const auto cube = [](const std::string &corner) {
    return "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7," + corner +
           "\n8,0,1,1\n*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6,7,8\n";
  };
  std::ofstream("corner.inp") << cube("0.45,0.45,1");
  const auto body = read_body("corner.inp");
  check("a corner slightly inverted: a warning", body->warnings.size() == 1);
  for (const std::string &warning : body->warnings)
    std::cout << warning << std::endl;
  std::ofstream("corner.inp") << cube("0.01,0.01,0.9");
  print_refusal([] { read_body("corner.inp"); });
}

void unmerged()
{
  const std::string part = "*PART, NAME=P\n*NODE\n" + inp_nodes() + "*ELEMENT, TYPE=C3D8\n" +
                           inp_cells() +
                           "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=A, PART=P\n"
                           "*END INSTANCE\n*INSTANCE, NAME=B, PART=P\n";
  std::ofstream("touching.inp") << part << "6.0001, 0, 0\n*END INSTANCE\n";
  std::ofstream("apart.inp") << part << "6.01, 0, 0\n*END INSTANCE\n";
  check("nodes at the places of others", find_coincident_nodes(*read_body("touching.inp")).n == 6);
  check("nodes apart", find_coincident_nodes(*read_body("apart.inp")).n == 0);
}

int main()
{
  return run_parts({lines_and_numbers,
                    sets_and_generation,
                    places,
                    vtk_files,
                    ucd_and_gmsh,
                    faces,
                    corners,
                    unmerged});
}
