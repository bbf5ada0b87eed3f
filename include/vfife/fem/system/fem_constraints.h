// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_constraints_h
#define vfife_fem_system_fem_constraints_h

#include <vfife/fem/system/fem_space.h>
#include <vfife/model/constraints/node_constraints.h>

#include <deal.II/base/types.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace dealii
{
  template <typename>
  class AffineConstraints;
}

namespace vfife
{
  /** Rotation of hubs that turn freely (free rotation, rigid hub) about the axis. */
  enum class HubRotation
  {
    free,
    pinned, ///< held at one node, which carries nothing where loads have no moment about the axis
    held    ///< as if the shaft were clamped
  };

  /**
   * The displacements u (3 per point) under the constraints of the model: u = T q, as lines of
   * dealii::AffineConstraints. The indices of q come first in them, then those of u. Held points
   * and points of a prescribed rotation have no unknowns (the system turns with the body), free
   * rotation leaves the tangential displacement, a rigid hub one common angle, constraints of one
   * point together what no held direction spans (NodeConstraints). Unknowns are numbered rank by
   * rank, each rank owning a run of them. Equal on all ranks.
   *
   * For a sector of a cyclic body, displacements are the real part of phasors whose value turns by
   * exp(i h angle) from one sector to the next, h the harmonic: points of the next sector are
   * images u' = R u exp(i h angle). With 0 < h < N/2 there are two copies of all points, real part
   * first.
   */
  class FemConstraints
  {
  public:
    /** A displacement as sum of unknowns: (unknown, coefficient), ascending. */
    using Line = std::vector<std::pair<dealii::types::global_dof_index, double>>;

    struct Options
    {
      /** Three unknowns per point also where constraints leave less: those left over do not act.
       * Multigrid wants it. */
      bool         padded   = false;
      unsigned int harmonic = 0; ///< of a sector
      HubRotation  rotation = HubRotation::free;
      /** Of a sector: images have unknowns of their own, along the axes of their originals turned,
       * in the order of theirs. There are no harmonics and
       * no bearing rings then. */
      bool open = false;
      /** Directions with a displacement other than zero are taken as held; else InputError. */
      bool led_are_held = false;
    };

    /** Throws InputError for a harmonic that the sectors do not have, for constraints in conflict
     * and where nothing is free to move. */
    FemConstraints(const FemSpace &space, const Options &options, unsigned int n_ranks);
    FemConstraints(const FemConstraints &)            = delete;
    FemConstraints &operator=(const FemConstraints &) = delete;
    ~FemConstraints();

    /** Number of unknowns. */
    unsigned int n() const
    {
      return padding_.size();
    }
    unsigned int n_copies() const
    {
      return n_copies_;
    }
    /** First unknown of rank @p r; r = number of ranks gives n(). */
    unsigned int first(const unsigned int r) const
    {
      return first_[r];
    }

    /** Line of the displacement 3 * (copy * points + point) + component. */
    const Line &line(std::size_t row) const;

    bool is_padding(const unsigned int unknown) const
    {
      return padding_[unknown] != 0;
    }

    /** Unknowns that are the angles of rigid hubs, which all sectors share. */
    const std::vector<unsigned int> &hub_angles() const
    {
      return hub_angles_;
    }

    /** u = T q. */
    std::vector<double> expand(const std::vector<double> &q) const;
    /** Coefficients that reproduce @p u where it is compatible: (T^T T)^-1 T^T u, T having
     * orthogonal columns. */
    std::vector<double> restrict_field(const std::vector<double> &u) const;

  private:
    struct LocalAxes;
    std::vector<LocalAxes> make_axes(const FemSpace &space, const Options &options) const;
    void
    number(const FemSpace &space, bool padded, unsigned int n_ranks, std::vector<LocalAxes> &axes);
    void
    add_lines(const FemSpace &space, const Options &options, const std::vector<LocalAxes> &axes);

    unsigned int                                       n_copies_ = 1;
    std::vector<unsigned int>                          first_;
    std::vector<unsigned int>                          hub_angles_;
    std::vector<bool>                                  padding_;
    std::vector<bool>                                  hangs_; ///< by point
    std::unique_ptr<dealii::AffineConstraints<double>> lines_;
  };

  /** The checked constraints of all points of a space that have any, by point; as
   * combine_constraints(), with the points of quadratic elements between the nodes. */
  std::map<unsigned int, NodeConstraints> find_point_constraints(const FemSpace &space);

  /**
   * Displacements of all points (3 per point) [mm] that the constraints prescribe, zero elsewhere
   * and along free directions: constraints of directions, and rotations by an angle, taken as
   * small.
   * @p factor: of the constraint's value. Throws InputError where constraints of a point contradict
   * each other.
   */
  std::vector<double>
  compute_prescribed_displacements(const FemSpace                                  &space,
                                   const std::function<double(const Constraint &)> &factor);
} // namespace vfife

#endif
