// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_elastic_contact_h
#define vfife_fem_pressure_elastic_contact_h

#include <vfife/contact/half_space/bonded_layer.h>
#include <vfife/fem/pressure/contact_cells.h>
#include <vfife/fem/pressure/near_layer.h>

#include <functional>

namespace vfife
{
  /** Corners (xi, eta) of a facet in cyclic order. */
  inline const std::array<Vector2, 4> unit_square = {
    {Vector2(0., 0.), Vector2(1., 0.), Vector2(1., 1.), Vector2(0., 1.)}};

  /** A quadrilateral between points of the elements on a facet (FacetParts). */
  struct FlankPart
  {
    std::array<Vector2, 4>      corners;     ///< (xi, eta) on the facet
    std::array<unsigned int, 4> places;      ///< of its points among those of the flexibility
    std::array<unsigned int, 4> near_places; ///< of its points among near->points
    /** Displacements of its points, without those of the facet there: bilinear between its nodes
     * [mm]. */
    std::array<Vector3, 4> bulges;
  };

  /** Where and with which weights a force acts. */
  struct FlankFoot
  {
    const FlankPart      *part = nullptr;
    std::array<double, 4> weights{}; ///< of the part's corners

    /** Of the bulges [mm]. */
    Vector3 bulge() const;
  };

  /** What a surface in contact belongs to. */
  struct ElasticFlank
  {
    const NearLayer *near = nullptr;
    /** By surface node: the place among the points of the flexibility. */
    std::vector<unsigned int> places;
    /** By facet; of those of the tooth. */
    std::vector<std::vector<FlankPart>> parts;
    Matrix3 rotation       = Matrix3::Identity();   ///< axes of the flexibility to the fixed frame
    double  youngs_modulus = 0, poissons_ratio = 0; ///< [MPa], [-]
    const BondedLayer *held = nullptr;              ///< ElasticLayer::held

    static constexpr unsigned int no_place = static_cast<unsigned int>(-1);

    /** Of the part in which a foot lies. */
    FlankFoot find(const CellFoot &foot) const;
  };

  /** Two groups of facets that may touch; flanks of slave and master. */
  struct ElasticContact
  {
    FacingSurfaces              surfaces;
    std::array<ElasticFlank, 2> flanks;
  };

  /** What bodies in contact do and carry, in the state in which their surfaces are. */
  struct ContactLoad
  {
    /** Displacements at rows (3 a point, as ElasticFlank::places) under unit forces there [mm/N].
     */
    std::function<Eigen::MatrixXd(const std::vector<unsigned int> &rows)> flexibility;
    /** Forces of the contact at all rows with which the surfaces have come to their state [N]. */
    Eigen::VectorXd forces;
    /** At a point, for the normal out of the master there: how fast the gap closes, by what
     * carries the load; 1: an approach [-], or of a turn [mm]. Positive. */
    std::function<double(const Vector3 &position, const Vector3 &normal)> arm;
    double                                                                load = 0; ///< [N], [N mm]
  };
} // namespace vfife

#endif
