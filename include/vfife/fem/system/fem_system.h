// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_system_h
#define vfife_fem_system_fem_system_h

#include <vfife/fem/system/bearing_rings.h>
#include <vfife/fem/system/fem_constraints.h>
#include <vfife/fem/system/fem_matrix.h>

#include <functional>
#include <vector>

namespace vfife
{
  class Communicator;

  /** Sums matrices and vectors of elements over a space, on the unknowns: T^T A T, T^T f. */
  class FemSystem
  {
  public:
    using ElementMatrix = std::function<Eigen::MatrixXd(unsigned int element)>;
    using ElementVector = std::function<Eigen::VectorXd(unsigned int element)>;

    /** Points that are coupled beside elements, as by a contact. */
    using Links = std::vector<std::vector<unsigned int>>;

    FemSystem(const FemSpace                &space,
              const FemConstraints::Options &options,
              const Communicator            &communicator,
              Links                          links   = {},
              HousingLaw                     housing = HousingLaw::joins_seats);

    const FemSpace &space() const
    {
      return space_;
    }
    /** Of bearings and couplings, whose points are coupled. */
    const BearingRings &rings() const
    {
      return rings_;
    }
    const FemConstraints &constraints() const
    {
      return constraints_;
    }
    const Communicator &communicator() const
    {
      return communicator_;
    }

    /** 3n x 3n matrices of elements, for each copy of the points. Rows of padding stay zero. */
    FemMatrix matrix(const ElementMatrix &element) const;

    /** Sums 3 x 3 matrices of points (copies of images included), for each copy. */
    FemMatrix point_matrix(const std::vector<std::pair<unsigned int, Matrix3>> &points) const;

    /** B^T K B of the rings of bearings and couplings, K over the motions of all of them. */
    FemMatrix ring_matrix(const Eigen::MatrixXd &stiffness) const;

    /** 3n x 3n matrices of the n points of each link. */
    FemMatrix link_matrix(const std::function<Eigen::MatrixXd(unsigned int link)> &link) const;

    /** Displacement-like vectors (3n) of elements, the same on all copies of the points. */
    OwnedVector vector(const ElementVector &element) const;

    /** T^T f of forces given at all points (3 per point), the same on every rank. */
    OwnedVector restrict_forces(const std::vector<double> &forces) const;

    /** Puts @p value on the diagonal of rows of padding. */
    void set_padding(FemMatrix &A, double value) const;

    /** Displacements of all points (every copy) on all ranks. Collective. */
    std::vector<double> expand(const OwnedVector &q) const;

    /** The owned part of the unknowns that reproduce a field of all points. */
    OwnedVector restrict_field(const std::vector<double> &u) const;

    /** Mean of the positive diagonal entries, all ranks: what fits to padding. Collective. */
    double mean_diagonal(const FemMatrix &A) const;

    double dot(const OwnedVector &a, const OwnedVector &b) const;

  private:
    bool is_mine(const unsigned int unknown) const
    {
      return unknown >= first_ && unknown < last_;
    }
    void find_elements();
    void make_pattern();
    void add(std::size_t            row_offset,
             const unsigned int    *row_points,
             const unsigned int    *column_points,
             const Eigen::MatrixXd &A,
             FemMatrix             &sum) const;

    const FemSpace                      &space_;
    const Communicator                  &communicator_;
    FemConstraints                       constraints_;
    unsigned int                         first_, last_;
    Links                                links_;
    BearingRings                         rings_;
    std::vector<unsigned int>            elements_; ///< that touch own unknowns
    std::shared_ptr<const SparsePattern> pattern_;
  };
} // namespace vfife

#endif
