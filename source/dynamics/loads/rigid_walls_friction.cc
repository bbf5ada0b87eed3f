// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// The part of RigidWalls that sticks and slides.
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/loads/rigid_walls.h>

#include <algorithm>

namespace vfife
{
  void RigidWalls::open(Wall &wall, Node &node, const Vector3 &x)
  {
    if (mode_ == FrictionMode::follows)
      {
        // The spring lets go.
        if (node.owned)
          wall.friction_loss += node.energy;
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

  Vector3 RigidWalls::stick(Wall &wall, Node &node, const PressedPoint &pressed, const Vector3 &x)
  {
    if (!node.sticks)
      node.anchor = x;
    node.sticks = true;
    // As between two bodies (ContactPass::stick), pressures being forces here.
    const FrictionOptions &friction     = wall.definition->friction;
    const Vector3         &n            = wall.definition->normal;
    const Vector3          way          = x - node.anchor;
    const Vector3          displacement = way - n.dot(way) * n;
    const double           k            = friction.stiffness_ratio * pressed.penalty;
    const SliderResponse   response =
      slide(displacement.norm(), friction.coefficient * pressed.pressure, k, node.elastic);
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
    return -k * elastic;
  }

  void RigidWalls::serialize(ByteStream &stream)
  {
    constexpr std::size_t n = 6; // numbers a node: whether it sticks, where, displacement, energy
    for (Wall &wall : walls_)
      {
        if (!wall.definition->friction.acts())
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
