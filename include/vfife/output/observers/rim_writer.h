// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_rim_writer_h
#define vfife_output_observers_rim_writer_h

#include <vfife/base/types.h>
#include <vfife/output/observers/sampled_table.h>

#include <functional>
#include <vector>

namespace vfife
{
  /** Coefficients of the rim's displacement [um] in the order of the columns of RimWriter. */
  using RimWaves = std::vector<double>;

  /**
   * rim.csv: motion of the driven gear's rim by nodal diameters, one line a sample. In the axes
   * that turn with the gear the displacement of the rim along r, theta and z [um] is
   *
   *   u(alpha, t) = c_0 + sum over n of c_n cos(n alpha) + s_n sin(n alpha),
   *
   * alpha the angle of the undeformed node about the gear's axis from x of its body frame; columns
   * "r cos 0", "r cos 1", "r sin 1"... up to `largest_diameters` or half the teeth. Coefficients
   * are means over all nodes of the rim, weighted with their masses: c_n = 2 sum m u cos(n alpha) /
   * sum m. The rim consists of equal sectors, so waves of up to half their number are orthogonal in
   * these sums.
   */
  class RimWriter : public SampledTable<RimWaves>
  {
  public:
    static constexpr unsigned int largest_diameters = 10;

    /** The coefficients up to a number of diameters where they do not follow from positions. */
    using Measure = std::function<RimWaves(unsigned int largest)>;

    /** A sample every @p steps_between steps; the model must have a transmission. Without
     * @p measure the positions of the state are looked at. */
    RimWriter(const OutputFolder &folder,
              const Model        &model,
              std::uint64_t       steps_between,
              Measure             measure = nullptr);

    /** Waves that a model's rim can show. */
    static unsigned int count_diameters(const Model &model);

  private:
    void add_rows(const Model &model, const State &state) override;

    struct Node
    {
      unsigned int number;       ///< of the body
      double       share;        ///< of the rim's mass
      double       cosine, sine; ///< of its angle about the axis
      Matrix3      axes;         ///< r, theta, z at time zero in the fixed frame (columns)
    };

    RimWaves measure_positions(const Model &model, const State &state) const;

    const OutputFolder &folder_;
    Measure             measure_;
    unsigned int        n_diameters_; ///< largest number of nodal diameters
    std::vector<Node>   nodes_;
  };
} // namespace vfife

#endif
