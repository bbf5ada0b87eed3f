// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/dynamics/operator/vfife_operator.h>
#include <vfife/element/reduced_stiffness.h>
#include <vfife/element/stable_step.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace vfife
{
  VfifeOperator::VfifeOperator(const Model         &model,
                               const FrameKind      frame,
                               const StiffnessKind  stiffness,
                               const Communicator  &communicator,
                               const OperatorLayout layout)
    : communicator_(communicator)
    , frame_(frame)
    , stiffness_(stiffness)
    , layout_(layout)
    , rank_of_element_(assign_elements(model, communicator.size()))
    , body_packs_(make_packs(model, rank_of_element_, communicator.rank(), layout.share_constants))
    , partition_(make_partition(model, body_packs_, rank_of_element_, communicator.rank()))
    , halo_(model, partition_, rank_of_element_, communicator)
    , kernels_(&select_kernels(frame, layout.instruction_set))
  {
    // 1. Constants, masses and frequency of each congruence class; groups of packs, two a body.
    compute_class_data(model);
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        add_group(model, b, true);
        add_group(model, b, false);
      }
    // 2. What kernels see of a group: pointers, so only now that no group moves any more.
    for (Group &group : groups_)
      group.packs = {group.element.size() / n_lanes,
                     group.nodes.data(),
                     group.constants.data(),
                     group.constants_row.empty() ? nullptr : group.constants_row.data(),
                     group.hourglass.empty() ? nullptr : group.hourglass.data()};

    // 3. Lumped masses, those of elements of other ranks included.
    masses_.reserve(partition_.n_local());
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (const std::uint32_t i : partition_.nodes(b))
        masses_.push_back(
          model.bodies[b].node_masses()[partition_.global_node[i] - model.bodies[b].first_node]);

    // 4. Room for what a pass measures of each element of a group.
    std::size_t largest_group = 0;
    for (const Group &group : groups_)
      largest_group = std::max(largest_group, group.element.size());
    element_energies_.resize(largest_group);
    element_jacobians_.resize(largest_group);
    find_limiting_element(model);
  }

  void VfifeOperator::compute_class_data(const Model &model)
  {
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body      &body  = model.bodies[b];
        const BodyPacks &packs = body_packs_[b];
        ClassData        data;
        for (const std::uint32_t e : packs.classes.representative)
          {
            // One element stands for all that are congruent with it.
            // Constants of the kernel from the undeformed element.
            const auto reduced =
              compute_reduced_stiffness(body.stress_free_nodes(e), body.material(e), stiffness_);
            const auto mass = compute_lumped_mass(body.element_nodes(e), body.material(e).density);

            data.constants.resize(data.constants.size() + n_element_constants);
            write_constants(reduced,
                            body.material(e),
                            data.constants.data() + data.constants.size() - n_element_constants);
            // Mass scaling: own step 2/omega below the target, then mass times (target/own step)^2.
            const double frequency =
              compute_largest_frequency(expand(reduced, body.material(e)), mass);
            const double scale =
              std::max(1., std::pow(0.5 * frequency * layout_.mass_scaling_step, 2));
            std::array<double, 8> masses;
            for (unsigned int i = 0; i < 8; ++i)
              masses[i] = scale * mass[i];
            data.masses.push_back(masses);
            data.frequency.push_back(frequency / std::sqrt(scale));
          }
        class_data_.push_back(std::move(data));

        // Local nodes of the elements of this rank.
        std::vector<std::array<std::uint32_t, 8>> local(packs.elements.size());
        for (std::size_t row = 0; row < local.size(); ++row)
          for (unsigned int i = 0; i < 8; ++i)
            local[row][i] =
              partition_.local_node[body.first_node + body.elements()[packs.elements[row]][i]];
        local_elements_.push_back(std::move(local));
        first_element_.push_back(body.first_element);
      }
  }

  void VfifeOperator::add_group(const Model &model, const unsigned int b, const bool shared)
  {
    const BodyPacks &packs = body_packs_[b];
    const auto      &rows  = shared ? packs.shared_packs : packs.own_packs;
    if (rows.empty())
      return;

    // Nodes as [pack][node][lane]. Unused lanes read and write the dummy node behind the last one.
    const std::uint32_t dummy = partition_.n_local();
    const ClassData    &data  = class_data_[b];
    Group               group;
    group.n_at_border = shared ? packs.n_shared_at_border : packs.n_own_at_border;
    group.nodes.resize(8 * rows.size());
    for (std::size_t slot = 0; slot < rows.size(); ++slot)
      {
        const std::size_t pack = slot / n_lanes, lane = slot % n_lanes;
        const bool        used = rows[slot] != Partition::absent;
        group.element.push_back(used ? model.bodies[b].first_element + packs.elements[rows[slot]]
                                     : Partition::absent);
        for (unsigned int i = 0; i < 8; ++i)
          group.nodes[(pack * 8 + i) * n_lanes + lane] =
            used ? local_elements_[b][rows[slot]][i] : dummy;
      }
    // One row of constants a pack, or constants of each lane.
    if (shared)
      {
        // The lanes of a pack are turned copies of one element: the kernel finds its one row.
        group.constants     = data.constants;
        group.constants_row = packs.shared_class;
      }
    else
      copy_own_constants(data.constants, packs, group);
    groups_.push_back(std::move(group));
  }

  void VfifeOperator::copy_own_constants(const std::vector<double> &class_constants,
                                         const BodyPacks           &packs,
                                         Group                     &group) const
  {
    // [pack][constant][lane]; in single precision the hourglass block has an array of its own.
    const std::vector<std::uint32_t> &rows = packs.own_packs;
    const unsigned int                n_kept =
      n_element_constants - (layout_.single_hourglass ? n_hourglass_constants : 0);
    group.constants.assign(rows.size() * n_kept, 0.);
    if (layout_.single_hourglass)
      group.hourglass.assign(rows.size() * n_hourglass_constants, 0.f);
    for (std::size_t slot = 0; slot < rows.size(); ++slot)
      {
        if (rows[slot] == Partition::absent)
          continue;
        const std::size_t pack = slot / n_lanes, lane = slot % n_lanes;
        const double     *from =
          class_constants.data() +
          static_cast<std::size_t>(packs.classes.class_of[rows[slot]]) * n_element_constants;
        unsigned int kept = 0;
        for (unsigned int k = 0; k < n_element_constants; ++k)
          if (layout_.single_hourglass && k >= start_of_hourglass_constants &&
              k < start_of_hourglass_constants + n_hourglass_constants)
            group.hourglass[(pack * n_hourglass_constants + k - start_of_hourglass_constants) *
                              n_lanes +
                            lane] = from[k];
          else
            group.constants[(pack * n_kept + kept++) * n_lanes + lane] = from[k];
      }
  }

  void VfifeOperator::find_limiting_element(const Model &model)
  {
    // The worst class of this rank, then of all.
    double       largest = 0;
    unsigned int body = 0, element = 0;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (std::size_t c = 0; c < class_data_[b].frequency.size(); ++c)
        if (class_data_[b].frequency[c] > largest)
          {
            largest = class_data_[b].frequency[c];
            body    = b;
            element = body_packs_[b].classes.representative[c];
          }

    limiting_element_.frequency = communicator_.max(largest);
    // Several ranks may hold an element of the worst class: the lowest number is reported.
    const double none = model.n_elements();
    const double global =
      largest == limiting_element_.frequency ? model.bodies[body].first_element + element : none;
    const double first = communicator_.min(global);
    for (const Body &candidate : model.bodies)
      if (first >= candidate.first_element &&
          first < candidate.first_element + candidate.n_elements())
        {
          limiting_element_.body    = candidate.name();
          limiting_element_.element = static_cast<unsigned int>(first) - candidate.first_element;
          limiting_element_.centroid =
            compute_centroid(candidate.element_nodes(limiting_element_.element));
        }
  }

  double VfifeOperator::stable_step_without(const unsigned int n) const
  {
    // The n + 1 largest frequencies of this rank's elements, then of all: the last one stays.
    std::vector<double> worst;
    for (unsigned int b = 0; b < class_data_.size(); ++b)
      // A class counts as often as it has members, but n + 1 of them are enough.
      for (std::size_t c = 0; c < class_data_[b].frequency.size(); ++c)
        worst.insert(worst.end(),
                     std::min(body_packs_[b].classes.size[c], n + 1),
                     class_data_[b].frequency[c]);
    const auto keep_worst = [n](std::vector<double> &frequencies) {
      // Of a model with no more than n elements the last one stays.
      const std::size_t kept = std::min<std::size_t>(frequencies.size(), n + 1);
      std::partial_sort(frequencies.begin(),
                        frequencies.begin() + kept,
                        frequencies.end(),
                        std::greater<double>());
      frequencies.resize(kept);
    };
    keep_worst(worst);
    worst = communicator_.all_gather(worst);
    keep_worst(worst);
    return 2. / worst.back();
  }

  template <typename Add>
  void VfifeOperator::for_all_packs(NodeField &forces, const Add &add)
  {
    forces.set_zero();
    // What neighbours wait for first; they and this rank compute the rest while messages travel.
    for (const Group &group : groups_)
      add(group, 0, group.n_at_border);
    halo_.start(forces);
    for (const Group &group : groups_)
      add(group, group.n_at_border, group.packs.n_packs);
    halo_.finish(forces);
  }

  void VfifeOperator::compute_internal_forces(const NodeField &positions, NodeField &forces)
  {
    for_all_packs(forces, [&](const Group &group, const std::size_t first, const std::size_t last) {
      kernels_->add_internal_forces(group.packs, first, last, positions.data(), forces.data());
    });
  }

  ElementMeasures VfifeOperator::measure_internal_forces(const NodeField &positions,
                                                         NodeField       &forces)
  {
    ElementMeasures measures;
    measures.least_jacobian = std::numeric_limits<double>::infinity();
    for_all_packs(forces, [&](const Group &group, const std::size_t first, const std::size_t last) {
      kernels_->measure_internal_forces(group.packs,
                                        first,
                                        last,
                                        positions.data(),
                                        forces.data(),
                                        element_energies_.data(),
                                        element_jacobians_.data());
      // In the order of the packs, so that the sum does not depend on when messages arrive.
      for (std::size_t slot = n_lanes * first; slot < n_lanes * last; ++slot)
        if (group.element[slot] != Partition::absent)
          {
            measures.strain_energy += element_energies_[slot];
            if (element_jacobians_[slot] < measures.least_jacobian)
              {
                measures.least_jacobian = element_jacobians_[slot];
                measures.least_element  = group.element[slot];
              }
          }
    });
    // The least Jacobian stays that of this rank: check_elements() asks the others.
    measures.strain_energy = communicator_.sum(measures.strain_energy);
    return measures;
  }

  std::vector<double> VfifeOperator::compute_relaxation_masses(const double fraction)
  {
    // The halo adds up vectors, and so it adds to shared nodes what elements of other ranks give:
    // one component of the field has the masses.
    NodeField sums = make_field(); // in x
    for (unsigned int b = 0; b < body_packs_.size(); ++b)
      for (std::size_t row = 0; row < local_elements_[b].size(); ++row)
        {
          // Masses times (omega/(2 fraction))^2 make the largest frequency 2 fraction.
          const std::uint32_t c     = body_packs_[b].classes.class_of[row];
          const double        scale = std::pow(class_data_[b].frequency[c] / (2 * fraction), 2);
          for (unsigned int i = 0; i < 8; ++i)
            sums.add(local_elements_[b][row][i],
                     scale * class_data_[b].masses[c][i] * Vector3::UnitX());
        }
    halo_.add_over_ranks(sums);

    std::vector<double> masses(partition_.n_local());
    for (std::size_t i = 0; i < masses.size(); ++i)
      masses[i] = sums.value(i)[0];
    return masses;
  }

  const std::vector<std::uint32_t> &VfifeOperator::elements_at(const std::uint32_t local_node) const
  {
    // All elements are looked through, once for a node: those that are asked for are few.
    const auto [entry, is_new] = elements_at_.try_emplace(local_node);
    if (is_new)
      for (unsigned int b = 0; b < local_elements_.size(); ++b)
        for (std::size_t row = 0; row < local_elements_[b].size(); ++row)
          if (std::find(local_elements_[b][row].begin(),
                        local_elements_[b][row].end(),
                        local_node) != local_elements_[b][row].end())
            entry->second.push_back(first_element_[b] + body_packs_[b].elements[row]);
    return entry->second;
  }

  void VfifeOperator::add_over_ranks(NodeField &values)
  {
    halo_.add_over_ranks(values);
  }

  const Partition &VfifeOperator::partition() const
  {
    return partition_;
  }

  FrameKind VfifeOperator::frame() const
  {
    return frame_;
  }

  StiffnessKind VfifeOperator::stiffness() const
  {
    return stiffness_;
  }

  NodeField VfifeOperator::make_field() const
  {
    return NodeField(partition_.n_local() + 1);
  }

  const LimitingElement &VfifeOperator::limiting_element() const
  {
    return limiting_element_;
  }

  const std::vector<double> &VfifeOperator::masses() const
  {
    return masses_;
  }

  std::size_t VfifeOperator::n_local_elements() const
  {
    return partition_.elements.size();
  }

  std::size_t VfifeOperator::n_congruence_classes() const
  {
    std::size_t n = 0;
    for (const BodyPacks &packs : body_packs_)
      n += packs.classes.size.size();
    return n;
  }

  const char *VfifeOperator::instruction_set() const
  {
    return name_of(layout_.instruction_set);
  }

  void VfifeOperator::use_kernels(const FrameKind frame, const InstructionSet instruction_set)
  {
    kernels_                = &select_kernels(frame, instruction_set);
    frame_                  = frame;
    layout_.instruction_set = instruction_set;
  }

  std::size_t VfifeOperator::n_own_elements() const
  {
    std::size_t n = 0;
    for (const BodyPacks &packs : body_packs_)
      for (const std::uint32_t row : packs.own_packs)
        n += row != Partition::absent;
    return n;
  }

  unsigned int VfifeOperator::own_bytes() const
  {
    // The triad of the undeformed element is for the three-node frame.
    const unsigned int triad = frame_ == FrameKind::polar ? 9 : 0;
    return sizeof(double) * (n_element_constants - triad - n_hourglass_constants) +
           (layout_.single_hourglass ? sizeof(float) : sizeof(double)) * n_hourglass_constants;
  }
} // namespace vfife
