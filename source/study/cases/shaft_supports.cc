// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/mesh/shaft_sections.h>
#include <vfife/model/model.h>
#include <vfife/study/cases/shaft_supports.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Places along the axis and radii that differ by less are the same [mm]. */
    constexpr double tolerance = 1e-6;

    std::string range_text(const double from, const double to)
    {
      std::ostringstream text;
      text << from << " to " << to << " mm";
      return text.str();
    }

    /** The section of the shaft that carries a ring. Throws InputError, naming the nearest. */
    const ShaftSection &find_section(const ShaftRing                 &ring,
                                     const std::vector<ShaftSection> &sections,
                                     const std::string               &section)
    {
      if (!(ring.to > ring.from))
        throw InputError(section + "/to",
                         "the ring from " + range_text(ring.from, ring.to) +
                           " must have \"to\" above \"from\"");
      const ShaftSection *nearest  = nullptr;
      double              distance = 0;
      for (const ShaftSection &s : sections)
        {
          if (ring.from >= s.from - tolerance && ring.to <= s.to + tolerance)
            return s;
          const double d = std::abs(.5 * (ring.from + ring.to) - .5 * (s.from + s.to));
          if (nearest == nullptr || d < distance)
            {
              nearest  = &s;
              distance = d;
            }
        }
      throw InputError(section + "/from",
                       "the ring from " + range_text(ring.from, ring.to) +
                         " does not lie on one section of the shaft; the nearest section is from " +
                         range_text(nearest->from, nearest->to));
    }

    /** Nodes of a ring on the shaft's surface; throws InputError where it meets the hub. */
    std::vector<unsigned int> find_nodes(const Body                      &body,
                                         const ShaftRing                 &ring,
                                         const std::vector<ShaftSection> &sections,
                                         const std::string               &section)
    {
      double in = std::numeric_limits<double>::infinity(), out = -in;
      for (const unsigned int node : body.node_set(node_set::bore))
        {
          in  = std::min(in, body.node_positions()[node][2]);
          out = std::max(out, body.node_positions()[node][2]);
        }
      if (ring.from < out - tolerance && ring.to > in + tolerance)
        throw InputError(section + "/from",
                         "the ring from " + range_text(ring.from, ring.to) +
                           " overlaps the hub from " + range_text(in, out) +
                           ", where the shaft has no free surface");
      const double              radius = .5 * find_section(ring, sections, section).outer;
      std::vector<unsigned int> nodes;
      for (const unsigned int node : body.node_set(node_set::shaft_surface))
        {
          const Vector3 &x = body.node_positions()[node];
          if (x[2] > ring.from - tolerance && x[2] < ring.to + tolerance &&
              std::abs(x.head<2>().norm() - radius) < tolerance)
            nodes.push_back(node);
        }
      return nodes;
    }
  } // namespace

  void ShaftRing::declare(dealii::ParameterHandler &prm, const std::string &what)
  {
    const std::string place = " of " + what + ": position along the axis from the apex";
    declare_quantity(prm, "from", from, "mm", "Beginning" + place);
    declare_quantity(prm, "to", to, "mm", "End" + place);
  }

  void ShaftSupports::Seat::declare_kind(dealii::ParameterHandler &prm)
  {
    const Choices<bool> kinds = {{"bearing", false}, {"rolling bearing", true}};
    declare_choice(
      prm, "kind", rolls, kinds, "Type of bearing: linear stiffness, or ball or roller bearing");
  }

  void ShaftSupports::declare_bearing_names(dealii::ParameterHandler &prm)
  {
    declare_names(prm,
                  "bearings",
                  names_,
                  "Names of bearings; each has a subsection \"Bearing NAME\"");
  }

  void ShaftSupports::declare_kinds(dealii::ParameterHandler &prm)
  {
    // All before anything is declared: entries are bound by address.
    seats_.clear();
    seats_.reserve(names_.size());
    for (const std::string &name : names_)
      seats_.emplace_back(name, Seat());
    for (auto &seat : seats_)
      {
        const Subsection subsection(prm, "Bearing " + seat.first);
        seat.second.declare_kind(prm);
      }
  }

  void ShaftSupports::declare(dealii::ParameterHandler &prm)
  {
    declare_bearing_names(prm);
    for (auto &[name, seat] : seats_)
      {
        const Subsection subsection(prm, "Bearing " + name);
        seat.declare_kind(prm);
        seat.ring.declare(prm, "the bearing seat");
        seat.law.declare(seat.rolls, prm);
      }
    const Subsection subsection(prm, "End");
    end_.declare(prm, "the ring at which the shaft is driven or loaded");
    coupling_.declare(prm);
  }

  std::string ShaftSupports::section_of(const std::string &section, const std::string &bearing)
  {
    return section + "/Bearing " + bearing;
  }

  void ShaftSupports::check(const std::string               &section,
                            const std::vector<ShaftSection> &sections) const
  {
    if (sections.empty())
      {
        if (!seats_.empty())
          throw InputError(section + "/bearings",
                           "expected the sections of the shaft of these bearings, got none");
        return;
      }
    if (seats_.empty())
      throw InputError(section + "/bearings",
                       "expected the names of the bearings of the shaft, got none");
    for (const auto &[name, seat] : seats_)
      {
        const std::string where = section_of(section, name);
        find_section(seat.ring, sections, where);
        seat.law.check(seat.rolls, where);
      }
    find_section(end_, sections, section + "/End");
  }

  std::vector<double> ShaftSupports::levels() const
  {
    std::vector<double> levels;
    for (const auto &seat : seats_)
      levels.insert(levels.end(), {seat.second.ring.from, seat.second.ring.to});
    levels.insert(levels.end(), {end_.from, end_.to});
    return levels;
  }

  void ShaftSupports::add_bearings(Model                           &model,
                                   const unsigned int               b,
                                   const std::string               &section,
                                   const std::vector<ShaftSection> &sections) const
  {
    for (const auto &[name, seat] : seats_)
      {
        const Body       &body  = model.bodies[b];
        const std::string where = section_of(section, name);
        seat.law.add_to(model,
                        seat.rolls,
                        body.name() + " " + name,
                        b,
                        find_nodes(body, seat.ring, sections, where),
                        where);
      }
  }

  void ShaftSupports::add_driver(Model                           &model,
                                 const unsigned int               body,
                                 const std::string               &section,
                                 const std::vector<ShaftSection> &sections) const
  {
    add_bearings(model, body, section, sections);
    model.couplings.push_back({model.bodies[body].name() + " drive",
                               body,
                               find_nodes(model.bodies[body], end_, sections, section + "/End"),
                               coupling_.stiffness,
                               coupling_.damping});
  }

  void ShaftSupports::add_driven(Model                           &model,
                                 const unsigned int               body,
                                 const std::string               &section,
                                 const std::vector<ShaftSection> &sections,
                                 const double                     value) const
  {
    add_bearings(model, body, section, sections);
    Torque load;
    load.name  = "load torque";
    load.body  = body;
    load.nodes = find_nodes(model.bodies[body], end_, sections, section + "/End");
    load.areas = compute_nodal_areas(model.bodies[body], load.nodes);
    load.value = value;
    model.torques.push_back(load);
  }
} // namespace vfife
