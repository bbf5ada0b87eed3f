// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/gear_manifolds.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/node_set_names.h>

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    using Points  = dealii::ArrayView<const dealii::Point<3>>;
    using Weights = dealii::ArrayView<const double>;

    enum ManifoldIds : dealii::types::manifold_id
    {
      revolution,
      concave_flank,
      convex_flank,
      concave_fillet,
      convex_fillet,
      first_web_fillet
    };

    Vector3 vector_of(const dealii::Point<3> &x)
    {
      return {x[0], x[1], x[2]};
    }

    /** The mean in cylinder coordinates about z, moved onto the torus of an arc in the meridian. */
    class TorusManifold : public dealii::Manifold<3>
    {
    public:
      explicit TorusManifold(const MeridianArc &arc)
        : arc_(arc)
      {
      }

      std::unique_ptr<dealii::Manifold<3>> clone() const override
      {
        return std::make_unique<TorusManifold>(*this);
      }

      dealii::Point<3> get_new_point(const Points  &surrounding_points,
                                     const Weights &weights) const override
      {
        const auto    mean = cylinder_.get_new_point(surrounding_points, weights);
        const double  r    = std::hypot(mean[0], mean[1]);
        const Vector2 moved =
          arc_.centre + arc_.radius * (Vector2(r, mean[2]) - arc_.centre).normalized();
        return {mean[0] * moved[0] / r, mean[1] * moved[0] / r, moved[1]};
      }

    private:
      MeridianArc                    arc_;
      dealii::CylindricalManifold<3> cylinder_{2};
    };

    /** Whether all corners of a face are on an arc. */
    template <typename Face>
    bool is_on(const MeridianArc &arc, const Face &face)
    {
      for (unsigned int v = 0; v < 4; ++v)
        if (!arc.contains(vector_of(face->vertex(v))))
          return false;
      return true;
    }

    /** Rotation from the tooth that has @p here near it on tooth 0 to the tooth of @p there. */
    Matrix3 rotation_between(const GearGeometry &gear, const Vector3 &here, const Vector3 &there)
    {
      const double angle = polar_angle(there) - polar_angle(here);
      return rotation_about(Vector3::UnitZ(), gear.pitch() * std::round(angle / gear.pitch()));
    }

    dealii::Point<3> turned(const Matrix3 &rotation, const Vector3 &x)
    {
      const Vector3 y = rotation * x;
      return {y[0], y[1], y[2]};
    }
  } // namespace

  FlankManifold::FlankManifold(const GearGeometry &gear, const FlankSide side)
    : gear_(gear.clone())
    , side_(side)
  {
  }

  std::unique_ptr<dealii::Manifold<3>> FlankManifold::clone() const
  {
    return std::make_unique<FlankManifold>(*this);
  }

  dealii::Point<3> FlankManifold::get_new_point(const Points  &surrounding_points,
                                                const Weights &weights) const
  {
    // The mean is taken in cone coordinates (L, h), and the new node is the own point of flank or
    // chamfer there.
    Vector2 mean = Vector2::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i)
      mean += weights[i] * gear_->blank().coordinates_of(vector_of(surrounding_points[i]));

    // All points are of one tooth: the first one tells which.
    const Vector3 first = vector_of(surrounding_points[0]);
    const Vector2 L_h   = gear_->blank().coordinates_of(first);
    const Matrix3 rotation =
      rotation_between(*gear_, gear_->flank_point(side_, L_h[0], L_h[1]).position, first);
    return turned(rotation, point_of_side(*gear_, side_, mean[0], mean[1]));
  }

  FilletManifold::FilletManifold(const GearGeometry &gear, const FlankSide side)
    : gear_(gear.clone())
    , side_(side)
  {
  }

  std::unique_ptr<dealii::Manifold<3>> FilletManifold::clone() const
  {
    return std::make_unique<FilletManifold>(*this);
  }

  double FilletManifold::fillet_parameter(const Vector3 &position) const
  {
    // The foot of the point on the profile L = const, by Gauss and Newton's method: at the bottom
    // the height is stationary in lambda, the distance along the profile is not.
    constexpr double difference = 1e-4, tolerance = 1e-11;
    const double     L   = gear_->blank().coordinates_of(position)[0];
    const double     end = gear_->fillet_end(side_);
    const auto       x   = [&](const double lambda) {
      return gear_->fillet_point(side_, L, lambda).position;
    };
    double lambda = .5 * end;
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        // Gauss-Newton step (x - x(lambda)) . x' / |x'|^2 with a difference for the tangent x'
        const double low       = std::max(0., lambda - difference),
                     high      = std::min(end, lambda + difference);
        const Vector3 tangent  = (x(high) - x(low)) / (high - low);
        const double  step     = (position - x(lambda)).dot(tangent) / tangent.squaredNorm();
        const double  previous = lambda;
        lambda                 = std::min(end, std::max(0., lambda + step));
        if (std::abs(lambda - previous) < tolerance)
          return lambda;
      }
    throw NumericalError(gear_->name() + ": a surface node could not be placed on the fillet");
  }

  dealii::Point<3> FilletManifold::get_new_point(const Points  &surrounding_points,
                                                 const Weights &weights) const
  {
    // on tooth 0, by the fillet's middle, which is near enough to tell teeth apart
    const Vector3 first = vector_of(surrounding_points[0]);
    const Matrix3 rotation =
      rotation_between(*gear_,
                       gear_
                         ->fillet_point(side_,
                                        gear_->blank().coordinates_of(first)[0],
                                        .5 * gear_->fillet_end(side_))
                         .position,
                       first);
    double L = 0., lambda = 0.;
    for (std::size_t i = 0; i < weights.size(); ++i)
      {
        const Vector3 x = rotation.transpose() * vector_of(surrounding_points[i]);
        L += weights[i] * gear_->blank().coordinates_of(x)[0];
        lambda += weights[i] * fillet_parameter(x);
      }
    lambda = std::min(gear_->fillet_end(side_), std::max(0., lambda));
    return turned(rotation, gear_->fillet_point(side_, L, lambda).position);
  }

  void
  attach_gear_manifolds(BodyMesh &mesh, const GearGeometry &gear, const WebFillets &web_fillets)
  {
    // Everything is a surface of revolution, but for flanks and fillets of teeth.
    dealii::Triangulation<3> &triangulation = mesh.triangulation;
    triangulation.reset_all_manifolds();
    triangulation.set_all_manifold_ids(revolution);
    triangulation.set_manifold(revolution, dealii::CylindricalManifold<3>(2));
    triangulation.set_manifold(concave_flank, FlankManifold(gear, FlankSide::concave));
    triangulation.set_manifold(convex_flank, FlankManifold(gear, FlankSide::convex));
    triangulation.set_manifold(concave_fillet, FilletManifold(gear, FlankSide::concave));
    triangulation.set_manifold(convex_fillet, FilletManifold(gear, FlankSide::convex));

    // Fillets last: they keep the edge to the flank, flanks and chamfers keep the tip.
    const std::vector<std::pair<std::string, ManifoldIds>> order[2] = {
      {{surface_name::concave, concave_flank},
       {surface_name::convex, convex_flank},
       {node_set::concave_chamfer, concave_flank},
       {node_set::convex_chamfer, convex_flank}},
      {{node_set::concave_fillet, concave_fillet}, {node_set::convex_fillet, convex_fillet}}};
    for (const auto &surfaces : order)
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            if (!face->at_boundary())
              continue;
            const auto name = mesh.boundaries.find(face->boundary_id());
            for (const auto &surface : surfaces)
              if (name != mesh.boundaries.end() && name->second == surface.first)
                face->set_all_manifold_ids(surface.second);
          }
    dealii::types::manifold_id id = first_web_fillet;
    for (const auto &[name, arc] : web_fillets)
      {
        triangulation.set_manifold(id, TorusManifold(arc));
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && is_on(arc, face))
              face->set_all_manifold_ids(id);
        ++id;
      }
  }
} // namespace vfife
