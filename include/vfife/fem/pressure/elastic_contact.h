// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_elastic_contact_h
#define vfife_fem_pressure_elastic_contact_h

#include <vfife/contact/half_space/bonded_layer.h>
#include <vfife/fem/pressure/contact_cells.h>
#include <vfife/fem/pressure/near_layer.h>

#include <functional>

namespace vfife
{
  /** What a surface in contact belongs to. */
  struct ElasticFlank
  {
    const NearLayer *near = nullptr;
    /** By surface node: the place among the points of the flexibility, and among near->points. */
    std::vector<unsigned int> places, near_places;
    Matrix3 rotation       = Matrix3::Identity();   ///< axes of the flexibility to the fixed frame
    double  youngs_modulus = 0, poissons_ratio = 0; ///< [MPa], [-]
    const BondedLayer *held = nullptr;              ///< ElasticLayer::held

    static constexpr unsigned int no_place = static_cast<unsigned int>(-1);
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
