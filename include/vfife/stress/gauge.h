// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_stress_gauge_h
#define vfife_stress_gauge_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/types.h>
#include <vfife/stress/fillet.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /** A strain gauge glued into a fillet: section Gauge NAME. */
  struct GaugeOptions
  {
    std::string  body      = "gear";    ///< "pinion" or "gear"
    std::string  side      = "concave"; ///< of the fillet
    unsigned int tooth     = 0;
    double       height    = .5; ///< of its middle, over the fillet's length up the profile
    double       place     = .5; ///< of its middle, over the face width, from the toe
    double       direction = 0;  ///< from up the profile towards the heel [rad]
    double       length    = 1;  ///< [mm]

    void declare(dealii::ParameterHandler &prm);
  };

  /**
   * The mean strain along a line on the surface: the change of its length over its length, as the
   * elements' own surface is displaced. The line keeps its angle to the lines along the face.
   */
  class Gauge
  {
  public:
    /** @p section: of the options, for messages. Throws InputError where the line leaves fillet,
     * root land and the first row of the flank. Body and fillet must outlive the gauge. */
    Gauge(const Body         &body,
          const Fillet       &fillet,
          const GaugeOptions &options,
          const std::string  &section);

    const Fillet &fillet() const
    {
      return fillet_;
    }

    /** A vector [mm] at a node of the body. */
    using NodeVectors = std::function<Vector3(unsigned int node)>;

    /** Strain of small displacements in the axes of the body frame, of this gauge's copy on
     * @p tooth. */
    double of_displacements(const NodeVectors &u, unsigned int tooth) const;

    /** Strain from the present places of the nodes in any axes. */
    double of_places(const NodeVectors &x, unsigned int tooth) const;

  private:
    /** A point of the line by the corners of its facet. */
    struct Point
    {
      unsigned int          column, row;
      std::array<double, 4> weights; ///< of the lines (0, 0), (1, 0), (0, 1), (1, 1)
    };
    using Points = std::vector<Point>;

    Point   make_point(const Vector2 &place) const;
    Vector3 value(const NodeVectors &field, const Point &point, unsigned int tooth) const;
    Vector3 undeformed(const Point &point, unsigned int tooth) const;
    Vector2 find_middle(const GaugeOptions &options) const;
    /** Points from the middle on, the middle left out. Throws InputError as the constructor. */
    Points walk(Vector2 place, double direction, double length, const std::string &section) const;

    const Body   &body_;
    const Fillet &fillet_;
    Points        points_;
  };
} // namespace vfife

#endif
