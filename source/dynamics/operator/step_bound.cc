// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/dynamics/operator/step_bound.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/model/model.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace vfife
{
  namespace
  {
    // Of omega^2: 1 % of it is 0.5 % of the step.
    constexpr double wanted_error = 0.01, failure_probability = 1e-9;

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

    /** Normally distributed numbers, so that no direction is preferred; the same on all copies of a
     * node. */
    NodeField random_vector(const Model &model, const VfifeOperator &vfife)
    {
      const Partition                 &partition = vfife.partition();
      std::vector<Vector3>             values(model.n_nodes());
      std::mt19937_64                  generator;
      std::normal_distribution<double> number;
      for (Vector3 &value : values)
        for (double &component : value)
          component = number(generator);
      NodeField v = vfife.make_field();
      for (const std::uint32_t i : partition.nodes())
        v.set(i, values[partition.global_node[i]]);
      return v;
    }

    /** A motion whose strains are small beside those that make forces non-linear, and large beside
     * round-off: this part of the least element's size [mm]. */
    double find_amplitude(const Model &model, const VfifeOperator &vfife)
    {
      double speed = 0;
      for (const Body &body : model.bodies)
        speed = std::max(speed, body.sound_speed());
      return 1e-6 * speed * vfife.limiting_element().stable_step();
    }
  } // namespace

  namespace
  {
    /** A = M^-1/2 K M^-1/2 for vectors that nodes hold, and their scalar product over all ranks. */
    class ScaledStiffness
    {
    public:
      ScaledStiffness(const Model &model, VfifeOperator &vfife, const Communicator &communicator)
        : vfife_(vfife)
        , communicator_(communicator)
        , amplitude_(find_amplitude(model, vfife))
        , undeformed_(undeformed_positions(model, vfife))
        , x_(undeformed_)
        , forces_(vfife.make_field())
        , at_rest_(vfife.make_field())
      {
        if (model.has_initial_strains())
          vfife.compute_internal_forces(undeformed_, at_rest_);
      }

      double dot(const NodeField &a, const NodeField &b) const
      {
        const Partition &partition = vfife_.partition();
        double           sum       = 0;
        for (const std::uint32_t i : partition.nodes())
          if (partition.owned[i])
            sum += a.value(i).dot(b.value(i));
        return communicator_.sum(sum);
      }

      /** Sets @p product to A q. */
      void multiply(const NodeField &q, NodeField &product)
      {
        // v = M^-1/2 q to the amplitude that differences of forces want; K v = f(x0) - f(x0 + v),
        // and undeformed bodies have forces by initial strains only.
        const Partition &partition = vfife_.partition();
        double           largest   = 0;
        for (const std::uint32_t i : partition.nodes())
          largest = std::max(largest, q.value(i).cwiseAbs().maxCoeff() / root_mass(i));
        const double scale = amplitude_ / communicator_.max(largest);
        for (const std::uint32_t i : partition.nodes())
          x_.set(i, undeformed_.value(i) + scale / root_mass(i) * q.value(i));
        vfife_.compute_internal_forces(x_, forces_);
        for (const std::uint32_t i : partition.nodes())
          product.set(i, -1. / (scale * root_mass(i)) * (forces_.value(i) - at_rest_.value(i)));
      }

    private:
      double root_mass(const std::uint32_t i) const
      {
        return std::sqrt(vfife_.masses()[i]);
      }

      VfifeOperator      &vfife_;
      const Communicator &communicator_;
      double              amplitude_;
      NodeField           undeformed_, x_, forces_;
      NodeField           at_rest_; ///< forces of undeformed bodies by initial strains [N]
    };

    /** a <- a - factor b at all nodes of the rank. */
    void subtract(const Partition &partition, const double factor, const NodeField &b, NodeField &a)
    {
      for (const std::uint32_t i : partition.nodes())
        a.add(i, -factor * b.value(i));
    }

    void scale(const Partition &partition, const double factor, NodeField &a)
    {
      for (const std::uint32_t i : partition.nodes())
        a.set(i, factor * a.value(i));
    }

    double largest_eigenvalue(const std::vector<double> &diagonal,
                              const std::vector<double> &beside)
    {
      const auto                                     n = static_cast<Eigen::Index>(diagonal.size());
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
      solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                    Eigen::Map<const Eigen::VectorXd>(beside.data(), n - 1),
                                    Eigen::EigenvaluesOnly);
      return solver.eigenvalues()[n - 1];
    }
  } // namespace

  AssembledFrequency bound_largest_frequency(const Model        &model,
                                             VfifeOperator      &vfife,
                                             const Communicator &communicator)
  {
    const Partition &partition = vfife.partition();
    ScaledStiffness  A(model, vfife, communicator);
    // 1. As many steps as the probability asks for; of a small model all there are.
    const double n_unknowns = 3. * model.n_nodes();
    const auto   n_steps    = static_cast<unsigned int>(
      std::min(n_unknowns,
               std::ceil(0.5 + std::log(1.648 * std::sqrt(n_unknowns) / failure_probability) /
                                 (2. * std::sqrt(wanted_error)))));

    // 2. q_k+1 = (A q_k - alpha_k q_k - beta_k-1 q_k-1)/beta_k. The vectors lose their
    // orthogonality in time, which repeats Ritz values and makes none of them too large.
    NodeField q = random_vector(model, vfife), before = vfife.make_field(),
              next = vfife.make_field();
    scale(partition, 1. / std::sqrt(A.dot(q, q)), q);
    std::vector<double> alpha, beta;
    for (;;)
      {
        A.multiply(q, next);
        if (!beta.empty())
          subtract(partition, beta.back(), before, next);
        alpha.push_back(A.dot(q, next));
        subtract(partition, alpha.back(), q, next);
        const double rest = std::sqrt(A.dot(next, next));
        // Without a rest the vectors are a whole invariant space.
        if (alpha.size() == n_steps || rest < 1e-5 * alpha.front())
          break;
        beta.push_back(rest);
        scale(partition, 1. / rest, next);
        std::swap(before, q);
        std::swap(q, next);
      }

    // 3. The bound, which no mesh needs that its worst element bounds better.
    AssembledFrequency result;
    result.iterations = static_cast<unsigned int>(alpha.size());
    result.ritz_value = largest_eigenvalue(alpha, beta);
    result.frequency  = std::min(std::sqrt(result.ritz_value / (1. - wanted_error)),
                                vfife.limiting_element().frequency);
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
    const AssembledFrequency assembled = bound_largest_frequency(model, vfife, communicator);
    const double             step      = 2. / assembled.frequency;
    log.line("the stable step of the assembly is ",
             1e9 * step,
             " ns, ",
             step / worst,
             " times the stable step of the worst element (",
             assembled.iterations,
             " Lanczos iterations)");
    return step;
  }
} // namespace vfife
