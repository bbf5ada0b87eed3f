// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>
#include <vfife/base/parameters/file_names.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/files/mesh_import.h>
#include <vfife/model/options/body_options.h>

namespace vfife
{
  namespace
  {
    /** The meshes that are no shapes of three sizes. */
    const std::string from_file = "file", stepped_shaft = "stepped shaft";
  } // namespace

  void BodyOptions::declare_kind(dealii::ParameterHandler &prm)
  {
    // Names of shapes, and two more; the word is stored itself, since the list
    // belongs to mesh.
    auto shapes = PrimitiveOptions::shapes();
    shapes.push_back(stepped_shaft);
    shapes.push_back(from_file);
    declare_choice(
      prm,
      "mesh",
      shapes,
      mesh,
      [this, shapes](const unsigned i) { mesh = shapes[i]; },
      "Shape of the body, or file: a mesh file of hexahedra");
    materials.declare(prm, "of a mesh file");
  }

  void BodyOptions::declare(dealii::ParameterHandler &prm, const std::string &section)
  {
    declare_kind(prm);
    // A file brings its own sizes; a shape declares those that it has.
    if (mesh == from_file)
      {
        declare_file_name(
          prm,
          "file",
          file,
          "Mesh file of 8-node hexahedra, lengths in mm: .msh (Gmsh), .inp (Abaqus, "
          "CalculiX), .vtk, .ucd, .unv (I-DEAS, Salome), .xda, .vtu (deal.II). Its named groups "
          "become node sets and surfaces. A "
          "relative name starts at the folder of the parameter file");
        declare_names(
          prm,
          "regions",
          regions,
          "Regions of the file that form the body (physical volumes, element sets, "
          "material ids), by name or number; empty: all regions. They must be joined by "
          "faces; other bodies may use other regions of the same file");
      }
    else if (mesh == stepped_shaft)
      shaft.declare(prm);
    else
      declare_shape(prm, section);
    declare_vector(prm, "position", position, "mm", "Position of the body frame's origin");
    declare_vector(
      prm, "rotation axis", rotation_axis, "-", "Axis of the rotation that places the body frame");
    declare_quantity(prm, "rotation angle", rotation_angle, "deg", "Angle of this rotation");
    declare_switch(prm,
                   "rotating",
                   bearing,
                   "yes: the body rotates about its axis, which stays in place; no: its rigid "
                   "motion is free");
    declare_vector(prm,
                   "axis point",
                   axis_point,
                   "mm",
                   "Point on the axis of rotation; 0, 0, 0 of a body that does not rotate about "
                   "an axis: centre of mass of a shape, origin of a mesh file");
    declare_vector(prm, "axis direction", axis_direction, "-", "Direction of the axis of rotation");
    declare_quantity(prm,
                     "rotational speed",
                     speed,
                     "rad/s",
                     "Angular velocity about the axis of a rotating body; 600 rpm is accepted too");
    declare_vector(prm,
                   "velocity",
                   velocity,
                   "mm/s",
                   "Initial velocity of a body that does not rotate about an axis");
    declare_vector(prm,
                   "angular velocity",
                   angular_velocity,
                   "rad/s",
                   "Initial angular velocity about the centre of mass, of a body that does not "
                   "rotate about an axis");
    const char *names = "xyz";
    for (unsigned int c = 0; c < 3; ++c)
      declare_text(
        prm,
        std::string("initial velocity ") + names[c],
        initial_velocity[c],
        "Additional initial velocity along " + std::string(1, names[c]) +
          " of the fixed frame [mm/s]: formula of x, y, z [mm] in the undeformed body frame");
  }

  void BodyOptions::declare_shape(dealii::ParameterHandler &prm, const std::string &section)
  {
    for_entry(section + "/mesh", [&] { primitive = std::make_unique<PrimitiveOptions>(mesh); });
    primitive->declare(prm);
  }

  void BodyOptions::check(const std::string &section) const
  {
    if (primitive)
      primitive->check(section);
    else if (mesh == stepped_shaft)
      shaft.check(section);
    else if (file.empty())
      throw InputError(section + "/file", "expected the name of the mesh file, got none");
    if (mesh != from_file && !materials.of_regions.empty())
      throw InputError(section + "/region materials",
                       "expected mesh = file, got mesh = " + mesh + ", which has one region");
    materials.check(section);
    if (rotation_axis.norm() == 0)
      throw InputError(section + "/rotation axis", "must not have length zero");
    if (axis_direction.norm() == 0)
      throw InputError(section + "/axis direction", "must not have length zero");
    // Two ways to say how a body moves; one given beside the other kind of body would be
    // ignored silently.
    if (bearing && (!velocity.isZero(0.) || !angular_velocity.isZero(0.)))
      throw InputError(
        section + "/" + (velocity.isZero(0.) ? "angular velocity" : "velocity"),
        "must be zero for a rotating body, which moves by its rotational speed only");
    if (!bearing && speed != 0)
      throw InputError(section + "/rotational speed",
                       "requires rotating = yes. Set angular velocity for a body that does not "
                       "rotate about an axis");
  }

  std::unique_ptr<BodyMesh> BodyOptions::make_mesh(const std::string &section) const
  {
    if (mesh == stepped_shaft)
      {
        std::unique_ptr<BodyMesh> body = make_stepped_shaft(shaft);
        if (count_parts(*body) > 1)
          throw InputError(section + "/sections",
                           "each section must have a common face with another one");
        return body;
      }
    return primitive ? make_primitive(*primitive) : read_file(section);
  }

  std::unique_ptr<BodyMesh> BodyOptions::read_file(const std::string &section) const
  {
    std::unique_ptr<BodyMesh> body;
    try
      {
        body = read_body(file, regions);
      }
    catch (const InputError &error)
      {
        throw InputError(section + "/" + (error.entry().empty() ? "file" : error.entry()),
                         error.what());
      }
    // Parts that nothing holds together are hardly meant as one body: whoever means it says so.
    const unsigned int    n_parts    = count_parts(*body);
    const CoincidentNodes coincident = find_coincident_nodes(*body);
    if (coincident.n > 0 && (!regions.empty() || n_parts == 1))
      body->warnings.push_back(file + ": " + coincident.describe() +
                               ": the elements are not connected there. Merge these nodes");
    if (!regions.empty() || n_parts == 1)
      return body;
    if (coincident.n > 0)
      throw InputError(
        section + "/file",
        file + " has " + std::to_string(n_parts) + " separate parts, and " + coincident.describe() +
          ": the parts touch but share no nodes. Merge the nodes in the mesh generator (Gmsh: "
          "Coherence Mesh). For separate bodies, give each its regions");
    std::vector<std::string> names;
    for (const auto &region : body->regions)
      names.push_back("\"" + region.second + "\"");
    throw InputError(section + "/file",
                     file + " has " + std::to_string(n_parts) +
                       " parts without a common face. Set regions to the regions of this body, or "
                       "to all regions if they are one body; the file has " +
                       list_of(names));
  }

  Body BodyOptions::make(const std::string      &name,
                         const MaterialSections &sections,
                         const std::string      &section) const
  {
    std::unique_ptr<BodyMesh> body_mesh = make_mesh(section);
    materials.assign(*body_mesh, section);
    Body body(name, materials.find(sections, section), std::move(body_mesh));
    materials.give_temperature(body, section);
    // x = R X + position: turned about the body frame's origin, then moved.
    body.placement.rotation    = rotation_about(rotation_axis.normalized(), rotation_angle);
    body.placement.translation = position;
    if (bearing)
      {
        // A bearing is given in the fixed frame, wherever the placement has put the body.
        body.axis          = {axis_point, axis_direction.normalized()};
        body.turns_on_axis = true;
        body.rate          = speed;
      }
    else
      {
        // A body that flies freely turns about its centre of mass: that is the point of its axis at
        // time zero, and the direction of its angular velocity the axis. Without angular velocity
        // the axis only says what r and theta are: a file may hold a part of what is round, whose
        // axis is that of the file's coordinates.
        Vector3 centre = Vector3::Zero();
        for (unsigned int i = 0; i < body.n_nodes(); ++i)
          centre += body.node_masses()[i] / body.mass() * body.placement(body.node_positions()[i]);
        body.rate = angular_velocity.norm();
        body.axis = {centre, axis_direction.normalized()};
        if (body.rate > 0)
          body.axis.direction = angular_velocity / body.rate;
        else if (!axis_point.isZero(0.))
          body.axis.point = axis_point;
        else if (mesh == from_file)
          body.axis.point = position;
        body.velocity = velocity;
      }

    // All three are parsed even if none is set: a mistake in one is found. Without any the body
    // stores nothing.
    std::vector<Expression> formulas;
    bool                    moves = false;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const std::string entry = section + "/initial velocity " + "xyz"[c];
        for_entry(entry, [&] { formulas.emplace_back(initial_velocity[c], entry); });
        moves = moves || initial_velocity[c] != "0";
      }
    if (moves)
      for (const Vector3 &X : body.node_positions())
        body.initial_velocity.emplace_back(formulas[0](X, 0.),
                                           formulas[1](X, 0.),
                                           formulas[2](X, 0.));
    return body;
  }
} // namespace vfife
