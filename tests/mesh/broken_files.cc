// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Mesh files with one thing wrong each: one line that names the file's line, whatever the file
// says.
#include "../parts.h"
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/mesh/mesh_quality.h>

#include <fstream>

using namespace vfife;

const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
// Two cubes, one on the other; lines 4 to 18 of the file.
const std::string nodes = "$Nodes\n12\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n"
                          "7 1 1 1\n8 0 1 1\n9 0 0 2\n10 1 0 2\n11 1 1 2\n12 0 1 2\n$EndNodes\n";
const std::string lower = "1 5 2 1 1 1 2 3 4 5 6 7 8\n", upper = "2 5 2 1 1 5 6 7 8 9 10 11 12\n";

std::string elements(const unsigned int n, const std::string &lines)
{
  return "$Elements\n" + std::to_string(n) + "\n" + lines + "$EndElements\n";
}

void read(const std::string &end, const std::string &text)
{
  const std::string path = "mesh." + end;
  std::ofstream(path, std::ios::binary) << text;
  try
    {
      const auto mesh = read_body(path);
      std::cout << "read, volume " << compute_mesh_quality(mesh->triangulation).volume << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

void read_gmsh_files()
{
  const std::string good = format + nodes + elements(2, lower + upper);
  read("msh", good);
  read("msh", good.substr(0, good.size() / 2));
  read("msh", "");
  read("msh", "$MeshFormat\n4 0 8\n$EndMeshFormat\n");
  read("msh", "$MeshFormat\n4.1 1 8\n\x01\x02");
  read("msh", nodes);
  read("msh", format + "\xff\xfe\x01\n");
  read("msh", format + "$Comments\nno end");
  read("msh", format + "$PhysicalNames\n1\n3 1 solid\n");
  read("msh", format + "$Nodes\n1000000000000\n1 0 0 0\n$EndNodes\n");
  read("msh", format + "$Nodes\n-1\n$EndNodes\n");
  read("msh", format + "$Nodes\n2\n1 0 0 0\n1 0 0 0\n$EndNodes\n");
  read("msh", format + "$Nodes\n1\n1 0 1e400 0\n$EndNodes\n");
  read("msh", format + "$Nodes\n1\n1 0 nan 0\n$EndNodes\n");
  read("msh", format + nodes);
  read("msh", format + nodes + elements(1, "1 5 2 1 1 1 2 3 4 5 6 7 99\n"));
  read("msh", format + nodes + elements(1, "1 5 2 1 1 1 2 3 4 5 6 7\n"));
  read("msh", format + nodes + elements(1, "1 4 2 1 1 1 2 3 5\n"));
  read("msh", format + nodes + elements(1, "1 2 2 1 1 1 2 3\n"));
  read("msh", format + nodes + elements(1, "1 5 2 1 1 1 2 3 4 5 6 7 7\n"));
  read("msh", format + nodes + elements(2, lower + "2 5 2 1 1 1 2 3 4 5 6 7 8\n"));
  read("msh", format + nodes + elements(2, lower + "2 5 2 1 1 9 10 11 12 5 6 7 8\n"));
  // Seen from the other side all of them are good; one alone is not.
  read("msh",
       format + nodes + elements(2, "1 5 2 1 1 5 6 7 8 1 2 3 4\n2 5 2 1 1 9 10 11 12 5 6 7 8\n"));
  // A third cube on the face between two; a neighbour that sees other edges in the face.
  std::string more = nodes;
  more.replace(more.find("12"), 2, "16")
    .insert(more.find("$End"), "13 0 0 3\n14 1 0 3\n15 1 1 3\n16 0 1 3\n");
  read("msh", format + more + elements(3, lower + upper + "3 5 2 1 1 5 6 7 8 13 14 15 16\n"));
  read("msh", format + nodes + elements(2, lower + "2 5 2 1 1 5 7 6 8 9 10 11 12\n"));
  // Groups of faces that are none of the body's.
  read("msh", format + nodes + elements(2, lower + "2 3 2 7 7 1 3 6 8\n"));
  read("msh", format + "$Nodse\n0\n$EndNodse\n");
  read("msh", format + "$PartitionedEntities\n1\n$EndPartitionedEntities\n");
  // Format 4.1: what the first line of a section states and what follows must agree.
  const std::string four = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  read("msh", four + "$Nodes\n1 3 1 3\n3 1 0 2\n1\n2\n0 0 0\n1 0 0\n$EndNodes\n");
  read("msh", four + "$Nodes\n1 1 1 1\n9 1 0 1\n1\n0 0 0\n$EndNodes\n");
  read("msh", four + "$Entities\n1000000000 0 0 0\n1 0 0 0 0\n$EndEntities\n");
}

void read_other_files()
{
  const std::string corners = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n"
                              "7,1,1,1\n8,0,1,1\n";
  const std::string cube    = "*ELEMENT, TYPE=C3D8, ELSET=ALL\n1, 1,2,3,4,5,6,7,8\n";
  read("inp", corners + cube);
  read("inp", corners + "*ELEMENT, =\n" + cube);
  read("inp", corners + cube + "*NSET, NSET=A, GENERATE\n1, 999999999999999999, 1\n");
  read("inp", corners + "*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6\n");
  read("inp", corners + "*ELEMENT, TYPE=C3D8\n1, 1,2,3,4,5,6,7,8,9,10\n");
  read("inp", corners + cube + "1, 1,2,3,4,5,6,7,8\n");
  read("inp", corners + "8,0,1,1\n" + cube);
  read("inp", corners + cube + "*SURFACE, NAME=A\n\x80, S1\n");
  // What changes a mesh is read or refused by its name.
  for (const char *more :
       {"*NSET, NSET=A\n1, 9\n",
        "*NSET, NSET=A\nB\n",
        "*NSTE, NSET=A\n1\n",
        "*NSET, NSET=A, EXCEPT=1\n2\n",
        "*NSET\n2\n",
        "*NMAP, NSET=A\n0, 0, 0\n",
        "*TIE, NAME=T\nA, B\n",
        "*SPRINGS\n",
        "*MATERIAL, NAME=M\n*ELASTIC\n2e5, 0.3\n*NODES\n9, 0, 0, 0\n",
        "*SURFACE, NAME=A\n1, S7\n",
        "*SURFACE, NAME=A, TYPE=CUTTING SURFACE\n",
        "*ELEMENT, TYPE=S4, ELSET=A\n2, 1, 3, 6, 8\n",
        "*ELEMENT, TYPE=S4, ELSET=A\n2, 1, 2, 3, 4\n*SHELL SECTION, ELSET=A\n1.\n",
        "*ELEMENT, TYPE=S3\n2, 1, 2, 3\n",
        "*ELEMENT, TYPE=C3D20\n",
        "*ELEMENT\n",
        "*SYSTEM\n0, 0, 0, 1, 0, 0\n2, 0, 0\n",
        "*NODE, SYSTEM=S\n9, 0, 0, 0\n",
        "*NGEN\n1, 8, 3\n",
        "*ELGEN\n1, 2, 8, 1\n",
        "*INSTANCE, NAME=A, PART=B\n",
        "*PART, NAME=A\n"})
    read("inp", corners + cube + more);
  read("inp", "\xFF\xFE*\n");

  const std::string head   = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string points = "POINTS 8 float\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n";
  read("vtk", head + points + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n");
  read("vtk", head + "POINTS 99999999999 float\n0 0 0\n");
  read("vtk", head + points + "CELLS 1 9\n8 0 1 2 3 4 5 6 8\n");
  read("vtk", head + points + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 2\n12\n12\n");
  read("vtk", head + points + "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n");
  read("vtk", head + points + "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n12\n");
  read("vtk", "# vtk DataFile Version 3.0\ncube\nBINARY\n");
  const std::string cells = "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n";
  read("vtk", head + points + "CELLS 1 8\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n12\n");
  read("vtk", head + points + "CELLS 2 8\nOFFSETS vtktypeint64\n0 7\n");
  read("vtk", head + points + cells + "CELL_DATA 1\nSCALARS mat_id int\nLOOKUP_TABLE d\n1.5\n");
  read("vtk", head + points + cells + "CELL_DATA 1\nVECTOR a float\n1 2 3\n");
  read("vtk", head + points + cells + "POINT_DATA 9\n");

  const std::string ucd = "8 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 1 0 1\n4 0 0 1\n5 0 1 0\n6 1 1 0\n"
                          "7 1 1 1\n8 0 1 1\n";
  read("ucd", ucd + "1 1 hex 1 2 3 4 5 6 7 8\n");
  read("ucd", ucd + "1 1 prism 1 2 3 4 5 6\n");
  read("ucd", ucd + "1 1 hex 1 2 3 4 5 6 7 0\n");
  read("ucd", "8 1 0\n");
  read("ucd", ucd + "1 1 hex 1 2 3 4 5 6 7 8\n2 1 hex 1 2 3 4 5 6 7 8\n");
}

/** By deal.II's readers: whatever they throw is one line. */
void read_files_by_dealii()
{
  const std::string corners = "0 1 1 11\n0 0 0\n1 1 1 11\n1 0 0\n2 1 1 11\n1 1 0\n3 1 1 11\n"
                              "0 1 0\n4 1 1 11\n0 0 1\n5 1 1 11\n1 0 1\n6 1 1 11\n1 1 1\n"
                              "7 1 1 11\n0 1 1\n-1\n";
  const std::string start   = "-1\n2411\n" + corners + "-1\n2412\n";
  const std::string cube    = "1 115 1 1 7 8\n0 1 2 3 4 5 6 7\n";
  read("unv", start + cube + "-1\n");
  read("unv", start + cube);
  read("unv", start + "-1\n");
  read("unv", "");
  read("unv", "\x7f\x01 no mesh\n");
  read("unv", "-1\n2411\n" + corners);
  read("unv", start + "1 111 1 1 7 4\n0 1 2 4\n-1\n");
  read("unv", start + cube + "2 111 1 1 7 4\n0 1 2 4\n-1\n");
  read("unv", start + "1 115 1 1 7 8\n0 1 2 3 4 5 6 99\n-1\n");
  read("unv", start + "1 115 1 1 7 8\n0 1 2 3 5 4 7 6\n-1\n");
  read("unv",
       start + cube + "2 44 1 1 7 4\n0 2 6 4\n-1\n-1\n2467\n1 0 0 0 0 0 0 1\n7\n8 2 0 0\n-1\n");
  read("unv", start + cube + "-1\n-1\n2467\n1 0 0 0 0 0 0 999999999\n7\n8 1 0 0\n");
  const std::string head = "xda\n1 # elements\n8 # nodes\n8\n0\n0\n1\n8\n1\nId\nTitle\n";
  const std::string box  = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
  read("xda", head + "0 1 2 3 4 5 6 7\n" + box);
  read("xda", head + "0 1 2 3 4 5 6 8\n" + box);
  read("xda", head + "0 1 2 3 4 5 6 7\n0 0 0\n");
  read("xda", head + "0 1 2 4\n" + box);
  read("xda", "xda\n4000000000\n4000000000\n");
  read("xda", "");
  read("vtu", "<VTKFile type=\"UnstructuredGrid\"></VTKFile>");
  read("vtu", "<VTKFile><dealiiData encoding=\"base64\">AAAA\n</dealiiData></VTKFile>");
  read("vtu", "no mesh");
  for (const char *end : {"mphtxt", "dat", "dbmesh", "e", "stl", "tar.unv2"})
    read(end, "");
}

int main()
{
  return run_parts({read_gmsh_files, read_other_files, read_files_by_dealii});
}
