// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_fem_pair_in_bearings_h
#define vfife_tests_fem_pair_in_bearings_h

#include "../study/few_teeth.h"
#include "../study/gear_model.h"

#include <vfife/bearing/bearing_law.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/fem_options.h>
#include <vfife/fem/pair/pair_equilibrium.h>

#include <memory>
#include <vector>

/** Steel a thousand times as stiff on a soft contact: bodies that do not deform. */
constexpr char rigid_steel[]   = "subsection Material steel\n set Young's modulus = 2.06e8\nend\n"
                                 "subsection Contact\n set penalty = 3e4\nend\n";
constexpr char stiff_contact[] = "subsection Contact\n set penalty = 6e5\nend\n";

/** A coarse pair without a web, 800 N m, both bodies held at the underside of the rim; @p more:
 * sections of a parameter file. */
inline vfife::Model make_held_pair(const vfife::Communicator &world,
                                   const std::string         &more = stiff_contact)
{
  return make_gear_model("in_bearings.prm",
                         few_teeth("set body type = rim only", "set elements through rim = 2") +
                           "subsection Operation\nset speed = 20000 rpm\nset torque = 800 N m\n"
                           "set mesh cycles = 1\nset bore rotation = rigid\nend\n" +
                           more,
                         world);
}

/** The nodes of @p nodes in the third of their length towards the apex, or in the last one. */
inline std::vector<unsigned int>
end_of(const vfife::Body &body, const std::vector<unsigned int> &nodes, const bool front)
{
  double least = 1e9, most = -1e9;
  for (const unsigned int node : nodes)
    {
      least = std::min(least, body.node_positions()[node].z());
      most  = std::max(most, body.node_positions()[node].z());
    }
  std::vector<unsigned int> end;
  for (const unsigned int node : nodes)
    if (std::abs(body.node_positions()[node].z() - (front ? least : most)) < (most - least) / 3)
      end.push_back(node);
  return end;
}

inline vfife::Matrix5
bearing_stiffness(const double radial, const double axial, const double tilting)
{
  return vfife::Vector5(radial, radial, axial, tilting, tilting).asDiagonal();
}

/** Bearings that give way by some um. */
inline const vfife::Matrix5 soft_front = bearing_stiffness(2e5, 3e5, 1e8),
                            soft_back  = bearing_stiffness(4e5, 1e5, 2e8);

inline std::shared_ptr<const vfife::BearingLaw>
linear_bearing(const vfife::Matrix5 &stiffness,
               const vfife::Vector5 &preload = vfife::Vector5::Zero())
{
  return std::make_shared<vfife::LinearBearing>(stiffness, vfife::Matrix5::Zero(), preload);
}

/** That pair with a bearing of each law in front and behind on each body (driver front, back,
 * driven front, back; no law: none) and a coupling on the driver instead of its constraints. */
inline void hang_in_bearings(vfife::Model                                                &model,
                             const std::vector<std::shared_ptr<const vfife::BearingLaw>> &laws,
                             const double                                                 coupling)
{
  using namespace vfife;
  Transmission             &t     = model.transmissions.front();
  std::vector<unsigned int> inner = model.constraints.front().nodes;
  model.constraints.clear();
  t.driver_bore = inner;
  for (unsigned int i = 0; i < 4; ++i)
    if (laws[i] != nullptr)
      {
        const unsigned int body = i < 2 ? t.driver : t.driven;
        Bearing            bearing;
        bearing.name  = std::string(i % 2 == 0 ? "front of " : "back of ") + std::to_string(body);
        bearing.body  = body;
        bearing.nodes = end_of(model.bodies[body], i < 2 ? inner : t.driven_bore, i % 2 == 0);
        bearing.axes  = axes_along(model.bodies[body].axis.direction);
        bearing.law   = laws[i];
        model.bearings.push_back(bearing);
      }
  model.couplings.push_back({"drive", t.driver, inner, coupling, 0.});
}

inline vfife::FemOptions lumped_masses()
{
  vfife::FemOptions fem;
  fem.mass = vfife::MassKind::lumped;
  return fem;
}

/** Transmission errors [rad] of a position but for the angles at time zero: of the unloaded pair,
 * of the loaded one, and what the latter changes by with the load factor. */
struct Errors
{
  double unloaded, loaded, slope;
};

inline Errors transmission_errors(const vfife::FemSpace              &space,
                                  const vfife::PairEquilibriumResult &result)
{
  const auto error = [&](const double turn, const std::vector<double> &u) {
    return lead_of_driven(space, turn, u);
  };
  return {error(result.touch_turn, result.touch_displacements),
          error(result.turn, result.displacements),
          error(result.turn_slope, result.displacement_slope)};
}

/** Forces that do not balance, over the contact's: sum of contact and bearings, of each body. */
inline double unbalanced(const vfife::Model &model, const vfife::PairEquilibriumResult &result)
{
  using namespace vfife;
  Vector3 contact = Vector3::Zero(); // on the driver, whose flank is the slave
  for (const ToothContact &tooth : result.teeth)
    contact += tooth.force;
  double largest = 0;
  for (unsigned int body = 0; body < 2; ++body)
    {
      Vector3 sum = body == model.only_transmission()->driver ? contact : Vector3(-contact);
      for (std::size_t b = 0; b < model.bearings.size(); ++b)
        if (model.bearings[b].body == body)
          sum += model.bearings[b].axes * result.bearings[b].load.head<3>();
      raise_to(largest, sum.norm() / contact.norm());
    }
  return largest;
}

/** Moments about the apex that do not balance, over the contact's on an arm of 100 mm: contact,
 * node by node, and bearings, of each body across its axis. Bodies are in their undeformed shape,
 * as small displacements have them. */
inline double unbalanced_moment(const vfife::Model                 &model,
                                const vfife::Compliance            &compliance,
                                const vfife::PairEquilibrium       &equilibrium,
                                const vfife::PairEquilibriumResult &result)
{
  using namespace vfife;
  std::vector<Vector3> sums(2, Vector3::Zero());
  double               contact = 0;
  for (const NodalForce &nodal : result.contact_forces)
    {
      const Body   &body = model.bodies[nodal.body];
      const Vector3 place =
        equilibrium.place(nodal.body, body.placement(body.node_positions()[nodal.node]));
      sums[nodal.body] += place.cross(nodal.force);
      contact += nodal.force.norm() / 2;
    }
  for (std::size_t b = 0; b < model.bearings.size(); ++b)
    {
      const Bearing &bearing = model.bearings[b];
      const Wrench   wrench =
        ShaftSeat(bearing.axes).of_load(result.bearings[b].load, MeanMotion::Motion());
      const Vector3 place = equilibrium.place(bearing.body, compliance.rings().list()[b].centre);
      sums[bearing.body] += place.cross(wrench.force) + wrench.moment;
    }
  double largest = 0;
  for (unsigned int body = 0; body < 2; ++body)
    {
      const Vector3 &axis = model.bodies[body].axis.direction;
      raise_to(largest, (sums[body] - sums[body].dot(axis) * axis).norm());
    }
  return largest / (100 * contact);
}

#endif
