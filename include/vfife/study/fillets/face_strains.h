// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_face_strains_h
#define vfife_study_fillets_face_strains_h

#include <vfife/fem/system/element_integrals.h>
#include <vfife/stress/surface_stress.h>

#include <array>
#include <vector>

namespace vfife
{
  class Body;

  /** Mean direction of the sides of a fillet's facet along the face, in the body frame [mm]. */
  Vector3 direction_along_face(const Body &body, const std::array<unsigned int, 4> &facet);

  /**
   * SurfaceTensor of strain at the Gauss points of an element's face (degree x degree) as three
   * rows over displacements of its points @p X (3 a point). Direction 1 is @p along in the tangent
   * plane, direction 2 across.
   */
  std::vector<Eigen::MatrixXd>
  list_face_strains(const ElementNodes &X, const Vector3 &along, unsigned int degree);

  /** Of several strains of a surface that with the largest principal stress. */
  class WorstStrain
  {
  public:
    /** The material must outlive the object. */
    explicit WorstStrain(const Material &material)
      : material_(material)
    {
    }

    void                 add(const SurfaceTensor &strain);
    const SurfaceTensor &strain() const
    {
      return strain_;
    }

  private:
    const Material &material_;
    SurfaceTensor   strain_  = SurfaceTensor::Zero();
    double          largest_ = -1.;
  };
} // namespace vfife

#endif
