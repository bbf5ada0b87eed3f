// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/reduced/touch_rows.h>

#include <algorithm>
#include <string>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXcd;
  using Eigen::VectorXd;

  namespace
  {
    constexpr unsigned int no_place = static_cast<unsigned int>(-1);
  } // namespace

  TouchRows::TouchRows(const ReducedBody &body, std::vector<MatrixXcd> gains, const RingAxes axes)
    : body_(body)
    , phase_(body.n_sectors)
    , gains_(std::move(gains))
    , placement_(axes.placement)
    , to_rows_(MatrixXd::Zero(6 * body.rings.n_bearings, 6 * body.rings.size()))
    , place_of_(body.nodes_per_sector, no_place)
  {
    for (Eigen::Index i = 0; i < to_rows_.rows(); i += 3)
      to_rows_.block<3, 3>(i, i) = (i % 6 == 0 ? 1. : axes.arm) * placement_;
    for (unsigned int i = 0; i < body.touch_nodes.size(); ++i)
      place_of_[body.touch_nodes[i]] = i;
  }

  int TouchRows::distance(const unsigned int a, const unsigned int b) const
  {
    const int n = body_.n_sectors;
    int       d = (int(a) - int(b)) % n;
    if (2 * d > n)
      d -= n;
    if (2 * d <= -n)
      d += n;
    return d;
  }

  const MatrixXd &TouchRows::find_block(const int distance)
  {
    const auto known = blocks_.find(distance);
    if (known != blocks_.end())
      return known->second;
    const Eigen::Index n     = 3 * body_.touch_nodes.size();
    MatrixXd           block = MatrixXd::Zero(n, n);
    // What is left out beyond the reach is ReducedBody::residual_left of what is kept.
    if (const MatrixXd *const residual = body_.find_residual(distance))
      block = residual->topRows(n);
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      {
        const ReducedBody::Harmonic &harmonic = body_.harmonics[i];
        const MatrixXcd              z        = harmonic.shapes.topRows(n);
        block += ((phase_(harmonic.number, distance) * z) * (gains_[i] * z.adjoint())).real();
      }
    return blocks_.emplace(distance, std::move(block)).first->second;
  }

  void TouchRows::set_nodes(const std::vector<unsigned int> &nodes)
  {
    const std::vector<Run> before = std::move(runs_);
    runs_.clear();
    Eigen::Index row = 0;
    for (const unsigned int node : nodes)
      {
        const unsigned int sector = body_.sector_of(node);
        if (runs_.empty() || runs_.back().sector != sector)
          runs_.push_back({sector, row, {}});
        runs_.back().places.push_back(place_of_[body_.first_copy(node)]);
        if (runs_.back().places.back() == no_place)
          throw NumericalError("node " + std::to_string(node) +
                               " of a reduced body may be in contact, "
                               "but is not among the nodes with forces");
        row += 3;
      }
    const Eigen::Index n_modes = body_.n_modes(), n_rows = row + n_ring_rows();
    shapes_.resize(2 * n_modes, n_rows);
    spin_.resize(n_rows);
    torque_.resize(n_rows);
    euler_.resize(n_rows);
    for (const Run &run : runs_)
      for (std::size_t k = 0; k < run.places.size(); ++k)
        {
          const Eigen::Index to = run.first + 3 * k, from = 3 * run.places[k];
          Eigen::Index       mode = 0;
          for (const ReducedBody::Harmonic &harmonic : body_.harmonics)
            {
              const MatrixXcd z =
                phase_(harmonic.number, run.sector) * harmonic.shapes.middleRows<3>(from);
              shapes_.block(mode, to, z.cols(), 3)           = z.real().transpose();
              shapes_.block(n_modes + mode, to, z.cols(), 3) = -z.imag().transpose();
              mode += z.cols();
            }
          spin_.segment<3>(to)   = body_.spin.segment<3>(from);
          torque_.segment<3>(to) = body_.torque_residual.segment<3>(from);
          euler_.segment<3>(to)  = body_.euler_residual.segment<3>(from);
        }
    // Teeth that take each other's places leave the flexibility as it is.
    const bool same =
      flexibility_.rows() == n_rows && before.size() == runs_.size() &&
      std::equal(before.begin(), before.end(), runs_.begin(), [&](const Run &a, const Run &b) {
        return a.places == b.places && distance(a.sector, before.front().sector) ==
                                         distance(b.sector, runs_.front().sector);
      });
    if (!same)
      fill_flexibility();
    if (n_ring_rows() > 0)
      fill_rings();
  }

  void TouchRows::set_gains(std::vector<MatrixXcd> gains)
  {
    gains_ = std::move(gains);
    blocks_.clear();
    if (shapes_.cols() == 0) // before set_nodes()
      return;
    fill_flexibility();
    if (n_ring_rows() > 0)
      fill_rings();
  }

  void TouchRows::fill_flexibility()
  {
    Eigen::Index n = 0;
    for (const Run &run : runs_)
      n += 3 * run.places.size();
    flexibility_.resize(n + n_ring_rows(), n + n_ring_rows());
    for (const Run &to : runs_)
      for (const Run &from : runs_)
        {
          const MatrixXd &block = find_block(distance(to.sector, from.sector));
          for (std::size_t k = 0; k < from.places.size(); ++k)
            for (std::size_t i = 0; i < to.places.size(); ++i)
              flexibility_.block<3, 3>(to.first + 3 * i, from.first + 3 * k) =
                block.block<3, 3>(3 * to.places[i], 3 * from.places[k]);
        }
  }

  VectorXd TouchRows::displace(const std::vector<VectorXcd> &coordinates) const
  {
    const Eigen::Index n_modes = shapes_.rows() / 2;
    VectorXd           parts(2 * n_modes);
    Eigen::Index       mode = 0;
    for (const VectorXcd &c : coordinates)
      {
        parts.segment(mode, c.size())           = c.real();
        parts.segment(n_modes + mode, c.size()) = c.imag();
        mode += c.size();
      }
    return shapes_.transpose() * parts;
  }

  VectorXd TouchRows::displace_nodes(const std::vector<unsigned int> &nodes,
                                     const double                     spin,
                                     const AxialLoad                 &axial,
                                     const std::vector<VectorXcd>    &coordinates,
                                     const VectorXd                  &forces) const
  {
    const Eigen::Index n     = 3 * body_.touch_nodes.size();
    const VectorXd     loads = ring_loads(forces);
    VectorXd           u(3 * nodes.size()), of_sector;
    unsigned int       last = body_.n_sectors;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const unsigned int sector = body_.sector_of(nodes[i]);
        if (std::exchange(last, sector) != sector)
          {
            // All touch nodes of the sector.
            of_sector = spin * body_.spin.head(n) + axial.torque * body_.torque_residual.head(n) +
                        axial.acceleration * body_.euler_residual.head(n);
            for (std::size_t h = 0; h < body_.harmonics.size(); ++h)
              of_sector += (body_.harmonics[h].shapes.topRows(n) *
                            (phase_(body_.harmonics[h].number, sector) * coordinates[h]))
                             .real();
            for (const Run &run : runs_)
              if (const MatrixXd *const residual =
                    body_.find_residual(distance(sector, run.sector)))
                for (std::size_t k = 0; k < run.places.size(); ++k)
                  for (unsigned int c = 0; c < 3; ++c)
                    if (const double f = forces[run.first + 3 * k + c]; f != 0.)
                      of_sector += f * residual->col(3 * run.places[k] + c).head(n);
            for (unsigned int h = 0; h < 2 && loads.size() > 0; ++h)
              of_sector += (phase_(h, sector) * (body_.rings.answers[h].topRows(n) * loads)).real();
          }
        u.segment<3>(3 * i) = of_sector.segment<3>(3 * place_of_[body_.first_copy(nodes[i])]);
      }
    return u;
  }

  std::vector<VectorXcd> TouchRows::project(const VectorXd &forces) const
  {
    // Few rows have forces.
    VectorXd parts = VectorXd::Zero(shapes_.rows());
    for (Eigen::Index k = 0; k < forces.size(); ++k)
      if (forces[k] != 0.)
        parts += forces[k] * shapes_.col(k);
    std::vector<VectorXcd> modal;
    const Eigen::Index     n_modes = shapes_.rows() / 2;
    Eigen::Index           mode    = 0;
    for (const ReducedBody::Harmonic &harmonic : body_.harmonics)
      {
        VectorXcd &g = modal.emplace_back(harmonic.n_modes());
        g.real()     = parts.segment(mode, g.size());
        g.imag()     = parts.segment(n_modes + mode, g.size());
        mode += g.size();
      }
    return modal;
  }

  Eigen::Index TouchRows::reading_row(const unsigned int reading) const
  {
    return 3 * body_.touch_nodes.size() + reading;
  }

  double TouchRows::read(const unsigned int            reading,
                         const unsigned int            sector,
                         const std::vector<VectorXcd> &coordinates,
                         const VectorXd               &forces,
                         const AxialLoad              &axial) const
  {
    const Eigen::Index row   = reading_row(reading);
    double             value = body_.read_axial(row, axial);
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      if (coordinates[i].size() > 0)
        value += (phase_(body_.harmonics[i].number, sector) *
                  (body_.harmonics[i].shapes.row(row) * coordinates[i])(0))
                   .real();
    for (const Run &run : runs_)
      {
        const MatrixXd *const residual = body_.find_residual(distance(sector, run.sector));
        if (residual == nullptr)
          continue;
        for (std::size_t k = 0; k < run.places.size(); ++k)
          value += residual->row(row)
                     .segment<3>(3 * run.places[k])
                     .dot(forces.segment<3>(run.first + 3 * k));
      }
    const VectorXd loads = ring_loads(forces);
    for (unsigned int h = 0; h < 2 && loads.size() > 0; ++h)
      value += (phase_(h, sector) * (body_.rings.answers[h].row(row) * loads)(0)).real();
    return value;
  }

  double TouchRows::read_all(const unsigned int            reading,
                             const std::vector<VectorXcd> &coordinates,
                             const VectorXd               &forces,
                             const AxialLoad              &axial) const
  {
    const Eigen::Index row   = reading_row(reading);
    double             value = body_.n_sectors * body_.read_axial(row, axial);
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      if (body_.harmonics[i].number == 0 && coordinates[i].size() > 0)
        value +=
          body_.n_sectors * body_.harmonics[i].shapes.row(row).real().dot(coordinates[i].real());
    for (const Run &run : runs_)
      for (std::size_t k = 0; k < run.places.size(); ++k)
        value += body_.summed_residual.row(reading)
                   .segment<3>(3 * run.places[k])
                   .dot(forces.segment<3>(run.first + 3 * k));
    if (const VectorXd loads = ring_loads(forces); loads.size() > 0)
      value += body_.n_sectors * (body_.rings.answers[0].row(row).real() * loads)(0);
    return value;
  }

  const Eigen::RowVectorXcd &TouchRows::find_wave(const unsigned int reading, const unsigned int n)
  {
    Eigen::RowVectorXcd &wave = waves_[{reading, n}];
    if (wave.size() > 0)
      return wave;
    wave          = Eigen::RowVectorXcd::Zero(3 * body_.touch_nodes.size());
    const int far = body_.reach;
    // Half a turn away lies one sector in both senses.
    for (int d = 2 * body_.reach == body_.n_sectors ? 1 - far : -far; d <= far; ++d)
      wave += phase_(n, d) *
              body_.find_residual(d)->row(reading_row(reading)).cast<std::complex<double>>();
    return wave;
  }

  std::complex<double> TouchRows::read_wave(const unsigned int            reading,
                                            const unsigned int            n,
                                            const std::vector<VectorXcd> &coordinates,
                                            const VectorXd               &forces)
  {
    // Sums over the sectors of exp(i n k alpha) Re(x exp(i h k alpha)) are conj(x) N/2 for h = n,
    // otherwise zero.
    std::complex<double> value = 0;
    for (std::size_t i = 0; i < body_.harmonics.size(); ++i)
      if (body_.harmonics[i].number == n)
        value +=
          .5 * body_.n_sectors *
          std::conj((body_.harmonics[i].shapes.row(reading_row(reading)) * coordinates[i])(0));
    const Eigen::RowVectorXcd &wave = find_wave(reading, n);
    for (const Run &run : runs_)
      {
        std::complex<double> sum = 0;
        for (std::size_t k = 0; k < run.places.size(); ++k)
          for (unsigned int c = 0; c < 3; ++c)
            sum += wave[3 * run.places[k] + c] * forces[run.first + 3 * k + c];
        value += phase_(n, run.sector) * sum;
      }
    if (const VectorXd loads = ring_loads(forces); loads.size() > 0 && n == 1)
      value += .5 * body_.n_sectors *
               std::conj((body_.rings.answers[1].row(reading_row(reading)) * loads)(0));
    return value;
  }

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
