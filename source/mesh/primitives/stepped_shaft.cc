// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/mesh/boundary_surface.h>
#include <vfife/mesh/mesh_size.h>
#include <vfife/mesh/primitives/disc_cells.h>
#include <vfife/mesh/primitives/stepped_shaft.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vfife
{
  namespace
  {
    /** The plane cells of all sections together: those between two neighbouring diameters belong to
     * one band. */
    struct Plane
    {
      std::vector<Vector2>                     nodes;
      std::vector<std::array<unsigned int, 4>> cells; ///< lexicographic
      std::vector<unsigned int>                band_of_cell;
      std::vector<double>                      radii; ///< outer ones of the bands
      std::vector<unsigned int> circles;              ///< first node of each radius, `around` each
      unsigned int              around = 0;
      unsigned int              centre = 0;
      bool                      solid  = false; ///< band 0 is a disc

      /** Inner radius of a band. */
      double inner(const unsigned int band) const
      {
        return band > 0 ? radii[band - 1] : 0.;
      }
      /** Whether a node lies on circle @p k. */
      bool is_on(const unsigned int node, const std::size_t k) const
      {
        return node >= circles[k] && node < circles[k] + around;
      }
    };

    Plane divide_plane(const std::vector<ShaftSection> &sections,
                       const unsigned int               around,
                       const double                     size)
    {
      Plane            plane;
      std::set<double> radii;
      for (const ShaftSection &section : sections)
        {
          radii.insert(.5 * section.outer);
          if (section.inner > 0)
            radii.insert(.5 * section.inner);
          plane.solid = plane.solid || section.inner == 0;
        }
      plane.radii.assign(radii.begin(), radii.end());
      plane.around = around;
      // 1. Within the smallest radius: a disc, or nothing but its circle.
      const double first = plane.radii.front();
      if (plane.solid)
        {
          const unsigned int n    = around / 4;
          const DiscCells    disc = divide_disc(n, count_cells((1. - core_part) * first, size));
          for (const Vector2 &node : disc.nodes)
            plane.nodes.push_back(first * node);
          plane.cells  = disc.cells;
          plane.centre = (n + 1) * (n + 1) / 2;
        }
      else
        for (unsigned int k = 0; k < around; ++k)
          {
            const double angle = -.75 * pi + 2. * pi * k / around;
            plane.nodes.emplace_back(first * std::cos(angle), first * std::sin(angle));
          }
      plane.band_of_cell.assign(plane.cells.size(), 0);
      plane.circles.push_back(plane.nodes.size() - around);
      // 2. Rows between neighbouring radii.
      for (unsigned int band = 1; band < plane.radii.size(); ++band)
        {
          const double       inner = plane.inner(band), outer = plane.radii[band];
          const unsigned int rows     = count_cells(outer - inner, size);
          unsigned int       previous = plane.circles.back();
          for (unsigned int row = 1; row <= rows; ++row)
            {
              const double       radius = inner + (outer - inner) * row / rows;
              const unsigned int next   = plane.nodes.size();
              for (unsigned int k = 0; k < around; ++k)
                {
                  const unsigned int l = (k + 1) % around;
                  plane.nodes.push_back(radius / first * plane.nodes[plane.circles[0] + k]);
                  plane.cells.push_back({{previous + k, next + k, previous + l, next + l}});
                  plane.band_of_cell.push_back(band);
                }
              previous = next;
            }
          plane.circles.push_back(previous);
        }
      return plane;
    }

    /** The meridian plane: layers of cells along the axis, and which bands of them are filled. */
    class Meridian
    {
    public:
      Meridian(const std::vector<ShaftSection> &sections, const Plane &plane, const double size)
      {
        std::set<double> places;
        for (const ShaftSection &section : sections)
          places.insert({section.from, section.to});
        heights_ = divide_between(places, size);
        n_bands_ = plane.radii.size();
        filled_.assign(n_layers() * n_bands_, false);
        for (const ShaftSection &section : sections)
          for (unsigned int layer = 0; layer < n_layers(); ++layer)
            for (unsigned int band = 0; band < n_bands_; ++band)
              if (section.from <= heights_[layer] && heights_[layer + 1] <= section.to &&
                  .5 * section.inner <= plane.inner(band) &&
                  plane.radii[band] <= .5 * section.outer)
                filled_[layer * n_bands_ + band] = true;
      }

      unsigned int n_layers() const
      {
        return heights_.size() - 1;
      }
      const std::vector<double> &heights() const
      {
        return heights_;
      }
      /** Nothing is filled beyond the ends, within the first band and beyond the last. */
      bool is_filled(const int layer, const int band) const
      {
        return layer >= 0 && layer < static_cast<int>(n_layers()) && band >= 0 &&
               band < static_cast<int>(n_bands_) && filled_[layer * n_bands_ + band];
      }
      /** Whether circle @p k bounds a filled band within (@p outer) or beyond it, and no other, in
       * a layer that lies from @p from to @p to [mm]. */
      bool is_side(
        const int layer, const int k, const bool outer, const double from, const double to) const
      {
        return is_filled(layer, outer ? k : k + 1) && !is_filled(layer, outer ? k + 1 : k) &&
               from <= heights_[layer] && heights_[layer + 1] <= to;
      }

    private:
      std::vector<double> heights_;
      unsigned int        n_bands_;
      std::vector<bool>   filled_; ///< band fastest
    };
  } // namespace

  void SteppedShaftOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_text(prm,
                 "sections",
                 text,
                 "Sections along z, separated by commas: FROM TO OUTER [INNER]; places and "
                 "diameters in mm. A section without an inner diameter is solid");
    declare_integer(prm,
                    "elements around",
                    around,
                    "Elements around the axis; a multiple of 8 where a section is solid",
                    8,
                    4096);
    declare_cell_sizes(prm, axial_cell_size, radial_cell_size);
  }

  std::vector<ShaftSection> SteppedShaftOptions::sections(const std::string &section) const
  {
    return parse_shaft_sections(text, section + "/sections");
  }

  void SteppedShaftOptions::check(const std::string &section) const
  {
    const std::vector<ShaftSection> all = sections(section);
    const bool                      solid =
      std::any_of(all.begin(), all.end(), [](const ShaftSection &s) { return s.inner == 0; });
    if (solid && around % 8 != 0)
      throw InputError(section + "/elements around",
                       "expected a multiple of 8 for the core of a solid section, got " +
                         std::to_string(around));
    double n_cells = 0;
    for (const ShaftSection &s : all)
      n_cells += ((s.to - s.from) / axial_cell_size + 1) *
                 (.5 * (s.outer - s.inner) / radial_cell_size + .25 * around) * around;
    check_mesh_size(section, n_cells);
  }

  namespace
  {
    /** By the circle and the level of each node, whose number among all of the plane and the levels
     * is @p original. */
    void name_sides(const std::vector<ShaftSection> &sections,
                    const Plane                     &plane,
                    const Meridian                  &meridian,
                    const std::vector<unsigned int> &original,
                    BodyMesh                        &mesh)
    {
      const unsigned int per_layer = plane.nodes.size();
      const double       lowest = meridian.heights().front(), highest = meridian.heights().back();
      const auto         add_cylinder = [&](const std::string         &name,
                                    const std::vector<double> &radii,
                                    const bool                 outer,
                                    const double               from,
                                    const double               to) {
        // Circles of levels above or below a layer that has a side there; sections that lie within
        // others have none.
        std::set<std::pair<unsigned int, std::size_t>> circles;
        for (std::size_t k = 0; k < plane.radii.size(); ++k)
          for (unsigned int layer = 0; layer < meridian.n_layers(); ++layer)
            if (std::count(radii.begin(), radii.end(), plane.radii[k]) != 0 &&
                meridian.is_side(layer, k, outer, from, to))
              circles.insert({{layer, k}, {layer + 1, k}});
        if (circles.empty())
          return;
        add_named_side(mesh, name, [&](const unsigned int i) {
          for (std::size_t k = 0; k < plane.radii.size(); ++k)
            if (plane.is_on(original[i] % per_layer, k))
              return circles.count({original[i] / per_layer, k}) != 0;
          return false;
        });
      };
      add_named_side(mesh, "bottom", [&](const unsigned int i) {
        return original[i] / per_layer == 0;
      });
      add_named_side(mesh, "top", [&](const unsigned int i) {
        return original[i] / per_layer == meridian.n_layers();
      });
      add_cylinder("outer", plane.radii, true, lowest, highest);
      for (std::size_t s = 0; s < sections.size(); ++s)
        add_cylinder("section " + std::to_string(s + 1),
                     {.5 * sections[s].outer},
                     true,
                     sections[s].from,
                     sections[s].to);
      std::vector<std::string> names = {"bottom", "top", "outer"};
      if (std::any_of(sections.begin(), sections.end(), [](const ShaftSection &s) {
            return s.inner > 0;
          }))
        {
          names.emplace_back("bore");
          add_cylinder("bore", plane.radii, false, lowest, highest);
        }
      if (plane.solid)
        for (unsigned int i = 0; i < original.size(); ++i)
          if (original[i] % per_layer == plane.centre)
            mesh.node_sets["axis"].push_back(i);
      name_boundaries(mesh, names);
    }
  } // namespace

  std::unique_ptr<BodyMesh> make_stepped_shaft(const SteppedShaftOptions &options)
  {
    const std::vector<ShaftSection> sections = options.sections("");
    const Plane plane = divide_plane(sections, options.around, options.radial_cell_size);
    // The polygon of n corners has the area of a circle times sin(a)/a, a = 2 pi/n.
    const double a = 2. * pi / options.around, scale = std::sqrt(a / std::sin(a));

    const Meridian meridian(sections, plane, options.axial_cell_size);
    auto           mesh = std::make_unique<BodyMesh>();
    mesh->name          = "stepped shaft";
    // 1. Cells among all nodes of all layers, of which they use some.
    std::vector<CellNodes> hexahedra;
    const unsigned int     per_layer = plane.nodes.size();
    for (unsigned int layer = 0; layer < meridian.n_layers(); ++layer)
      for (std::size_t c = 0; c < plane.cells.size(); ++c)
        if (meridian.is_filled(layer, plane.band_of_cell[c]))
          {
            CellNodes corners;
            for (unsigned int v = 0; v < 8; ++v)
              corners[v] = plane.cells[c][v & 3u] + (layer + (v >> 2)) * per_layer;
            hexahedra.push_back(corners);
          }
    // 2. Nodes in use, numbered anew.
    constexpr unsigned int    unused = ~0u;
    std::vector<unsigned int> number(per_layer * meridian.heights().size(), unused), original;
    for (const CellNodes &cell : hexahedra)
      for (const unsigned int node : cell)
        number[node] = 0;
    std::vector<Vector3> nodes;
    for (unsigned int i = 0; i < number.size(); ++i)
      if (number[i] != unused)
        {
          number[i]        = nodes.size();
          const Vector2 &x = plane.nodes[i % per_layer];
          nodes.emplace_back(scale * x[0], scale * x[1], meridian.heights()[i / per_layer]);
          original.push_back(i);
        }
    for (CellNodes &cell : hexahedra)
      for (unsigned int &node : cell)
        node = number[node];
    create_triangulation(*mesh, nodes, hexahedra);

    name_sides(sections, plane, meridian, original, *mesh);
    return mesh;
  }
} // namespace vfife
