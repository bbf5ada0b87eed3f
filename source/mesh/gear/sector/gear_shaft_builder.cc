// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/mesh/gear/sector/gear_shaft_builder.h>
#include <vfife/mesh/node_set_names.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vfife
{
  namespace
  {
    /** Least length of a row that joins columns, and of what it leaves of its band, over the best
     * length. */
    constexpr double least_part = .5;

    /** Adds a place where there is none yet. */
    void add_distinct(const double place, std::set<double> &places)
    {
      const auto next = places.lower_bound(place - GearShaftOptions::tolerance);
      if (next == places.end() || *next > place + GearShaftOptions::tolerance)
        places.insert(place);
    }
  } // namespace

  // The grid in the meridian, circle 0 at the largest radius; cells between lines of the hub share
  // the bore's nodes, and rows outside the bore keep clear of the hub:
  //
  //      line   0    1    2    3    4    5    6
  //      circle 0                        o----o      a shoulder, apart from the hub
  //                 |---- hub -----|     |    |
  //      bore   o----o----o----o----o----o----o      the bore's columns
  //             | joins three columns into one |
  //             o----o----o----o----o----o----o
  //             |    |    |    |    |    |    |      a third of them
  //             o----o----o----o----o----o----o
  GearShaftBuilder::GearShaftBuilder(const GearShaftOptions &options,
                                     GearSectorCells        &cells,
                                     NodeLayer               bore)
    : options_(options)
    , cells_(cells)
    , bore_(std::move(bore))
    , sections_(options.sections("Shaft"))
  {
    divide_axis();
    divide_radius();
    nodes_.assign(radii_.size(), NodeLayer(heights_.size()));
    inner_.resize(heights_.size());
    std::copy(bore_.begin(), bore_.end(), nodes_[bore_circle_].begin() + first_in_hub_);
  }

  void GearShaftBuilder::divide_axis()
  {
    // The bore's own lines; beyond them, on either side, ends of sections and levels asked for.
    std::vector<double> in_hub;
    for (const auto &line : bore_)
      in_hub.push_back(cells_.position(line.front())[2]);
    std::set<double> below = {in_hub.front()}, above = {in_hub.back()}, ends;
    const auto       add = [&](const double place) {
      if (place < in_hub.front())
        add_distinct(place, below);
      else if (place > in_hub.back())
        add_distinct(place, above);
    };
    for (const ShaftSection &section : sections_)
      for (const double end : {section.from, section.to})
        {
          add(end);
          add_distinct(end, ends);
        }
    for (const double level : options_.levels)
      add(level);
    // Two cells at least between ends that may be faces across the axis: else all nodes of the side
    // between them were nodes of these faces. In the hub there are lines between them.
    for (auto end = std::next(ends.begin()); end != ends.end(); ++end)
      {
        const double from = *std::prev(end), to = *end;
        const bool   divided =
          count_cells(to - from, options_.axial_cell_size) > 1 ||
          (from < in_hub.back() && to > in_hub.front()) ||
          std::any_of(options_.levels.begin(), options_.levels.end(), [&](const double level) {
            return from < level && level < to;
          });
        if (!divided)
          add(.5 * (from + to));
      }

    heights_      = divide_between(below, options_.axial_cell_size);
    first_in_hub_ = heights_.size() - 1;
    heights_.insert(heights_.end(), in_hub.begin() + 1, in_hub.end());
    const std::vector<double> behind = divide_between(above, options_.axial_cell_size);
    heights_.insert(heights_.end(), behind.begin() + 1, behind.end());
  }

  void GearShaftBuilder::divide_radius()
  {
    const Vector3    at_bore     = cells_.position(bore_[0][0]);
    const double     bore_radius = at_bore.head<2>().norm();
    std::set<double> found       = {bore_radius};
    for (const ShaftSection &section : sections_)
      for (const double diameter : {section.outer, section.inner})
        add_distinct(.5 * diameter, found);

    const auto have = [&](const double ShaftSection::*diameter, const double radius) {
      return std::any_of(sections_.begin(), sections_.end(), [&](const ShaftSection &s) {
        return std::abs(.5 * s.*diameter - radius) <= GearShaftOptions::tolerance;
      });
    };
    const bool can_join = (bore_[0].size() - 1) % 3 == 0;
    bool       joined   = false;
    radii_              = {*found.rbegin()};
    for (auto radius = std::next(found.rbegin()); radius != found.rend(); ++radius)
      {
        if (radii_.back() == bore_radius)
          bore_circle_ = radii_.size() - 1;
        const double band = radii_.back() - *radius, length = joining_length(radii_.back());
        if (can_join && !joined && radii_.back() <= bore_radius && band > least_part * length)
          {
            joined          = true;
            joining_circle_ = radii_.size() - 1;
            // The whole band, or a row of the best length and what that leaves.
            const bool whole = band < (1. + least_part) * length;
            radii_.push_back(whole ? *radius : radii_.back() - length);
            if (whole)
              continue;
          }
        // A shoulder between two sides is no part of them: nodes of it lie on neither.
        const bool shoulder =
          (have(&ShaftSection::outer, radii_.back()) && have(&ShaftSection::outer, *radius)) ||
          (have(&ShaftSection::inner, radii_.back()) && have(&ShaftSection::inner, *radius));
        const double       outer = radii_.back();
        const unsigned int rows =
          std::max(shoulder ? 2u : 1u, count_cells(outer - *radius, options_.radial_cell_size));
        for (unsigned int row = 1; row <= rows; ++row)
          radii_.push_back(row == rows ? *radius : outer + (*radius - outer) * row / rows);
      }
    if (!joined)
      joining_circle_ = radii_.size();
  }

  const std::vector<unsigned int> &GearShaftBuilder::bore_line(const unsigned int line) const
  {
    const unsigned int last = bore_.size() - 1;
    return bore_[line <= first_in_hub_ ? 0 : std::min(line - first_in_hub_, last)];
  }

  double GearShaftBuilder::angle_of(const unsigned int node) const
  {
    const Vector3 x = cells_.position(node);
    return polar_angle(x);
  }

  double GearShaftBuilder::joining_length(const double radius) const
  {
    const std::vector<unsigned int> &line = bore_.front();
    const double pitch = std::remainder(angle_of(line.back()) - angle_of(line.front()), 2. * pi);
    return coarsening_row_length * radius * 3. * pitch / (line.size() - 1);
  }

  bool GearShaftBuilder::is_filled(const int line, const int circle) const
  {
    if (line < 0 || line + 1 >= static_cast<int>(heights_.size()) || circle < 0 ||
        circle + 1 >= static_cast<int>(radii_.size()))
      return false;
    const double z        = .5 * (heights_[line] + heights_[line + 1]),
                 diameter = radii_[circle] + radii_[circle + 1];
    return std::any_of(sections_.begin(), sections_.end(), [&](const ShaftSection &s) {
      return s.from < z && z < s.to && s.inner < diameter && diameter < s.outer;
    });
  }

  bool GearShaftBuilder::is_in_hub(const unsigned int line) const
  {
    return line >= first_in_hub_ && line + 1 < first_in_hub_ + bore_.size();
  }

  NodeLayer GearShaftBuilder::nodes_of(const unsigned int circle,
                                       const unsigned int first,
                                       const unsigned int last)
  {
    const unsigned int step = circle > joining_circle_ ? 3 : 1;
    for (unsigned int line = first; line <= last; ++line)
      {
        std::vector<unsigned int> &nodes = nodes_[circle][line];
        if (!nodes.empty())
          continue;
        const auto &columns = bore_line(line);
        for (unsigned int c = 0; c + 1 < columns.size(); c += step)
          {
            const double angle = angle_of(columns[c]), r = radii_[circle];
            nodes.push_back(
              cells_.add_node({r * std::cos(angle), r * std::sin(angle), heights_[line]}));
          }
        nodes.push_back(GearSector::next_sector(nodes.front()));
      }
    return {nodes_[circle].begin() + first, nodes_[circle].begin() + last + 1};
  }

  void GearShaftBuilder::add_cells(const unsigned int circle,
                                   const unsigned int first,
                                   const unsigned int last)
  {
    const NodeLayer outer = nodes_of(circle, first, last),
                    inner = nodes_of(circle + 1, first, last);
    for (const NodeLayer &nodes : {outer, inner})
      cells_.add_to_set(node_set::shaft, nodes);
    if (circle != joining_circle_)
      {
        cells_.add_row(outer, inner);
        return;
      }
    // Half-way between the bore's columns, which need not be equally wide, and equal ones.
    const double radius =
      radii_[circle] + coarsening_row_place * (radii_[circle + 1] - radii_[circle]);
    const auto place = [&](const unsigned int layer, const unsigned int column) {
      const std::vector<unsigned int> &own   = bore_line(first + layer);
      const unsigned int               group = column / 3 * 3;
      const double                     start = angle_of(own[group]);
      const double width = std::remainder(angle_of(own[group + 3]) - start, 2. * pi),
                   part  = std::remainder(angle_of(own[column]) - start, 2. * pi);
      const double angle = start + .5 * (part + width * (column % 3) / 3.);
      return Vector3(radius * std::cos(angle), radius * std::sin(angle), heights_[first + layer]);
    };
    const NodeLayer between = cells_.add_coarsening_row(outer, inner, place);
    cells_.add_to_set(node_set::shaft, between);
    std::copy(between.begin(), between.end(), inner_.begin() + first);
  }

  void GearShaftBuilder::add_sides(const unsigned int line, const unsigned int circle)
  {
    const auto add_side = [&](const char *name, const unsigned int on) {
      cells_.add_to_set(name, {nodes_[on][line], nodes_[on][line + 1]});
    };
    const auto add_end = [&](const unsigned int on) {
      cells_.add_to_set(node_set::shaft_ends, {nodes_[circle][on], nodes_[circle + 1][on]});
      if (circle == joining_circle_)
        cells_.add_to_set(node_set::shaft_ends, NodeLayer{inner_[on]});
    };
    const int i = line, k = circle;
    if (!is_filled(i, k - 1) && !(circle == bore_circle_ && is_in_hub(line)))
      add_side(node_set::shaft_surface, circle);
    if (!is_filled(i, k + 1))
      add_side(node_set::shaft_bore, circle + 1);
    if (!is_filled(i - 1, k))
      add_end(line);
    if (!is_filled(i + 1, k))
      add_end(line + 1);
  }

  void GearShaftBuilder::add()
  {
    cells_.enter(GearRegion::shaft);
    const unsigned int n_circles = radii_.size() - 1, n_lines = heights_.size() - 1;
    // runs of lines without a gap
    for (unsigned int circle = 0; circle < n_circles; ++circle)
      for (unsigned int line = 0; line < n_lines; ++line)
        {
          const unsigned int first = line;
          while (is_filled(line, circle))
            ++line;
          if (line > first)
            add_cells(circle, first, line);
        }
    for (unsigned int circle = 0; circle < n_circles; ++circle)
      for (unsigned int line = 0; line < n_lines; ++line)
        if (is_filled(line, circle))
          add_sides(line, circle);
  }
} // namespace vfife
