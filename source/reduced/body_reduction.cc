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
#include <optional>

namespace vfife
{
  namespace
  {
    /** Nodes whose flexibility is followed all around the body. */
    constexpr unsigned int largest_sample = 32;

    /**
     * Sums phasors of the harmonics to what a unit force on sector 0 alone does on sectors around
     * it: f on one of N sectors is the sum of w_h Re(f exp(i h d alpha)) over h = 0 ... N/2, with
     * w_h = 1/N at both ends and 2/N between them. Columns are forces, which are the first rows.
     */
    class ResidualSum
    {
    public:
      ResidualSum(const unsigned int n_sectors,
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

      /** Phasors of a harmonic: @p answers to forces on all sectors, less the part of @p modes
       * under a force on one sector. */
      void add(const unsigned int      harmonic,
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
            near_[d + reach_] +=
              std::cos(d * angle) * rest.real() - std::sin(d * angle) * rest.imag();
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

      /** Over the ranks. Collective. */
      void sum(const Communicator &communicator)
      {
        for (auto *const matrices : {&near_, &far_})
          for (Eigen::MatrixXd &matrix : *matrices)
            communicator.sum(matrix.data(), matrix.size());
        communicator.sum(summed_.data(), summed_.size());
      }

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
      double left() const
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

    private:
      unsigned int                 n_sectors_, reach_;
      std::vector<int>             sample_; ///< forces, three by three
      std::vector<Eigen::MatrixXd> near_, far_;
      Eigen::MatrixXd              summed_;
    };

    /** Throws InputError for nodes that cannot be meant. */
    void check_nodes(const CyclicBody &sector, const ReductionOptions &options)
    {
      const Body          &body      = sector.body();
      const unsigned int   n_points  = sector.all_sectors().n_points();
      const std::string    name      = "body \"" + body.name() + "\": ";
      const BodyStructure &structure = body.structure();
      // What a body grows by spin is scaled with the speed, which a temperature is not.
      body.require_no_initial_strains("reduced bodies");
      for (const unsigned int node : options.touch_nodes)
        if (structure.sector_of(node) != 0)
          throw InputError(name + "node " + std::to_string(node) +
                           " with a force is outside sector 0, which has nodes 0 to " +
                           std::to_string(structure.nodes_per_sector() - 1));
      for (const SectorReading &reading : options.readings)
        for (const auto &weight : reading.weights)
          if (weight.first >= n_points)
            throw InputError(name + "reading \"" + reading.name + "\" uses node " +
                             std::to_string(weight.first) + " of " + std::to_string(n_points) +
                             " nodes");
    }

    /** Touch nodes along the axes of the body frame, then the readings. */
    std::vector<SectorRow> make_rows(const CyclicBody &body, const ReductionOptions &options)
    {
      const NodeAverages     averages(body.all_sectors());
      std::vector<SectorRow> rows;
      for (const unsigned int node : options.touch_nodes)
        for (unsigned int c = 0; c < 3; ++c)
          {
            std::vector<std::pair<unsigned int, Vector3>> weights;
            for (const auto &[point, weight] : averages.of(node))
              weights.emplace_back(point, weight * Vector3::Unit(c));
            rows.push_back(body.make_row(weights));
          }
      for (const SectorReading &reading : options.readings)
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

    /** All of it that harmonics do not give. */
    ReducedBody describe_body(const CyclicBody &sector, const ReductionOptions &options)
    {
      check_nodes(sector, options);
      ReducedBody reduced;
      reduced.n_sectors        = sector.n_sectors();
      reduced.nodes_per_sector = sector.body().structure().nodes_per_sector();
      reduced.sector_angle     = sector.sector().sector_angle();
      reduced.rate             = options.rate;
      reduced.cutoff           = options.cutoff;
      reduced.touch_nodes      = options.touch_nodes;
      reduced.readings         = options.readings;
      reduced.reach            = std::min(options.reach, reduced.n_sectors / 2);
      reduced.turns            = sector.turns();
      reduced.turn_inertia     = sector.turn_inertia();
      reduced.counted          = true; // CyclicHarmonic::find_modes() returns no others
      return reduced;
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

    /** What all harmonics have in common, and the sums over them. Ranks share the harmonics. */
    class BodyReducer
    {
    public:
      BodyReducer(const Model            &model,
                  const unsigned int      body,
                  const ReductionOptions &options,
                  const Communicator     &communicator)
        : communicator_(communicator)
        , sector_(model, body, options.fem, options.rate)
        , reduced_(describe_body(sector_, options))
        , rows_(make_rows(sector_, options))
        , ring_rows_(describe_rings(model, body, sector_, options.rate, reduced_.rings))
        , own_(*this)
        , residual_(reduced_.n_sectors,
                    reduced_.reach,
                    rows_.size(),
                    3 * reduced_.touch_nodes.size())
      {
        reduced_.spin.resize(rows_.size());
        for (std::size_t i = 0; i < rows_.size(); ++i)
          reduced_.spin[i] = read_row(rows_[i], sector_.spin());
      }

      /** Collective. */
      ReducedBody reduce()
      {
        // Harmonics do not know each other: each rank takes every so manieth one.
        do_on_all(communicator_, [&]() {
          condense();
          for (unsigned int h = communicator_.rank(); h <= reduced_.n_sectors / 2;
               h += communicator_.size())
            add_harmonic(h);
        });
        residual_.sum(communicator_);
        gather();
        reduced_.residual_left   = residual_.left();
        reduced_.summed_residual = residual_.summed().bottomRows(reduced_.readings.size());
        reduced_.residual        = residual_.take_near();
        return std::move(reduced_);
      }

    private:
      /** What a rank finds of the harmonics that are its own. */
      struct Found
      {
        RingParts                          rings;
        std::vector<ReducedBody::Harmonic> harmonics;
        /** Of h = 0, or empty. */
        Eigen::VectorXd torque_residual, euler_residual, turn_coriolis;
        unsigned int    n_unknowns = 0;
        double          memory     = 0;

        explicit Found(const BodyReducer &of)
          : rings(of.sector_, of.rows_, of.ring_rows_)
        {
        }
        void pass(ByteStream &stream)
        {
          std::size_t n = harmonics.size();
          stream.pass(n, n_unknowns, memory);
          harmonics.resize(n);
          for (ReducedBody::Harmonic &harmonic : harmonics)
            serialize(harmonic, stream);
          pass_matrix(torque_residual, stream);
          pass_matrix(euler_residual, stream);
          pass_matrix(turn_coriolis, stream);
          rings.pass(stream);
        }
      };

      void condense()
      {
        std::vector<SectorRow> all = rows_;
        all.insert(all.end(), ring_rows_.begin(), ring_rows_.end());
        condensed_.emplace(sector_, reduced_.cutoff, all);
        coriolis_         = condensed_->coriolis();
        const double rate = second_rate(sector_.body(), reduced_.rate);
        spin_stiffness_   = condensed_->spin_stiffness(sector_.find_equilibrium(rate), rate);
      }

      void add_harmonic(const unsigned int number)
      {
        CyclicHarmonic        sector(*condensed_, number);
        ReducedBody::Harmonic harmonic;
        const std::size_t     n_touch = 3 * reduced_.touch_nodes.size();
        // 1. Modes and what speed does to them.
        const CyclicModes modes = sector.find_modes();
        harmonic.number         = number;
        harmonic.eigenvalues    = modes.eigenvalues;
        harmonic.shapes         = sector.read(modes).topRows(rows_.size());
        const bool is_empty     = harmonic.n_modes() == 0;
        if (!is_empty)
          {
            const Eigen::MatrixXcd G = sector.project(modes, coriolis_);
            harmonic.coriolis        = .5 * (G - G.adjoint());
            const Eigen::MatrixXcd D = sector.project(modes, spin_stiffness_);
            harmonic.spin_stiffness  = .5 * (D + D.adjoint());
          }
        if (number < 2)
          own_.rings.add(sector, modes, harmonic);

        // 2. What they leave of the static displacements.
        const auto flexibilities = harmonic.eigenvalues.cwiseInverse().cast<std::complex<double>>();
        residual_.add(number,
                      sector.answers(0, n_touch).topRows(rows_.size()),
                      harmonic.shapes * flexibilities.asDiagonal() *
                        harmonic.shapes.topRows(n_touch).adjoint());
        if (number == 0)
          add_axial(sector, modes, harmonic);
        own_.n_unknowns = std::max(own_.n_unknowns, sector.n_unknowns());
        own_.memory     = std::max(own_.memory, sector.memory());
        // The rigid turn of a hub is one of h = 0 even where no mode is.
        if (!is_empty || (number == 0 && sector_.turns()))
          own_.harmonics.push_back(std::move(harmonic));
      }

      /** h = 0: what is the same in all sectors. */
      void add_axial(const CyclicHarmonic  &sector,
                     const CyclicModes     &modes,
                     ReducedBody::Harmonic &harmonic)
      {
        const auto flexibilities = harmonic.eigenvalues.cwiseInverse().cast<std::complex<double>>();
        const auto modal_part    = [&](const Eigen::VectorXcd &force) -> Eigen::VectorXd {
          return (harmonic.shapes * (flexibilities.asDiagonal() * force)).real();
        };
        harmonic.torque = sector.modal_forces(modes, sector_.torque()).cast<std::complex<double>>();
        harmonic.euler  = sector.euler_forces(modes).cast<std::complex<double>>();
        const auto n    = static_cast<Eigen::Index>(rows_.size());
        own_.torque_residual =
          sector.answer(sector_.torque()).head(n) - modal_part(harmonic.torque);
        own_.euler_residual = sector.euler_answer().head(n) - modal_part(harmonic.euler);
        own_.rings.add_axial(sector, harmonic);
        if (sector_.turns())
          own_.turn_coriolis = sector.turn_coriolis(modes, coriolis_);
      }

      /** What all ranks have found. Collective. */
      void gather()
      {
        ByteStream collected;
        own_.pass(collected);
        for (const std::string &bytes : communicator_.all_gather(collected.bytes()))
          {
            Found      found(*this);
            ByteStream stream(bytes);
            found.pass(stream);
            for (ReducedBody::Harmonic &harmonic : found.harmonics)
              reduced_.harmonics.push_back(std::move(harmonic));
            reduced_.n_unknowns = std::max(reduced_.n_unknowns, found.n_unknowns);
            reduced_.memory     = std::max(reduced_.memory, found.memory);
            if (found.torque_residual.size() > 0)
              {
                reduced_.torque_residual = found.torque_residual;
                reduced_.euler_residual  = found.euler_residual;
              }
            if (found.turn_coriolis.size() > 0)
              reduced_.turn_coriolis = found.turn_coriolis;
            found.rings.move_to(reduced_.rings);
          }
        std::sort(reduced_.harmonics.begin(),
                  reduced_.harmonics.end(),
                  [](const auto &a, const auto &b) { return a.number < b.number; });
      }

      const Communicator    &communicator_;
      const CyclicBody       sector_;
      ReducedBody            reduced_;
      std::vector<SectorRow> rows_, ring_rows_;
      /** Made by reduce(). */
      std::optional<CyclicSector> condensed_;
      SectorMatrix                coriolis_, spin_stiffness_;
      Found                       own_;
      ResidualSum                 residual_;
    };
  } // namespace

  ReducedBody reduce_body(const Model            &model,
                          const unsigned int      body,
                          const ReductionOptions &options,
                          const Communicator     &communicator)
  {
    return BodyReducer(model, body, options, communicator).reduce();
  }
} // namespace vfife
