// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/element/stress.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/model.h>
#include <vfife/model/state.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/measures/node_stresses.h>
#include <vfife/output/observers/part_stress_watch.h>

#include <cmath>
#include <iterator>
#include <set>

namespace vfife
{
  namespace
  {
    /** Nodes of the sets that a body has, without those of others. */
    std::vector<unsigned int> nodes_of(const Body                      &body,
                                       const std::vector<const char *> &sets,
                                       const std::vector<const char *> &without)
    {
      std::set<unsigned int> nodes;
      for (const char *set : sets)
        if (body.has_node_set(set))
          nodes.insert(body.node_set(set).begin(), body.node_set(set).end());
      for (const char *set : without)
        if (body.has_node_set(set))
          for (const unsigned int node : body.node_set(set))
            nodes.erase(node);
      return {nodes.begin(), nodes.end()};
    }
  } // namespace

  PartStresses::PartStresses(const Model &model)
    : model_(model)
  {
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body &body = model.bodies[b];
        const auto  add  = [&](const char                      *name,
                             const std::vector<const char *> &sets,
                             const std::vector<const char *> &without) {
          std::vector<unsigned int> nodes = nodes_of(body, sets, without);
          if (!nodes.empty())
            parts_.push_back({body.name() + " " + name, b, std::move(nodes)});
        };
        add("web", {node_set::web_front, node_set::web_back}, {});
        add("rim", {node_set::rim}, {node_set::concave_fillet, node_set::convex_fillet});
        add("hub", {node_set::hub}, {});
      }
    largest_.resize(parts_.size());
  }

  void PartStresses::look(const std::function<double(unsigned int node)> &von_mises)
  {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (const unsigned int node : parts_[p].nodes)
        {
          const double stress = von_mises(model_.bodies[parts_[p].body].first_node + node);
          if (stress > largest_[p].stress)
            largest_[p] = {stress, node};
        }
  }

  std::pair<double, double> PartStresses::place_of(const std::size_t part) const
  {
    const Body    &body = model_.bodies[parts_[part].body];
    const Vector3 &x    = body.node_positions()[largest_[part].node];
    return {std::hypot(x[0], x[1]), x[2]};
  }

  NamedFigures PartStresses::list_figures() const
  {
    NamedFigures figures;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (largest_[p].stress > 0)
        {
          const auto [radius, height] = place_of(p);
          const std::string of        = parts_[p].name + figure_name::stress_of_part;
          figures.push_back({of, {largest_[p].stress, "MPa"}});
          figures.push_back({of + ", at radius", {radius, "mm"}});
          figures.push_back({of + ", at height", {height, "mm"}});
        }
    return figures;
  }

  void PartStresses::write_to(Log &log) const
  {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (largest_[p].stress > 0)
        log.line(parts_[p].name,
                 ": largest von Mises stress of a node ",
                 largest_[p].stress,
                 " MPa, ",
                 place_of(p).first,
                 " mm from the axis, at ",
                 place_of(p).second,
                 " mm along the axis from the apex");
  }

  void PartStresses::serialize(ByteStream &stream)
  {
    stream.pass_records(largest_);
    stream.require(largest_.size() == parts_.size(), "stresses of other parts");
    for (std::size_t p = 0; p < parts_.size(); ++p)
      stream.require(largest_[p].node < model_.bodies[parts_[p].body].n_nodes(),
                     "a node does not exist");
  }

  PartStressWatch::PartStressWatch(const OutputFolder &folder,
                                   const Model        &model,
                                   const std::uint64_t steps_between,
                                   const StiffnessKind stiffness,
                                   const FrameKind     frame)
    : folder_(folder)
    , steps_between_(steps_between)
    , stiffness_(stiffness)
    , frame_(frame)
    , stresses_(model)
  {
  }

  bool PartStressWatch::due(const State &state) const
  {
    return state.step % steps_between_ == 0;
  }

  void PartStressWatch::observe(const Model &model, const State &state)
  {
    if (!due(state))
      return;
    const std::vector<std::array<double, 6>> stresses =
      compute_node_stresses(model, state, stiffness_, frame_, folder_.communicator());
    stresses_.look([&](const unsigned int node) {
      return von_mises(Eigen::Map<const Stress>(stresses[node].data()));
    });
  }

  std::string PartStressWatch::part_name() const
  {
    return "part stresses";
  }

  void PartStressWatch::serialize(ByteStream &stream)
  {
    stresses_.serialize(stream);
  }
} // namespace vfife
