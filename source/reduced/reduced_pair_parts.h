// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduced_pair_parts_h
#define vfife_reduced_reduced_pair_parts_h

#include <vfife/model/model.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/reduced/touch_rows.h>

namespace vfife
{
  /** The model's torque on a body about its axis [N mm]. */
  double torque_on(const Model &model, unsigned int body, double time);

  /** Places of a body's bearings in Model::bearings. */
  std::vector<std::size_t> list_bearings(const Model &model, unsigned int body);

  /** What all bearings do beyond the springs that the reduced bodies have for them. */
  BearingSprings make_bearing_springs(const Model &model, const std::vector<ReducedBody> &bodies);

  /** One of the two bodies. */
  struct ReducedPair::Member
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

    Member(const Model              &model,
           unsigned int              b,
           ReducedBody             &&reduced,
           const ReducedPairOptions &options);

    void set_rate(double new_rate);
    /** Takes the modes along to the rate, in steps of @p step [s], where they are far from it. */
    void follow_rate(double step);
    /** The flexibility becomes that of the modes' present steps. */
    void set_gains();
    /** What @p load does to modes and turn, contact left out. */
    ModalForces forces_of(const AxialLoad &load) const;
    /** Coordinates of its modes now. */
    std::vector<Eigen::VectorXcd> coordinates() const;
    /** Of forces that stand still in space. */
    std::vector<Eigen::MatrixXcd> standing_gains() const;
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

  /** Both bodies' answers at the rows of a pair, nodes in front and seats of bearings behind them,
   * and what bearings do there. */
  class ReducedPair::Answers : public PressedBodies
  {
  public:
    /** @p rows: of the bodies of @p pair. All must outlive the object. */
    Answers(const ReducedPair &pair, std::vector<const TouchRows *> rows)
      : pair_(pair)
      , rows_(std::move(rows))
    {
    }

    Eigen::VectorXd answer(const Eigen::VectorXd &force) override;
    Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows) override;
    void            add_forces(const Eigen::VectorXd &u, PressedForces &sum) const override;
    PressedSprings  find_springs(const Eigen::VectorXd &u, bool turning, bool own) const override;

    BearingSprings::Response evaluate_bearings(const Eigen::VectorXd &u) const;

  private:
    const ReducedPair             &pair_;
    std::vector<const TouchRows *> rows_;
  };
} // namespace vfife

#endif
