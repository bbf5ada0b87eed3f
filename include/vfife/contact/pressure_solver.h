// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_contact_pressure_solver_h
#define vfife_contact_pressure_solver_h

#include <vfife/contact/law/surface_interaction.h>
#include <vfife/contact/touching_point.h>

#include <vector>

namespace vfife
{
  /**
   * Mean pressures of touching points over a step of central differences, from t_n - dt/2 to
   * t_n + dt/2 (doc/theory/contact.md, In time). The pressure of a point is the difference of the
   * law's energy between the gaps at both ends over the difference of these gaps, and the gap at
   * the end is what all pressures make of it: the contact's energy is kept whatever the penalty and
   * the step. Solved by sweeps over the points, each with Newton's step of its own law.
   */
  class PressureSolver
  {
  public:
    /** Of a node of the surfaces. */
    struct Node
    {
      Vector3 old_velocity;  ///< at t_n - dt/2 [mm/s]
      Vector3 free_velocity; ///< at t_n + dt/2 without contact [mm/s]
      Matrix3 inverse_mass;  ///< [1/t]; zero along directions that are held
    };

    /** @p nodes by the numbers that the points to come name. */
    PressureSolver(double dt, std::vector<Node> nodes);

    /** Begins anew with other nodes and no point. */
    void reset(double dt, const std::vector<Node> &nodes);

    /** Adds a point, which names @p slave_nodes and @p master_nodes here, of a contact with the
     * law, penalty and damping of the @p interaction where it is stiffest. */
    void add(const TouchingPoint               &point,
             const std::array<unsigned int, 4> &slave_nodes,
             const std::array<unsigned int, 4> &master_nodes,
             const SurfaceInteraction          &interaction);

    /**
     * Fills in gap rate, pressures and energy of the points, in the order in which they were added,
     * their pressure being the first guess. The energy is that of the ledger at t_n, which goes
     * with the product of the velocities before and after. Throws NumericalError where it does not
     * converge.
     */
    void solve(std::vector<TouchingPoint> &points);

    /** Sweeps of the last solve(). */
    unsigned int n_sweeps() const
    {
      return n_sweeps_;
    }

  private:
    struct Row
    {
      const ContactLaw           *law;
      double                      penalty, damping;
      std::array<unsigned int, 8> nodes;
      std::array<Vector3, 8>      slopes;    ///< of the gap
      std::array<Vector3, 8>      responses; ///< of the velocities to a unit force on the gap
      double                      area, gap;
      double                      before   = 0.; ///< penetration at t_n - dt/2 [mm]
      double                      give     = 0.; ///< of the end's gap to a pressure [mm/MPa]
      double                      pressure = 0.;
      double                      elastic = 0., slope = 0., after = 0.; ///< of the last sweep
    };

    double end_penetration(const Row &row) const;
    void   push(const Row &row, double pressure);
    void   evaluate_law();

    double                    dt_;
    std::vector<Node>         nodes_;
    std::vector<Row>          rows_;
    std::vector<PressedPoint> pressed_;
    unsigned int              n_sweeps_ = 0;
  };
} // namespace vfife

#endif
