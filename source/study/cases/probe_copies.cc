// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/model/pair_measures.h>
#include <vfife/study/cases/probe_copies.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** How the body of a probe takes part in the pair. */
    MemberOfPair member_of(const Model &model, const Probe &probe)
    {
      if (model.transmissions.empty())
        throw InputError("expected a model of a gear pair");
      return find_member(*model.only_transmission(), probe.body);
    }
  } // namespace

  std::vector<Probe> list_copies(const Model &model, const Probe &probe)
  {
    const MemberOfPair member = member_of(model, probe);
    const Body        &body   = model.bodies[probe.body];
    // Sectors follow each other in the + sense of the axis.
    const std::vector<unsigned int> nodes =
      body.has_node_set(probe.name) ? body.node_set(probe.name) : std::vector<unsigned int>();
    const auto here = std::find(nodes.begin(), nodes.end(), probe.node);
    if (here == nodes.end() || nodes.size() != member.teeth)
      throw InputError("body \"" + body.name() + "\" has no copy of \"" + probe.name +
                       "\" in each of its sectors");
    const unsigned int z = member.teeth, first = here - nodes.begin();
    std::vector<Probe> copies(z, probe);
    for (unsigned int m = 0; m < z; ++m)
      copies[m].node = nodes[(first + (member.sense > 0 ? m : z - m)) % z];
    return copies;
  }

  double meshes_to_contact(const Model &model, const Probe &probe)
  {
    const MemberOfPair member = member_of(model, probe);
    const Body        &body   = model.bodies[probe.body];
    const Vector3      a      = body.axis.direction;
    const auto         flat   = [&](const Vector3 &x) {
      const Vector3 r = x - body.axis.point;
      return Vector3(r - a.dot(r) * a);
    };
    const Vector3 node    = flat(body.placement(body.node_positions()[probe.node]));
    const Vector3 contact = flat(model.only_transmission()->contact_point);
    const double  angle  = member.sense * std::atan2(a.dot(node.cross(contact)), node.dot(contact));
    const double  meshes = angle * member.teeth / (2 * pi);
    return meshes < 0 ? meshes + member.teeth : meshes;
  }
} // namespace vfife
