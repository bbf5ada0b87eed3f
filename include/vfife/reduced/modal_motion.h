// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_modal_motion_h
#define vfife_reduced_modal_motion_h

#include <vfife/base/types.h>

#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct ReducedBody;

  /** Damping proportional to mass [1/s]: of deformation relative to the turning body, of rigid
   * motions that supports oppose relative to the ground. */
  struct ModalDamping
  {
    double modes = 0; ///< c'' + modes c'
    double turn  = 0; ///< theta'' + turn theta', of the rigid turn
    /** Hermitian matrices on c' beside that, in the order of ReducedBody::harmonics; those behind
     * the last one are zero. */
    std::vector<Eigen::MatrixXcd> more = {};
    /** What makes velocities of rigid motions in the turning axes those of the ground, c'' + rate
     * circulation c, in the same order. */
    std::vector<Eigen::MatrixXcd> circulation = {};
  };

  /** Modal forces: of each harmonic of a ReducedBody, and about the axis. */
  struct ModalForces
  {
    std::vector<Eigen::VectorXcd> modes;      ///< in the order of ReducedBody::harmonics
    double                        moment = 0; ///< [N mm]

    void add(double factor, const ModalForces &other);
  };

  /**
   * Motion of the modes of a ReducedBody at one rate, and of its rigid turn where it has one, step
   * by step: the exact solution for forces that are constant in each step (doc/theory/reduced.md,
   * Steps). The forces of a step are the mean of those at its two ends, which conserves energy
   * whatever the step is.
   */
  class ModalMotion
  {
  public:
    /** At the @p rate [rad/s], which may differ from the body's, and the @p step [s]. Throws
     * NumericalError where the body is not stable at that rate. */
    ModalMotion(const ReducedBody &body, double rate, const ModalDamping &damping, double step);

    /** Goes on at another rate and step from the motion as it is. Throws as the constructor. */
    void change(double rate, double step);

    /** The present one [rad/s]. */
    double rate() const
    {
      return rate_;
    }

    /** No forces. */
    ModalForces no_forces() const;

    /** Coordinates c of the harmonic in place @p i at the end of the step that begins now, were
     * the mean force of the step @p forces. */
    Eigen::VectorXcd expect(std::size_t i, const ModalForces &forces) const;
    /** The same of the rigid turn [rad]. */
    double expect_turn(const ModalForces &forces) const;

    /** Change of the coordinates with the force at the end of the step, of which the mean has one
     * half. */
    const Eigen::MatrixXcd &gain(const std::size_t i) const
    {
      return harmonics_[i].gain;
    }
    /** Change of the coordinates with forces that stand still in space while the body turns below
     * them at @p sector_rate about the axis of its sectors [rad/s]; with those that go with it
     * where the waves of such forces run faster than the body's own. */
    Eigen::MatrixXcd standing_flexibility(std::size_t i, double sector_rate) const;
    /** Of the turn with the moment [1/(N mm)]. */
    double turn_gain() const
    {
      return turn_gain_;
    }

    /** Steps with the mean forces of the step. */
    void advance(const ModalForces &forces);

    /** The coordinates under @p forces that stand still in space, as standing_flexibility(); the
     * turn is set to @p turn, at rest. */
    void stand(const ModalForces &forces, double turn, double sector_rate);

    /** [rad/s] */
    void add_turn_rate(const double rate)
    {
      turn_rate_ += rate;
    }

    const Eigen::VectorXcd &coordinates(const std::size_t i) const
    {
      return harmonics_[i].position;
    }
    const Eigen::VectorXcd &velocities(const std::size_t i) const
    {
      return harmonics_[i].velocity;
    }
    double turn() const
    {
      return turn_;
    }
    double turn_rate() const
    {
      return turn_rate_; ///< [rad/s]
    }

    /** |c'|^2/2 of all modes, without the turn [mJ]. */
    double kinetic() const;
    /** c^H K c/2 of all modes, K with the spin [mJ]. */
    double strain() const;
    /** Loss by damping of the modes and of the turn now [mJ/s]. */
    std::pair<double, double> losses() const;
    /** By how much breathing changes the moment of inertia of a body with a turn [t mm^2]. */
    double added_inertia() const;

    void serialize(ByteStream &stream);

  private:
    struct Harmonic
    {
      Eigen::MatrixXcd stiffness;          ///< at this rate [1/s^2]
      Eigen::MatrixXcd damping;            ///< ModalDamping::more, or empty
      Eigen::MatrixXcd circulation;        ///< ModalDamping::circulation, or empty
      Eigen::MatrixXcd propagator, forced; ///< of (c, c') in one step; rows of a turn are the last
      Eigen::MatrixXcd gain;               ///< half of what a force does to c
      Eigen::VectorXcd position, velocity;
    };

    /** Whether the turn is the last coordinate of the harmonic in place @p i. */
    bool has_turn(std::size_t i) const;
    /** Forces on the coordinates of a harmonic, and (c, c') at the end of the step. */
    Eigen::VectorXcd force_of(std::size_t i, const ModalForces &forces) const;
    Eigen::VectorXcd end_of_step(std::size_t i, const ModalForces &forces) const;
    void find_propagator(Harmonic &harmonic, const Eigen::MatrixXcd &coupling, double step) const;

    const ReducedBody    &body_;
    double                rate_ = 0;
    ModalDamping          damping_;
    std::vector<Harmonic> harmonics_;
    double                turn_scale_ = 0; ///< root of the inertia; 0: no turn
    double                turn_ = 0, turn_rate_ = 0, turn_gain_ = 0;
  };
} // namespace vfife

#endif
