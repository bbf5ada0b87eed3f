// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// One tooth of a pinion under pressure: stress in its fillets with elements of 8 and 27 nodes and
// over a family of meshes. With the argument "ccx" and a folder the same by CalculiX (77 without
// it).
#include "../mesh/coarsest.h"
#include "pinion_fillets.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/fem/statics/static_solver.h>
#include <vfife/mesh/hexahedron_corners.h>

#include <Eigen/Eigenvalues>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>

using namespace vfife;

/** The pinion held by its bore, with a pressure of 100 MPa on the whole concave flank of tooth 0.
 */
class LoadedTooth
{
public:
  LoadedTooth(GearBodyOptions options, const unsigned int refinements)
  {
    options.refinements = refinements;
    model               = make_held_pinion(options);
    const Body &body    = model.bodies[0];
    loads.nodal_forces.assign(model.n_nodes(), Vector3::Zero());
    const FacetSurface       &flank = body.mesh().surfaces.at(surface_name::concave);
    const std::vector<double> areas = compute_nodal_areas(body, flank.nodes);
    for (std::size_t i = 0; i < flank.nodes.size(); ++i)
      if (flank.nodes[i] < body.n_nodes() / body.mesh().structure.n_sectors())
        loads.nodal_forces[flank.nodes[i]] = -100. * areas[i] * flank.normals[i];
  }

  /** Of both fillets of tooth 0 under displacements of the nodes. */
  RootStresses find(const std::function<Vector3(unsigned int)> &u) const
  {
    return find_largest(list_fillets(model.bodies[0]),
                        strains_of_displacements(
                          model, [&u](unsigned int, const unsigned int node) { return u(node); }));
  }

  RootStresses find(const std::vector<double> &displacements) const
  {
    return find([&](const unsigned int i) {
      return Vector3(Eigen::Map<const Vector3>(displacements.data() + 3 * std::size_t(i)));
    });
  }

  /** Nodes of both fillets of tooth 0. */
  std::vector<unsigned int> fillet_nodes() const
  {
    std::vector<unsigned int> nodes;
    for (const char *set : {node_set::concave_fillet, node_set::convex_fillet})
      for (const unsigned int i : model.bodies[0].node_set(set))
        if (i < model.n_nodes() / model.bodies[0].mesh().structure.n_sectors())
          nodes.push_back(i);
    return nodes;
  }

  /** By whole bodies. */
  RootStresses solve(const FemElement element, const Communicator &world) const
  {
    FemOptions options;
    options.element       = element;
    options.linear_solver = LinearSolverKind::direct;
    return find(StaticSolver(model, {0}, options, world).solve(loads).displacements);
  }

  /** By one sector, elements with incompatible modes. */
  RootStresses solve_by_sectors(const Communicator &world) const
  {
    const Compliance    compliance(model, FemOptions(), false, world);
    std::vector<double> forces(3 * model.n_nodes());
    for (unsigned int i = 0; i < model.n_nodes(); ++i)
      Eigen::Map<Vector3>(forces.data() + 3 * std::size_t(i)) = loads.nodal_forces[i];
    return find(compliance.solve(forces));
  }

  Model       model;
  StaticLoads loads;
};

void print(const std::string &name, const RootStresses &stresses)
{
  std::cout << name << ": tension " << std::fixed << std::setprecision(1) << stresses.tension
            << ", compression " << stresses.compression << " MPa" << std::endl;
}

/** Cells that are nearly as deep and as wide at the fillets as the facets are long. */
GearBodyOptions graded_pinion()
{
  GearBodyOptions options        = coarsest(pinion_body_defaults());
  options.cells_across           = 4;
  options.rim_rows               = 6;
  options.grading_towards_fillet = 10.;
  options.grading_towards_flank  = 3.;
  return options;
}

void family(const Communicator &world)
{
  for (const bool graded : {false, true})
    {
      std::cout << (graded ? "graded" : "even") << " mesh" << std::endl;
      std::vector<RootStresses> found;
      for (const unsigned int refinements : {0u, 1u, 2u})
        {
          const LoadedTooth tooth(graded ? graded_pinion() : coarsest(pinion_body_defaults()),
                                  refinements);
          found.push_back(tooth.solve_by_sectors(world));
          print("  " + std::to_string(tooth.model.n_elements()) + " elements", found.back());
          if (refinements == 0)
            check_ratio("  by sectors as whole",
                        tooth.solve(FemElement::incompatible_modes, world).tension /
                          found.back().tension,
                        1e-8);
        }
      // Cells that are deep under the fillet hold the root land back, however many facets there
      // are.
      check("  differences fall to less than half",
            graded ==
              (found[2].tension - found[1].tension < .5 * (found[1].tension - found[0].tension) &&
               found[2].compression - found[1].compression >
                 .5 * (found[1].compression - found[0].compression)));
    }
}

/** C3D8I on the cells, or C3D20 with straight sides. */
void write_input(const LoadedTooth &tooth, const FemElement element, const std::string &path)
{
  const FemSpace d(tooth.model, {0}, element);
  std::ofstream  out(path);
  out << std::setprecision(12) << "*NODE, NSET=ALL\n";
  // Middles of faces and cells belong to elements of 27 nodes alone.
  constexpr unsigned int                 edges[12] = {1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15};
  std::map<unsigned int, bool>           used;
  std::vector<std::vector<unsigned int>> cells;
  for (unsigned int e = 0; e < d.n_elements(); ++e)
    {
      const unsigned int       *points = d.element_points(e);
      std::vector<unsigned int> cell;
      for (const unsigned int k : corner_of_files)
        cell.push_back(
          points[element == FemElement::quadratic ? 2 * (k % 2) + 6 * (k / 2 % 2) + 18 * (k / 4)
                                                  : k]);
      if (element == FemElement::quadratic)
        for (const unsigned int k : edges)
          cell.push_back(points[k]);
      for (const unsigned int p : cell)
        used[p] = true;
      cells.push_back(cell);
    }
  for (const auto &point : used)
    {
      const Vector3 &x = d.points()[point.first];
      out << point.first + 1 << "," << x[0] << "," << x[1] << "," << x[2] << "\n";
    }
  out << "*ELEMENT, ELSET=BODY, TYPE=" << (element == FemElement::quadratic ? "C3D20" : "C3D8I")
      << "\n";
  for (std::size_t e = 0; e < cells.size(); ++e)
    {
      std::vector<unsigned int> line = {static_cast<unsigned int>(e + 1)};
      for (const unsigned int p : cells[e])
        line.push_back(p + 1);
      for (std::size_t i = 0; i < line.size(); ++i)
        out << line[i] << (i + 1 == line.size() ? "\n" : i == 10 ? ",\n" : ",");
    }
  const Material &material = tooth.model.bodies[0].materials().front();
  out << "*MATERIAL, NAME=STEEL\n*ELASTIC\n"
      << material.youngs_modulus << "," << material.poissons_ratio
      << "\n*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n*BOUNDARY\n";
  for (const unsigned int p : d.points_of(d.parts()[0], tooth.model.constraints[0].nodes))
    if (used.count(p) == 1)
      out << p + 1 << ",1,3\n";
  out << "*NSET, NSET=FILLET\n";
  for (const unsigned int i : tooth.fillet_nodes())
    out << i + 1 << ",\n";
  out << "*STEP\n*STATIC\n*CLOAD\n";
  for (unsigned int i = 0; i < tooth.loads.nodal_forces.size(); ++i)
    for (unsigned int c = 0; c < 3; ++c)
      if (tooth.loads.nodal_forces[i][c] != 0.)
        out << i + 1 << "," << c + 1 << "," << tooth.loads.nodal_forces[i][c] << "\n";
  out << "*NODE PRINT, NSET=FILLET\nU\n*EL FILE\nS\n*END STEP\n";
}

/** Displacements of the fillets' nodes from the .dat file. */
std::map<unsigned int, Vector3> read_displacements(const std::string &path)
{
  std::ifstream                   in(path);
  std::map<unsigned int, Vector3> u;
  for (std::string line; std::getline(in, line);)
    {
      std::istringstream words(line);
      unsigned int       node;
      Vector3            moved;
      if (words >> node >> moved[0] >> moved[1] >> moved[2])
        u[node - 1] = moved;
    }
  return u;
}

/** Largest principal stresses that CalculiX itself has at those nodes, from the .frd file. */
RootStresses read_stresses(const std::string &path, const std::map<unsigned int, Vector3> &nodes)
{
  std::ifstream in(path);
  RootStresses  found;
  bool          inside = false;
  for (std::string line; std::getline(in, line);)
    {
      if (line.rfind(" -4", 0) == 0)
        inside = has_text(line, "STRESS");
      if (!inside || line.rfind(" -1", 0) != 0 ||
          nodes.count(std::stoul(line.substr(3, 10)) - 1) == 0)
        continue;
      double s[6];
      for (unsigned int c = 0; c < 6; ++c)
        s[c] = std::stod(line.substr(13 + 12 * c, 12));
      Matrix3 tensor;
      tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
      const Vector3 principal = tensor.selfadjointView<Eigen::Lower>().eigenvalues();
      found.tension           = std::max(found.tension, principal.maxCoeff());
      found.compression       = std::min(found.compression, principal.minCoeff());
    }
  return found;
}

int compare_with_calculix(const std::string &folder, const Communicator &world)
{
  if (std::system("command -v ccx >/dev/null") != 0)
    return 77;
  std::filesystem::create_directories(folder);
  for (const auto &[element, refinements] : {std::make_pair(FemElement::incompatible_modes, 0u),
                                             std::make_pair(FemElement::incompatible_modes, 1u),
                                             std::make_pair(FemElement::quadratic, 0u)})
    {
      // What is shown and not compared needs no graded mesh.
      const LoadedTooth tooth(element == FemElement::quadratic ? coarsest(pinion_body_defaults())
                                                               : graded_pinion(),
                              refinements);
      const std::string type = element == FemElement::quadratic ? "C3D20" : "C3D8I",
                        name = type + "_" + std::to_string(refinements);
      const std::string path = folder + "/" + name;
      write_input(tooth, element, path + ".inp");
      if (std::system(("cd '" + folder + "' && ccx " + name + " >" + name + ".log").c_str()) != 0)
        std::cout << name << ": FAILED, ccx ends with an error" << std::endl;
      const auto         u      = read_displacements(path + ".dat");
      const RootStresses ours   = element == FemElement::quadratic ? tooth.solve(element, world)
                                                                   : tooth.solve_by_sectors(world),
                         theirs = tooth.find([&u](const unsigned int i) { return u.at(i); });
      print(word_of(element, fem_element_choices()), ours);
      print(name + ", displacements", theirs);
      print(name + ", its own stresses at nodes", read_stresses(path + ".frd", u));
      // Quadratic elements see the corners between the two facets of a profile as notches, each
      // kind in its own way: shown, and not compared.
      if (element == FemElement::quadratic)
        continue;
      check_ratio(name + ": tension", theirs.tension / ours.tension, .03);
      check_ratio(name + ": compression", theirs.compression / ours.compression, .03);
    }
  return 0;
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  if (argc == 3)
    return compare_with_calculix(argv[2], session.world());
  family(session.world());
  return 0;
}
