// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_rim_writer_h
#define vfife_output_observers_rim_writer_h

#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/model/observer.h>
#include <vfife/output/files/csv_stream.h>

#include <complex>
#include <cstdint>
#include <vector>

namespace vfife
{
  class OutputFolder;

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
  class RimWriter : public Observer
  {
  public:
    static constexpr unsigned int largest_diameters = 10;

    /** A sample every @p steps_between steps; the model must have a transmission. */
    RimWriter(const OutputFolder &folder, const Model &model, std::uint64_t steps_between);

    bool due(const State &state) const override;
    void observe(const Model &model, const State &state) override;
    void exchange(ByteStream &stream) override;
    void finish(const Model &model, const State &state) override;

    const Table &table() const;

  private:
    struct Node
    {
      unsigned int         number;    ///< of the body
      double               share;     ///< of the rim's mass
      std::complex<double> direction; ///< exp(i alpha)
      Matrix3              axes;      ///< r, theta, z in the body frame (columns)
    };

    const OutputFolder &folder_;
    std::uint64_t       steps_between_;
    unsigned int        n_diameters_; ///< largest number of nodal diameters
    std::vector<Node>   nodes_;
    Table               table_;
    CsvStream           file_;
  };
} // namespace vfife

#endif
