// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/loads/contact/contact_system.h>
#include <vfife/dynamics/loads/rigid_walls.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/dynamics/update_sums.h>
#include <vfife/dynamics/watch/guards.h>
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
          state.partition->local_node[body.first_node + body.elements()[element][i]]);
      // Of an element that is inverted at a corner from the start the Gauss points tell.
      const HexahedronNodes undeformed = body.element_nodes(element);
      const double          at_start   = compute_least_jacobian(undeformed);
      return {b,
              element,
              at_start > 0
                ? compute_least_jacobian(x) / at_start
                : compute_least_gauss_jacobian(x) / compute_least_gauss_jacobian(undeformed)};
    }

    /** Of this rank. */
    Distortion find_most_distorted(const Model &model, const State &state)
    {
      Distortion worst;
      for (const std::uint32_t e : state.partition->elements)
        {
          // NaN counts as the worst: no comparison finds it.
          const Distortion one = find_distortion(model, state, e);
          if (one.least_jacobian < worst.least_jacobian || std::isnan(one.least_jacobian))
            worst = one;
        }
      return worst;
    }

    std::string describe(const Model &model, const Distortion &worst)
    {
      std::ostringstream text;
      set_figure_digits(text, 4);
      text << "body \"" << model.bodies[worst.body].name() << "\", element " << worst.element
           << ", least Jacobian " << worst.least_jacobian << " times the undeformed one";
      return text.str();
    }

    /** The first node of this rank whose position is no longer finite, and the element with the
     * least Jacobian relative to the undeformed one in the state measured last. */
    std::string
    describe_broken_element(const Model &model, const State &last_measured, const State &now)
    {
      std::ostringstream text;
      set_figure_digits(text, 4);
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        {
          const Body &body = model.bodies[b];
          for (const std::uint32_t i : now.partition->nodes(b))
            if (!now.node_position(i).allFinite())
              {
                text << "body \"" << body.name() << "\", node "
                     << now.partition->global_node[i] - body.first_node << "; ";
                break;
              }
        }

      text << "most distorted before: "
           << describe(model, find_most_distorted(model, last_measured));
      return text.str();
    }
  } // namespace

  std::string describe_instant(const State &state)
  {
    return "at time " + std::to_string(1e3 * state.time) + " ms, step " +
           std::to_string(state.step);
  }

  void check_motion(const Model                 &model,
                    const std::vector<BodySums> &sums,
                    const State                 &last_measured,
                    const State                 &now)
  {
    // One number that is not finite anywhere makes this sum so; comparisons with NaN would be
    // false.
    double kinetic = 0;
    for (const BodySums &body : sums)
      kinetic += body.update.kinetic;
    if (!std::isfinite(kinetic))
      throw NumericalError("NaN or infinite displacement " + describe_instant(now) + ": " +
                           describe_broken_element(model, last_measured, now) +
                           ". Reduce Dynamics/time step factor or the contact penalty");
  }

  void check_penetration(const Model         &model,
                         const ContactSystem &contact,
                         const RigidWalls    &walls,
                         const State         &now)
  {
    // All ranks know: the flags have travelled with the reductions of contact and walls.
    if (contact.sums().is_too_deep())
      throw NumericalError("penetration exceeds the limit " + describe_instant(now) + ": " +
                           contact.describe_deepest_point());
    if (walls.is_too_deep())
      throw NumericalError("penetration exceeds the limit " + describe_instant(now) + ": " +
                           walls.describe_deepest_node(model));
  }

  std::string
  describe_deepest(const Model &model, const ContactSystem &contact, const RigidWalls &walls)
  {
    return contact.sums().is_pressed() ? contact.describe_deepest_point()
                                       : walls.describe_deepest_node(model);
  }

  void check_elements(const Model           &model,
                      const State           &measured,
                      const ElementMeasures &measures,
                      const Communicator    &communicator)
  {
    // Each rank names its own worst element; the text of those that have none is empty.
    std::string text;
    if (measures.least_jacobian <= 0)
      text = describe(model, find_distortion(model, measured, measures.least_element));
    if (!communicator.any(!text.empty()))
      return;
    // The lowest rank that has an inverted element names it.
    for (const std::string &found : communicator.all_gather(text))
      if (!found.empty())
        throw NumericalError("an element is inverted " + describe_instant(measured) + ": " + found);
  }
} // namespace vfife
