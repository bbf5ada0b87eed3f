// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    // Of the Rayleigh quotient omega^2: 1 % of it is 0.5 % of the step.
    constexpr unsigned int least_iterations = 20, most_iterations = 400;
    constexpr double       wanted_deviation = 0.01;

    NodeField undeformed_positions(const Model &model, const VfifeOperator &vfife)
    {
      const Partition &partition = vfife.partition();
      NodeField        positions = vfife.make_field();
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        for (const std::uint32_t i : partition.nodes(b))
          {
            const Body &body = model.bodies[b];
            // Near the origin of its own, a body's coordinates carry the least round-off.
            positions.set(i, body.node_positions()[partition.global_node[i] - body.first_node]);
          }
      return positions;
    }

    /** Numbers between -1 and 1 without a pattern, the same on all copies of a node. */
    NodeField start_vector(const VfifeOperator &vfife)
    {
      const Partition &partition = vfife.partition();
      NodeField        v         = vfife.make_field();
      for (const std::uint32_t i : partition.nodes())
        {
          Vector3 value;
          for (unsigned int c = 0; c < 3; ++c)
            value[c] = std::sin(12.9898 * (3. * partition.global_node[i] + c) + 1.) *
                       std::cos(78.233 * (3. * partition.global_node[i] + c));
          v.set(i, value);
        }
      return v;
    }

    /** A motion whose strains are small beside those that make forces non-linear, and large beside
     * round-off: this part of the least element's size [mm]. */
    double find_amplitude(const Model &model, const VfifeOperator &vfife)
    {
      double speed = 0;
      for (const Body &body : model.bodies)
        speed =
          std::max(speed, std::sqrt(body.material().youngs_modulus / body.material().density));
      return 1e-6 * speed * vfife.limiting_element().stable_step();
    }
  } // namespace


  AssembledFrequency iterate_largest_frequency(const Model        &model,
                                               VfifeOperator      &vfife,
                                               const Communicator &communicator)
  {
    const Partition &partition = vfife.partition();
    const NodeField  x0        = undeformed_positions(model, vfife);
    NodeField        v = start_vector(vfife), x = x0, forces = vfife.make_field();
    const double     amplitude = find_amplitude(model, vfife);

    AssembledFrequency result;
    // v <- M^-1 K v turns towards the shape of the largest omega^2, K v = omega^2 M v.
    for (unsigned int iteration = 1; iteration <= most_iterations; ++iteration)
      {
        // 1. v to the amplitude that differences of forces want, x = x0 + v.
        double largest = 0;
        for (const std::uint32_t i : partition.nodes())
          largest = std::max(largest, v.value(i).cwiseAbs().maxCoeff());
        const double scale = amplitude / communicator.max(largest);
        for (const std::uint32_t i : partition.nodes())
          {
            v.set(i, scale * v.value(i));
            x.set(i, x0.value(i) + v.value(i));
          }
        vfife.compute_internal_forces(x, forces);

        // 2. K v = -f, as the undeformed bodies have no forces; the next v is M^-1 K v.
        std::vector<double> sums(3, 0.); // v.M v, v.K v, K v . M^-1 K v
        for (const std::uint32_t i : partition.nodes())
          {
            const double  m   = vfife.masses()[i];
            const Vector3 v_i = v.value(i), Kv = -forces.value(i);
            for (unsigned int c = 0; partition.owned[i] && c < 3; ++c)
              {
                sums[0] += m * v_i[c] * v_i[c];
                sums[1] += v_i[c] * Kv[c];
                sums[2] += Kv[c] * Kv[c] / m;
              }
            v.set(i, Kv / m);
          }
        // 3. Rayleigh quotient q = v.K v / v.M v and deviation, s^2 = |M^-1/2 K v|^2 / v.M v - q^2.
        communicator.sum(sums);
        result.quotient = sums[1] / sums[0];
        result.deviation =
          std::sqrt(std::max(0., sums[2] / sums[0] - result.quotient * result.quotient));
        result.iterations = iteration;
        if (iteration >= least_iterations && result.deviation < wanted_deviation * result.quotient)
          break;
      }
    // omega^2 = q + s, for some eigenvalue lies within s of q; never above the worst element's
    result.frequency =
      std::min(std::sqrt(result.quotient + result.deviation), vfife.limiting_element().frequency);
    return result;
  }


  double find_element_step(const Model        &model,
                           const StepBound     bound,
                           VfifeOperator      &vfife,
                           const Communicator &communicator,
                           Log                &log)
  {
    const double worst = vfife.limiting_element().stable_step();
    if (bound == StepBound::element)
      return worst;
    const AssembledFrequency assembled = iterate_largest_frequency(model, vfife, communicator);
    const double             step      = 2. / assembled.frequency;
    log.line("power iteration: stable step ",
             1e9 * step,
             " ns, ",
             step / worst,
             " of that of the worst element, after ",
             assembled.iterations,
             " iterations; an eigenvalue is within ",
             100 * assembled.deviation / assembled.quotient,
             " % of the quotient");
    return step;
  }
} // namespace vfife
