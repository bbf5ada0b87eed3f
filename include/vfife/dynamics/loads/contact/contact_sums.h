// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_loads_contact_contact_sums_h
#define vfife_dynamics_loads_contact_contact_sums_h

#include <vfife/dynamics/loads/contact/contact_nodes.h>

#include <array>
#include <vector>

namespace vfife
{
  class Communicator;

  /** What the contact of all pairs adds up to in an evaluation. Numbers are those of this rank
   * until they have been summed over the ranks, by sum() or by who asked for them with append(). */
  class ContactSums
  {
  public:
    /** Takes those of this rank from the results of the @p pairs; @p fails: the rank has none. */
    void set(const ContactPairs &pairs, bool fails);

    /** Takes the forces of the tooth pairs of a gear pair, and the torque, of this rank. */
    void set_teeth(const Model &model, const ContactPairs &pairs);

    /** Over the ranks, without those of set_teeth(). Collective. */
    void sum(const Communicator &communicator);

    /** Appends all numbers, to be summed in place. */
    void append(std::vector<double *> &numbers);

    /** Whether anything pressed. */
    bool is_pressed() const
    {
      return sums_[of_pressure] > 0;
    }
    /** Energy stored in the contact springs [mJ]. That of a step that is integrated implicitly may
     * be negative where a point comes or goes. */
    double energy() const
    {
      return sums_[of_energy];
    }
    /** Power lost in contact damping [mW = mJ/s]. */
    double lost_power() const
    {
      return sums_[of_lost_power];
    }
    /** Lost in friction since the evaluation before [mJ]. */
    double friction_loss() const
    {
      return sums_[of_friction_loss];
    }
    /** Whether a penetration is beyond its pair's penetration limit. */
    bool is_too_deep() const
    {
      return sums_[of_depth] > 0;
    }
    /** Whether the evaluation has failed on some rank. */
    bool fails() const
    {
      return sums_[of_failure] > 0;
    }
    /** At the last set_teeth(): sum of the magnitudes of the tooth pairs' forces [N], and torque on
     * the driven member [N mm]. */
    double tooth_force() const;
    double torque() const;

  private:
    enum Sum : std::size_t
    {
      of_energy,
      of_lost_power,
      of_depth, ///< ranks with a penetration that is too deep
      of_friction_loss,
      of_pressure, ///< its integral [N]
      of_failure,  ///< ranks that failed
      n_sums
    };

    std::array<double, n_sums> sums_ = {};
    /** Of a gear pair: torque on the driven member, then the force of each candidate pair of teeth.
     */
    std::vector<double> teeth_;
  };
} // namespace vfife

#endif
