// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "ring_parts.h"

#include "matrix_stream.h"

#include <vfife/bearing/shaft_seat.h>
#include <vfife/fem/system/bearing_rings.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/reduced/body_rings.h>

#include <cmath>
#include <complex>

namespace vfife
{
  using Eigen::MatrixXcd;
  using Eigen::MatrixXd;
  using Eigen::VectorXd;

  namespace
  {
    /** Pi of displacements and turns of @p n rings, body frame. */
    MatrixXcd
    make_projector(const CyclicBody &body, const unsigned int harmonic, const std::size_t n)
    {
      const Matrix3    axes  = axes_along(body.body().placement.rotation.transpose() *
                                      compute_sector_axis(body.body()).direction);
      Eigen::Vector3cd along = axes.col(2).cast<std::complex<double>>();
      if (harmonic == 1)
        {
          along.real() = std::sqrt(.5) * axes.col(0);
          along.imag() = std::sqrt(.5) * axes.col(1);
        }
      MatrixXcd projector = MatrixXcd::Zero(6 * n, 6 * n);
      for (std::size_t i = 0; i < 2 * n; ++i)
        projector.block<3, 3>(3 * i, 3 * i) = along * along.adjoint();
      return projector;
    }

    /** What the modes do under the modal forces, a column each. */
    MatrixXcd static_modes(const ReducedBody::Harmonic &harmonic, const MatrixXcd &forces)
    {
      return harmonic.eigenvalues.cwiseInverse().cast<std::complex<double>>().asDiagonal() * forces;
    }
  } // namespace

  std::vector<SectorRow> describe_rings(const Model        &model,
                                        const unsigned int  number,
                                        const CyclicBody   &body,
                                        const double        rate,
                                        ReducedBody::Rings &rings)
  {
    std::vector<SectorRow> rows;
    for (const MotionOfRing &ring : list_rings(model, number))
      {
        rings.names.push_back(ring.name);
        rings.centres.push_back(ring.centre);
        for (unsigned int c = 0; c < 6; ++c)
          {
            std::vector<std::pair<unsigned int, Vector3>> weights;
            for (const auto &[node, motion] : ring.motion)
              weights.emplace_back(node, motion.row(c).transpose());
            rows.push_back(body.make_row(weights));
          }
      }
    if (rows.empty())
      return rows;
    for (const Bearing &bearing : model.bearings)
      rings.n_bearings += bearing.body == number ? 1 : 0;
    // As K has them, there along the axes of the fixed frame.
    const Matrix3      back = body.body().placement.rotation.transpose();
    const Eigen::Index n    = 6 * rings.n_bearings;
    MatrixXd           turn = MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; i += 3)
      turn.block<3, 3>(i, i) = back;
    rings.stiffness = turn *
                      BearingRings(body.sector())
                        .stiffness([rate](unsigned int) { return rate; })
                        .topLeftCorner(n, n) *
                      turn.transpose();
    rings.inertia = find_rigid_inertia(model, number);
    VectorXd spin(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      spin[i] = read_row(rows[i], body.spin());
    rings.spin = body.n_sectors() * make_projector(body, 0, rings.size()).real() * spin;
    return rows;
  }

  void RingParts::add(const CyclicHarmonic  &sector,
                      const CyclicModes     &modes,
                      ReducedBody::Harmonic &harmonic)
  {
    if (ring_rows_.empty())
      return;
    const unsigned int h  = harmonic.number;
    const MatrixXcd    Pi = make_projector(body_, h, ring_rows_.size() / 6);
    const double       N  = body_.n_sectors();
    harmonic.rings        = N * Pi * sector.read(modes).bottomRows(ring_rows_.size());
    const MatrixXcd under =
      (h == 0 ? 1. : 2.) * sector.answers(rows_.size(), ring_rows_.size()) * Pi;
    const MatrixXcd modal = static_modes(harmonic, harmonic.rings.adjoint());
    answers_[h]           = under.topRows(rows_.size()) - harmonic.shapes * modal;
    const MatrixXd part =
      (N * Pi * under.bottomRows(ring_rows_.size()) - harmonic.rings * modal).real();
    residual_ = residual_.size() > 0 ? MatrixXd(residual_ + part) : part;
  }

  void RingParts::add_axial(const CyclicHarmonic &sector, const ReducedBody::Harmonic &harmonic)
  {
    if (ring_rows_.empty())
      return;
    const MatrixXd whole =
      body_.n_sectors() * make_projector(body_, 0, ring_rows_.size() / 6).real();
    const auto modal_part = [&](const Eigen::VectorXcd &force) -> VectorXd {
      return (harmonic.rings * static_modes(harmonic, force)).real();
    };
    const auto n = static_cast<Eigen::Index>(ring_rows_.size());
    torque_      = whole * sector.answer(body_.torque()).tail(n) - modal_part(harmonic.torque);
    euler_       = whole * sector.euler_answer().tail(n) - modal_part(harmonic.euler);
  }

  void RingParts::pass(ByteStream &stream)
  {
    for (MatrixXcd &answers : answers_)
      pass_matrix(answers, stream);
    pass_matrix(residual_, stream);
    pass_matrix(torque_, stream);
    pass_matrix(euler_, stream);
  }

  void RingParts::move_to(ReducedBody::Rings &rings)
  {
    for (unsigned int h = 0; h < 2; ++h)
      if (answers_[h].size() > 0)
        rings.answers[h] = std::move(answers_[h]);
    if (residual_.size() > 0)
      rings.residual =
        rings.residual.size() > 0 ? MatrixXd(rings.residual + residual_) : std::move(residual_);
    if (torque_.size() > 0)
      {
        rings.torque = std::move(torque_);
        rings.euler  = std::move(euler_);
      }
  }
} // namespace vfife
