// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_rim_writer_h
#define vfife_output_observers_rim_writer_h

#include <vfife/base/types.h>
#include <vfife/output/observers/sampled_table.h>

#include <functional>
#include <memory>
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

    /** A node of the rim that this rank owns: a copy of a node of the first sector. */
    struct Node
    {
      std::uint32_t local; ///< of the partition
      std::uint32_t place; ///< of places_
      std::uint32_t sector;
    };

    /** A node of the first sector, in the body frame. */
    struct Place
    {
      Vector3 at_rest; ///< undeformed, from the axis [mm]
      Matrix3 weights; ///< share of the rim's mass times the directions r, theta, z (rows)
      double  angle;   ///< of r, from x [rad]
    };

    void     find_nodes(const Model &model, const Partition &partition);
    RimWaves measure_positions(const Model &model, const State &state);

    const OutputFolder &folder_;
    Measure             measure_;
    unsigned int        n_diameters_; ///< largest number of nodal diameters

    // Of the partition of the states that are measured.
    std::shared_ptr<const Partition> partition_;
    unsigned int                     n_sectors_ = 1;
    std::vector<Node>                nodes_;
    std::vector<Place>               places_;
    std::vector<Matrix3>             turns_back_;      ///< of each sector onto the first
    std::vector<unsigned int>        columns_;         ///< of each sector below
    Eigen::MatrixXd                  cosines_;         ///< of n times the sector's angle
    Eigen::MatrixXd                  sines_;           ///< rows: columns, columns: n
    Eigen::MatrixXd                  even_, odd_;      ///< sums, differences of two sectors [mm]
    Eigen::MatrixXd                  as_cos_, as_sin_; ///< their waves [mm]
  };
} // namespace vfife

#endif
