// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_compare_pair_probe_passages_h
#define vfife_study_compare_pair_probe_passages_h

#include <vfife/base/text/table.h>

#include <functional>
#include <string>
#include <vector>

namespace vfife
{
  /** The von Mises stress of a probe of a run beside that of static positions, at the instants of
   * the latter. */
  struct ProbePassage
  {
    std::string  probe;
    unsigned int instants       = 0;
    double       peak           = 0; ///< of the run [MPa]
    double       reference_peak = 0; ///< of the static positions [MPa]
    double       distance       = 0; ///< largest difference of both [MPa]
  };

  /** Time [s] at which a probe of that name passes the mesh; NaN where it is not known. */
  using PassageTime = std::function<double(const std::string &)>;

  /**
   * For each probe of @p probes (rows of probes.csv) that @p loaded (rows of loaded_probes.csv)
   * knows, over its instants from @p start [s] on; linear between samples. Probes without such
   * instants are left out.
   */
  std::vector<ProbePassage> compare_passages(const Table       &probes,
                                             const Table       &loaded,
                                             const PassageTime &passes_mesh,
                                             double             mesh_frequency,
                                             double             start);
} // namespace vfife

#endif
