// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_fillet_faces_h
#define vfife_study_fillets_fillet_faces_h

#include <vfife/fem/system/fem_space.h>
#include <vfife/output/measures/root_stress.h>

#include <memory>

namespace vfife
{
  /**
   * Surface strains of fillets from displacements of finite elements: of each facet the strain at
   * that of its elements' Gauss points, degree along each side, where the principal stress is
   * largest. With undivided elements of degree 1 it is FacetStrain at the centre. Gauges read
   * nodes.
   */
  class FilletFaces
  {
  public:
    /** Finds the elements' faces on the fillets. The space must outlive the strains. */
    FilletFaces(const FemSpace &space, const std::deque<MemberFillet> &fillets);

    /** Of displacements of all points (3 a point, fixed frame) [mm], which must outlive it. */
    FilletStrains of(const std::vector<double> &u) const;

  private:
    SurfaceTensor of_facet(const MemberFillet        &member,
                           unsigned int               column,
                           unsigned int               row,
                           unsigned int               tooth,
                           const std::vector<double> &u) const;

    const FemSpace *space_;
    /** By body and sorted corners: points of each element's face. */
    std::map<std::pair<unsigned int, std::array<unsigned int, 4>>,
             std::vector<std::vector<unsigned int>>>
      faces_;
  };
} // namespace vfife

#endif
