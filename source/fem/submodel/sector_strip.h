// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_submodel_sector_strip_h
#define vfife_fem_submodel_sector_strip_h

#include <vfife/fem/submodel/submodel_part.h>
#include <vfife/fem/system/fem_space.h>

#include <map>
#include <utility>
#include <vector>

namespace vfife
{
  class Communicator;
  class FemMatrix;

  /** A part of sector 0 of a gear body and of the sectors next to it, in the axes of the body.
   * Points where it is cut from the rest of the body, held or turned have given displacements. */
  class SectorStrip
  {
  public:
    /** @p sector must outlive the strip. */
    SectorStrip(const FemSpace &sector, SubmodelPart part);

    /** [mm]. */
    const std::vector<Vector3> &points() const
    {
      return points_;
    }
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** Of the sector's point, turned by so many sectors; images of the next one included. */
    unsigned int number(int turned, unsigned int point) const;

    /** Points with given displacements. */
    const std::vector<unsigned int> &cut() const
    {
      return cut_;
    }
    unsigned int n_unknowns() const
    {
      return n_unknowns_;
    }

    /** What the displacement of something is made of, a row each. */
    struct Influence
    {
      Eigen::MatrixXd of_forces; ///< at all points; a column per component [mm/N]
      Eigen::MatrixXd of_cut;    ///< displacements at the cut [-]
    };
    /** @p readings of points of the sector where it is not turned. */
    Influence find_influence(const std::vector<PointReading> &readings) const;

    /** Centrifugal forces on all points at 1 rad/s [N]. */
    Eigen::VectorXd compute_spin_forces() const;

    /** Forces on all points that expand the elements by the initial strains of the body [N], where
     * the strip's middle is @p tooth; in the axes of tooth 0. */
    Eigen::VectorXd compute_expanding_forces(unsigned int tooth) const;

  private:
    struct Element
    {
      unsigned int              of_sector; ///< the element of the sector that it is a copy of
      int                       turned;
      std::vector<unsigned int> points;
    };

    /** A point turned so many times, images of the next sector by their originals. */
    using Key = std::pair<int, unsigned int>;
    Key key_of(int turned, unsigned int point) const;

    /** By element of the sector: whether it belongs to the strip when it is turned from -beside to
     * beside sectors. */
    using Chosen = std::vector<std::vector<bool>>;
    Chosen          choose_teeth() const;
    Chosen          choose_web() const;
    void            add_elements(const Chosen &chosen);
    void            number_unknowns(const Chosen &chosen);
    FemMatrix       make_matrix(const Communicator &communicator) const;
    Vector3         body_place(unsigned int point) const;
    Eigen::MatrixXd stiffness_of(const Element &element) const;
    ElementNodes    places_of(const Element &element) const;
    bool            is_cut(const unsigned int point) const
    {
      return first_unknown_[point] < 0;
    }

    const FemSpace                      &sector_;
    int                                  beside_;    ///< sectors on either side
    const Body                          &body_;      ///< of the sector
    std::map<unsigned int, unsigned int> originals_; ///< of images
    std::vector<Vector3>                 points_;
    std::map<Key, unsigned int>          numbers_;
    std::vector<Element>                 elements_;
    std::vector<Eigen::MatrixXd>         stiffness_; ///< by element of the sector
    std::vector<unsigned int>            cut_;
    std::vector<int>                     first_unknown_; ///< by point; -1: cut
    unsigned int                         n_unknowns_ = 0;
  };
} // namespace vfife

#endif
