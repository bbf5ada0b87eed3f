// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_reduced_whole_body_h
#define vfife_tests_reduced_whole_body_h

#include "../model_parts.h"
#include "../study/gear_model.h"
#include "../study/quick_pair.h"

#include <vfife/base/process/communicator.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/fem_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/body_frame.h>
#include <vfife/reduced/reduced_body.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
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
  model.torques.push_back(torque_on(model, set, 1.));
}

/** A wheel of twelve sectors, placed askew. */
inline vfife::Model make_wheel(const std::optional<vfife::ConstraintKind> &hub,
                               const double                                rate,
                               const std::array<unsigned int, 3>          &cells = {{6, 12, 4}})
{
  vfife::Model model;
  vfife::Body  wheel("wheel", vfife::make_ring(20., 40., 3., cells), {});
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
  const std::string all =
    quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5");
  vfife::Model pair = make_gear_model("pinion.prm",
                                      all.substr(0, all.find("subsection Dynamics")),
                                      world),
               model;
  model.add_body(std::move(pair.bodies[0]));
  hold_hub(model, "bore", hub, rate);
  return model;
}

/** That body, held by nothing else, in a bearing at either end of the set, turned by a coupling or
 * by nothing: radial springs [N/mm], @p unlike times as stiff along y. */
inline vfife::Model hang_in_bearings(vfife::Model       model,
                                     const std::string &set,
                                     const double       radial,
                                     const double       unlike,
                                     const double       coupling)
{
  vfife::Body                    &body   = model.bodies[0];
  const std::vector<unsigned int> nodes  = body.node_set(set);
  const auto                      height = [&body](const unsigned int a, const unsigned int b) {
    return body.node_positions()[a].z() < body.node_positions()[b].z();
  };
  const double first =
                 body.node_positions()[*std::min_element(nodes.begin(), nodes.end(), height)].z(),
               last =
                 body.node_positions()[*std::max_element(nodes.begin(), nodes.end(), height)].z();
  body.floats = true;
  model.constraints.clear();
  for (const bool front : {true, false})
    {
      vfife::Bearing bearing;
      bearing.name = front ? "front" : "back";
      for (const unsigned int node : nodes)
        if (std::abs(body.node_positions()[node].z() - (front ? first : last)) <
            .4 * (last - first))
          bearing.nodes.push_back(node);
      bearing.axes = vfife::axes_along(body.axis.direction);
      vfife::Matrix5 K =
        vfife::Vector5(radial, unlike * radial, .3 * radial, 50. * radial, 50. * radial)
          .asDiagonal();
      // A force tilts it, alike in all directions.
      K(0, 4) = K(4, 0) = .1 * radial;
      K(1, 3) = K(3, 1) = -.1 * radial;
      bearing.law =
        std::make_shared<vfife::LinearBearing>(K, vfife::Matrix5::Zero(), vfife::Vector5::Zero());
      model.bearings.push_back(bearing);
    }
  if (coupling > 0)
    model.couplings.push_back({"drive", 0, nodes, coupling, 0.});
  // Its turn may be asked for.
  model.transmissions.emplace_back();
  model.transmissions.front().driven = 0;
  return model;
}

/** All nodes of sector 0. */
inline std::vector<unsigned int> first_sector(const vfife::Body &body)
{
  return numbers_below(body.structure().nodes_per_sector());
}

/** Displacements of all nodes (fixed frame, 3 a node) of what the rows of all nodes of the sectors
 * read: rows(k) gives those of sector k in its own axes. */
template <typename Rows>
std::vector<double> whole_field(const vfife::Body &body, const Rows &rows)
{
  const vfife::Vector3 axis = vfife::compute_sector_axis(body).direction;
  std::vector<double>  field;
  for (unsigned int k = 0; k < body.mesh().structure.n_sectors(); ++k)
    {
      const Eigen::VectorXd values = rows(k);
      const vfife::Matrix3  turn =
        vfife::rotation_about(axis, 2. * vfife::pi * k / body.mesh().structure.n_sectors()) *
        body.placement.rotation;
      for (unsigned int i = 0; i < body.structure().nodes_per_sector(); ++i)
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
