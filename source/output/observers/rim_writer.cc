// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/column_names.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/measures/body_motion.h>
#include <vfife/output/observers/rim_writer.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <utility>

namespace vfife
{
  namespace
  {
    /** All columns in the order of the file, which is that of the coefficients. */
    SampleColumns<RimWaves> list_columns(const unsigned int n_diameters)
    {
      SampleColumns<RimWaves> columns;
      std::size_t             k   = 0;
      const auto              add = [&](const std::string &name) {
        columns.add(name, "um", [k](const RimWaves &waves) { return waves[k]; });
        ++k;
      };
      for (const std::string component : column::cylindrical_axes)
        {
          add(component + " cos 0");
          for (unsigned int n = 1; n <= n_diameters; ++n)
            for (const char *wave : {" cos ", " sin "})
              add(component + wave + std::to_string(n));
        }
      return columns;
    }
  } // namespace

  unsigned int RimWriter::count_diameters(const Model &model)
  {
    const unsigned int teeth = model.only_transmission()->driven_teeth;
    // Waves shorter than two teeth cannot be told from longer ones.
    return std::min(largest_diameters, teeth > 0 ? (teeth - 1) / 2 : 0);
  }

  RimWriter::RimWriter(const OutputFolder &folder,
                       const Model        &model,
                       const std::uint64_t steps_between,
                       Measure             measure)
    : SampledTable(folder, "rim.csv", list_columns(count_diameters(model)), steps_between)
    , folder_(folder)
    , measure_(std::move(measure))
    , n_diameters_(count_diameters(model))
  {
  }

  void RimWriter::find_nodes(const Model &model, const Partition &partition)
  {
    const Body &gear = model.bodies[model.only_transmission()->driven];
    const auto &rim  = model.only_transmission()->driven_rim;
    double      mass = 0;
    for (const unsigned int i : rim)
      mass += gear.node_masses()[i];

    // Where the gear turns about the very line of its sectors, node i of the first one is node i +
    // k n of sector k, turned; elsewhere all nodes are those of one sector.
    const Matrix3 into_body    = gear.placement.rotation.transpose();
    const Vector3 point        = into_body * (gear.axis.point - gear.placement.translation),
                  direction    = into_body * gear.axis.direction;
    constexpr double round_off = 1e-12;
    const bool       is_cyclic =
      std::max(point.head<2>().norm(), direction.head<2>().norm()) <= round_off;
    const BodyStructure  one_sector(1, gear.n_nodes(), gear.n_elements());
    const BodyStructure &structure = is_cyclic ? gear.structure() : one_sector;
    n_sectors_                     = structure.n_sectors();
    std::map<unsigned int, std::uint32_t> place_of;
    std::set<unsigned int>                pairs;
    nodes_.clear();
    places_.clear();
    for (const unsigned int node : rim)
      {
        const std::uint32_t local = partition.find_owned(gear.first_node + node);
        if (local == Partition::absent)
          continue;
        const unsigned int first = structure.first_copy(node), sector = structure.sector_of(node);
        const auto [place, is_new] = place_of.emplace(first, places_.size());
        if (is_new)
          {
            const Vector3 &X    = gear.node_positions()[first];
            const Matrix3  axes = compute_cylindrical_axes(gear, X);
            places_.push_back({X - point,
                               gear.node_masses()[first] / mass * axes.transpose(),
                               std::atan2(axes(1, 0), axes(0, 0))});
          }
        nodes_.push_back({local, place->second, sector});
        pairs.insert(std::min(sector, n_sectors_ - sector));
      }
    // As they lie in memory.
    std::sort(nodes_.begin(), nodes_.end(), [](const Node &a, const Node &b) {
      return a.local < b.local;
    });

    // Sector k and sector -k have the same cosines and opposite sines.
    const double angle = 2. * pi / n_sectors_;
    cosines_.resize(pairs.size(), n_diameters_ + 1);
    sines_.resize(pairs.size(), n_diameters_ + 1);
    columns_.assign(n_sectors_, 0);
    turns_back_.clear();
    unsigned int column = 0;
    for (const unsigned int k : pairs)
      {
        columns_[k] = columns_[(n_sectors_ - k) % n_sectors_] = column;
        for (unsigned int wave = 0; wave <= n_diameters_; ++wave)
          {
            cosines_(column, wave) = std::cos(angle * (wave * k % n_sectors_));
            sines_(column, wave)   = std::sin(angle * (wave * k % n_sectors_));
          }
        ++column;
      }
    for (unsigned int k = 0; k < n_sectors_; ++k)
      turns_back_.push_back(rotation_about(Vector3::UnitZ(), -angle * k));
    even_.resize(3 * places_.size(), pairs.size());
    odd_.resize(3 * places_.size(), pairs.size());
  }

  void RimWriter::add_rows(const Model &model, const State &state)
  {
    add_row(state, measure_ ? measure_(n_diameters_) : measure_positions(model, state));
  }

  RimWaves RimWriter::measure_positions(const Model &model, const State &state)
  {
    const unsigned int b    = model.only_transmission()->driven;
    const Body        &gear = model.bodies[b];
    if (partition_ != state.partition)
      find_nodes(model, *state.partition);
    partition_ = state.partition;
    // Sums over whole bodies only where the state does not tell.
    const Matrix3 back =
      (state.body_motion.size() == model.bodies.size()
         ? compute_turn(gear, state.body_motion[b])
         : compute_body_motions(model, state, folder_.communicator())[b].rotation)
        .transpose();
    // 1. u = R^T (x - c) - (X - c) in axes that are turned with the sector, where X is that of the
    // first one; sums and differences of sectors k and -k.
    const Vector3        point = gear.axis.point;
    std::vector<Matrix3> onto_first;
    for (const Matrix3 &turn_back : turns_back_)
      onto_first.push_back(turn_back * gear.placement.rotation.transpose() * back);
    even_.setZero();
    odd_.setZero();
    for (const Node &node : nodes_)
      {
        const Vector3 u = onto_first[node.sector] * (state.node_position(node.local) - point) -
                          places_[node.place].at_rest;
        const unsigned int column = columns_[node.sector];
        even_.col(column).segment<3>(3 * node.place) += u;
        if (2 * node.sector < n_sectors_)
          odd_.col(column).segment<3>(3 * node.place) += u;
        else
          odd_.col(column).segment<3>(3 * node.place) -= u;
      }
    // 2. The waves of each node of the first sector over the sectors: sum u cos n k, sum u sin n k.
    as_cos_.noalias() = even_ * cosines_;
    as_sin_.noalias() = odd_ * sines_;

    // 3. u = c_0 + sum_n (c_n cos n alpha + s_n sin n alpha),  c_0 = sum share u,
    // c_n = 2 sum share u cos n alpha,  s_n alike: means over the rim, weighted with its mass.
    // alpha is that of the node in the first sector and that of the sector.
    const unsigned int per_component = 2 * n_diameters_ + 1;
    RimWaves           sums(3 * per_component, 0.); // cos 0, cos 1, sin 1... of r, of theta, of z
    Eigen::Map<Eigen::MatrixX3d> coefficients(sums.data(), per_component, 3);
    for (std::size_t i = 0; i < places_.size(); ++i)
      {
        const Matrix3 weights = 1e3 * places_[i].weights;
        coefficients.row(0) += (weights * as_cos_.col(0).segment<3>(3 * i)).transpose();
        const std::complex<double> turn  = std::polar(1., places_[i].angle);
        std::complex<double>       power = 2.;
        for (unsigned int n = 1; n <= n_diameters_; ++n)
          {
            power *= turn;
            const Vector3 cosine = weights * as_cos_.col(n).segment<3>(3 * i),
                          sine   = weights * as_sin_.col(n).segment<3>(3 * i);
            coefficients.row(2 * n - 1) +=
              (power.real() * cosine - power.imag() * sine).transpose();
            coefficients.row(2 * n) += (power.imag() * cosine + power.real() * sine).transpose();
          }
      }
    folder_.communicator().sum(sums);
    return sums;
  }
} // namespace vfife
