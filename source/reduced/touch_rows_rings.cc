// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Rings of a reduced body in bearings.
#include <vfife/reduced/touch_rows.h>

#include <complex>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  void TouchRows::fill_rings()
  {
    const ReducedBody::Rings &rings   = body_.rings;
    const Eigen::Index        n_modes = body_.n_modes(), n_rings = n_ring_rows(),
                       first = shapes_.cols() - n_rings, n = 3 * body_.touch_nodes.size();
    spin_.tail(n_rings)   = to_rows_ * rings.spin;
    torque_.tail(n_rings) = to_rows_ * rings.torque;
    euler_.tail(n_rings)  = to_rows_ * rings.euler;
    shapes_.rightCols(n_rings).setZero();

    // 1. What loads on the rings do to all nodes that may touch, by the harmonic, and to each
    // other.
    std::array<MatrixXcd, 2> at_nodes;
    for (unsigned int h = 0; h < 2; ++h)
      at_nodes[h] = rings.answers[h].topRows(n) * to_rows_.transpose();
    MatrixXd     at_rings = to_rows_ * rings.residual * to_rows_.transpose();
    Eigen::Index mode     = 0;
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      {
        const ReducedBody::Harmonic &harmonic = body_.harmonics[i];
        if (harmonic.number < 2)
          {
            const MatrixXcd z     = to_rows_ * harmonic.rings;
            const MatrixXcd modal = gains_[i] * z.adjoint();
            at_nodes[harmonic.number] += harmonic.shapes.topRows(n) * modal;
            at_rings += (z * modal).real();
            shapes_.block(mode, first, z.cols(), n_rings)           = z.real().transpose();
            shapes_.block(n_modes + mode, first, z.cols(), n_rings) = -z.imag().transpose();
          }
        mode += harmonic.n_modes();
      }

    // 2. Those of the rows.
    flexibility_.bottomRightCorner(n_rings, n_rings) = at_rings;
    for (const Run &run : runs_)
      for (std::size_t k = 0; k < run.places.size(); ++k)
        {
          const std::complex<double> turned = phase_(1, run.sector);
          const Eigen::Index         from   = 3 * run.places[k];
          flexibility_.block(run.first + 3 * k, first, 3, n_rings) =
            at_nodes[0].middleRows<3>(from).real() +
            (turned * at_nodes[1].middleRows<3>(from)).real();
        }
    flexibility_.bottomLeftCorner(n_rings, first) =
      flexibility_.topRightCorner(first, n_rings).transpose();
  }

  VectorXd TouchRows::ring_loads(const VectorXd &forces) const
  {
    return to_rows_.transpose() * forces.tail(n_ring_rows());
  }

  Eigen::Matrix<double, 6, 1> TouchRows::read_ring(const unsigned int            ring,
                                                   const double                  spin,
                                                   const std::vector<VectorXcd> &coordinates,
                                                   const VectorXd               &forces,
                                                   const AxialLoad              &axial) const
  {
    const ReducedBody::Rings   &rings  = body_.rings;
    const Eigen::Index          first  = 6 * ring;
    Eigen::Matrix<double, 6, 1> motion = spin * rings.spin.segment<6>(first) +
                                         axial.torque * rings.torque.segment<6>(first) +
                                         axial.acceleration * rings.euler.segment<6>(first) +
                                         rings.residual.middleRows<6>(first) * ring_loads(forces);
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      if (body_.harmonics[i].number < 2)
        motion += (body_.harmonics[i].rings.middleRows<6>(first) * coordinates[i]).real();
    for (const Run &run : runs_)
      for (std::size_t k = 0; k < run.places.size(); ++k)
        {
          const Eigen::Index at = 3 * run.places[k];
          for (unsigned int h = 0; h < 2; ++h)
            motion +=
              (phase_(h, run.sector) * rings.answers[h].block<3, 6>(at, first)).real().transpose() *
              forces.segment<3>(run.first + 3 * k);
        }
    motion << placement_ * motion.head<3>().eval(), placement_ * motion.tail<3>().eval();
    return motion;
  }
} // namespace vfife
