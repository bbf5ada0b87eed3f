// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/reduced/reduced_body.h>

#include <algorithm>
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
      const ReducedBody::Rings &rings       = body.rings;
      const Eigen::Index        n_of_rings  = 6 * rings.size();
      const Eigen::Index        of_bearings = 6 * rings.n_bearings;
      fits = fits && rings.centres.size() == rings.size() && rings.n_bearings <= rings.size() &&
             is(rings.stiffness, of_bearings, of_bearings) &&
             is(rings.residual, n_of_rings, n_of_rings) && rings.spin.size() == n_of_rings &&
             rings.torque.size() == n_of_rings && rings.euler.size() == n_of_rings;
      for (const Eigen::MatrixXcd &answers : rings.answers)
        fits = fits && is(answers, n_of_rings > 0 ? n_rows : 0, n_of_rings);
      for (const ReducedBody::Harmonic &harmonic : body.harmonics)
        {
          const Eigen::Index n     = harmonic.n_modes();
          const Eigen::Index alike = harmonic.number == 0 ? n : 0;
          fits = fits && harmonic.number <= body.n_sectors / 2 && is(harmonic.shapes, n_rows, n) &&
                 (n == 0 || (is(harmonic.coriolis, n, n) && is(harmonic.spin_stiffness, n, n))) &&
                 harmonic.torque.size() == alike && harmonic.euler.size() == alike &&
                 is(harmonic.rings,
                    harmonic.number < 2 ? n_of_rings : 0,
                    harmonic.number < 2 && n_of_rings > 0 ? n : 0);
          if (harmonic.number == 0 && body.turns)
            fits = fits && body.turn_coriolis.size() == n;
        }
      return fits;
    }
  } // namespace

  unsigned int ReducedBody::Rings::find(const std::string &name) const
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw std::logic_error("a reduced body has no ring \"" + name + "\"");
    return found - names.begin();
  }

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
    pass_matrix(harmonic.rings, stream);
  }

  namespace
  {
    void serialize(ReducedBody::Rings &rings, ByteStream &stream)
    {
      stream.pass(rings.names, rings.centres, rings.n_bearings);
      pass_matrix(rings.stiffness, stream);
      Eigen::MatrixXd inertia = rings.inertia;
      pass_matrix(inertia, stream);
      stream.require(inertia.rows() == 6 && inertia.cols() == 6, "the inertia is not valid");
      rings.inertia = inertia;
      for (Eigen::MatrixXcd &answers : rings.answers)
        pass_matrix(answers, stream);
      pass_matrix(rings.residual, stream);
      for (Eigen::VectorXd *const vector : {&rings.spin, &rings.torque, &rings.euler})
        pass_matrix(*vector, stream);
    }
  } // namespace

  void serialize(ReducedBody &body, ByteStream &stream)
  {
    stream.pass(body.n_sectors,
                body.nodes_per_sector,
                body.sector_angle,
                body.rate,
                body.cutoff,
                body.touch_nodes);
    pass_all(body.readings, stream, [&](SectorReading &reading) {
      stream.pass(reading.name, reading.weights);
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
    serialize(body.rings, stream);
    stream.require(has_consistent_sizes(body), "the parts of a reduced body do not match");
  }
} // namespace vfife
