// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/model/options/constraint_options.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    const Choices<SupportKind> support_kinds = {{"fixed", SupportKind::fixed},
                                                {"displacement", SupportKind::displacement},
                                                {"turning", SupportKind::turning},
                                                {"angle", SupportKind::angle},
                                                {"free rotation", SupportKind::free_rotation},
                                                {"rigid hub", SupportKind::rigid_hub},
                                                {"spring", SupportKind::spring},
                                                {"bearing", SupportKind::bearing},
                                                {"rolling bearing", SupportKind::rolling_bearing},
                                                {"coupling", SupportKind::coupling}};

    const std::vector<std::string> fixed_directions       = {"x", "y", "z"};
    const std::vector<std::string> cylindrical_directions = {"r", "theta", "z"};

    bool are_all_in(const std::vector<std::string> &words, const std::vector<std::string> &allowed)
    {
      return std::all_of(words.begin(), words.end(), [&](const std::string &word) {
        return std::find(allowed.begin(), allowed.end(), word) != allowed.end();
      });
    }

    /** What a solver knows; springs become loads, bearings and couplings are lists of their own. */
    ConstraintKind constraint_kind(const SupportKind kind)
    {
      switch (kind)
        {
        case SupportKind::turning:
        case SupportKind::angle:
          return ConstraintKind::prescribed_rotation;
        case SupportKind::free_rotation:
          return ConstraintKind::free_rotation;
        case SupportKind::rigid_hub:
          return ConstraintKind::rigid_hub;
        case SupportKind::displacement:
          return ConstraintKind::directions;
        default:
          return ConstraintKind::held;
        }
    }
  } // namespace

  void ConstraintOptions::declare_kind(dealii::ParameterHandler &prm)
  {
    declare_choice(prm, "kind", kind, support_kinds, "Type of constraint");
  }

  void ConstraintOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_kind(prm);
    selection.declare(prm);
    if (kind == SupportKind::displacement)
      {
        declare_names(prm,
                      "directions",
                      directions,
                      "Prescribed directions: of x, y, z (fixed frame), or of r, theta, z (body's "
                      "axis)");
        declare_vector(prm,
                       "displacement",
                       displacement,
                       "mm",
                       "Displacement along x, y, z or r, -, z, multiplied by the history");
      }
    if (kind == SupportKind::displacement || kind == SupportKind::angle)
      {
        declare_quantity(prm,
                         "angle",
                         angle,
                         "deg",
                         "Rotation about the body's axis (theta), multiplied by the history");
        history.declare(prm);
      }
    if (kind == SupportKind::spring)
      declare_vector(
        prm, "stiffness", stiffness, "N/mm", "Total stiffness of all nodes together along x, y, z");
    if (is_bearing())
      bearing.declare(kind == SupportKind::rolling_bearing, prm);
    if (kind == SupportKind::coupling)
      coupling.declare(prm);
  }

  void ConstraintOptions::check(const std::string &section) const
  {
    if (kind == SupportKind::spring && !(stiffness.minCoeff() >= 0))
      throw InputError(section + "/stiffness", "must not be negative");
    if (is_bearing())
      bearing.check(kind == SupportKind::rolling_bearing, section);
    if (kind != SupportKind::displacement)
      return;
    if (directions.empty())
      throw InputError(section + "/directions",
                       "expected at least one of x, y, z or of r, theta, z, got none");
    const bool fixed = are_all_in(directions, fixed_directions);
    if (!fixed && !are_all_in(directions, cylindrical_directions))
      throw InputError(section + "/directions",
                       "expected directions of x, y, z or of r, theta, z, got \"" +
                         list_of(directions) + "\"");
    // What is given along a direction that is not prescribed, or not in its own entry, would be
    // passed over.
    const auto &words      = fixed ? fixed_directions : cylindrical_directions;
    const auto  prescribes = [this](const std::string &word) {
      return std::find(directions.begin(), directions.end(), word) != directions.end();
    };
    if (angle != 0 && !prescribes("theta"))
      throw InputError(section + "/angle",
                       "theta is not one of the directions (" + list_of(directions) +
                         "). Add it, with r and z instead of x, y and z, or set the angle to 0");
    if (!fixed && displacement[1] != 0)
      throw InputError(section + "/displacement",
                       "the second number must be 0. Set angle for the displacement along theta");
    for (unsigned int c = 0; c < 3; ++c)
      if (displacement[c] != 0 && !prescribes(words[c]))
        throw InputError(section + "/displacement",
                         words[c] + " is not one of the directions (" + list_of(directions) +
                           "). Add it, or set the displacement along it to 0");
  }

  bool ConstraintOptions::is_bearing() const
  {
    return kind == SupportKind::bearing || kind == SupportKind::rolling_bearing;
  }

  void ConstraintOptions::add_seat(Model                    &model,
                                   const std::string        &name,
                                   const unsigned int        b,
                                   std::vector<unsigned int> nodes,
                                   const std::string        &section) const
  {
    const Body &body = model.bodies[b];
    if (!body.turns_on_axis)
      throw InputError(section + "/body",
                       "body \"" + body.name() +
                         "\" has no axis of rotation. Set rotating = yes in its section, with axis "
                         "point, axis direction and speed");
    SelectedFaces faces = selection.find_faces(body, nodes, section);
    if (kind == SupportKind::coupling)
      model.couplings.push_back(
        {name, b, std::move(nodes), coupling.stiffness, coupling.damping, std::move(faces)});
    else
      {
        bearing.add_to(
          model, kind == SupportKind::rolling_bearing, name, b, std::move(nodes), section);
        model.bearings.back().faces = std::move(faces);
      }
  }

  void
  ConstraintOptions::add_to(Model &model, const std::string &name, const std::string &section) const
  {
    const unsigned int body  = selection.find_body(model.bodies, section);
    const auto         nodes = selection.find_nodes(model.bodies[body], section);
    if (kind == SupportKind::spring)
      {
        // A spring gives forces and no place: solvers take it with the loads, constant in time.
        Load load;
        load.name   = name;
        load.kind   = LoadKind::spring;
        load.body   = body;
        load.nodes  = nodes;
        load.faces  = selection.find_faces(model.bodies[body], nodes, section);
        load.vector = stiffness;
        model.loads.push_back(load);
        return;
      }

    if (is_bearing() || kind == SupportKind::coupling)
      {
        add_seat(model, name, body, nodes, section);
        return;
      }

    Constraint constraint;
    constraint.name  = name;
    constraint.kind  = constraint_kind(kind);
    constraint.body  = body;
    constraint.nodes = nodes;
    // A prescribed rotation without an angle turns at the rate of its body.
    if (kind == SupportKind::angle)
      constraint.angle = angle;
    if (kind == SupportKind::displacement)
      {
        // z alone is of both lists and taken as that of the fixed frame.
        constraint.cylindrical = !are_all_in(directions, fixed_directions);
        const auto &words      = constraint.cylindrical ? cylindrical_directions : fixed_directions;
        for (unsigned int c = 0; c < 3; ++c)
          constraint.prescribed[c] =
            std::find(directions.begin(), directions.end(), words[c]) != directions.end();
        // Along r, theta, z the second entry is the angle, which has an entry (and a
        // unit) of its own.
        constraint.displacement = displacement;
        if (constraint.cylindrical)
          constraint.displacement[1] = angle;
      }
    // Times the displacement or the angle; what has neither is not asked for its history.
    constraint.history = history;
    constraint.history.check(section);
    model.constraints.push_back(constraint);
  }
} // namespace vfife
