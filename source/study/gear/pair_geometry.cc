// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/parameters/declared_section.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/types.h>
#include <vfife/gear/spiral_bevel/gear_pair_options.h>
#include <vfife/mesh/gear/gear_body_sizes.h>
#include <vfife/study/gear/pair_geometry.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vfife
{
  namespace
  {
    /** Diameter of a circle about the axis at the cone distance @p L, @p h over the pitch cone
     * [mm]: 2 (L sin d + h cos d). */
    double diameter_at(const Blank &blank, const double L, const double h)
    {
      return 2 * blank.meridian_point(Vector2(L, h))[0];
    }

    /** Mean spiral angle: as given, else that of the gear's cutter, the mean of its flanks. */
    double find_spiral_angle(const Blank &blank, const GearMemberOptions &gear)
    {
      if (blank.spiral_angle != 0)
        return blank.spiral_angle;
      return (CutterPosition(gear.blank, gear.concave).spiral_angle +
              CutterPosition(gear.blank, gear.convex).spiral_angle) /
             2;
    }

    NamedFigures list_member(const GearMemberOptions &member, const GearMemberOptions &gear)
    {
      const Blank &b     = member.blank;
      const double outer = b.outer_cone_distance, mean = b.mean_cone_distance;
      const auto   angle  = [](const double a) { return Figure{a / degree, "deg"}; };
      const auto   length = [](const double l) { return Figure{l, "mm"}; };
      const double cutter = member.concave.point_radius + member.convex.point_radius;
      return {{"number of teeth", {double(b.teeth), "-"}},
              {"mean spiral angle", angle(find_spiral_angle(b, gear))},
              {"pitch angle", angle(b.pitch_angle)},
              {"face angle", angle(b.face_angle)},
              {"root angle", angle(b.root_angle)},
              {"outer cone distance", length(outer)},
              {"mean cone distance", length(mean)},
              {"face width", length(b.face_width)},
              {"outer pitch diameter", length(diameter_at(b, outer, 0))},
              {"outer tip diameter", length(diameter_at(b, outer, b.addendum(outer)))},
              {"mean addendum", length(b.mean_addendum)},
              {"mean dedendum", length(b.mean_dedendum)},
              {"cutter diameter, mean of the point radii", length(cutter)},
              {"blade angle, concave flank", angle(member.concave.blade_angle)},
              {"blade angle, convex flank", angle(member.convex.blade_angle)}};
    }
  } // namespace

  namespace
  {
    /** Sizes that the body has, not known for others: both members have the same names. */
    void add_body(const GearBodyOptions &body, NamedFigures &figures)
    {
      const auto add = [&figures](const char *name, const bool has, const double size) {
        figures.push_back({name, {has ? size : not_known, "mm"}});
      };
      const bool has_web = body.web == WebKind::conical;
      add("bore radius", body.web != WebKind::none, body.bore_radius);
      add("rim thickness", body.web != WebKind::solid, body.rim_thickness);
      add("web thickness", has_web, body.web_thickness);
      add("hub radius", has_web, body.hub_radius);
      add("hub length", has_web, body.hub_length);
    }
  } // namespace

  namespace
  {
    DeclaredSection declared(GearPairOptions options)
    {
      dealii::ParameterHandler prm;
      options.declare(prm);
      return find_declared(prm);
    }
  } // namespace

  PairGeometry::PairGeometry(const GearPairOptions &options, const std::optional<Bodies> &bodies)
  {
    const DeclaredSection given = declared(options), defaults = declared(GearPairOptions());
    for (const char *name : {"Mounting", "Errors"})
      {
        const std::vector<std::string> differences =
          given.find_section(name)->list_differences(*defaults.find_section(name));
        if (!differences.empty())
          settings_.push_back(std::string(spiral_bevel_section) + "/" + name + ": " +
                              list_of(differences));
      }
    for (unsigned int b = 0; bodies && b < 2; ++b)
      if ((*bodies)[b].shaft.present())
        settings_.push_back(std::string("shaft of the ") + (b == 0 ? "pinion" : "gear") +
                            ": sections " + (*bodies)[b].shaft.text +
                            " (from, to, outer, inner diameter, mm)");
    for (unsigned int b = 0; b < 2; ++b)
      {
        const double chamfer = (b == 0 ? options.pinion : options.gear).blank.tip_chamfer;
        if (chamfer > 0.)
          settings_.push_back(
            text_of("tip chamfer of the ", b == 0 ? "pinion: " : "gear: ", chamfer, " mm"));
      }
    const GearPairOptions o = options.completed();
    members_ = {{{"pinion", name_of(o.pinion.blank.hand), list_member(o.pinion, o.gear)},
                 {"gear", name_of(o.gear.blank.hand), list_member(o.gear, o.gear)}}};
    if (bodies)
      for (unsigned int b = 0; b < 2; ++b)
        add_body(with_open_sizes((*bodies)[b], b == 0 ? o.pinion.blank : o.gear.blank),
                 members_[b].figures);
    const Blank &gear = o.gear.blank;
    pair_             = {{"outer transverse module",
                          {diameter_at(gear, gear.outer_cone_distance, 0) / gear.teeth, "mm"}},
                         {"mean normal module",
                          {gear.mean_module() * std::cos(find_spiral_angle(gear, o.gear)), "mm"}},
                         {"shaft angle", {o.shaft_angle / degree, "deg"}},
                         {"designed normal backlash, mean point", {o.backlash, "mm"}}};
  }

  void PairGeometry::show(Log &log) const
  {
    const auto row =
      [&log](const std::string &name, const std::string &first, const std::string &second) {
        char text[128];
        std::snprintf(
          text, sizeof text, "  %-44s %10s %10s", name.c_str(), first.c_str(), second.c_str());
        log.line(text);
      };
    const auto number = [](const double value) {
      if (std::isnan(value))
        return std::string("-");
      char text[32];
      std::snprintf(text, sizeof text, "%.6g", value);
      return std::string(text);
    };
    const auto named = [](const auto &figure) {
      return figure.first + (figure.second.unit == "-" ? "" : " [" + figure.second.unit + "]");
    };
    for (const std::string &setting : settings_)
      log.line(setting);
    log.line("geometry with all derived values:");
    for (const auto &figure : pair_)
      row(named(figure), number(figure.second.value), "");
    row("", members_[0].name, members_[1].name);
    row("hand of spiral", members_[0].hand, members_[1].hand);
    for (std::size_t i = 0; i < members_[0].figures.size(); ++i)
      row(named(members_[0].figures[i]),
          number(members_[0].figures[i].second.value),
          number(members_[1].figures[i].second.value));
  }

  Json PairGeometry::json() const
  {
    Json json = {{"pair", figures_json(pair_)}};
    for (const Member &member : members_)
      {
        json[member.name] = {{"hand of spiral", member.hand}};
        json[member.name].update(figures_json(member.figures));
      }
    return json;
  }

  GearPairOptions read_pair_options(const ParameterFile &file)
  {
    GearPairOptions options;
    file.read_known([&](dealii::ParameterHandler &known) {
      declare_section(known, spiral_bevel_section, options);
    });
    return options;
  }

  std::optional<PairGeometry> find_pair_geometry(const ParameterFile            &file,
                                                 const dealii::ParameterHandler &prm)
  {
    const auto reads = [entries = find_declared(prm).list_texts(&DeclaredSection::Entry::value)](
                         const std::string &entry) {
      const std::string path = std::string(spiral_bevel_section) + "/" + entry;
      return std::any_of(entries.begin(), entries.end(), [&path](const auto &one) {
        return one.first == path;
      });
    };
    if (!reads("Gear/Blank/number of teeth"))
      return {};
    GearPairOptions      options;
    PairGeometry::Bodies bodies;
    bodies[0] = pinion_body_defaults();
    file.read_known([&](dealii::ParameterHandler &known) {
      declare_section(known, spiral_bevel_section, options);
      const Subsection section(known, spiral_bevel_section);
      for (unsigned int b = 0; b < 2; ++b)
        {
          const Subsection member(known, b == 0 ? "Pinion" : "Gear");
          bodies[b].leave_sizes_open();
          bodies[b].declare(known);
        }
    });
    const bool has_bodies = reads("Gear/Body/body type");
    return PairGeometry(options,
                        has_bodies ? std::optional<PairGeometry::Bodies>(bodies) : std::nullopt);
  }
} // namespace vfife
