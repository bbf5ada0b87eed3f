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

  /** One of the two bodies. */
  struct ReducedPair::Member
  {
    ReducedBody  body;
    double       rate;            ///< about Body::axis [rad/s]
    double       sense;           ///< of Body::axis about the axis of its sectors
    double       sector_rate = 0; ///< about the axis of its sectors [rad/s]
    double       spin        = 0; ///< what the state of spin is multiplied by
    AxialLoad    axial;           ///< about Body::axis; acceleration: of its rate
    double       inertia;         ///< about Body::axis [t mm^2]
    ModalMotion  motion;
    TouchRows    rows;
    double       gain_rate = 0; ///< at which the modes' part of the flexibility was found [rad/s]
    Eigen::Index first     = 0; ///< of its rows

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
  };

  /** Both bodies' answers at the rows, the first body's in front. */
  class ReducedPair::Answers : public PressedBodies
  {
  public:
    /** The objects must outlive this one. */
    explicit Answers(std::vector<const TouchRows *> rows)
      : rows_(std::move(rows))
    {
    }

    Eigen::VectorXd answer(const Eigen::VectorXd &force) override;
    Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows) override;

  private:
    std::vector<const TouchRows *> rows_;
  };
} // namespace vfife

#endif
