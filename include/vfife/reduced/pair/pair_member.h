// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_member_h
#define vfife_reduced_pair_pair_member_h

#include <vfife/reduced/modal_motion.h>
#include <vfife/reduced/reduced_body.h>
#include <vfife/reduced/touch_rows.h>

#include <memory>
#include <utility>
#include <vector>

namespace vfife
{
  struct Coupling;
  struct Model;

  /** One of the two bodies of a ReducedPair. */
  struct PairMember
  {
    ReducedBody body;
    double      rate;            ///< about Body::axis [rad/s]
    double      sense;           ///< of Body::axis about the axis of its sectors
    double      sector_rate = 0; ///< about the axis of its sectors [rad/s]
    double      spin        = 0; ///< what the state of spin is multiplied by
    AxialLoad   axial;           ///< about Body::axis; acceleration: of its rate
    double      inertia;         ///< about Body::axis [t mm^2]
    ModalMotion motion;
    TouchRows   rows;
    double      gain_rate = 0; ///< at which the modes' part of the flexibility was found [rad/s]
    std::vector<Eigen::Index> places; ///< of its rows among those of both

    /** In steps of @p step [s]. */
    PairMember(const Model        &model,
               unsigned int        b,
               ReducedBody       &&reduced,
               const ModalDamping &damping,
               double              step);

    void set_rate(double new_rate);
    /** Takes the modes along to the rate, in steps of @p step [s], where they are far from it. */
    void follow_rate(double step);
    /** The flexibility becomes that of the modes' present steps. */
    void set_gains();
    /** Passes rates, load and motion in steps of @p step [s]. */
    void serialize(double step, ByteStream &stream);
    /** What @p load does to modes and turn, contact left out. */
    ModalForces forces_of(const AxialLoad &load) const;
    /** Coordinates of its modes now. */
    std::vector<Eigen::VectorXcd> coordinates() const;
    /** Those under @p load alone where they stand still in space. */
    std::vector<Eigen::VectorXcd> standing_coordinates(const AxialLoad &load) const;
    /** Of forces that stand still in space. */
    std::vector<Eigen::MatrixXcd> standing_gains() const;
    /** Its part of a vector @p x over the rows of both bodies. */
    Eigen::VectorXd part_of(const Eigen::VectorXd &x) const;
    /** Mean rotation of bore or rim (pair_readings.h) about the axis beyond the kinematic turn,
     * under @p forces at its rows [rad]. */
    double read_turn(const char *reading, const Eigen::VectorXd &forces) const;
    /** What the modes beside the turn add to the rate about Body::axis [rad/s]. */
    double modal_rate() const;
    /** The same of the mean turn of a ring. */
    double modal_rate_of(unsigned int ring) const;
    /** Twist of the seat of a coupling about Body::axis [rad], and its rate. */
    std::pair<double, double> twist(const Coupling &coupling, const Eigen::VectorXd &forces) const;
    bool                      in_bearings() const
    {
      return body.rings.size() > 0;
    }

  private:
    Vector3 axis_; ///< Body::axis, in the axes of the body frame
  };

  /** In the model's order of the bodies. */
  using PairMembers = std::vector<std::unique_ptr<PairMember>>;
} // namespace vfife

#endif
