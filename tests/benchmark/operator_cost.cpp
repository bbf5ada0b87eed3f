// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "operator_cost.h"
#include "machine_ceilings.h"

#include <vfife/base/process/wall_clock.h>
#include <vfife/base/sample_measures.h>
#include <vfife/dynamics/motion/nodal_update.h>
#include <vfife/element/frame.h>

namespace vfife
{
  namespace
  {
    /** Lanes of the kernels of each set, in the order of InstructionSet. */
    constexpr std::array<unsigned int, 4>   lanes = {{1, 2, 4, 8}};
    constexpr std::array<InstructionSet, 4> sets  = {{InstructionSet::generic,
                                                      InstructionSet::sse2,
                                                      InstructionSet::avx2,
                                                      InstructionSet::avx512}};

    /** Per round. */
    struct Samples
    {
      std::vector<double> rate, forces, update, arithmetic, arithmetic_share, bandwidth,
        bandwidth_share, gain;
    };

    /** One variant in one round. Times are in s an element and step; @p plain likewise, @p
     * bandwidth in GB/s, @p arithmetic in GFLOP/s, measured next to it. */
    void measure(BenchmarkCase     &subject,
                 const FrameKind    frame,
                 const unsigned int set,
                 const unsigned int steps,
                 const double       plain,
                 const double       bandwidth,
                 const double       arithmetic,
                 Samples           &samples)
    {
      // Forces and update of an element and step [s].
      const auto   time = subject.measure(frame, sets[set], steps);
      const double step = time[0] + time[1];
      // Million element-steps a second, ns; shares are 100 (flops or bytes)/time over what the core
      // can do.
      samples.rate.push_back(1e-6 / step);
      samples.forces.push_back(1e9 * time[0]);
      samples.update.push_back(1e9 * time[1]);
      samples.arithmetic.push_back(arithmetic);
      samples.arithmetic_share.push_back(100e-9 * flops_of(frame) / step / arithmetic);
      samples.bandwidth.push_back(bandwidth);
      samples.bandwidth_share.push_back(100e-9 * subject.bytes() / step / bandwidth);
      samples.gain.push_back(plain / step);
    }
  } // namespace

  double flops_of(const FrameKind frame)
  {
    return frame == FrameKind::polar ? 1080 : 900;
  }

  BenchmarkCase::BenchmarkCase(const std::string   &mesh_name,
                               const Model         &model,
                               const StiffnessKind  stiffness_kind,
                               const OperatorLayout operator_layout,
                               const PlainElements &plain,
                               const Communicator  &communicator)
    : mesh(mesh_name)
    , layout(operator_layout.share_constants    ? "shared"
             : operator_layout.single_hourglass ? "own, single"
                                                : "own")
    , stiffness(stiffness_kind)
    , model_(model)
    , plain_(plain)
    , operator_(model, FrameKind::polar, stiffness, communicator, operator_layout)
    , positions_(operator_.make_field())
    , velocities_(operator_.make_field())
    , forces_(operator_.make_field())
  {
    // Turning and a little strained, so that no number of the kernels is special.
    const Partition &partition = operator_.partition();
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (const std::uint32_t i : partition.nodes(b))
        {
          const Body    &body = model.bodies[b];
          const Vector3 &X    = body.node_positions()[partition.global_node[i] - body.first_node];
          const Vector3  x    = body.placement(X + 1e-4 * Vector3(X[1], X[0], -X[2]));
          positions_.set(i, x);
          positions_.set_number(i, 1. / operator_.masses()[i]);
          velocities_.set(i, body.rate * body.axis.direction.cross(x - body.axis.point));
          velocities_.set_number(i, operator_.masses()[i]);
        }
    for (const Vector3 &X : model.bodies.back().node_positions())
      plain_positions_.insert(plain_positions_.end(),
                              {1.0001 * X[0], X[1] + 1e-4 * X[0], X[2], 0.});
    plain_forces_.resize(plain_positions_.size());
  }

  double BenchmarkCase::update(const InstructionSet set)
  {
    const double     start     = processor_time();
    const Partition &partition = operator_.partition();
    for (unsigned int b = 0; b < model_.bodies.size(); ++b)
      {
        const Body &body = model_.bodies[b];
        BodyDamping damping;
        damping.zeta           = 1000;
        damping.rigid.omega    = body.rate * body.axis.direction;
        damping.rigid.velocity = -damping.rigid.omega.cross(body.axis.point);
        update_nodes(partition.first_local_node[b],
                     partition.first_local_node[b + 1],
                     0.5 * operator_.limiting_element().stable_step(),
                     damping,
                     UpdateAxis::of(body),
                     {partition.owned.data(),
                      forces_.data(),
                      positions_.data(),
                      velocities_.data(),
                      positions_.data(),
                      velocities_.data()},
                     nullptr,
                     set);
      }
    return processor_time() - start;
  }

  std::array<double, 2>
  BenchmarkCase::measure(const FrameKind frame, const InstructionSet set, const unsigned int steps)
  {
    operator_.use_kernels(frame, set);
    std::array<double, 2> time = {{0., 0.}};
    // The first step fills the caches.
    for (unsigned int step = 0; step <= steps; ++step)
      {
        if (step == 1)
          time = {{0., 0.}};
        const double start = processor_time();
        operator_.compute_internal_forces(positions_, forces_);
        time[0] += processor_time() - start;
        time[1] += update(set);
      }
    for (double &t : time)
      t /= steps * static_cast<double>(operator_.n_local_elements());
    return time;
  }

  double BenchmarkCase::measure_plain(const FrameKind frame)
  {
    const double start = processor_time();
    plain_.add_internal_forces(frame, plain_positions_.data(), plain_forces_.data());
    // The update is that by plain numbers of all nodes, however few elements have been measured.
    const double forces = (processor_time() - start) / plain_.size();
    operator_.compute_internal_forces(positions_, forces_);
    return forces + update(InstructionSet::generic) / operator_.n_local_elements();
  }

  double BenchmarkCase::bytes() const
  {
    // A node: position read, force set to zero, read and written; the update reads the force and
    // reads and writes position and velocity.
    const double a_node = 32 * (1 + 1 + 2 + 1 + 2 + 2);
    const double own    = operator_.own_bytes() * static_cast<double>(operator_.n_own_elements());
    const double n      = operator_.n_local_elements();
    return 8 * sizeof(std::uint32_t) +
           (own + a_node * static_cast<double>(operator_.partition().n_local())) / n;
  }

  Table compare_operators(std::vector<std::unique_ptr<BenchmarkCase>> &cases,
                          const unsigned int                           repeats,
                          const unsigned int                           steps)
  {
    using Variant = std::array<std::array<Samples, 4>, n_frame_kinds>;
    // Rounds outermost: whatever slows the machine for a while falls on all variants of that round,
    // and medians are taken over rounds.
    std::vector<Variant> samples(cases.size());
    MemoryTriad          triad;
    for (unsigned int round = 0; round < repeats; ++round)
      for (std::size_t c = 0; c < cases.size(); ++c)
        for (unsigned int f = 0; f < n_frame_kinds; ++f)
          {
            // What a variant is compared with is measured next to it: clock and neighbours of the
            // core change from round to round.
            const FrameKind frame     = frame_choices()[f].second;
            const double    plain     = cases[c]->measure_plain(frame);
            const double    bandwidth = triad.measure();
            for (unsigned int set = 0; set < sets.size(); ++set)
              if (is_available(sets[set]))
                measure(*cases[c],
                        frame,
                        set,
                        steps,
                        plain,
                        bandwidth,
                        measure_multiply_adds(lanes[set]),
                        samples[c][f][set]);
          }

    Table table;
    for (const char *name : {"mesh", "layout", "stiffness", "frame", "instruction set"})
      table.add_text_column(name);
    table.add_column("element-steps", "1e6/s");
    table.add_column("internal forces", "ns");
    table.add_column("nodal update", "ns");
    table.add_column("multiply-adds of the core", "GFLOP/s");
    table.add_column("share of multiply-adds", "%");
    table.add_column("triad of the core", "GB/s");
    table.add_column("share of bandwidth", "%");
    table.add_column("gain over plain", "-");
    for (std::size_t c = 0; c < cases.size(); ++c)
      for (unsigned int f = 0; f < n_frame_kinds; ++f)
        for (unsigned int set = 0; set < sets.size(); ++set)
          if (const Samples &s = samples[c][f][set]; !s.rate.empty())
            table.add_row({cases[c]->mesh,
                           cases[c]->layout,
                           word_of(cases[c]->stiffness, stiffness_choices()),
                           frame_choices()[f].first,
                           name_of(sets[set]),
                           median_of(s.rate),
                           median_of(s.forces),
                           median_of(s.update),
                           median_of(s.arithmetic),
                           median_of(s.arithmetic_share),
                           median_of(s.bandwidth),
                           median_of(s.bandwidth_share),
                           median_of(s.gain)});
    return table;
  }
} // namespace vfife
