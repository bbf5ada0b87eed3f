// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_reduced_whole_body_h
#define vfife_tests_reduced_whole_body_h

#include "../study/gear_model.h"
#include "../study/quick_pair.h"

#include <vfife/base/process/communicator.h>
#include <vfife/fem/fem_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/body_frame.h>
#include <vfife/reduced/reduced_body.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <numeric>
#include <optional>
#include <vector>

/** Holds the hub of a model's only body in a way, or in none, and puts a torque on it. */
inline void hold_hub(vfife::Model                               &model,
                     const std::string                          &set,
                     const std::optional<vfife::ConstraintKind> &hub,
                     const double                                rate)
{
  vfife::Body                    &body  = model.bodies[0];
  const std::vector<unsigned int> nodes = body.node_set(set);
  body.rate                             = rate;
  model.constraints.clear();
  model.torques.clear();
  if (hub)
    model.constraints.push_back({"hub", *hub, 0, nodes});
  vfife::Torque torque;
  torque.name  = "torque";
  torque.nodes = nodes;
  torque.areas = vfife::compute_nodal_areas(body, nodes);
  torque.value = 1.;
  model.torques.push_back(torque);
}

/** A wheel of twelve sectors, placed askew. */
inline vfife::Model make_wheel(const std::optional<vfife::ConstraintKind> &hub, const double rate)
{
  vfife::Model model;
  vfife::Body  wheel("wheel", vfife::make_ring(20., 40., 3., {{6, 12, 4}}), {});
  wheel.placement.rotation    = vfife::rotation_about(vfife::Vector3(1., 2., -1.).normalized(), 1.);
  wheel.placement.translation = vfife::Vector3(7., -5., 3.);
  // It turns against the sense in which its sectors follow each other.
  wheel.axis = {wheel.placement(vfife::Vector3(0., 0., 11.)),
                wheel.placement.rotation * -vfife::Vector3::UnitZ()};
  model.add_body(std::move(wheel));
  hold_hub(model, "inner", hub, rate);
  return model;
}

/** The coarsest pinion of the paper's pair, 27 sectors without a mirror plane. */
inline vfife::Model make_pinion(const std::optional<vfife::ConstraintKind> &hub,
                                const double                                rate,
                                const vfife::Communicator                  &world)
{
  const std::string all = quick_pair("set web = none", "set rim rows = 2", "1e-5");
  std::ofstream("pinion.prm") << all.substr(0, all.find("subsection Dynamics"));
  vfife::Model pair = make_gear_model("pinion.prm", world), model;
  model.add_body(std::move(pair.bodies[0]));
  hold_hub(model, "bore", hub, rate);
  return model;
}

/** All nodes of sector 0. */
inline std::vector<unsigned int> first_sector(const vfife::Body &body)
{
  std::vector<unsigned int> nodes(vfife::nodes_per_sector(body));
  std::iota(nodes.begin(), nodes.end(), 0u);
  return nodes;
}

/** Displacements of all nodes (fixed frame, 3 a node) of what the rows of all nodes of the sectors
 * read: rows(k) gives those of sector k in its own axes. */
template <typename Rows>
std::vector<double> whole_field(const vfife::Body &body, const Rows &rows)
{
  const vfife::Vector3 axis = vfife::compute_sector_axis(body).direction;
  std::vector<double>  field;
  for (unsigned int k = 0; k < body.mesh().n_sectors; ++k)
    {
      const Eigen::VectorXd values = rows(k);
      const vfife::Matrix3  turn =
        vfife::rotation_about(axis, 2. * vfife::pi * k / body.mesh().n_sectors) *
        body.placement.rotation;
      for (unsigned int i = 0; i < vfife::nodes_per_sector(body); ++i)
        {
          const vfife::Vector3 u = turn * values.segment<3>(3 * i);
          field.insert(field.end(), u.data(), u.data() + 3);
        }
    }
  return field;
}

/** Rows of sector @p d under unit forces on sector 0, by modes and residuals together. */
inline Eigen::MatrixXd static_answer(const vfife::ReducedBody &body, const int d)
{
  Eigen::MatrixXd answer = body.residual[d + body.reach];
  for (const vfife::ReducedBody::Harmonic &harmonic : body.harmonics)
    answer += (std::polar(1., d * body.sector_angle * harmonic.number) * harmonic.shapes *
               harmonic.eigenvalues.cwiseInverse().cast<std::complex<double>>().asDiagonal() *
               harmonic.shapes.topRows(3 * body.touch_nodes.size()).adjoint())
                .real();
  return answer;
}

#endif
