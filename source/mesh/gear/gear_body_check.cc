// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/mesh/gear/gear_body_check.h>
#include <vfife/mesh/mesh_size.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Least element size over the face width: some ten million elements in a pair. */
    constexpr double least_size_part = 1. / 150.;
    /** Least part of the rim's thickness that stays free on either side of the web. */
    constexpr double least_free_part = .08;

    /** Root radius at cone distance L. */
    Vector2 root_point(const BlankOutline &blank, const double L)
    {
      return blank.meridian_point({L, -blank.dedendum(L)});
    }

    /** Refuses entries of one section. */
    class Refusal
    {
    public:
      explicit Refusal(const std::string &section)
        : section_(section)
      {
      }

      void unless(const bool condition, const std::string &entry, const std::string &message) const
      {
        if (!condition)
          throw InputError(section_ + "/" + entry, message);
      }

    private:
      std::string section_;
    };

    std::string millimetres(const double value)
    {
      std::ostringstream text;
      text << value << " mm";
      return text.str();
    }

    /** Numbers of cells that the layout can do with. */
    void check_counts(const GearBodyOptions &options, const Refusal &refuse)
    {
      const auto at_least =
        [&](const char *entry, const unsigned int count, const unsigned int least) {
          refuse.unless(count >= least,
                        std::string("Mesh/") + entry,
                        std::to_string(count) + " is too small, expected at least " +
                          std::to_string(least));
        };
      at_least("elements along face width", options.cells_lengthwise, 1);
      at_least("elements across tooth", options.cells_across, 2);
      at_least("elements along profile", options.flank_rows, 1);
      at_least("elements through rim", options.rim_rows, 1);
      if (options.web != WebKind::conical)
        return;
      at_least("elements through web", options.web_layers, 1);
      at_least("elements along web", options.web_rows, 2);
      at_least("elements through hub", options.hub_rows, 1);
      at_least("elements beside web", options.hub_side_cells, 1);
      at_least("elements along web fillet", options.fillet_rows, 1);
      if (options.web_attachment == WebAttachment::toe)
        at_least("elements through rim", options.rim_rows, options.web_layers + 2);
      else
        at_least("elements along face width", options.cells_lengthwise, options.web_layers + 2);
    }

    const char *direction_words(const WebDirection direction)
    {
      return direction == WebDirection::back ? " deg towards the back" : " deg towards the apex";
    }

    /** "60 to 90 deg towards the back": whole degrees of the web to the axis that leave the wall.
     */
    std::string list_angles(WebShape shape, const WebDirection direction, const BlankOutline &blank)
    {
      constexpr int right_angle = 90;
      int           first = 0, last = 0;
      shape.web_direction = direction;
      for (int angle = right_angle; angle > 0; --angle)
        {
          shape.web_angle = angle * degree;
          if (!ConicalWeb::leaves_wall(blank, shape))
            continue;
          first = angle;
          last  = std::max(last, angle);
        }
      if (last == 0)
        return {};
      return std::to_string(first) + " to " + std::to_string(last) + direction_words(direction);
    }

    /** What is wrong with a web that does not leave its wall, and what fits. */
    std::string describe_turn(const GearBodyOptions &options, const BlankOutline &blank)
    {
      const bool         at_toe = options.web_attachment == WebAttachment::toe;
      const std::string  wall   = at_toe ? "toe face" : "rim's underside";
      const double       left = 90. - std::abs(ConicalWeb::turn_from_wall(blank, options)) / degree;
      std::ostringstream message;
      message << "a web at " << options.web_angle / degree
              << direction_words(options.web_direction);
      if (left > 0.)
        message << " leaves the " << wall << " at " << left
                << " deg to it; at least 15 deg are needed";
      else
        message << " does not leave the " << wall << ", it would run into the rim";
      const std::string to_back = list_angles(options, WebDirection::back, blank),
                        to_apex = list_angles(options, WebDirection::apex, blank);
      message << ". Give " << to_back << (to_back.empty() || to_apex.empty() ? "" : " or ")
              << to_apex;
      return message.str();
    }

    /** Sizes of a web that contradict each other or leave no room. */
    void
    check_conical(const GearBodyOptions &options, const BlankOutline &blank, const Refusal &refuse)
    {
      refuse.unless(options.web_thickness > 0.,
                    "Body/web thickness",
                    "must be positive, not " + millimetres(options.web_thickness) +
                      " (choose body type = rim only for a rim without web)");
      refuse.unless(options.web_angle > 0. && options.web_angle <= pi / 2,
                    "Body/web inclination",
                    "must lie above 0 and not above 90 deg");
      refuse.unless(options.hub_radius > options.bore_radius,
                    "Body/bore radius",
                    millimetres(options.bore_radius) + " is not smaller than the hub radius " +
                      millimetres(options.hub_radius));
      // the web must leave its wall at an angle
      const bool at_toe = options.web_attachment == WebAttachment::toe;
      refuse.unless(ConicalWeb::leaves_wall(blank, options),
                    at_toe ? "Body/web inclination" : "Body/web attachment",
                    describe_turn(options, blank));

      // its foot must fit on the wall: the depth of the rim at the toe, the underside elsewhere
      const double     inner = blank.inner_cone_distance(), outer = blank.outer_cone_distance;
      const ConicalWeb web(blank, options);
      const double     first = web.wall_place(0.), last = web.wall_place(1.);
      if (at_toe)
        refuse.unless(first >= least_free_part * options.rim_thickness &&
                        last <= (1. - least_free_part) * options.rim_thickness,
                      options.rim_fillet_radius > 0. ? "Body/rim fillet radius"
                                                     : "Body/web thickness",
                      "a web " + millimetres(options.web_thickness) +
                        " thick takes with its fillets " + millimetres(last - first) +
                        " and does not fit under the root of a rim " +
                        millimetres(options.rim_thickness) + " thick");
      else
        refuse.unless(first >= inner + least_free_part * blank.face_width &&
                        (options.web_attachment == WebAttachment::heel ||
                         last <= outer - least_free_part * blank.face_width),
                      "Body/web attachment",
                      "the foot of the web with its fillets is " + millimetres(last - first) +
                        " long and does not fit on the rim's underside, " +
                        millimetres(blank.face_width) + " long");
      // hub inside the foot, a straight part between the fillets, a hub as long as the web's end
      const double start = std::min(web.point(0., 0.)[0], web.point(0., 1.)[0]);
      refuse.unless(options.hub_radius < start,
                    "Body/hub radius",
                    millimetres(options.hub_radius) +
                      " must be smaller than the radius at which the web starts, r = " +
                      millimetres(start));
      refuse.unless(web.straight_start() < web.straight_end(),
                    "Body/hub fillet radius",
                    "the fillets leave no straight part of the web");
      refuse.unless(options.hub_length > web.foot_on_hub(),
                    "Body/hub length",
                    millimetres(options.hub_length) + " is shorter than the web's foot on the hub");
    }
  } // namespace

  void check_gear_body(const std::string     &section,
                       const GearBodyOptions &options,
                       const BlankOutline    &blank)
  {
    const Refusal refuse(section);
    options.shaft.check(section + "/Shaft");
    refuse.unless(!options.shaft.present() || options.web != WebKind::none,
                  "Shaft/sections",
                  "a shaft requires body type = conical web or solid, because a body with rim only "
                  "has no bore");
    if (options.shaft.present())
      {
        GearBodyOptions bare = options;
        bare.shaft           = {};
        check_mesh_size(section + "/Shaft", options.n_cells(blank) - bare.n_cells(blank));
      }
    refuse.unless(options.element_size == 0. ||
                    options.element_size >= least_size_part * blank.face_width,
                  "Mesh/element size",
                  millimetres(options.element_size) + " is too small, expected at least " +
                    millimetres(least_size_part * blank.face_width));
    if (options.element_size == 0.)
      {
        check_counts(options, refuse);
        check_mesh_size(section + "/Mesh", options.n_cells(blank));
      }

    const double L = blank.inner_cone_distance();
    // under the root: the bore of a solid body, or a rim that does not reach the axis
    const Vector2 inner = root_point(blank, L);
    if (options.web == WebKind::solid)
      {
        refuse.unless(options.bore_radius > 0. && options.bore_radius < inner[0],
                      "Body/bore radius",
                      millimetres(options.bore_radius) +
                        " must be positive and smaller than the root at the toe, " +
                        millimetres(inner[0]));
        return;
      }
    const double underside =
      blank.meridian_point({L, -blank.dedendum(L) - options.rim_thickness})[0];
    refuse.unless(options.rim_thickness > 0., "Body/rim thickness", "must be positive");
    refuse.unless(underside > 0.,
                  "Body/rim thickness",
                  millimetres(options.rim_thickness) + " reaches the axis at the toe");
    if (options.web == WebKind::conical)
      check_conical(options, blank, refuse);
  }
} // namespace vfife
