// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/half_space/cell_forces.h>

#include <Eigen/LU>

#include <algorithm>
#include <string>
#include <vector>

namespace vfife
{
  namespace
  {
    /** Beyond so many gradients the cells that carry are found one set after the other; the
     * elements' part of the flexibility may be so badly conditioned that gradients stagnate. Sets
     * of more cells take minutes: there gradients go on. */
    constexpr unsigned int most_gradients = 600, most_gradients_of_many = 5000;
    constexpr unsigned int most_sets  = 400;
    constexpr Eigen::Index most_cells = 2000;
    /** From this set on only the worst cell is added, which ends cycles. */
    constexpr unsigned int first_single_set = 50;
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
      bool                   follows   = false; ///< deflections were changed by those of a step

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
        conjugate = follows = true;
        for (Eigen::Index i = 0; i < q.size(); ++i)
          if (q[i] > 0.)
            {
              q[i] -= length * direction[i];
              if (!(q[i] > 0.))
                {
                  q[i]    = 0.;
                  follows = false;
                }
            }
          else if (h[i] < 0.)
            {
              // A cell that is penetrated carries from now on, and gradients begin anew.
              q[i]      = -(length > 0. ? length : 1. / (against + 1e-300)) * h[i];
              conjugate = follows = false;
            }
        const double factor = load / q.sum();
        q *= factor;
        if (follows)
          deflections = factor * (deflections - length * change);
      }
    };

    using Deflect = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;

    /** The same by sets of cells that carry, each solved directly; starts from forces @p q, all
     * over the arms. Returns forces, gaps and closing over the arms. */
    CellForces find_by_sets(const Deflect         &deflect,
                            const Eigen::VectorXd &gaps,
                            const double           load,
                            const Eigen::VectorXd &q)
    {
      const Eigen::Index n = gaps.size();
      Eigen::MatrixXd    flexibility(n, n);
      for (Eigen::Index i = 0; i < n; ++i)
        flexibility.col(i) = deflect(Eigen::VectorXd::Unit(n, i));
      std::vector<char> carries(n);
      for (Eigen::Index i = 0; i < n; ++i)
        carries[i] = q[i] > 0.;
      CellForces result;
      for (result.iterations = 0; result.iterations < most_sets; ++result.iterations)
        {
          std::vector<Eigen::Index> set;
          for (Eigen::Index i = 0; i < n; ++i)
            if (carries[i])
              set.push_back(i);
          // Gaps of the set are zero and its forces have the load: the closing is the multiplier.
          const Eigen::Index m      = set.size();
          Eigen::MatrixXd    system = Eigen::MatrixXd::Zero(m + 1, m + 1);
          Eigen::VectorXd    right(m + 1);
          for (Eigen::Index a = 0; a < m; ++a)
            {
              for (Eigen::Index b = 0; b < m; ++b)
                system(a, b) = flexibility(set[a], set[b]);
              system(a, m) = -1.;
              system(m, a) = 1.;
              right[a]     = -gaps[set[a]];
            }
          right[m]                    = load;
          const Eigen::VectorXd found = system.partialPivLu().solve(right);
          if (found.head(m).minCoeff() < 0.)
            {
              for (Eigen::Index a = 0; a < m; ++a)
                carries[set[a]] = found[a] >= 0.;
              continue;
            }
          result.forces = Eigen::VectorXd::Zero(n);
          for (Eigen::Index a = 0; a < m; ++a)
            result.forces[set[a]] = found[a];
          result.closing     = found[m];
          result.gaps        = (gaps + flexibility * result.forces).array() - result.closing;
          const double least = -tolerance * (flexibility * result.forces).lpNorm<Eigen::Infinity>();
          Eigen::Index worst = 0;
          if (result.gaps.minCoeff(&worst) >= least)
            return result;
          for (Eigen::Index i = 0; i < n; ++i)
            if (result.gaps[i] < least && (i == worst || result.iterations < first_single_set))
              carries[i] = true;
        }
      throw NumericalError("the pressures on the contact's own grid did not converge in " +
                           std::to_string(most_sets) + " sets of loaded cells");
    }
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
        if (!now.follows)
          now.deflections = deflect(now.q);
        const Eigen::VectorXd h = now.find_gaps();
        if (now.largest <= tolerance * now.deflections.lpNorm<Eigen::Infinity>())
          {
            if (now.follows) // round-off of the steps
              {
                now.follows = false;
                continue;
              }
            result.forces  = now.q.cwiseQuotient(arms);
            result.gaps    = h.cwiseProduct(arms);
            result.closing = now.closing;
            return result;
          }
        if (result.iterations == most_gradients_of_many)
          throw NumericalError("the pressures on the contact's own grid did not converge in " +
                               std::to_string(most_gradients_of_many) + " iterations");
        if (result.iterations == most_gradients && n <= most_cells)
          {
            result        = find_by_sets(deflect, scaled, load, now.q);
            result.forces = result.forces.cwiseQuotient(arms);
            result.gaps   = result.gaps.cwiseProduct(arms);
            return result;
          }
        now.update_direction(h);
        now.step(h, deflect(now.direction));
      }
  }
} // namespace vfife
