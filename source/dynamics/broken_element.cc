// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/dynamics/broken_element.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  std::string find_broken_element(const Model &model, const State &last_measured, const State &now)
  {
    std::ostringstream text;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        for (std::uint32_t i = now.partition.first_local_node[b];
             i < now.partition.first_local_node[b + 1];
             ++i)
          if (!now.node_position(i).allFinite())
            {
              text << "body \"" << body.name() << "\", node "
                   << now.partition.global_node[i] - body.first_node << "; ";
              break;
            }
      }

    double             least = std::numeric_limits<double>::infinity();
    std::ostringstream worst;
    for (const std::uint32_t e : last_measured.partition.elements)
      {
        unsigned int b = model.bodies.size() - 1;
        while (model.bodies[b].first_element > e)
          --b;
        const Body         &body    = model.bodies[b];
        const std::uint32_t element = e - body.first_element;
        HexahedronNodes     x;
        for (unsigned int i = 0; i < 8; ++i)
          x.col(i) = last_measured.node_position(
            last_measured.partition.local_node[body.first_node + body.elements()[element][i]]);
        const double ratio =
          compute_least_jacobian(x) / compute_least_jacobian(body.element_nodes(element));
        if (ratio < least)
          {
            least = ratio;
            worst.str("");
            worst << "most distorted before: body \"" << body.name() << "\", element " << element
                  << ", least Jacobian " << ratio << " of the undeformed one";
          }
      }
    text << worst.str();
    return text.str();
  }
} // namespace vfife
