// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/half_space/cell_forces.h>

#include <algorithm>
#include <limits>
#include <string>

namespace vfife
{
  namespace
  {
    constexpr unsigned int largest_iterations = 5000;
    /** Gaps of cells that carry, and penetrations of others, over the largest deflection. */
    constexpr double tolerance = 1e-8;

    /** All over the arms, with which every cell has the arm 1: forces as q = arms f, gaps as h /
     * arms. */
    struct Iteration
    {
      const Eigen::VectorXd &gaps;
      double                 load;
      Eigen::VectorXd        q, deflections;
      Eigen::VectorXd        direction;
      double                 closing = 0., square = 1., largest = 0.;
      bool                   conjugate = false;

      /** Gaps of now; closed on the average where cells carry. */
      Eigen::VectorXd find_gaps()
      {
        Eigen::VectorXd h   = gaps + deflections;
        double          sum = 0.;
        unsigned int    n   = 0;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            {
              sum += h[i];
              ++n;
            }
        closing = sum / n;
        h.array() -= closing;
        largest = 0.;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          largest = std::max(largest, q[i] > 0. ? std::abs(h[i]) : -h[i]);
        return h;
      }

      /** Along the conjugate direction of the cells that carry. */
      void update_direction(const Eigen::VectorXd &h)
      {
        double now = 0.;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            now += h[i] * h[i];
        const double kept = conjugate ? now / square : 0.;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          direction[i] = q[i] > 0. ? h[i] + kept * direction[i] : 0.;
        square = now;
      }

      /** @p change: of deflections along the direction. */
      void step(const Eigen::VectorXd &h, const Eigen::VectorXd &change)
      {
        double       mean = 0., along = 0., against = 0.;
        unsigned int n = 0;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            {
              mean += change[i];
              ++n;
            }
        mean /= n;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            {
              along += h[i] * direction[i];
              against += (change[i] - mean) * direction[i];
            }
        // One cell alone has nothing to share out.
        const double length = against > 0. ? along / against : 0.;
        conjugate           = true;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            q[i] = std::max(q[i] - length * direction[i], 0.);
          else if (h[i] < 0.)
            {
              // A cell that is penetrated carries from now on, and gradients begin anew.
              q[i]      = -(length > 0. ? length : 1. / (against + 1e-300)) * h[i];
              conjugate = false;
            }
        q *= load / q.sum();
      }
    };
  } // namespace


  CellForces
  find_cell_forces(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &flexibility,
                   const Eigen::VectorXd                                         &gaps,
                   const Eigen::VectorXd                                         &arms,
                   const double                                                   load)
  {
    if (gaps.size() == 0 || !(arms.minCoeff() > 0.) || !(load > 0.))
      throw InputError("the forces of cells need cells, and positive arms and a positive load");
    const auto deflect = [&](const Eigen::VectorXd &q) -> Eigen::VectorXd {
      return flexibility(q.cwiseQuotient(arms)).cwiseQuotient(arms);
    };
    const Eigen::VectorXd scaled = gaps.cwiseQuotient(arms);
    const Eigen::Index    n      = gaps.size();
    Iteration             now{
      scaled, load, Eigen::VectorXd::Constant(n, load / n), {}, Eigen::VectorXd::Zero(n)};
    CellForces result;
    for (result.iterations = 0;; ++result.iterations)
      {
        now.deflections         = deflect(now.q);
        const Eigen::VectorXd h = now.find_gaps();
        if (now.largest <= tolerance * now.deflections.lpNorm<Eigen::Infinity>())
          {
            result.forces  = now.q.cwiseQuotient(arms);
            result.gaps    = h.cwiseProduct(arms);
            result.closing = now.closing;
            return result;
          }
        if (result.iterations == largest_iterations)
          throw NumericalError("the pressures of a contact's own grid are not found in " +
                               std::to_string(largest_iterations) + " iterations");
        now.update_direction(h);
        now.step(h, deflect(now.direction));
      }
  }
} // namespace vfife
