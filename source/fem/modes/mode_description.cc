// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/modes/mode_description.h>
#include <vfife/mesh/body_mesh.h>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    /** Places of the nodes from a point of the axis. */
    std::vector<Vector3>
    places_from_axis(const FemSpace &space, const FemSpace::Part &part, const Body &body)
    {
      std::vector<Vector3> places;
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        places.push_back(space.points()[part.first_point + i] - body.axis.point);
      return places;
    }
  } // namespace

  ModeDescriber::ModeDescriber(const FemSpace &space, const FemSpace::Part &part)
    : space_(space)
    , first_point_(part.first_point)
    , body_(space.model().bodies[part.body])
  {
    const Vector3              z      = body_.axis.direction;
    const std::vector<Vector3> places = places_from_axis(space, part, body_);
    copies_                           = find_cyclic_copies(places, z);
    for (const Vector3 &x : places)
      {
        const Vector3 across = x - z.dot(x) * z;
        const Vector3 r = across.norm() > 0 ? Vector3(across.normalized()) : z.unitOrthogonal();
        Matrix3       axes;
        axes << r, z.cross(r), z;
        axes_.push_back(axes);
      }
    for (std::size_t i = 0; i < copies_.n_per_sector(); ++i)
      {
        const Vector3 &x = places[copies_.points[i]];
        radii_.push_back((x - z.dot(x) * z).norm());
      }
  }

  Vector3 ModeDescriber::components(const unsigned int node, const std::vector<double> &shape) const
  {
    const double *u = shape.data() + 3 * static_cast<std::size_t>(first_point_ + node);
    return axes_[node].transpose() * Vector3(u[0], u[1], u[2]);
  }

  ModeDescription ModeDescriber::describe(const std::vector<double> &shape) const
  {
    return describe(shape, std::vector<double>(shape.size(), 0.));
  }

  ModeDescription ModeDescriber::describe(const std::vector<double> &real,
                                          const std::vector<double> &imaginary) const
  {
    Amplitudes values(3 * static_cast<std::size_t>(body_.n_nodes()));
    Vector3    energy = Vector3::Zero();
    for (unsigned int i = 0; i < body_.n_nodes(); ++i)
      {
        // In r, theta, z of each node, where the copies of a node in all sectors can be compared.
        const Vector3 a = components(i, real), b = components(i, imaginary);
        energy += body_.node_masses()[i] * (a.cwiseAbs2() + b.cwiseAbs2());
        for (unsigned int c = 0; c < 3; ++c)
          values[3 * i + c] = {a[c], b[c]};
      }
    ModeDescription description;
    description.radial           = energy[0] / energy.sum();
    description.tangential       = energy[1] / energy.sum();
    description.axial            = energy[2] / energy.sum();
    const unsigned int n_sectors = copies_.n_sectors;
    if (n_sectors == 0)
      return description;

    // The body's kinetic energy by harmonics over the sectors: the largest is the nodal diameter.
    // By Parseval: sums over the sectors, squared and divided by their number, add up over all
    // harmonics -N/2 < h <= N/2 to the energy of the body.
    const auto energy_of = [&](const Amplitudes &amplitudes) {
      double sum = 0;
      for (std::size_t i = 0; i < amplitudes.size(); ++i)
        sum += first_mass(i / 3) * std::norm(amplitudes[i]);
      return sum / n_sectors;
    };
    double largest = 0, positive = 0;
    for (unsigned int h = 0; h <= n_sectors / 2; ++h)
      {
        // h = 0 and h = N/2 are their own counterparts.
        const bool   both  = h > 0 && 2 * h < n_sectors;
        const double plus  = energy_of(harmonic(values, h)),
                     minus = both ? energy_of(harmonic(values, -static_cast<int>(h))) : 0.;
        if (plus + minus > largest)
          {
            largest                    = plus + minus;
            positive                   = plus;
            description.nodal_diameter = h;
            description.is_pair        = both;
          }
      }
    description.share = largest / energy.sum();
    // exp(i (h theta + omega t)) travels towards - theta.
    if (description.is_pair)
      description.forward = 1. - positive / largest;
    unsigned int component;
    energy.maxCoeff(&component);
    // Of a wave that travels one side has all of the motion, and the other one round-off.
    const int side = 2. * positive < largest ? -1 : 1;
    description.nodal_circles =
      count_circles(harmonic(values, side * description.nodal_diameter), component);
    return description;
  }

  double ModeDescriber::first_mass(const std::size_t i) const
  {
    return body_.node_masses()[copies_.points[i]];
  }

  ModeDescriber::Amplitudes ModeDescriber::harmonic(const Amplitudes &values, const int h) const
  {
    const std::size_t per_sector = copies_.n_per_sector();
    // A_h = sum_k a_k exp(-2 pi i h k / N), a_k the amplitudes of sector k.
    Amplitudes sums(3 * per_sector);
    for (unsigned int k = 0; k < copies_.n_sectors; ++k)
      {
        const std::complex<double> phase =
          std::polar(1., -2. * pi * h * static_cast<double>(k) / copies_.n_sectors);
        for (std::size_t i = 0; i < per_sector; ++i)
          for (unsigned int c = 0; c < 3; ++c)
            sums[3 * i + c] += phase * values[3 * copies_.points[k * per_sector + i] + c];
      }
    return sums;
  }

  int ModeDescriber::count_circles(const Amplitudes &amplitudes, const unsigned int component) const
  {
    // Real at the meridian of largest motion.
    std::complex<double> square = 0;
    for (std::size_t i = 0; i < radii_.size(); ++i)
      square += first_mass(i) * amplitudes[3 * i + component] * amplitudes[3 * i + component];
    const std::complex<double> phase = std::polar(1., -.5 * std::arg(square));

    // The wave of one sector as a function of the radius alone: a circle is where it changes sign.
    constexpr unsigned int n_rings = 24;
    const auto             range   = std::minmax_element(radii_.begin(), radii_.end());
    std::vector<double>    sum(n_rings, 0.), mass(n_rings, 0.);
    for (std::size_t i = 0; i < radii_.size(); ++i)
      {
        // Rings of equal width; what they move is the mean of their nodes, weighted with mass.
        const double       part = (radii_[i] - *range.first) / (*range.second - *range.first);
        const unsigned int ring = std::min<unsigned int>(n_rings * part, n_rings - 1);
        sum[ring] += first_mass(i) * (phase * amplitudes[3 * i + component]).real();
        mass[ring] += first_mass(i);
      }
    double largest = 0;
    for (unsigned int ring = 0; ring < n_rings; ++ring)
      if (mass[ring] > 0)
        largest = std::max(largest, std::abs(sum[ring] /= mass[ring]));
    // A ring that hardly moves has no sign.
    int    circles = 0;
    double before  = 0;
    for (const double value : sum)
      if (std::abs(value) > .05 * largest)
        {
          circles += value * before < 0;
          before = value;
        }
    return circles;
  }
} // namespace vfife
