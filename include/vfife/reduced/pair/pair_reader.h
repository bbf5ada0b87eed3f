// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_pair_pair_reader_h
#define vfife_reduced_pair_pair_reader_h

#include <vfife/bearing/mean_motion.h>
#include <vfife/reduced/pair/pair_rows.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  struct Probe;

  /** Reads the bodies of a ReducedPair as they are now. */
  class PairReader
  {
  public:
    /** All must outlive the object; @p now: forces at the rows. */
    PairReader(const Model        &model,
               const PairMembers  &members,
               const PressedPair  &pair,
               const PairRows     &rows,
               const PressedState &now)
      : model_(model)
      , members_(members)
      , pair_(pair)
      , rows_(rows)
      , now_(now)
    {
    }

    /** The value of a reading (its place among those of the body) on a sector, spin included. */
    using Reading = std::function<double(unsigned int reading, unsigned int sector)>;

    /** Of body @p b as it is at this call; the pair must outlive the function. */
    Reading reading_of(unsigned int b) const;

    /** What @p probes show, which are the model's or copies of them in other sectors. */
    std::vector<ProbeValue> read_probes(const std::vector<Probe> &probes) const;

    /** Coefficients of the rim's waves [um] up to @p largest diameters, as RimWaves has them. */
    std::vector<double> read_rim(unsigned int largest) const;

    /** What the contact does to the modes of a body, in the order of ReducedBody::harmonics. */
    std::vector<Eigen::VectorXcd> read_modal_forces(unsigned int body) const;

    /** Turn of a body's momentum about its axis beyond the kinematic one [rad]. */
    double read_turn(unsigned int body) const;

    /** The mean motion of a ring (its name) of a body in bearings, without rates. */
    MeanMotion::Motion read_ring(unsigned int body, const std::string &name) const;

    /** Where flank nodes of a body are (3 each), fixed frame [mm]. */
    std::vector<double> read_places(unsigned int b, const std::vector<unsigned int> &nodes) const;

  private:
    const Model        &model_;
    const PairMembers  &members_;
    const PressedPair  &pair_;
    const PairRows     &rows_;
    const PressedState &now_;
  };
} // namespace vfife

#endif
