// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_instant_pressure_h
#define vfife_fem_pressure_instant_pressure_h

#include <vfife/fem/fem_options.h>
#include <vfife/fem/pressure/flank_pair.h>

#include <array>
#include <memory>
#include <vector>

namespace vfife
{
  class Communicator;

  /** The surfaces of a gear pair's first contact pair at an instant of its motion, slave and
   * master; places and forces of teeth that are not asked for may be zero. */
  struct FlankState
  {
    std::array<std::vector<double>, 2> positions; ///< of surface nodes, 3 each, fixed frame [mm]
    std::array<std::vector<double>, 2> forces;    ///< of the contact on them [N]
    std::array<RigidMotion, 2>         motions;   ///< mean, body frame to fixed frame
  };

  /**
   * Pressures of teeth of a moving gear pair that neither its mesh nor its penalty makes. The force
   * of each tooth pair is that of the motion: only what of it lies where is found anew, with the
   * other teeth as they are (doc/theory/pressure-grid.md, At instants of a run). The flexibility of
   * the teeth is that of tooth 0 of each member in the state of spin at time zero.
   */
  class InstantPressure
  {
  public:
    /** Factorizes the bodies and forgets the factors. @p options: of elements that are those of the
     * motion; @p depth of the layers, at least [mm]; @p cells_across the width of a contact. The
     * model must outlive the object. Collective. Throws as Compliance, and InputError for bodies
     * with one element across a tooth. */
    InstantPressure(const Model        &model,
                    const FemOptions   &options,
                    double              depth,
                    unsigned int        cells_across,
                    const Communicator &communicator);

    /** Throws the InputError of the constructor, without its factors. */
    static void check(const Model &model, const FemOptions &options, double depth);

    /** From now on teeth are in this state. */
    void place(const FlankState &state);

    /** Of two teeth that press each other in the state. Its force is that of the state, along the
     * resultant, or, where the contact rubs, the @p normal_force [N]; its closing: by how much they
     * come nearer to each other than the penalty has let them [mm]. Throws NumericalError where no
     * pressures are found. */
    ToothPressure solve(unsigned int slave_group, unsigned int master_group, double normal_force);

  private:
    bool rubs() const;
    /** By surface node, of the contact; where it rubs, their parts along the normals [N]. */
    std::vector<Vector3> find_forces(unsigned int side, unsigned int group);
    ContactLoad          make_load(const std::array<unsigned int, 2> &groups,
                                   const std::array<ElasticFlank, 2> &flanks,
                                   double                             normal_force);

    unsigned int                       cells_across_;
    FemSpace                           space_;
    FlankPair                          flanks_;
    double                             depth_limit_; ///< deepest penetration taken for contact [mm]
    std::unique_ptr<const PointPlaces> places_;      ///< of points of tooth 0
    Eigen::MatrixXd                    flexibility_; ///< of tooth 0 of both members [mm/N]
    std::array<std::vector<double>, 2> forces_;      ///< of the state
  };
} // namespace vfife

#endif
