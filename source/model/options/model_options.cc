// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/model/options/model_options.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    std::string section_of(const std::string &part, const std::string &name)
    {
      return "Model/" + part + " " + name;
    }

    template <typename Options>
    /**
     * Default options for each name. All are made before anything is declared: entries are
     * bound by address.
     */
    void make_named(const std::vector<std::string>               &names,
                    std::vector<std::pair<std::string, Options>> &options)
    {
      options.clear();
      options.reserve(names.size());
      for (const std::string &name : names)
        options.emplace_back(name, Options());
    }

    /** Calls a function with the options of each name inside their subsection. */
    template <typename Options, typename Function>
    void inside_each(dealii::ParameterHandler                     &prm,
                     const std::string                            &part,
                     std::vector<std::pair<std::string, Options>> &options,
                     const Function                               &function)
    {
      for (auto &named : options)
        {
          Subsection section(prm, part + " " + named.first);
          function(named.second, section_of(part, named.first));
        }
    }
    /** Of the elements around a node [mm]. */
    double longest_edge_at(const Body &body, const unsigned int node)
    {
      double longest = 0;
      for (unsigned int e = 0; e < body.n_elements(); ++e)
        if (const auto &nodes = body.elements()[e];
            std::find(nodes.begin(), nodes.end(), node) != nodes.end())
          for (unsigned int v = 0; v < 8; ++v)
            for (const unsigned int bit : {1u, 2u, 4u})
              longest = std::max(
                longest,
                (body.node_positions()[nodes[v]] - body.node_positions()[nodes[v ^ bit]]).norm());
      return longest;
    }

    [[noreturn]] void refuse_far_point(const Body        &body,
                                       const Vector3     &point,
                                       const double       distance,
                                       const std::string &section)
    {
      Vector3 low = body.node_positions().front(), high = low;
      for (const Vector3 &x : body.node_positions())
        {
          low  = low.cwiseMin(x);
          high = high.cwiseMax(x);
        }
      std::ostringstream text;
      text << "expected a place on body \"" << body.name() << "\" or within an element's edge of it"
           << " (body frame: x from " << low[0] << " to " << high[0] << ", y from " << low[1]
           << " to " << high[1] << ", z from " << low[2] << " to " << high[2] << " mm), got ("
           << point[0] << ", " << point[1] << ", " << point[2] << ") mm, " << distance
           << " mm from the nearest node. Give a place of the undeformed body";
      throw InputError(section + "/point", text.str());
    }
  } // namespace

  void ProbeOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm, "body", selection.body, "Name of a body");
    declare_vector(prm,
                   "point",
                   point,
                   "mm",
                   "Point in the undeformed body frame; the nearest node is recorded");
    const Choices<bool> axes = {{"x, y, z", true}, {"r, theta, z", false}};
    declare_choice(prm,
                   "axes",
                   fixed_axes,
                   axes,
                   "x, y, z: displacement in the fixed frame (stresses in the body frame); r, "
                   "theta, z: deformation of a rotating body in cylindrical coordinates about "
                   "its axis");
  }

  void ProbeOptions::add_to(Model &model, const std::string &name, const std::string &section) const
  {
    Probe probe;
    probe.name         = name;
    probe.body         = selection.find_body(model.bodies, section);
    probe.fixed_axes   = fixed_axes;
    double      least  = std::numeric_limits<double>::infinity();
    const auto &places = model.bodies[probe.body].node_positions();
    for (unsigned int i = 0; i < places.size(); ++i)
      // A node and no point within an element: nothing is interpolated.
      // The first of several nodes that are equally near.
      if ((places[i] - point).norm() < least)
        {
          least      = (places[i] - point).norm();
          probe.node = i;
        }
    if (!(least <= longest_edge_at(model.bodies[probe.body], probe.node)))
      refuse_far_point(model.bodies[probe.body], point, least, section);
    model.probes.push_back(probe);
  }

  void ModelOptions::declare_names_of_parts(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Model");
    declare_names(prm,
                  "bodies",
                  body_names_,
                  "Names of bodies; each has a subsection \"Body NAME\"");
    declare_names(prm,
                  "constraints",
                  constraint_names_,
                  "Names of constraints; each has a subsection \"Constraint NAME\"");
    declare_names(prm, "loads", load_names_, "Names of loads; each has a subsection \"Load NAME\"");
    declare_names(prm,
                  "contacts",
                  contact_names_,
                  "Names of contacts; each has a subsection \"Contact NAME\"");
    declare_names(prm,
                  "probes",
                  probe_names_,
                  "Names of probes; each has a subsection \"Probe NAME\"");
  }

  void ModelOptions::declare_kinds(dealii::ParameterHandler &prm)
  {
    Subsection section(prm, "Model");
    const auto declare_kind = [&prm](auto &options, const std::string &) {
      options.declare_kind(prm);
    };
    inside_each(prm, "Body", bodies_, declare_kind);
    inside_each(prm, "Constraint", constraints_, declare_kind);
    inside_each(prm, "Load", loads_, declare_kind);
    inside_each(prm, "Contact", contacts_, declare_kind);
  }

  void ModelOptions::declare_materials(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    std::vector<std::string> names;
    for (const auto &body : bodies_)
      for (const std::string &name : body.second.materials.names())
        names.push_back(name);
    materials_.declare(prm, file, names);
  }

  void ModelOptions::declare(dealii::ParameterHandler &prm, const ParameterFile &file)
  {
    // First pass: which parts there are.
    file.read_known([this](dealii::ParameterHandler &first) { declare_names_of_parts(first); });
    make_named(body_names_, bodies_);
    make_named(constraint_names_, constraints_);
    make_named(load_names_, loads_);
    make_named(contact_names_, contacts_);
    make_named(probe_names_, probes_);
    // Second pass: mesh and kinds, which decide what entries the parts have.
    file.read_known([this](dealii::ParameterHandler &second) { declare_kinds(second); });

    // Third: everything, in the handler with which the whole file is read strictly.
    declare_names_of_parts(prm);
    {
      Subsection section(prm, "Model");
      inside_each(prm, "Body", bodies_, [&](BodyOptions &body, const std::string &path) {
        body.declare(prm, path);
      });
      const auto declare_all = [&prm](auto &options, const std::string &) { options.declare(prm); };
      inside_each(prm, "Constraint", constraints_, declare_all);
      inside_each(prm, "Load", loads_, declare_all);
      inside_each(prm, "Contact", contacts_, declare_all);
      inside_each(prm, "Probe", probes_, declare_all);
    }
    declare_materials(prm, file);
  }

  void ModelOptions::check() const
  {
    if (bodies_.empty())
      throw InputError("Model/bodies", "expected at least one body, got none");
    for (const auto &body : bodies_)
      {
        body.second.check(section_of("Body", body.first));
        body.second.materials.find(materials_, section_of("Body", body.first));
      }
    for (const auto &constraint : constraints_)
      constraint.second.check(section_of("Constraint", constraint.first));
    for (const auto &contact : contacts_)
      contact.second.check(section_of("Contact", contact.first));
    materials_.check();
  }

  Model ModelOptions::make_model() const
  {
    Model model;
    // Bodies first: the other parts look up bodies and their nodes.
    for (const auto &body : bodies_)
      model.add_body(body.second.make(body.first, materials_, section_of("Body", body.first)));
    for (const auto &constraint : constraints_)
      constraint.second.add_to(model, constraint.first, section_of("Constraint", constraint.first));
    for (const auto &load : loads_)
      load.second.add_to(model, load.first, section_of("Load", load.first));
    for (const auto &contact : contacts_)
      contact.second.add_to(model, contact.first, section_of("Contact", contact.first));
    for (const auto &probe : probes_)
      probe.second.add_to(model, probe.first, section_of("Probe", probe.first));
    return model;
  }

  void ModelOptions::log_probes(const Model &model, Log &log) const
  {
    // In the order in which make_model() has added them.
    for (std::size_t i = 0; i < probes_.size(); ++i)
      {
        const Probe  &probe = model.probes[i];
        const Body   &body  = model.bodies[probe.body];
        const Vector3 place = body.node_positions()[probe.node];
        const double  way   = (place - probes_[i].second.point).norm();
        if (way > 1e-9 * place.norm())
          log.line("probe ",
                   probe.name,
                   ": no node is at its point. The program records node ",
                   probe.node,
                   " of body ",
                   body.name(),
                   " at (",
                   place[0],
                   ", ",
                   place[1],
                   ", ",
                   place[2],
                   ") mm, ",
                   way,
                   " mm away");
      }
  }
} // namespace vfife
