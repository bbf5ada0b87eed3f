// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes of a surface in contact between which elements have points, and corners of the parts of its
// facets: linear fields, force and moment of their tractions, and a block under even pressure by
// forces on its nodes.
#include "../composite.h"
#include "../ranks.h"
#include "../tests.h"

#include <vfife/fem/statics/compliance.h>
#include <vfife/model/load_shares.h>

using namespace vfife;

/** Two blocks, one on the other, with uneven facets where they meet; each is led by its sides. */
Model make_blocks()
{
  Model model;
  for (const double z : {0., 1.})
    {
      auto mesh = make_block(Vector3(2., 1.5, 1.), {{3, 3, 2}}, Vector3(0., 0., z));
      for (const auto &cell : mesh->triangulation.active_cell_iterators())
        for (unsigned int v = 0; v < 8; ++v)
          if (auto &x = cell->vertex(v);
              x[2] == 1. && x[0] > .1 && x[0] < 1.9 && x[1] > .1 && x[1] < 1.4 && v % 4 == 0)
            x[0] += .1;
      model.add_body(Body(z > 0. ? "upper" : "lower", std::move(mesh), {}));
    }
  model.contacts.push_back(contact_of("faces", {1, "z-"}, {0, "z+"}));
  for (unsigned int body = 0; body < 2; ++body)
    for (const auto &[side, direction] :
         {std::pair("x-", 0), std::pair("y-", 1), std::pair(body == 0 ? "z-" : "z+", 2)})
      {
        std::array<bool, 3> directions = {{false, false, false}};
        directions[direction]          = true;
        model.constraints.push_back(hold(model.bodies[body].node_set(side), directions));
        model.constraints.back().body = body;
      }
  return model;
}

/** By how much the weights of a point do not sum to one or not have its place as their mean. */
double find_error(const FemSpace &space, const unsigned int point, const PointWeights &weights)
{
  double  sum  = 0;
  Vector3 mean = Vector3::Zero();
  for (const auto &[p, weight] : weights)
    {
      sum += weight;
      mean += weight * space.points()[p];
    }
  return std::abs(sum - 1.) + (mean - space.points()[point]).norm();
}

/** The parts of a surface's facets cover them, and their corners have linear fields. */
void check_parts(const std::string &name, const FemSpace &space, const Model &model)
{
  const FacetParts parts(space);
  double           worst = 0, most = 0;
  for (const auto &[body, surface] : {std::pair(1u, "z-"), std::pair(0u, "z+")})
    {
      const unsigned int  first  = space.find_part(body)->first_point;
      const FacetSurface &facets = model.bodies[body].mesh().surfaces.at(surface);
      for (const auto &facet : facets.facets)
        {
          FacetParts::Corners    corners;
          std::array<Vector3, 4> x;
          for (unsigned int k = 0; k < 4; ++k)
            {
              corners[k] = first + facets.nodes[facet[k]];
              x[k]       = space.points()[corners[k]];
            }
          const std::vector<FacetParts::Corners> of_facet = parts.of(corners);
          double                                 area     = 0;
          for (const FacetParts::Corners &part : of_facet)
            {
              std::array<Vector2, 4> places;
              for (unsigned int k = 0; k < 4; ++k)
                {
                  places[k] = place_on_facet(x, space.points()[part[k]]);
                  raise_to(worst, find_error(space, part[k], parts.mean_of(part[k])));
                }
              const Vector2 a = places[2] - places[0], b = places[3] - places[1];
              area += .5 * std::abs(a[0] * b[1] - a[1] * b[0]);
            }
          raise_to(worst, std::abs(area - 1.));
          raise_to(most, double(of_facet.size()));
        }
    }
  check_below(name + ": parts of facets", worst, 1e-12);
  const unsigned int pieces = space.n_elements() > 36 ? 2 : 1;
  check(name + ": number of parts", most == std::pow(space.degree() * pieces, 2));
}

void check_weights(const std::string &name, const FemSpace &space, const Model &model)
{
  const NodeAverages averages(space);
  double             worst = 0, most = 0;
  for (const ContactPair &pair : model.contacts)
    for (const auto &[body, surface] : {std::pair(pair.slave_body, pair.slave_surface),
                                        std::pair(pair.master_body, pair.master_surface)})
      for (const unsigned int node : model.bodies[body].node_set(surface))
        {
          const unsigned int point = space.find_part(body)->first_point + node;
          raise_to(worst, find_error(space, point, averages.of(point)));
          raise_to(most, double(averages.of(point).size()));
        }
  check_below(name + ": linear fields", worst, 1e-13);
  check(name + ": points by which nodes move",
        (most > 1.) == (space.degree() > 1 || space.n_elements() > 36));
}

/** The forces of an even pressure on nodes compress the block evenly. */
void press(const std::string  &name,
           const Model        &model,
           const FemOptions   &options,
           const Communicator &communicator)
{
  Compliance                      compliance(model, options, false, communicator);
  const FemSpace                 &space = compliance.space();
  const Body                     &body  = model.bodies[0];
  const std::vector<unsigned int> nodes = body.node_set("z+");
  check_weights(name, space, model);
  check_parts(name, space, model);
  compliance.watch(nodes);
  const std::vector<double> shares = compute_area_shares(body, nodes);
  constexpr double          force  = 3e3; // [N] on 3 mm^2
  Eigen::VectorXd           forces = Eigen::VectorXd::Zero(compliance.first_motion_row());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    forces[3 * k + 2] = -force * shares[k];
  const std::vector<double> u      = compliance.solve(compliance.spread(forces));
  const double              strain = -1e3 / body.materials().front().youngs_modulus,
               across              = -body.materials().front().poissons_ratio * strain;
  double worst                     = 0;
  for (unsigned int p = 0; p < space.parts()[0].n_points; ++p)
    raise_to(worst,
             (Eigen::Map<const Vector3>(u.data() + 3 * std::size_t(p)) -
              space.points()[p].cwiseProduct(Vector3(across, across, strain)))
               .norm());
  check_below(name + ": even pressure", worst / -strain, 1e-12);

  // The flexibility of nodes and corners is symmetric, and forces act as their sum and moment.
  std::vector<unsigned int> rows(forces.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = i;
  const Eigen::MatrixXd A = compliance.flexibility(rows);
  check_below(name + ": symmetry", (A - A.transpose()).norm() / A.norm(), 1e-12);
  const Eigen::VectorXd     some   = Eigen::VectorXd::LinSpaced(forces.size(), -3., 8.);
  const std::vector<double> spread = compliance.spread(some);
  Vector3                   sum = Vector3::Zero(), moment = Vector3::Zero();
  std::vector<unsigned int> points = compliance.watched();
  points.insert(points.end(),
                compliance.surface_points().begin(),
                compliance.surface_points().end());
  for (std::size_t k = 0; k < points.size(); ++k)
    {
      sum += some.segment<3>(3 * k);
      moment += space.points()[points[k]].cross(some.segment<3>(3 * k));
    }
  for (unsigned int p = 0; p < space.n_points(); ++p)
    {
      const Vector3 f = Eigen::Map<const Vector3>(spread.data() + 3 * std::size_t(p));
      sum -= f;
      moment -= space.points()[p].cross(f);
    }
  check_below(name + ": force and moment", (sum.norm() + moment.norm()) / some.norm(), 1e-12);
}

int main(int argc, char **argv)
{
  const TestRanks ranks(argc, argv);
  const Model     model = make_blocks();
  for (const auto &choice : fem_element_choices())
    for (const bool divided : {false, true})
      {
        FemOptions options;
        options.element       = choice.second;
        options.linear_solver = LinearSolverKind::direct;
        if (divided)
          options.local_refinement = {"x- 1"};
        press(choice.first + (divided ? ", divided at a side" : ""), model, options, ranks.world);
      }
  return 0;
}
