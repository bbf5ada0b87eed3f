// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "nodes_around.h"

#include <vfife/base/errors.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Part of an element's diagonal by which a place may be outside of it: curved surfaces of two
     * meshes differ. */
    constexpr double margin = .15;

    /** Trilinear functions at a place @p x of the unit cube, and their derivatives. */
    struct Trilinear
    {
      Eigen::Matrix<double, 8, 1> values;
      Eigen::Matrix<double, 8, 3> derivatives;

      explicit Trilinear(const Vector3 &x)
      {
        for (unsigned int a = 0; a < 8; ++a)
          {
            std::array<double, 3> of, slope;
            for (unsigned int c = 0; c < 3; ++c)
              {
                const bool upper = (a >> c & 1u) != 0;
                of[c]            = upper ? x[c] : 1. - x[c];
                slope[c]         = upper ? 1. : -1.;
              }
            values[a] = of[0] * of[1] * of[2];
            derivatives.row(a) << slope[0] * of[1] * of[2], of[0] * slope[1] * of[2],
              of[0] * of[1] * slope[2];
          }
      }
    };

    /** Newton's method for the place of @p target in an element with the corners @p X; says whether
     * it is found. */
    bool invert(const HexahedronNodes &X, const Vector3 &target, Vector3 &x)
    {
      constexpr unsigned int most_steps = 30;
      constexpr double       far        = 10.; ///< outside the element
      x.setConstant(.5);
      for (unsigned int step = 0; step < most_steps && x.norm() < far; ++step)
        {
          const Trilinear at(x);
          const Vector3   change = Matrix3(X * at.derivatives).inverse() * (X * at.values - target);
          x -= change;
          if (change.norm() < 1e-12)
            return true;
        }
      return false;
    }
  } // namespace

  NodesAround::NodesAround(const Body &body)
    : body_(body)
  {
    for (unsigned int e = 0; e < body.n_elements(); ++e)
      {
        const HexahedronNodes X     = body.element_nodes(e);
        const Vector3         lower = X.rowwise().minCoeff(), upper = X.rowwise().maxCoeff();
        const Vector3         more = Vector3::Constant(margin * (upper - lower).norm());
        boxes_.push_back({{lower - more, upper + more}});
      }
  }

  PointWeights NodesAround::find(const Vector3 &place) const
  {
    double       least = std::numeric_limits<double>::infinity();
    PointWeights found;
    for (unsigned int e = 0; e < body_.n_elements() && least > 0.; ++e)
      {
        Vector3 x;
        if ((place.array() < boxes_[e][0].array()).any() ||
            (place.array() > boxes_[e][1].array()).any() ||
            !invert(body_.element_nodes(e), place, x))
          continue;
        const double outside = std::max(0., (x.array() - .5).abs().maxCoeff() - .5);
        if (outside >= least)
          continue;
        least = outside;
        found.clear();
        const Trilinear at(x);
        for (unsigned int a = 0; a < 8; ++a)
          found.emplace_back(body_.elements()[e][a], at.values[a]);
      }
    if (found.empty())
      {
        std::ostringstream message;
        message << "body \"" << body_.name() << "\": no element is near the place "
                << place.transpose() << " mm of a submodel";
        throw InputError(message.str());
      }
    return found;
  }
} // namespace vfife
