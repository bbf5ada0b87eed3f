// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_composite_h
#define vfife_tests_composite_h

#include "model_parts.h"

#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/model.h>

#include <functional>

/** Material 1 where @p second holds at the middle of an element, material 0 elsewhere. */
inline vfife::Body make_composite(std::unique_ptr<vfife::BodyMesh>                   mesh,
                                  const std::vector<vfife::Material>                &materials,
                                  const std::function<bool(const vfife::Vector3 &)> &second)
{
  std::vector<std::uint8_t> numbers;
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    {
      const auto middle = cell->center();
      numbers.push_back(second(vfife::Vector3(middle[0], middle[1], middle[2])) ? 1 : 0);
    }
  mesh->structure.set_materials(std::move(numbers));
  return vfife::Body("composite", materials, std::move(mesh));
}

/** Adds to each element the strain of its middle. */
inline void set_strains(vfife::Body                                         &body,
                        const std::function<double(const vfife::Vector3 &)> &strain)
{
  std::vector<double> strains;
  for (unsigned int e = 0; e < body.n_elements(); ++e)
    strains.push_back(strain(body.element_nodes(e).rowwise().mean()));
  body.add_initial_strains(strains);
}

/** A bar along x between two planes, hotter than them: sigma = -E strain. */
inline vfife::Model make_heated_bar(const double strain)
{
  vfife::Model model = model_of(vfife::Body(
    "bar", vfife::make_block(vfife::Vector3(20, 3, 2), {{5, 2, 2}}), vfife::Material()));
  vfife::Body &bar   = model.bodies[0];
  set_strains(bar, [strain](const vfife::Vector3 &) { return strain; });
  for (const char *end : {"x-", "x+"})
    model.constraints.push_back(hold(bar.node_set(end), {{true, false, false}}));
  model.constraints.push_back(hold(bar.node_set("y-"), {{false, true, false}}));
  model.constraints.push_back(hold(bar.node_set("z-"), {{false, false, true}}));
  return model;
}

/** Timoshenko's strip (1925): two layers of equal thickness, the upper one twice as stiff and
 * expanding more; half of it, from its plane of symmetry. */
struct BimetalStrip
{
  static constexpr double thickness = 1., strain = 2e-3, stiffness_ratio = 2.;

  vfife::Model model;
  double       length;

  /** @p n: elements over its thickness. */
  BimetalStrip(const double length_, const unsigned int n)
    : length(length_)
  {
    vfife::Material lower, upper;
    lower.poissons_ratio = upper.poissons_ratio = 0.;
    upper.youngs_modulus                        = stiffness_ratio * lower.youngs_modulus;
    model.add_body(
      make_composite(vfife::make_block(vfife::Vector3(length, .5, thickness),
                                       {{static_cast<unsigned int>(length * n / 4.), 1, n}}),
                     {lower, upper},
                     [](const vfife::Vector3 &x) { return x[2] > .5 * thickness; }));
    vfife::Body &strip = model.bodies[0];
    set_strains(strip, [](const vfife::Vector3 &x) { return x[2] > .5 * thickness ? strain : 0.; });
    model.constraints.push_back(hold(strip.node_set("x-"), {{true, false, false}}));
    model.constraints.push_back(hold(all_nodes(strip), {{false, true, false}}));
    std::vector<unsigned int> foot;
    for (const unsigned int node : strip.node_set("x-"))
      if (strip.node_positions()[node][2] < 1e-9)
        foot.push_back(node);
    model.constraints.push_back(hold(foot, {{false, false, true}}));
  }

  /** Eq. (4) there, of thicknesses in the ratio m and moduli in the ratio n. */
  static double curvature()
  {
    constexpr double m = 1., n = stiffness_ratio;
    return 6. * strain * std::pow(1. + m, 2) /
           (thickness * (3. * std::pow(1. + m, 2) + (1. + m * n) * (m * m + 1. / (m * n))));
  }

  /** A node at half the length, below, where the free end does not disturb. */
  unsigned int middle() const
  {
    const vfife::Body &strip   = model.bodies[0];
    unsigned int       nearest = 0;
    for (unsigned int i = 0; i < strip.n_nodes(); ++i)
      if ((strip.node_positions()[i] - vfife::Vector3(.5 * length, 0, 0)).norm() <
          (strip.node_positions()[nearest] - vfife::Vector3(.5 * length, 0, 0)).norm())
        nearest = i;
    return nearest;
  }
};

/** A ring that has shrunk onto another one with the interference delta (Lame), both free along the
 * axis. */
struct ShrinkFit
{
  static constexpr double inner = 10., joint = 15., outer = 20., interference = 0.015;

  vfife::Model model;

  /** @p n: elements across each ring. */
  explicit ShrinkFit(const unsigned int n)
  {
    model.add_body(vfife::Body("rings",
                               vfife::make_ring(inner, outer, 1., {{2 * n, 24 * n, 1}}),
                               vfife::Material()));
    vfife::Body &rings = model.bodies[0];
    set_strains(rings, [](const vfife::Vector3 &x) {
      return x.head<2>().norm() > joint ? -interference / joint : 0.;
    });
    model.constraints.push_back(hold(all_nodes(rings), {{false, true, false}}, true));
    model.constraints.push_back(hold(rings.node_set("bottom"), {{false, false, true}}));
  }

  /** Of both rings on each other [MPa]. */
  double pressure() const
  {
    const double a = inner * inner, b = joint * joint, c = outer * outer;
    return model.bodies[0].materials().front().youngs_modulus * interference / joint * (c - b) *
           (b - a) / (2. * b * (c - a));
  }

  /** Of the bore, radially [mm]. */
  double bore() const
  {
    return -2. * pressure() * joint * joint * inner /
           (model.bodies[0].materials().front().youngs_modulus * (joint * joint - inner * inner));
  }

  unsigned int bore_node() const
  {
    return model.bodies[0].node_set("inner").front();
  }
};

/** A bar of two materials along x, each half the length, whose cross-section stays plane: steel,
 * then one of a third of the impedance. */
inline vfife::Model make_layered_bar(const unsigned int n, const double length)
{
  vfife::Material steel, light;
  steel.poissons_ratio = light.poissons_ratio = 0.;
  light.density                               = steel.density / 3.;
  light.youngs_modulus                        = steel.youngs_modulus / 3.;
  vfife::Model model =
    model_of(make_composite(vfife::make_block(vfife::Vector3(length, 1, 1), {{n, 1, 1}}),
                            {steel, light},
                            [length](const vfife::Vector3 &x) { return x[0] > .5 * length; }));
  model.constraints.push_back(hold(all_nodes(model.bodies[0]), {{false, true, true}}));
  return model;
}

#endif
