// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Congruent elements, their packs, the operator's forces against dense element matrices, and
// relaxation against a turning bar's closed form.
#include "../internal_force.h"
#include "../refusal.h"
#include "../tests.h"
#include "relaxed.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/body_mesh.h>

#include <random>
#include <set>

using namespace vfife;

/** Random numbers in [-1, 1], the same everywhere. */
double noise()
{
  static std::mt19937 generator(7);
  return 2. * generator() / 4294967295. - 1.;
}

Vector3 random_vector()
{
  const double x = noise(), y = noise(), z = noise();
  return Vector3(x, y, z);
}

/** A block whose inner and outer nodes are moved by up to a tenth of a cell. */
std::unique_ptr<BodyMesh> make_distorted_block(const std::array<unsigned int, 3> &counts)
{
  const auto block = make_block(Vector3(counts[0], counts[1], counts[2]), counts);
  return make_moved(*block, "distorted block", [](const Vector3 &x) -> Vector3 {
    return x + 0.1 * random_vector();
  });
}

std::size_t n_classes(const Body &body)
{
  std::vector<std::uint32_t> all(body.n_elements());
  std::iota(all.begin(), all.end(), 0);
  return find_congruence_classes(body, all).size.size();
}

void check_classes()
{
  check("block has one class",
        n_classes(Body("block", make_block(Vector3(7, 1.3, 2.1), {{7, 5, 3}}), Material())) == 1);
  check("ring has one class",
        n_classes(Body("ring", make_ring(20, 30, 5, {{1, 31, 1}}), Material())) == 1);
  check("ring of two rows has two",
        n_classes(Body("ring", make_ring(20, 30, 5, {{2, 31, 3}}), Material())) == 2);
  check("distorted block has as many as elements",
        n_classes(Body("distorted", make_distorted_block({{3, 2, 2}}), Material())) == 12);
}

void check_packs()
{
  Model model =
    model_of(Body("block", make_block(Vector3(3, 3, 2), {{3, 3, 2}}), Material())); // 18 elements
  model.add_body(Body("distorted", make_distorted_block({{3, 1, 1}}), Material()));
  const auto rank_of_element = assign_elements(model, 1);
  const auto packs           = make_packs(model, rank_of_element, 0);
  check("block: three packs of a class",
        packs[0].shared_packs.size() == 3 * n_lanes && packs[0].own_packs.empty());
  check("distorted block: one pack of its own",
        packs[1].own_packs.size() == n_lanes && packs[1].shared_packs.empty());

  const auto count = [](const std::vector<std::uint32_t> &rows, const std::size_t n_elements) {
    std::multiset<std::uint32_t> used(rows.begin(), rows.end());
    bool                         each_once = true;
    for (std::uint32_t row = 0; row < n_elements; ++row)
      each_once = each_once && used.count(row) == 1;
    return each_once && used.count(Partition::absent) == rows.size() - n_elements;
  };
  check("block: each element once, the rest is padding", count(packs[0].shared_packs, 18));
  check("distorted block: each element once, the rest is padding", count(packs[1].own_packs, 3));

  const Partition partition = make_partition(model, packs, rank_of_element, 0);
  check("partition: all nodes, body by body",
        partition.n_local() == model.n_nodes() &&
          partition.first_local_node[1] == model.bodies[0].n_nodes());
  bool inverse = true;
  for (std::uint32_t i = 0; i < partition.n_local(); ++i)
    inverse = inverse && partition.local_node[partition.global_node[i]] == i && partition.owned[i];
  check("partition: numbering and its inverse", inverse);
}

/** A bar of 2 x 2 x 24 cells cut across in two: the four cells at the cut are in the first pack.
 */
void check_border(const bool share_constants)
{
  Model      model = model_of(Body("bar", make_block(Vector3(2, 2, 24), {{2, 2, 24}}), Material()));
  const auto rank_of_element = assign_elements(model, 2);
  const auto packs           = make_packs(model, rank_of_element, 0, share_constants)[0];
  const auto       &rows     = share_constants ? packs.shared_packs : packs.own_packs;
  const std::size_t first    = share_constants ? packs.n_shared_at_border : packs.n_own_at_border;
  bool              inside   = true;
  for (std::size_t slot = n_lanes * first; slot < rows.size(); ++slot)
    inside = inside && packs.elements[rows[slot]] < 44;
  check(std::string("packs at the border come first, ") + (share_constants ? "shared" : "own"),
        rows.size() == 48 && first == 1 && inside);
}

void check_forces(const StiffnessKind stiffness, const FrameKind frame, const std::string &name)
{
  Material material;
  Model    model = model_of(Body("block", make_block(Vector3(3, 3, 2), {{3, 3, 2}}), material));
  model.add_body(Body("distorted", make_distorted_block({{3, 3, 2}}), material));
  const Communicator alone(MPI_COMM_SELF);
  VfifeOperator      vfife(model, frame, stiffness, alone);

  // Turned far and strained by about a percent.
  const Partition &partition = vfife.partition();
  const Matrix3    turn      = rotation_about(Vector3(1, -2, 2) / 3., 2.);
  NodeField        positions = vfife.make_field(), forces = vfife.make_field();
  for (unsigned int b = 0; b < 2; ++b)
    for (unsigned int i = 0; i < model.bodies[b].n_nodes(); ++i)
      positions.set(partition.local_node[model.bodies[b].first_node + i],
                    turn * (model.bodies[b].node_positions()[i] + 0.005 * random_vector()) +
                      Vector3(40, -20, 10));
  for (std::size_t i = 0; i < forces.n_nodes(); ++i)
    forces.set(i, Vector3::Ones()); // is overwritten
  NodeField measured = forces;
  vfife.compute_internal_forces(positions, forces);
  const double energy = vfife.measure_internal_forces(positions, measured).strain_energy;

  std::vector<Vector3> reference(partition.n_local(), Vector3::Zero());
  std::vector<double>  masses(partition.n_local(), 0.);
  double               reference_energy = 0, size = 0;
  for (const Body &body : model.bodies)
    for (unsigned int e = 0; e < body.n_elements(); ++e)
      {
        const HexahedronNodes X = body.element_nodes(e);
        HexahedronNodes       x;
        std::uint32_t         local[8];
        for (unsigned int i = 0; i < 8; ++i)
          {
            local[i] = partition.local_node[body.first_node + body.elements()[e][i]];
            x.col(i) = positions.value(local[i]);
          }
        const Matrix24        K = compute_stiffness(X, material, stiffness);
        const HexahedronNodes f = compute_internal_forces(K, X, x, frame);
        const auto            m = compute_lumped_mass(X, material.density);
        reference_energy += compute_strain_energy(K, X, x, frame);
        for (unsigned int i = 0; i < 8; ++i)
          {
            reference[local[i]] += f.col(i);
            masses[local[i]] += m[i];
            raise_to(size, f.col(i).norm());
          }
      }
  double error = 0, mass_error = 0;
  for (std::uint32_t i = 0; i < partition.n_local(); ++i)
    {
      raise_to(error, (forces.value(i) - reference[i]).norm());
      raise_to(mass_error, std::abs(vfife.masses()[i] / masses[i] - 1));
    }
  // Coordinates of 50 mm in cells of 1 mm strained by 1e-2 lose four digits of sixteen.
  check_below(name + ": forces over the largest", error / size, 1e-11);
  check_ratio(name + ": strain energy", energy / reference_energy, 1e-11);
  check_below(name + ": masses", mass_error, 1e-13);
}

void check_relaxation()
{
  // Code_Aster SSLV104: a bar turns about an axis through its held end, the load follows the
  // moved masses.
  const unsigned int n = 40;
  const double       L = 500, H = 20, h = L / n;
  Material           material;
  material.youngs_modulus = 200000;
  material.poissons_ratio = 0;
  material.density        = 7.8e-9;
  Model model;
  Body  bar("bar", make_block(Vector3(L, H, H), {{n, 1, 1}}), material);
  bar.placement.rotation = rotation_about(Vector3::UnitZ(), 0.7);
  const Vector3 end(5, 6, 7); // the middle of the held end
  bar.placement.translation = end + bar.placement.rotation * Vector3(0, -H / 2, -H / 2);
  bar.axis.point            = end - Vector3(0, 0, 50); // any point of the axis
  bar.rate                  = 3000;
  model.add_body(std::move(bar));
  model.constraints.push_back({"end", ConstraintKind::held, 0, model.bodies[0].node_set("x-")});
  OneSolver run(model, undamped());
  run.options.relaxation.tolerance = 1e-8;
  const RelaxationReport report    = relax(model, run);

  Vector3 tip  = Vector3::Zero();
  double  held = 0;
  for (const unsigned int node : model.bodies[0].node_set("x+"))
    tip += run.state.node_position(run.state.partition->local_node[node]) / 4;
  for (const unsigned int node : model.bodies[0].node_set("x-"))
    raise_to(held,
             (run.state.node_position(run.state.partition->local_node[node]) -
              model.bodies[0].placement(model.bodies[0].node_positions()[node]))
               .norm());
  const Vector3 way = model.bodies[0].placement.rotation.transpose() * (tip - end);

  // The lumped bar: X_j = h sin(j t)/(cos(n t) sin t) with 2 (1 - cos t) = (k h)^2.
  const double k      = 3000 * std::sqrt(material.density / material.youngs_modulus);
  const double t      = std::acos(1 - k * k * h * h / 2);
  const double lumped = h * std::tan(n * t) / std::sin(t) - L,
               exact  = L * (std::tan(k * L) / (k * L) - 1);
  check("relaxation: residual below the tolerance", report.residual < 1e-8 && report.steps > 0);
  // The residual of 1e-8 of the load, times the bar's length in elements (40 to 1600).
  check_ratio("turning bar: extension over that of lumped masses", (way[0] - L) / lumped, 1e-5);
  // Lumping is right to (k h)^2/6 = 9e-6 of X, which is 34 times the extension.
  check_ratio("turning bar: extension over closed form", (way[0] - L) / exact, 4e-4);
  check_below("turning bar: sideways over the extension", way.tail<2>().norm() / exact, 1e-6);
  check_below("turning bar: held end", held, 0);

  // A start at the answer needs no steps, and too few steps are an error.
  check("relaxation: at once when in equilibrium", relax(model, run).steps == 0);
  run.solver.start(run.state);
  run.options.relaxation.largest_steps = 10;
  check("relaxation: gives up", refuses<NumericalError>([&] { relax(model, run); }));
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  check_classes();
  check_packs();
  check_border(true);
  check_border(false);
  check_forces(StiffnessKind::incompatible_modes,
               FrameKind::polar,
               "incompatible modes, polar frame");
  check_forces(StiffnessKind::full, FrameKind::polar, "full integration, polar frame");
  check_forces(StiffnessKind::incompatible_modes, FrameKind::three_nodes, "three-node frame");
  check_relaxation();
  return 0;
}
