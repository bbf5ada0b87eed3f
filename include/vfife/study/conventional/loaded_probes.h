// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_probes_h
#define vfife_study_conventional_loaded_probes_h

#include <vfife/base/text/table.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  /**
   * Stresses of the probes of a turning gear pair from static positions over one mesh cycle. After
   * m mesh cycles a probe is where its copy m sectors farther on was at the start, so the copies'
   * stresses at the position p are the probe's at the time m + p: its whole passage through a turn.
   */
  class LoadedProbes
  {
  public:
    /** Throws InputError as list_copies(). */
    explicit LoadedProbes(const Model &model);

    /** Stresses of the model's nodes (fixed frame at time zero) at a position [mesh cycles]. */
    void add_position(double position, const std::vector<Stress> &stresses);

    /** A row a probe and place [mesh cycles after it has passed the mean contact], of a whole
     * turn: von Mises, stresses in r, theta, z of the body. */
    const Table &table() const
    {
      return table_;
    }

    /** Where the largest von Mises stress of a probe is, a row of table(). */
    std::size_t find_largest(const std::string &probe) const;

  private:
    const Model                    &model_;
    std::vector<ProbeQuantity>      stresses_;
    std::vector<std::vector<Probe>> copies_; ///< by probe and mesh cycle
    Table                           table_;
  };
} // namespace vfife

#endif
