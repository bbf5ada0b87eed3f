// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"
#include "ring_parts.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/types.h>
#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/reduced/body_reduction.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace vfife
{
  namespace
  {
    /**
     * Sums phasors of the harmonics to what a unit force on sector 0 alone does on sectors around
     * it: f on one of N sectors is the sum of w_h Re(f exp(i h d alpha)) over h = 0 ... N/2, with
     * w_h = 1/N at both ends and 2/N between them. Columns are forces, which are the first rows.
     */
    class ResidualSum
    {
    public:
      ResidualSum(unsigned int n_sectors,
                  unsigned int reach,
                  unsigned int n_rows,
                  unsigned int n_columns);

      /** Phasors of a harmonic: @p answers to forces on all sectors, less the part of @p modes
       * under a force on one sector. */
      void
      add(unsigned int harmonic, const Eigen::MatrixXcd &answers, const Eigen::MatrixXcd &modes);

      /** Over the ranks. Collective. */
      void sum(const Communicator &communicator);

      /** By sector, -reach first. */
      std::vector<Eigen::MatrixXd> take_near()
      {
        return std::move(near_);
      }
      /** The sum over all sectors. */
      const Eigen::MatrixXd &summed() const
      {
        return summed_;
      }
      /** Largest entry at the forces' rows on sectors beyond the reach over that within, among a
       * sample of the forces. */
      double left() const;

    private:
      unsigned int                 n_sectors_, reach_;
      std::vector<int>             sample_; ///< forces, three by three
      std::vector<Eigen::MatrixXd> near_, far_;
      Eigen::MatrixXd              summed_;
    };

    /** Nodes whose flexibility is followed all around the body. */
    constexpr unsigned int largest_sample = 32;

    /** Throws InputError for nodes that cannot be meant. */
    void check_nodes(const CyclicBody                 &sector,
                     const std::vector<unsigned int>  &touch_nodes,
                     const std::vector<SectorReading> &readings)
    {
      const Body          &body      = sector.body();
      const unsigned int   n_points  = sector.all_sectors().n_points();
      const std::string    name      = "body \"" + body.name() + "\": ";
      const BodyStructure &structure = body.structure();
      for (const unsigned int node : touch_nodes)
        if (structure.sector_of(node) != 0)
          throw InputError(name + "node " + std::to_string(node) +
                           " with a force is outside sector 0, which has nodes 0 to " +
                           std::to_string(structure.nodes_per_sector() - 1));
      for (const SectorReading &reading : readings)
        for (const auto &weight : reading.weights)
          if (weight.first >= n_points)
            throw InputError(name + "reading \"" + reading.name + "\" uses node " +
                             std::to_string(weight.first) + " of " + std::to_string(n_points) +
                             " nodes");
    }

    /** Touch nodes along the axes of the body frame, then the readings. */
    std::vector<SectorRow> make_rows(const CyclicBody                 &body,
                                     const std::vector<unsigned int>  &touch_nodes,
                                     const std::vector<SectorReading> &readings)
    {
      const NodeAverages     averages(body.all_sectors());
      std::vector<SectorRow> rows;
      for (const unsigned int node : touch_nodes)
        for (unsigned int c = 0; c < 3; ++c)
          {
            std::vector<std::pair<unsigned int, Vector3>> weights;
            for (const auto &[point, weight] : averages.of(node))
              weights.emplace_back(point, weight * Vector3::Unit(c));
            rows.push_back(body.make_row(weights));
          }
      for (const SectorReading &reading : readings)
        rows.push_back(body.make_row(reading.weights));
      return rows;
    }

    /**
     * The second rate for the stiffness of spin. Matrices are nearly linear in s = Omega^2, with a
     * curvature b: between 0 and 1 (s over that at the rate) the secant through 1 and p is off by
     * b (1 - s)(s - p), whose largest values, b p at standstill and b (1 - p)^2/4 in between, are
     * equal for p = (sqrt(2) - 1)^2. At rest: a rate whose stresses are far above round-off and
     * whose strains, (Omega R/c)^2 and so 1e-5, are far from changing the stiffness.
     */
    double second_rate(const Body &body, const double rate)
    {
      if (rate != 0)
        return (std::sqrt(2.) - 1.) * rate;
      double radius = 0;
      for (const Vector3 &x : body.node_positions())
        radius =
          std::max(radius, body.axis.direction.cross(body.placement(x) - body.axis.point).norm());
      return 3e-3 * body.sound_speed() / radius;
    }

    /** What a rank finds of the harmonics that are its own. */
    struct OwnHarmonics
    {
      std::vector<ReducedBody::Harmonic> harmonics;
      RingParts                          rings;
      /** Of h = 0, or empty. */
      Eigen::VectorXd torque_residual, euler_residual, turn_coriolis;
      unsigned int    n_unknowns = 0;
      double          memory     = 0;
    };

    void add_harmonic(const CyclicBody             &body,
                      const std::vector<double>    &second_equilibrium,
                      const double                  second_rate,
                      const std::vector<SectorRow> &rows,
                      const std::vector<SectorRow> &ring_rows,
                      const ReducedBody            &reduced,
                      const unsigned int            number,
                      OwnHarmonics                 &own,
                      ResidualSum                  &residual)
    {
      CyclicHarmonic               sector(body, number);
      ReducedBody::Harmonic        harmonic;
      const std::vector<SectorRow> touch(rows.begin(),
                                         rows.begin() + 3 * reduced.touch_nodes.size());
      // 1. Modes and what speed does to them.
      const CyclicModes modes = sector.find_modes(reduced.cutoff);
      harmonic.number         = number;
      harmonic.eigenvalues    = modes.eigenvalues;
      const bool is_empty     = modes.vectors.empty();
      harmonic.shapes = is_empty ? Eigen::MatrixXcd(rows.size(), 0) : sector.read(modes, rows);
      if (!is_empty)
        {
          const Eigen::MatrixXcd G = sector.project(modes, sector.coriolis());
          harmonic.coriolis        = .5 * (G - G.adjoint());
          const Eigen::MatrixXcd D =
            sector.project(modes, sector.spin_stiffness(second_equilibrium, second_rate));
          harmonic.spin_stiffness = .5 * (D + D.adjoint());
        }
      const auto flexibilities = harmonic.eigenvalues.cwiseInverse().cast<std::complex<double>>();
      if (number < 2)
        own.rings.add(body, sector, modes, rows, ring_rows, harmonic);

      // 2. What they leave of the static displacements.
      residual.add(number,
                   sector.answers(touch, rows),
                   harmonic.shapes * flexibilities.asDiagonal() *
                     harmonic.shapes.topRows(touch.size()).adjoint());

      // 3. What is the same in all sectors.
      if (number == 0)
        {
          const auto modal_part = [&](const Eigen::VectorXcd &force) -> Eigen::VectorXd {
            return (harmonic.shapes * (flexibilities.asDiagonal() * force)).real();
          };
          harmonic.torque = sector.modal_forces(modes, body.torque()).cast<std::complex<double>>();
          harmonic.euler  = sector.euler_forces(modes).cast<std::complex<double>>();
          own.torque_residual = sector.answer(body.torque(), rows) - modal_part(harmonic.torque);
          own.euler_residual  = sector.euler_answer(rows) - modal_part(harmonic.euler);
          own.rings.add_axial(body, sector, ring_rows, harmonic);
          if (body.turns())
            own.turn_coriolis = sector.turn_coriolis(modes);
        }
      own.n_unknowns = std::max(own.n_unknowns, sector.n_unknowns());
      own.memory     = std::max(own.memory, sector.memory());
      // The rigid turn of a hub is one of h = 0 even where no mode is.
      if (!is_empty || (number == 0 && body.turns()))
        own.harmonics.push_back(std::move(harmonic));
    }

    /** Does what each rank does by itself; what one of them throws, all throw. Collective. */
    template <typename Act>
    void do_on_all(const Communicator &communicator, const Act &act)
    {
      std::string wrong, failed;
      try
        {
          act();
        }
      catch (const InputError &error)
        {
          wrong = error.what();
        }
      catch (const std::exception &error)
        {
          failed = error.what();
        }
      for (const std::string &message : communicator.all_gather(wrong))
        if (!message.empty())
          throw InputError(message);
      for (const std::string &message : communicator.all_gather(failed))
        if (!message.empty())
          throw NumericalError(message);
    }

    void pass(OwnHarmonics &own, ByteStream &stream)
    {
      std::size_t n = own.harmonics.size();
      stream.pass(n, own.n_unknowns, own.memory);
      own.harmonics.resize(n);
      for (ReducedBody::Harmonic &harmonic : own.harmonics)
        serialize(harmonic, stream);
      pass_matrix(own.torque_residual, stream);
      pass_matrix(own.euler_residual, stream);
      pass_matrix(own.turn_coriolis, stream);
      own.rings.pass(stream);
    }

    /** What all ranks have found. Collective. */
    void gather(OwnHarmonics &own, const Communicator &communicator, ReducedBody &reduced)
    {
      ByteStream collected;
      pass(own, collected);
      for (const std::string &bytes : communicator.all_gather(collected.bytes()))
        {
          OwnHarmonics found;
          ByteStream   stream(bytes);
          pass(found, stream);
          for (ReducedBody::Harmonic &harmonic : found.harmonics)
            reduced.harmonics.push_back(std::move(harmonic));
          reduced.n_unknowns = std::max(reduced.n_unknowns, found.n_unknowns);
          reduced.memory     = std::max(reduced.memory, found.memory);
          if (found.torque_residual.size() > 0)
            {
              reduced.torque_residual = found.torque_residual;
              reduced.euler_residual  = found.euler_residual;
            }
          if (found.turn_coriolis.size() > 0)
            reduced.turn_coriolis = found.turn_coriolis;
          found.rings.move_to(reduced.rings);
        }
      std::sort(reduced.harmonics.begin(),
                reduced.harmonics.end(),
                [](const auto &a, const auto &b) { return a.number < b.number; });
    }
  } // namespace

  ResidualSum::ResidualSum(const unsigned int n_sectors,
                           const unsigned int reach,
                           const unsigned int n_rows,
                           const unsigned int n_columns)
    : n_sectors_(n_sectors)
    , reach_(std::min(reach, n_sectors / 2))
    , near_(2 * reach_ + 1, Eigen::MatrixXd::Zero(n_rows, n_columns))
    , summed_(Eigen::MatrixXd::Zero(n_rows, n_columns))
  {
    const unsigned int n_nodes = n_columns / 3, n = std::min(n_nodes, largest_sample);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        sample_.push_back(3 * (i * n_nodes / n) + c);
    if (2 * reach_ + 1 < n_sectors)
      far_.assign(n_sectors - 2 * reach_ - 1,
                  Eigen::MatrixXd::Zero(sample_.size(), sample_.size()));
  }

  void ResidualSum::add(const unsigned int      harmonic,
                        const Eigen::MatrixXcd &answers,
                        const Eigen::MatrixXcd &modes)
  {
    const bool             is_end = harmonic == 0 || 2 * harmonic == n_sectors_;
    const Eigen::MatrixXcd rest   = (is_end ? 1. : 2.) / n_sectors_ * answers - modes;
    const double           angle  = harmonic * 2. * pi / n_sectors_;
    // Re(z exp(i phi)) = a cos(phi) - b sin(phi)
    for (int d = -int(reach_); d <= int(reach_); ++d)
      // Half a turn away lies one sector in both senses.
      if (2 * d != -int(n_sectors_))
        near_[d + reach_] += std::cos(d * angle) * rest.real() - std::sin(d * angle) * rest.imag();
    if (harmonic == 0)
      summed_ = n_sectors_ * rest.real();
    if (far_.empty())
      return;
    Eigen::MatrixXcd part(sample_.size(), sample_.size());
    for (std::size_t i = 0; i < sample_.size(); ++i)
      for (std::size_t k = 0; k < sample_.size(); ++k)
        part(i, k) = rest(sample_[i], sample_[k]);
    for (std::size_t k = 0; k < far_.size(); ++k)
      {
        const double phase = (reach_ + 1. + k) * angle;
        far_[k] += std::cos(phase) * part.real() - std::sin(phase) * part.imag();
      }
  }

  void ResidualSum::sum(const Communicator &communicator)
  {
    for (auto *const matrices : {&near_, &far_})
      for (Eigen::MatrixXd &matrix : *matrices)
        communicator.sum(matrix.data(), matrix.size());
    communicator.sum(summed_.data(), summed_.size());
  }

  double ResidualSum::left() const
  {
    double within = 0, beyond = 0;
    for (const Eigen::MatrixXd &matrix : near_)
      for (const int i : sample_)
        for (const int k : sample_)
          within = std::max(within, std::abs(matrix(i, k)));
    for (const Eigen::MatrixXd &matrix : far_)
      beyond = std::max(beyond, matrix.cwiseAbs().maxCoeff());
    return within > 0 ? beyond / within : 0.;
  }

  ReducedBody reduce_body(const Model                     &model,
                          const unsigned int               body,
                          const std::vector<unsigned int> &touch_nodes,
                          std::vector<SectorReading>       readings,
                          const FemOptions                &fem,
                          const ReductionOptions          &options,
                          const double                     rate,
                          const Communicator              &communicator)
  {
    const CyclicBody sector(model, body, fem, rate);
    check_nodes(sector, touch_nodes, readings);
    ReducedBody reduced;
    reduced.n_sectors        = sector.n_sectors();
    reduced.nodes_per_sector = sector.body().structure().nodes_per_sector();
    reduced.sector_angle     = sector.sector().sector_angle();
    reduced.rate             = rate;
    reduced.cutoff           = options.cutoff;
    reduced.touch_nodes      = touch_nodes;
    reduced.readings         = std::move(readings);
    reduced.reach            = std::min(options.reach, reduced.n_sectors / 2);
    reduced.turns            = sector.turns();
    reduced.turn_inertia     = sector.turn_inertia();
    reduced.counted          = true; // CyclicHarmonic::find_modes() returns no others

    const std::vector<SectorRow> rows = make_rows(sector, touch_nodes, reduced.readings);
    const std::vector<SectorRow> ring_rows =
      describe_rings(model, body, sector, rate, reduced.rings);
    reduced.spin.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      reduced.spin[i] = read_row(rows[i], sector.spin());
    for (std::size_t i = 0; i < reduced.readings.size(); ++i)
      if (reduced.readings[i].offset)
        reduced.spin[3 * touch_nodes.size() + i] = *reduced.readings[i].offset;

    // Harmonics do not know each other: each rank takes every so manieth one.
    ResidualSum  residual(reduced.n_sectors, reduced.reach, rows.size(), 3 * touch_nodes.size());
    OwnHarmonics own;
    do_on_all(communicator, [&]() {
      const double              second = second_rate(sector.body(), rate);
      const std::vector<double> there  = sector.find_equilibrium(second);
      for (unsigned int h = communicator.rank(); h <= reduced.n_sectors / 2;
           h += communicator.size())
        add_harmonic(sector, there, second, rows, ring_rows, reduced, h, own, residual);
    });
    residual.sum(communicator);
    gather(own, communicator, reduced);
    reduced.residual_left   = residual.left();
    reduced.summed_residual = residual.summed().bottomRows(reduced.readings.size());
    reduced.residual        = residual.take_near();
    return reduced;
  }
} // namespace vfife
