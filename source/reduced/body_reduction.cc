// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"
#include "residual_sum.h"
#include "ring_parts.h"

#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/reduced/body_reduction.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace vfife
{
  namespace
  {
    /** Throws InputError for nodes that cannot be meant. */
    void check_nodes(const Body                       &body,
                     const std::vector<unsigned int>  &touch_nodes,
                     const std::vector<SectorReading> &readings)
    {
      const std::string    name      = "body \"" + body.name() + "\": ";
      const BodyStructure &structure = body.structure();
      for (const unsigned int node : touch_nodes)
        if (structure.sector_of(node) != 0)
          throw InputError(name + "node " + std::to_string(node) +
                           " with a force is outside sector 0, which has nodes 0 to " +
                           std::to_string(structure.nodes_per_sector() - 1));
      for (const SectorReading &reading : readings)
        for (const auto &weight : reading.weights)
          if (weight.first >= body.n_nodes())
            throw InputError(name + "reading \"" + reading.name + "\" uses node " +
                             std::to_string(weight.first) + " of " +
                             std::to_string(body.n_nodes()) + " nodes");
    }

    /** Touch nodes along the axes of the body frame, then the readings. */
    std::vector<SectorRow> make_rows(const CyclicBody                 &body,
                                     const std::vector<unsigned int>  &touch_nodes,
                                     const std::vector<SectorReading> &readings)
    {
      std::vector<SectorRow> rows;
      for (const unsigned int node : touch_nodes)
        for (unsigned int c = 0; c < 3; ++c)
          rows.push_back(body.make_row({{node, Vector3::Unit(c)}}));
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
    check_nodes(sector.body(), touch_nodes, readings);
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
