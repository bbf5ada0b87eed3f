// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_load_shares_h
#define vfife_model_load_shares_h

#include <vfife/model/model.h>

#include <array>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * What each node of a load takes of it: a share of one by the area that belongs to the node
   * (equal shares where the nodes carry no whole face), or, of an acceleration, its mass [t].
   * Throws InputError for a pressure without a face.
   */
  std::vector<double> compute_load_shares(const Load &load, const Body &body);

  /**
   * The forces along the tangents of their circles with which nodes exert a unit torque about the
   * body's axis [1/mm]: A_i/sum A_j r_j, r the distance from the axis in the undeformed body. A
   * node on the axis has no tangent and takes nothing. Throws InputError where all lie on it or
   * carry no area.
   */
  std::vector<double> compute_torque_shares(const Torque &torque, const Body &body);

  /** A face of a body on its boundary. */
  struct BoundaryFace
  {
    unsigned int                element; ///< of the body
    unsigned int                number;  ///< of the element's six: 2 * direction + side
    std::array<unsigned int, 4> nodes;   ///< of the body, seen from outside counter-clockwise
  };

  /** The faces on the body's boundary whose nodes all are among @p nodes. */
  std::vector<BoundaryFace> find_boundary_faces(const Body                      &body,
                                                const std::vector<unsigned int> &nodes);

  /** Vector area of the bilinear face through four places in turn [mm^2]. */
  Vector3
  compute_vector_area(const Vector3 &a, const Vector3 &b, const Vector3 &c, const Vector3 &d);

  /**
   * A moment M, fixed in space, as a traction on a set of nodes that turns with the set:
   * f_i = A_i w x (R r_i), r_i from the set's centre to node i in the undeformed body, R the mean
   * rotation of the set (the polar factor of sum A x r^T), J w = M with J = tr(S) I - S and
   * S = sum A x (R r)^T. The forces sum to zero, their moments to M, and their power is M times the
   * rate of R, so that the deformation of the set within itself gains nothing (doc/model.md).
   */
  class MomentTraction
  {
  public:
    /** Shares A and undeformed places [mm] of the whole set. Throws InputError, naming the load,
     * for nodes on a line. */
    MomentTraction(std::vector<double>         shares,
                   const std::vector<Vector3> &places,
                   const std::string          &load);

    /** Rotation R and turn w of the set. */
    struct Motion
    {
      Matrix3 rotation;
      Vector3 turn;
    };

    /** Adds node @p i at its present place [mm] to @p sums: sum A x r^T. Sums of ranks add up. */
    void add(std::size_t i, const Vector3 &place, std::vector<double> &sums) const;

    /** Zero sums. */
    static std::vector<double> make_sums()
    {
      return std::vector<double>(9, 0.);
    }

    /** Of the present places whose @p sums these are, for @p moment [N mm]. Throws NumericalError,
     * naming the load, where the set has shrunk to a line. */
    Motion solve(const Vector3 &moment, const std::vector<double> &sums) const;

    /** Of the undeformed places. */
    Motion solve(const Vector3 &moment) const;

    /** Force on node @p i [N]. */
    Vector3 force(std::size_t i, const Motion &motion) const;

  private:
    std::vector<double>  shares_;
    std::vector<Vector3> arms_;
    std::string          load_;
  };
} // namespace vfife

#endif
