// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/reduced/reduced_body.h>

#include <cstdlib>
#include <stdexcept>

namespace vfife
{
  namespace
  {
    /** Passes objects with their number. */
    template <typename Object, typename Pass>
    void pass_all(std::vector<Object> &objects, ByteStream &stream, const Pass &pass)
    {
      // Each has a byte at least: no number that a damaged file states takes more memory than it.
      std::vector<char> places(objects.size());
      stream.pass(places);
      objects.resize(places.size());
      for (Object &object : objects)
        pass(object);
    }

    /** Sizes on which those who use a body rely. */
    bool has_consistent_sizes(const ReducedBody &body)
    {
      const Eigen::Index n_rows = body.n_rows(), n_columns = 3 * body.touch_nodes.size();
      const auto         is = [](const auto &matrix, const Eigen::Index n, const Eigen::Index m) {
        return matrix.rows() == n && matrix.cols() == m;
      };
      bool fits = body.n_sectors > 1 && body.reach <= body.n_sectors / 2 &&
                  body.residual.size() == 2 * body.reach + 1 && body.spin.size() == n_rows &&
                  body.torque_residual.size() == n_rows && body.euler_residual.size() == n_rows &&
                  is(body.summed_residual, body.readings.size(), n_columns);
      for (const Eigen::MatrixXd &residual : body.residual)
        fits = fits && is(residual, n_rows, n_columns);
      for (const unsigned int node : body.touch_nodes)
        fits = fits && node < body.nodes_per_sector;
      for (const ReducedBody::Harmonic &harmonic : body.harmonics)
        {
          const Eigen::Index n     = harmonic.n_modes();
          const Eigen::Index alike = harmonic.number == 0 ? n : 0;
          fits = fits && harmonic.number <= body.n_sectors / 2 && is(harmonic.shapes, n_rows, n) &&
                 (n == 0 || (is(harmonic.coriolis, n, n) && is(harmonic.spin_stiffness, n, n))) &&
                 harmonic.torque.size() == alike && harmonic.euler.size() == alike;
          if (harmonic.number == 0 && body.turns)
            fits = fits && body.turn_coriolis.size() == n;
        }
      return fits;
    }
  } // namespace

  Eigen::VectorXcd ReducedBody::Harmonic::forces_of(const AxialLoad &load) const
  {
    if (number > 0)
      return Eigen::VectorXcd::Zero(n_modes());
    return load.torque * torque + load.acceleration * euler;
  }

  unsigned int ReducedBody::n_modes() const
  {
    unsigned int n = 0;
    for (const Harmonic &harmonic : harmonics)
      n += harmonic.n_modes();
    return n;
  }

  unsigned int ReducedBody::find_reading(const std::string &name) const
  {
    for (unsigned int i = 0; i < readings.size(); ++i)
      if (readings[i].name == name)
        return i;
    throw std::logic_error("a reduced body has no reading \"" + name + "\"");
  }

  const Eigen::MatrixXd *ReducedBody::find_residual(const int distance) const
  {
    const int n = n_sectors;
    if (static_cast<unsigned int>(std::abs(distance)) > reach)
      return nullptr;
    // Half a turn away lies one sector in both senses.
    return &residual[2 * distance == -n ? 2 * reach : distance + reach];
  }

  void serialize(ReducedBody::Harmonic &harmonic, ByteStream &stream)
  {
    stream.pass(harmonic.number);
    pass_matrix(harmonic.eigenvalues, stream);
    pass_matrix(harmonic.coriolis, stream);
    pass_matrix(harmonic.spin_stiffness, stream);
    pass_matrix(harmonic.shapes, stream);
    pass_matrix(harmonic.torque, stream);
    pass_matrix(harmonic.euler, stream);
  }

  void serialize(ReducedBody &body, ByteStream &stream)
  {
    stream.pass(body.n_sectors,
                body.nodes_per_sector,
                body.sector_angle,
                body.rate,
                body.cutoff,
                body.touch_nodes);
    pass_all(body.readings, stream, [&](SectorReading &reading) {
      bool   has_offset = reading.offset.has_value();
      double offset     = reading.offset.value_or(0.);
      stream.pass(reading.name, reading.weights, has_offset, offset);
      if (has_offset)
        reading.offset = offset;
    });
    pass_all(body.harmonics, stream, [&](ReducedBody::Harmonic &harmonic) {
      serialize(harmonic, stream);
    });
    stream.pass(body.reach);
    pass_all(body.residual, stream, [&](Eigen::MatrixXd &matrix) { pass_matrix(matrix, stream); });
    pass_matrix(body.summed_residual, stream);
    pass_matrix(body.torque_residual, stream);
    pass_matrix(body.euler_residual, stream);
    pass_matrix(body.spin, stream);
    pass_matrix(body.turn_coriolis, stream);
    stream.pass(body.residual_left,
                body.turns,
                body.turn_inertia,
                body.n_unknowns,
                body.counted,
                body.memory);
    stream.require(has_consistent_sizes(body), "a reduced body whose parts do not fit each other");
  }
} // namespace vfife
