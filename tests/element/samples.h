// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_element_samples_h
#define vfife_tests_element_samples_h

#include <vfife/element/kernels/kernels.h>
#include <vfife/element/reduced_stiffness.h>

#include <random>
#include <vector>

/**
 * Elements and motions that the element tests share. Repeatable: only the raw numbers of the
 * Mersenne twister are used, which the standard fixes.
 */
class Samples
{
public:
  /** Uniform in [-1, 1]. */
  double number()
  {
    return 2. * (generator_() / 4294967295.) - 1.;
  }

  vfife::Vector3 vector()
  {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  vfife::Matrix3 rotation()
  {
    const vfife::Vector3 axis = vector().normalized();
    return vfife::rotation_about(axis, vfife::pi * number());
  }

  /** Box of @p sides [mm] whose corners are moved by up to @p distortion of the shortest side. */
  vfife::HexahedronNodes hexahedron(const vfife::Vector3 &sides,
                                    const double          distortion,
                                    const vfife::Vector3 &place = vfife::Vector3::Zero())
  {
    vfife::HexahedronNodes nodes;
    for (unsigned int a = 0; a < 8; ++a)
      nodes.col(a) = place + 0.5 * vfife::reference_corner(a).cwiseProduct(sides) +
                     distortion * sides.minCoeff() * vector();
    return nodes;
  }

  /** Displacements of each node by up to @p amplitude [mm]. */
  vfife::HexahedronNodes displacement(const double amplitude)
  {
    vfife::HexahedronNodes u;
    for (unsigned int a = 0; a < 8; ++a)
      u.col(a) = amplitude * vector();
    return u;
  }

private:
  std::mt19937 generator_;
};


/** Arrays behind an ElementPacks, and the loops over it. */
struct SamplePacks
{
  std::vector<std::uint32_t> nodes;
  std::vector<double>        constants;
  std::vector<std::uint32_t> constants_row; ///< empty: own constants
  std::vector<double>        positions;     ///< four numbers a node

  void resize(const std::size_t n_packs, const std::size_t n_nodes)
  {
    nodes.assign(8 * vfife::n_lanes * n_packs, 0);
    positions.assign(4 * n_nodes, 0.);
  }

  std::size_t n_packs() const
  {
    return nodes.size() / (8 * vfife::n_lanes);
  }

  vfife::ElementPacks view() const
  {
    return {n_packs(),
            nodes.data(),
            constants.data(),
            constants_row.empty() ? nullptr : constants_row.data()};
  }

  void set_node(const std::size_t   pack,
                const unsigned int  lane,
                const unsigned int  a,
                const std::uint32_t node)
  {
    nodes[8 * vfife::n_lanes * pack + vfife::n_lanes * a + lane] = node;
  }

  void set_position(const std::size_t node, const vfife::Vector3 &x)
  {
    for (unsigned int i = 0; i < 3; ++i)
      positions[4 * node + i] = x[i];
  }

  /** Own constants of one lane. */
  void set_constants(const std::size_t              pack,
                     const unsigned int             lane,
                     const vfife::ReducedStiffness &reduced,
                     const vfife::Material         &material)
  {
    constants.resize(n_packs() * vfife::n_element_constants * vfife::n_lanes, 0.);
    double row[vfife::n_element_constants];
    write_constants(reduced, material, row);
    for (unsigned int i = 0; i < vfife::n_element_constants; ++i)
      constants[vfife::n_lanes * (vfife::n_element_constants * pack + i) + lane] = row[i];
  }

  /** Force on a node out of an array of four numbers a node. */
  static vfife::Vector3 at(const std::vector<double> &records, const std::size_t node)
  {
    return {records[4 * node], records[4 * node + 1], records[4 * node + 2]};
  }
};

#endif
