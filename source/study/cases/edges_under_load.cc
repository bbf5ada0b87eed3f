// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/text/table.h>
#include <vfife/gear/unloaded_contact/contact_analysis.h>
#include <vfife/study/cases/edges_under_load.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  EdgesUnderLoad::EdgesUnderLoad(const ContactAnalysis &analysis, const unsigned int driver_teeth)
    : driver_teeth_(driver_teeth)
  {
    for (unsigned int i = 0; i < 2; ++i)
      {
        borders_[i].name  = analysis.ends[i].border;
        borders_[i].place = analysis.ends[i].place;
      }
  }

  std::array<double, 2> EdgesUnderLoad::positions() const
  {
    constexpr double      beyond = 1e-3; // of a pitch
    std::array<double, 2> positions;
    for (unsigned int i = 0; i < 2; ++i)
      {
        const double place = borders_[i].place + (i == 0 ? -beyond : beyond);
        positions[i]       = place - std::floor(place);
      }
    return positions;
  }

  void EdgesUnderLoad::observe(const Table &teeth, const std::string &place, const double per_mesh)
  {
    const std::vector<double> &tooth = teeth.numbers(column::tooth_of("pinion")),
                              &force = teeth.numbers(column::force), &at = teeth.numbers(place);
    const std::vector<std::string> &side = teeth.column(column::side).texts;
    for (std::size_t i = 0; i < teeth.n_rows(); ++i)
      {
        if (side[i] != side_name(MeshSide::drive))
          continue;
        // Tooth z - m comes m meshes after tooth 0, and again every turn: of these the passage that
        // is nearest to now.
        const double z        = driver_teeth_;
        double       distance = at[i] / per_mesh + tooth[i];
        distance -= z * std::round(distance / z);
        largest_ = std::max(largest_, force[i]);
        if (distance < borders_[0].place)
          borders_[0].force = std::max(borders_[0].force, force[i]);
        if (distance > borders_[1].place)
          borders_[1].force = std::max(borders_[1].force, force[i]);
      }
  }

  bool EdgesUnderLoad::found() const
  {
    return is_loaded(borders_[0]) || is_loaded(borders_[1]);
  }

  bool EdgesUnderLoad::is_loaded(const Border &border) const
  {
    return border.force > 0.01 * largest_;
  }

  std::string EdgesUnderLoad::explain() const
  {
    std::ostringstream text;
    set_figure_digits(text, 3);
    if (!found())
      {
        text
          << "no edge contact: tooth pairs are in contact only within their path of contact, from "
          << borders_[0].place << " to " << borders_[1].place << " pitches";
        return text.str();
      }
    std::string separator = "edge contact: ";
    for (unsigned int i = 0; i < 2; ++i)
      if (is_loaded(borders_[i]))
        {
          text << separator << borders_[i].name << " at the " << (i == 0 ? "start" : "end")
               << " of the engagement, up to " << std::lround(borders_[i].force) << " N";
          separator = "; ";
        }
    text
      << "; largest force of a tooth pair " << std::lround(largest_)
      << " N. Without load the path of contact is from " << borders_[0].place << " to "
      << borders_[1].place
      << " pitches from the mean contact. Hertzian pressure applies inside the flanks only. At a "
         "sharp edge the pressure is larger and depends on the mesh (Contact/edge relief)";
    return text.str();
  }

  NamedFigures EdgesUnderLoad::list_figures() const
  {
    return {{"largest force before the path of contact", {borders_[0].force, "N"}},
            {"largest force after the path of contact", {borders_[1].force, "N"}},
            {"largest force of a tooth pair", {largest_, "N"}}};
  }

  Json EdgesUnderLoad::json() const
  {
    Json json = {{"edge contact", found()}, {"explanation", explain()}};
    json.update(figures_json({{"path of contact begins", {borders_[0].place, "pitches"}},
                              {"path of contact ends", {borders_[1].place, "pitches"}},
                              {"largest force before it", {borders_[0].force, "N"}},
                              {"largest force after it", {borders_[1].force, "N"}},
                              {"largest force of a tooth pair", {largest_, "N"}}}));
    json["borders"] = {borders_[0].name, borders_[1].name};
    return json;
  }

  NamedFigures write_edge_contact(std::optional<EdgesUnderLoad> edges,
                                  const Table                  &teeth,
                                  const std::string            &place,
                                  const double                  per_mesh,
                                  const OutputFolder           &folder,
                                  Log                          &log)
  {
    if (!edges)
      return {};
    edges->observe(teeth, place, per_mesh);
    if (edges->found())
      log.warning(edges->explain());
    else
      log.line(edges->explain());
    write_json(folder, "edge_contact.json", edges->json());
    return edges->list_figures();
  }
} // namespace vfife
