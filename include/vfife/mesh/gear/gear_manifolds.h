// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_gear_manifolds_h
#define vfife_mesh_gear_gear_manifolds_h

#include <vfife/gear/gear_geometry.h>
#include <vfife/mesh/gear/sector/gear_sector.h>

#include <deal.II/grid/manifold.h>

#include <memory>

namespace vfife
{
  /**
   * The true flanks of one side of all teeth with their tip chamfers, in coordinates (L, h) of the
   * blank: a new point has the weighted mean of them and lies on the true flank or chamfer. Toe,
   * heel, end of the flank and tip (h linear in L) are kept.
   */
  class FlankManifold : public dealii::Manifold<3>
  {
  public:
    FlankManifold(const GearGeometry &gear, FlankSide side);

    std::unique_ptr<dealii::Manifold<3>> clone() const override;

    dealii::Point<3>
    get_new_point(const dealii::ArrayView<const dealii::Point<3>> &surrounding_points,
                  const dealii::ArrayView<const double>           &weights) const override;

  private:
    std::shared_ptr<const GearGeometry> gear_; ///< shared by copies; never changed
    FlankSide                           side_;
  };

  /**
   * The true fillets of one side of all teeth, in (L, lambda): place along the pitch line and
   * parameter of the fillet. The start of the flank (largest lambda) and the bottom (lambda = 0)
   * are kept.
   */
  class FilletManifold : public dealii::Manifold<3>
  {
  public:
    FilletManifold(const GearGeometry &gear, FlankSide side);

    std::unique_ptr<dealii::Manifold<3>> clone() const override;

    /** Throws NumericalError when a point is not on a fillet. */
    dealii::Point<3>
    get_new_point(const dealii::ArrayView<const dealii::Point<3>> &surrounding_points,
                  const dealii::ArrayView<const double>           &weights) const override;

    /** lambda of a point of the fillet of tooth 0. */
    double fillet_parameter(const Vector3 &position) const;

  private:
    std::shared_ptr<const GearGeometry> gear_; ///< shared by copies; never changed
    FlankSide                           side_;
  };

  /**
   * Puts manifolds on the triangulation of a gear body whose boundaries have been named
   * (gear_boundaries()): flanks and fillets as above, fillets of the web on their arcs, everything
   * else in cylinder coordinates about z, which keeps cones and cylinders of revolution and the
   * tooth number's symmetry. New nodes inside a cell are deal.II's transfinite mean of its refined
   * faces.
   */
  void
  attach_gear_manifolds(BodyMesh &mesh, const GearGeometry &gear, const WebFillets &web_fillets);
} // namespace vfife

#endif
