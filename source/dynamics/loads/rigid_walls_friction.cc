// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of RigidWalls that sticks and slides.
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loads/rigid_walls.h>

#include <algorithm>

namespace vfife
{
  void RigidWalls::open(Wall &wall, Node &node, const Vector3 &x, const Vector3 &way)
  {
    if (mode_ == FrictionMode::follows)
      {
        // The spring lets go, after its force has acted on half of the way since the evaluation
        // before, as all forces of central differences do.
        if (node.owned && node.sticks)
          {
            const Vector3 &n       = wall.definition->normal;
            const Vector3  stretch = x - way - node.anchor;
            const Vector3  along   = way - n.dot(way) * n;
            wall.friction_loss +=
              node.energy + .5 * node.tangential * node.area * stretch.dot(along);
          }
        node.sticks  = false;
        node.elastic = node.energy = 0;
      }
    else if (!node.sticks)
      {
        // Where a load step begins, for nodes that may come to touch within it.
        node.sticks = true;
        node.anchor = x;
      }
  }

  Vector3 RigidWalls::stick(
    Wall &wall, Node &node, const double pressure, const Vector3 &x, const Vector3 &way)
  {
    // A node that comes to touch does so on the way since the evaluation before.
    if (!node.sticks)
      node.anchor = x - way;
    node.sticks = true;
    // As between two bodies (StickSlip::stick), pressures being forces here.
    const FrictionLaw &law          = *wall.friction_law;
    const Vector3     &n            = wall.definition->normal;
    const Vector3      stretch      = x - node.anchor;
    const Vector3      displacement = stretch - n.dot(stretch) * n;
    const double       speed =
      law.depends_on_speed() && step_ > 0 ? (way - n.dot(way) * n).norm() / step_ : 0.;
    const SliderResponse response =
      slide(law, {pressure, speed, node.tangential, node.elastic, node.area}, displacement.norm());
    const Vector3 elastic = response.elastic_part * displacement;
    if (node.owned)
      wall.energy += response.energy;
    if (mode_ == FrictionMode::follows)
      {
        if (node.owned)
          wall.friction_loss += response.loss;
        if (response.slid > 0)
          node.anchor = x - elastic;
        node.elastic = response.elastic;
        node.energy  = response.energy;
      }
    return -(node.tangential * node.area) * elastic;
  }

  void RigidWalls::serialize(ByteStream &stream)
  {
    constexpr std::size_t n = 6; // numbers a node: whether it sticks, where, displacement, energy
    for (Wall &wall : walls_)
      {
        if (!wall.friction_law)
          continue;
        // One owner a node: adding the others' zeros changes no digit.
        std::vector<double> all(n * wall.definition->nodes.size(), 0.);
        if (!stream.reads())
          {
            for (const Node &node : wall.nodes)
              if (node.owned && node.sticks)
                {
                  double *values = all.data() + n * node.index;
                  values[0]      = 1;
                  std::copy_n(node.anchor.data(), 3, values + 1);
                  values[4] = node.elastic;
                  values[5] = node.energy;
                }
            communicator_.sum(all);
          }
        stream.pass_known(all);
        if (stream.reads())
          for (Node &node : wall.nodes)
            {
              const double *values = all.data() + n * node.index;
              node.sticks          = values[0] > 0;
              node.anchor          = Vector3(values[1], values[2], values[3]);
              node.elastic         = values[4];
              node.energy          = values[5];
            }
      }
  }
} // namespace vfife
