// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_submodel_sector_submodel_h
#define vfife_fem_submodel_sector_submodel_h

#include <vfife/fem/submodel/submodel_part.h>
#include <vfife/fem/system/fem_space.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * A fine mesh of a part of a gear body that follows the body with a coarser mesh: a submodel.
   * Where the part is cut from the rest of the body, it has the displacements of the body; the
   * forces on its flanks act on the fine mesh. Stresses at fillets then have the error of the fine
   * mesh (doc/theory/stress.md, Submodel). What is read of sector 0, the middle one, is linear in
   * displacements of the body's nodes and in forces, so it is solved for once; other sectors are
   * turned copies.
   */
  class SectorSubmodel
  {
  public:
    /**
     * @p sector: FemSpace::sector_of() the fine body, of which the elements of the part are taken;
     * @p followed: the body with the coarser mesh, in the same axes, with as many sectors; @p
     * readings of points of the sector, in axes of the body.
     * Throws InputError where the bodies do not go together.
     */
    SectorSubmodel(SubmodelPart                     part,
                   const FemSpace                  &sector,
                   const Body                      &followed,
                   const std::vector<PointReading> &readings);

    /** Forces on the teeth, each in the axes of tooth 0: those of its copies turned back. */
    using ToothForces = std::map<unsigned int, Eigen::VectorXd>;

    /** Adds a force [N] at a place [mm] on or near the flank (surface "concave" or "convex") of a
     * tooth, in the axes of the body. */
    void add_force(const std::string &surface,
                   unsigned int       tooth,
                   const Vector3     &place,
                   const Vector3     &force,
                   ToothForces       &forces) const;

    /** Adds a force [N] on a node of the followed body's flanks, in the axes of the body: a
     * traction around it with the node's moments (NodeAverages). Nothing for other nodes. */
    void add_nodal_force(unsigned int node, const Vector3 &force, ToothForces &forces) const;

    /** Nodes of the followed body on the flanks of all teeth, tooth by tooth. */
    std::vector<unsigned int> list_flank_nodes() const;

    /** Of a node of the followed body, in its axes [mm]. */
    using NodeDisplacement = std::function<Vector3(unsigned int node)>;

    /** What displacements of the followed body make of the readings of a tooth. */
    Eigen::VectorXd follow(unsigned int tooth, const NodeDisplacement &u) const;
    /** What forces, a spin at @p rate [rad/s] and initial strains make of them. A part without
     * flanks does not see forces on flanks. */
    Eigen::VectorXd load(unsigned int tooth, const ToothForces &forces, double rate) const;

    /** Nodes of the followed body by which the readings of tooth 0 move, and by how much: a column
     * per component of each. */
    const std::vector<unsigned int> &followed_nodes() const
    {
      return nodes_;
    }
    const Eigen::MatrixXd &of_displacements() const
    {
      return of_displacements_;
    }

    unsigned int n_unknowns() const
    {
      return n_unknowns_;
    }

  private:
    /** A face of the fine mesh on a flank of tooth 0. */
    struct FlankFace
    {
      std::array<Vector3, 4>    corners; ///< in cyclic order [mm]
      std::vector<unsigned int> points;  ///< places among those of the flanks
    };
    /** Shape functions of the points of the face below or above a place. */
    using FacePlace = std::pair<const FlankFace *, Eigen::VectorXd>;

    void             find_flanks(const FemSpace &sector);
    FacePlace        find_on_flank(const std::string &surface, const Vector3 &place) const;
    void             find_node_shares();
    Eigen::VectorXd &forces_of(unsigned int tooth, ToothForces &forces) const;

    const Body                                   *followed_;
    unsigned int                                  n_unknowns_ = 0;
    std::map<std::string, std::vector<FlankFace>> flanks_;       ///< by surface
    std::vector<unsigned int>                     flank_points_; ///< of the sector
    /** By node of the followed body's tooth 0: weights of flank_points_. */
    std::map<unsigned int, PointWeights> node_shares_;
    std::vector<unsigned int>            nodes_;
    Eigen::MatrixXd                      of_displacements_;
    /** On the teeth before, here and after; none of a part without flanks. */
    std::vector<Eigen::MatrixXd> of_forces_;
    Eigen::VectorXd              of_spin_;            ///< at 1 rad/s
    std::vector<Eigen::VectorXd> of_initial_strains_; ///< by tooth; empty: none
  };
} // namespace vfife

#endif
