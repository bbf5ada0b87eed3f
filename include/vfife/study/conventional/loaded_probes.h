// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_conventional_loaded_probes_h
#define vfife_study_conventional_loaded_probes_h

#include <vfife/base/text/table.h>
#include <vfife/element/stress.h>
#include <vfife/model/model.h>

#include <vector>

namespace vfife
{
  /**
   * Stresses of the probes of a turning gear pair from static positions over one tooth mesh. After
   * m tooth meshes a probe is where its copy m sectors farther on was at the start, so the copies'
   * stresses at the position p are the probe's at the time m + p: the whole of its passage.
   */
  class LoadedProbes
  {
  public:
    /** Over @p meshes tooth meshes. Throws InputError where the model is no gear pair or the
     * sectors of a body are not rotated copies of each other. */
    LoadedProbes(const Model &model, unsigned int meshes);

    /** Stresses of the model's nodes (fixed frame at time zero) at a position [tooth meshes]. */
    void add_position(double position, const std::vector<Stress> &stresses);

    /** A row a probe and time [tooth meshes]: von Mises, stresses in r, theta, z of the body. */
    const Table &table() const
    {
      return table_;
    }

  private:
    const Model                           &model_;
    std::vector<std::vector<unsigned int>> copies_; ///< node of the body, by probe and tooth mesh
    Table                                  table_;
  };
} // namespace vfife

#endif
