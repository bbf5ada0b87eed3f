// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/operator/broken_element.h>
#include <vfife/dynamics/operator/vfife_operator.h>
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

    /** Of an element of the model, relative to the undeformed one. */
    Distortion
    find_distortion(const Model &model, const State &state, const std::uint32_t model_element)
    {
      std::size_t b = 0;
      while (model_element >= model.bodies[b].first_element + model.bodies[b].n_elements())
        ++b;
      const Body         &body    = model.bodies[b];
      const std::uint32_t element = model_element - body.first_element;
      HexahedronNodes     x;
      for (unsigned int i = 0; i < 8; ++i)
        x.col(i) = state.node_position(
          state.partition.local_node[body.first_node + body.elements()[element][i]]);
      return {b,
              element,
              compute_least_jacobian(x) / compute_least_jacobian(body.element_nodes(element))};
    }

    /** Of this rank. */
    Distortion find_most_distorted(const Model &model, const State &state)
    {
      Distortion worst;
      for (const std::uint32_t e : state.partition.elements)
        {
          const Distortion one = find_distortion(model, state, e);
          if (one.least_jacobian < worst.least_jacobian || std::isnan(one.least_jacobian))
            worst = one;
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
        for (const std::uint32_t i : now.partition.nodes(b))
          if (!now.node_position(i).allFinite())
            {
              text << "body \"" << body.name() << "\", node "
                   << now.partition.global_node[i] - body.first_node << "; ";
              break;
            }
      }

    text << "most distorted before: " << describe(model, find_most_distorted(model, last_measured));
    return text.str();
  }

  std::string find_inverted_element(const Model           &model,
                                    const State           &state,
                                    const ElementMeasures &measures,
                                    const Communicator    &communicator)
  {
    std::string text;
    if (measures.least_jacobian <= 0)
      text = describe(model, find_distortion(model, state, measures.least_element));
    if (!communicator.any(!text.empty()))
      return "";
    for (const std::string &found : communicator.all_gather(text))
      if (!found.empty())
        return found;
    return "";
  }
} // namespace vfife
