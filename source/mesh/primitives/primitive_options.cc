// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/mesh/mesh_size.h>
#include <vfife/mesh/primitives/primitive_options.h>
#include <vfife/mesh/primitives/primitives.h>

namespace vfife
{
  namespace
  {
    using Sizes  = std::array<double, 3>;
    using Counts = std::array<unsigned int, 3>;

    /** An entry for a length [mm], with its default. */
    struct SizeEntry
    {
      const char *name, *meaning;
      double      value;
    };

    /** An entry for a number of cells, with its default and bounds. */
    struct CountEntry
    {
      const char  *name, *meaning;
      unsigned int value, least;
      bool         even;
    };

    /** Cells of a grid of the three counts. */
    double cells_of_grid(const Counts &n)
    {
      return static_cast<double>(n[0]) * n[1] * n[2];
    }

    /** Cells of a disc's core of n x n, and of rows around it with a cell at each of its 4 n border
     * sides, in all layers. */
    double cells_of_disc(const Counts &n)
    {
      return static_cast<double>(n[0]) * (n[0] + 4. * n[1]) * n[2];
    }

    /** The same of a ball: a core of n^3, and rows around its six sides. */
    double cells_of_ball(const Counts &n)
    {
      return static_cast<double>(n[0]) * n[0] * (n[0] + 6. * n[1]);
    }

    constexpr char across_core[] = "Elements across the core; even number";
    constexpr char around_core[] = "Rows of elements between core and outer surface";
  } // namespace

  struct PrimitiveShape
  {
    const char             *name;
    std::vector<SizeEntry>  sizes;
    std::vector<CountEntry> counts;
    double (*n_cells)(const Counts &);
    bool rising; ///< the second size must be larger than the first
    std::unique_ptr<BodyMesh> (*make)(const Sizes &, const Counts &);
  };

  namespace
  {
    /** All shapes, a row each. */
    const std::vector<PrimitiveShape> &shape_table()
    {
      static const std::vector<PrimitiveShape> table = {
        {"block",
         {{"size x", "From x = 0", 10.},
          {"size y", "From y = 0", 10.},
          {"size z", "From z = 0", 10.}},
         {{"elements x", "Elements along x", 4, 1, false},
          {"elements y", "Elements along y", 4, 1, false},
          {"elements z", "Elements along z", 4, 1, false}},
         &cells_of_grid,
         false,
         [](const Sizes &s, const Counts &n) {
           return make_block({s[0], s[1], s[2]}, n);
         }},
        {"beam",
         {{"length", "Length along x, from x = 0", 100.},
          {"width", "Width along y, centred on the x axis", 10.},
          {"height", "Height along z, centred on the x axis", 10.}},
         {{"elements along length", "Elements along x", 20, 1, false},
          {"elements across width", "Elements along y", 2, 1, false},
          {"elements over height", "Elements along z", 2, 1, false}},
         &cells_of_grid,
         false,
         [](const Sizes &s, const Counts &n) {
           return make_beam({s[0], s[1], s[2]}, n);
         }},
        {"ring",
         {{"inner radius", "Radius about the z axis", 20.},
          {"outer radius", "Radius about the z axis", 30.},
          {"height", "Height along z, from z = 0", 10.}},
         {{"radial elements", "Elements from inner to outer radius", 4, 1, false},
          {"elements around", "Elements around the axis", 36, 3, false},
          {"axial elements", "Elements along z", 4, 1, false}},
         &cells_of_grid,
         true,
         [](const Sizes &s, const Counts &n) { return make_ring(s[0], s[1], s[2], n); }},
        {"cylinder",
         {{"radius", "Radius about the z axis", 10.},
          {"height", "Height along z, from z = 0", 20.}},
         {{"core elements", across_core, 4, 2, true},
          {"radial elements", around_core, 3, 1, false},
          {"axial elements", "Elements along z", 8, 1, false}},
         &cells_of_disc,
         false,
         [](const Sizes &s, const Counts &n) { return make_cylinder(s[0], s[1], n); }},
        {"disc",
         {{"radius", "Radius about the z axis", 50.},
          {"thickness", "Thickness along z, centred on z = 0", 5.}},
         {{"core elements", across_core, 8, 2, true},
          {"radial elements", around_core, 8, 1, false},
          {"axial elements", "Elements through the thickness", 2, 1, false}},
         &cells_of_disc,
         false,
         [](const Sizes &s, const Counts &n) { return make_disc(s[0], s[1], n); }},
        {"sphere",
         {{"radius", "Radius about the origin", 10.}},
         {{"core elements", across_core, 4, 2, true},
          {"radial elements", around_core, 4, 1, false}},
         &cells_of_ball,
         false,
         [](const Sizes &s, const Counts &n) {
           return make_sphere(s[0], {{n[0], n[1]}});
         }}};
      return table;
    }

    const PrimitiveShape &find_shape(const std::string &name)
    {
      for (const PrimitiveShape &shape : shape_table())
        if (shape.name == name)
          return shape;
      const auto names = PrimitiveOptions::shapes();
      throw InputError("expected a shape, got \"" + name + "\"; allowed: " + list_of(names) +
                       did_you_mean(name, names));
    }
  } // namespace

  PrimitiveOptions::PrimitiveOptions(const std::string &shape)
    : sizes{}
    , counts{}
    , shape_(&find_shape(shape))
  {
    for (unsigned int i = 0; i < shape_->sizes.size(); ++i)
      sizes[i] = shape_->sizes[i].value;
    for (unsigned int i = 0; i < shape_->counts.size(); ++i)
      counts[i] = shape_->counts[i].value;
  }

  std::vector<std::string> PrimitiveOptions::shapes()
  {
    std::vector<std::string> names;
    for (const PrimitiveShape &shape : shape_table())
      names.push_back(shape.name);
    return names;
  }

  void PrimitiveOptions::declare(dealii::ParameterHandler &prm)
  {
    for (unsigned int i = 0; i < shape_->sizes.size(); ++i)
      declare_quantity(
        prm, shape_->sizes[i].name, sizes[i], "mm", shape_->sizes[i].meaning, Range::positive());
    for (unsigned int i = 0; i < shape_->counts.size(); ++i)
      declare_integer(
        prm, shape_->counts[i].name, counts[i], shape_->counts[i].meaning, shape_->counts[i].least);
  }

  void PrimitiveOptions::check(const std::string &section) const
  {
    for (unsigned int i = 0; i < shape_->counts.size(); ++i)
      if (shape_->counts[i].even && counts[i] % 2 != 0)
        throw InputError(section + "/" + shape_->counts[i].name,
                         "expected an even number, got " + std::to_string(counts[i]));
    // Bounds of single entries are checked when they are read; here what ties two of them.
    check_mesh_size(section, shape_->n_cells(counts));
    if (shape_->rising && !(sizes[0] < sizes[1]))
      throw InputError(section + "/" + shape_->sizes[0].name,
                       std::string("must be smaller than the ") + shape_->sizes[1].name);
  }

  std::unique_ptr<BodyMesh> make_primitive(const PrimitiveOptions &options)
  {
    return options.shape_->make(options.sizes, options.counts);
  }
} // namespace vfife
