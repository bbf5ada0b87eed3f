// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/real_body.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;

  namespace
  {
    /** A coordinate c of a harmonic is real, or two real ones. */
    bool is_real(const ReducedBody &body, const ReducedBody::Harmonic &harmonic)
    {
      return harmonic.number == 0 || 2 * harmonic.number == body.n_sectors;
    }

    /** A Hermitian or skew-Hermitian matrix for real and imaginary parts, one behind the other. */
    MatrixXd real_matrix(const MatrixXcd &A, const bool real)
    {
      const Eigen::Index n = A.rows();
      if (real)
        return A.real();
      MatrixXd both(2 * n, 2 * n);
      both << A.real(), -A.imag(), A.imag(), A.real();
      return both;
    }

    /** What is read: one reading on a sector, or its sum over all of them. */
    struct Row
    {
      std::string                 name, unit;
      Eigen::Index                place; ///< in ReducedBody::Harmonic::shapes
      std::optional<unsigned int> sector;
      bool                        turns;           ///< with the turn of the body
      bool                        of_ring = false; ///< place: in ReducedBody::Harmonic::rings
    };

    std::vector<Row> list_rows(const ReducedBody &body, const Model &model, const unsigned int b)
    {
      const char *const components[] = {"x", "y", "z", "xx", "yy", "zz", "xy", "yz", "zx"};
      std::vector<Row>  rows;
      Eigen::Index      place = 0;
      for (const unsigned int node : body.touch_nodes)
        for (unsigned int c = 0; c < 3; ++c)
          rows.push_back({"node " + std::to_string(node) + " displacement " + components[c],
                          "mm",
                          place++,
                          0,
                          false});
      const auto place_of = [&](const std::string &reading) {
        return place + Eigen::Index(body.find_reading(reading));
      };
      for (const char *const name : {reading::bore_turn, reading::rim_turn})
        if (std::any_of(body.readings.begin(), body.readings.end(), [&](const SectorReading &one) {
              return one.name == name;
            }))
          rows.push_back({name, "rad", place_of(name), {}, true});
      for (const Probe &probe : model.probes)
        if (probe.body == b)
          for (unsigned int c = 0; c < 9; ++c)
            rows.push_back({probe.name + (c < 3 ? " displacement " : " stress ") + components[c],
                            c < 3 ? "mm" : "MPa",
                            place_of(reading::of_probe(probe.name, c)),
                            body.sector_of(probe.node),
                            false});
      for (std::size_t i = 0; i < 6 * body.rings.size(); ++i)
        rows.push_back(
          {body.rings.names[i / 6] + (i % 6 < 3 ? " displacement " : " turn ") + components[i % 3],
           i % 6 < 3 ? "mm" : "rad",
           Eigen::Index(i),
           {},
           false,
           true});
      return rows;
    }

    void add_harmonic(const ReducedBody           &body,
                      const ReducedBody::Harmonic &harmonic,
                      const std::vector<Row>      &rows,
                      const Eigen::Index           first,
                      RealBody                    &real)
    {
      const Eigen::Index n = harmonic.n_modes(), size = is_real(body, harmonic) ? n : 2 * n;
      const auto         block = [&](MatrixXd &matrix, const MatrixXcd &A) {
        matrix.block(first, first, size, size) = real_matrix(A, size == n);
      };
      block(real.mass, MatrixXcd::Identity(n, n));
      block(real.stiffness,
            harmonic.eigenvalues.cast<std::complex<double>>().asDiagonal().toDenseMatrix());
      block(real.coriolis, harmonic.coriolis);
      block(real.spin_stiffness, harmonic.spin_stiffness);
      if (harmonic.number == 0)
        real.torque.block(first, 0, n, 1) = harmonic.torque.real();
      for (std::size_t i = 0; i < rows.size(); ++i)
        {
          // Sector k has Re(z c exp(i h k alpha)); sums over all sectors know h = 0 alone.
          Eigen::RowVectorXcd z = Eigen::RowVectorXcd::Zero(n);
          if (!rows[i].of_ring)
            z = harmonic.shapes.row(rows[i].place);
          else if (harmonic.number < 2)
            z = harmonic.rings.row(rows[i].place);
          if (rows[i].sector)
            z *= std::polar(1., harmonic.number * *rows[i].sector * body.sector_angle);
          else if (!rows[i].of_ring)
            z *= harmonic.number == 0 ? body.n_sectors : 0.;
          real.shapes.block(i, first, 1, n) = z.real();
          if (size > n)
            real.shapes.block(i, first + n, 1, n) = -z.imag();
        }
      for (const char *const part : {"real", "imaginary"})
        for (Eigen::Index k = 0; k < n && (size > n || part == std::string("real")); ++k)
          real.coordinates.add_row({double(real.coordinates.n_rows()),
                                    double(harmonic.number),
                                    std::string(part),
                                    // Motions that spin makes unstable but for Coriolis forces
                                    // have none.
                                    std::sqrt(std::max(0., harmonic.eigenvalues[k])) / (2. * pi)});
    }

    void add_turn(const ReducedBody &body, const std::vector<Row> &rows, RealBody &real)
    {
      // I theta'' + 2 Omega t . c' = moment, c'' + ... = g + 2 Omega t theta'; h = 0 comes first.
      const Eigen::Index last = real.mass.rows() - 1, n = body.turn_coriolis.size();
      real.mass(last, last)           = body.turn_inertia;
      real.coriolis.row(last).head(n) = body.turn_coriolis.transpose();
      real.coriolis.col(last).head(n) = -body.turn_coriolis;
      real.torque(last, 0)            = 1.;
      for (std::size_t i = 0; i < rows.size(); ++i)
        real.shapes(i, last) = rows[i].turns ? 1. : 0.;
      real.coordinates.add_row({double(last), 0., std::string("turn"), 0.});
    }
  } // namespace

  RealBody make_real_body(const ReducedBody &body, const Model &model, const unsigned int number)
  {
    const std::vector<Row> rows = list_rows(body, model, number);
    Eigen::Index           n    = body.turns ? 1 : 0;
    for (const ReducedBody::Harmonic &harmonic : body.harmonics)
      n += harmonic.n_modes() * (is_real(body, harmonic) ? 1 : 2);
    RealBody real;
    for (MatrixXd *const matrix :
         {&real.mass, &real.stiffness, &real.coriolis, &real.spin_stiffness})
      *matrix = MatrixXd::Zero(n, n);
    real.shapes = MatrixXd::Zero(rows.size(), n);
    real.torque = MatrixXd::Zero(n, 1);
    real.coordinates.add_column("coordinate", "-");
    real.coordinates.add_column("nodal diameters", "-");
    real.coordinates.add_text_column("part");
    real.coordinates.add_column("frequency", "Hz");
    Eigen::Index first = 0;
    for (const ReducedBody::Harmonic &harmonic : body.harmonics)
      {
        add_harmonic(body, harmonic, rows, first, real);
        first += harmonic.n_modes() * (is_real(body, harmonic) ? 1 : 2);
      }
    if (body.turns)
      add_turn(body, rows, real);

    real.rows.add_column("row", "-");
    real.rows.add_text_column("reading");
    real.rows.add_text_column("unit");
    // Rows differ in their unit, which is a cell of its own.
    real.rows.add_column("state of spin", "unit");
    real.rows.add_column("at once under a unit torque", "unit/(N mm)");
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const Eigen::Index place = rows[i].place;
        const double       sum   = rows[i].sector || rows[i].of_ring ? 1. : body.n_sectors;
        real.rows.add_row(
          {double(i),
           rows[i].name,
           rows[i].unit,
           sum * (rows[i].of_ring ? body.rings.spin : body.spin)[place],
           sum * (rows[i].of_ring ? body.rings.torque : body.torque_residual)[place]});
      }
    real.seats    = body.rings.stiffness;
    real.residual = body.residual[body.reach].topRows(3 * body.touch_nodes.size());
    return real;
  }
} // namespace vfife
