// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/communicator.h>
#include <vfife/dynamics/broken_element.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    struct Distortion
    {
      std::size_t   body           = 0;
      std::uint32_t element        = 0; ///< of the body
      double        least_jacobian = std::numeric_limits<double>::infinity();
    };

    /** Of this rank; Jacobians over those of the undeformed elements where @p relative. */
    Distortion find_most_distorted(const Model &model, const State &state, const bool relative)
    {
      Distortion  worst;
      std::size_t b = 0;
      for (const std::uint32_t e : state.partition.elements)
        {
          while (e >= model.bodies[b].first_element + model.bodies[b].n_elements())
            ++b;
          const Body         &body    = model.bodies[b];
          const std::uint32_t element = e - body.first_element;
          HexahedronNodes     x;
          for (unsigned int i = 0; i < 8; ++i)
            x.col(i) = state.node_position(
              state.partition.local_node[body.first_node + body.elements()[element][i]]);
          double least = compute_least_jacobian(x);
          if (relative)
            least /= compute_least_jacobian(body.element_nodes(element));
          if (least < worst.least_jacobian || std::isnan(least))
            worst = {b, element, least};
        }
      return worst;
    }

    std::string describe(const Model &model, const Distortion &worst)
    {
      std::ostringstream text;
      text << "body \"" << model.bodies[worst.body].name() << "\", element " << worst.element
           << ", least Jacobian " << worst.least_jacobian << " of the undeformed one";
      return text.str();
    }
  } // namespace

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

    text << "most distorted before: "
         << describe(model, find_most_distorted(model, last_measured, true));
    return text.str();
  }

  std::string
  find_inverted_element(const Model &model, const State &state, const Communicator &communicator)
  {
    // The sign alone needs no undeformed element: this is done at every sample.
    std::string text;
    if (!(find_most_distorted(model, state, false).least_jacobian > 0))
      text = describe(model, find_most_distorted(model, state, true));
    if (!communicator.any(!text.empty()))
      return "";
    for (const std::string &found : communicator.all_gather(text))
      if (!found.empty())
        return found;
    return "";
  }
} // namespace vfife
