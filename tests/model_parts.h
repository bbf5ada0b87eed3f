// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_model_parts_h
#define vfife_tests_model_parts_h

#include <vfife/model/model.h>

#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/** A model with a body, the first one. */
inline vfife::Model model_of(vfife::Body body)
{
  vfife::Model model;
  model.add_body(std::move(body));
  return model;
}

/** 0 to n - 1. */
inline std::vector<unsigned int> numbers_below(const unsigned int n)
{
  std::vector<unsigned int> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

inline std::vector<unsigned int> all_nodes(const vfife::Body &body)
{
  return numbers_below(body.n_nodes());
}

/** Puts a body's z axis through its origin on an axis, about which it turns. */
inline void
place_on_axis(vfife::Body &body, const vfife::Vector3 &point, const vfife::Vector3 &axis)
{
  body.axis = {point, axis.normalized()};
  body.placement.rotation =
    Eigen::Quaterniond::FromTwoVectors(vfife::Vector3::UnitZ(), body.axis.direction)
      .toRotationMatrix();
  body.placement.translation = point;
  body.turns_on_axis         = true;
}

/** A constraint of the body 0 that holds the given directions. */
inline vfife::Constraint hold(const std::vector<unsigned int> &nodes,
                              const std::array<bool, 3>       &directions,
                              const bool                       cylindrical = false)
{
  vfife::Constraint constraint;
  constraint.name        = "support";
  constraint.kind        = vfife::ConstraintKind::directions;
  constraint.nodes       = nodes;
  constraint.prescribed  = directions;
  constraint.cylindrical = cylindrical;
  return constraint;
}

/** A torque [N mm] on a set of nodes of a body of the model. */
inline vfife::Torque torque_on(const vfife::Model &model,
                               const std::string  &set,
                               const double        value,
                               const unsigned int  body = 0)
{
  vfife::Torque torque;
  torque.name  = "torque";
  torque.body  = body;
  torque.nodes = model.bodies[body].node_set(set);
  torque.areas = vfife::compute_nodal_areas(model.bodies[body], torque.nodes);
  torque.value = value;
  return torque;
}

/** A pressure [MPa] on the body 0. */
inline vfife::Load pressure_on(const std::vector<unsigned int> &nodes, const double pressure)
{
  vfife::Load load;
  load.name     = "pressure";
  load.kind     = vfife::LoadKind::pressure;
  load.nodes    = nodes;
  load.pressure = pressure;
  return load;
}

/** A body of a model and one of its surfaces. */
struct Touching
{
  unsigned int body;
  std::string  surface;
};

inline vfife::ContactPair
contact_of(const std::string &side, const Touching &slave, const Touching &master)
{
  vfife::ContactPair pair;
  pair.side           = side;
  pair.slave_body     = slave.body;
  pair.slave_surface  = slave.surface;
  pair.master_body    = master.body;
  pair.master_surface = master.surface;
  return pair;
}

#endif
