// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/fem/fem_options.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body_frame.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/reduced/pair_readings.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace vfife
{
  namespace reading
  {
    const char *const bore_turn = "bore turn";
    const char *const rim_turn  = "rim turn";

    std::string of_probe(const std::string &probe, const unsigned int component)
    {
      return "probe " + probe + " component " + std::to_string(component);
    }

    std::string
    of_rim(const unsigned int component, const unsigned int diameters, const bool imaginary)
    {
      return "rim " + std::to_string(component) + " diameters " + std::to_string(diameters) +
             (imaginary ? " imaginary" : " real");
    }
  } // namespace reading

  namespace
  {
    /** Mass-weighted share of sector 0 in the mean rotation of nodes of all sectors. */
    SectorReading
    make_turn(const Body &body, const std::string &name, const std::vector<unsigned int> &nodes)
    {
      SectorReading reading{name, {}};
      double        mass = 0;
      for (const unsigned int node : nodes)
        mass += body.node_masses()[node];
      for (const unsigned int node : nodes)
        if (body.structure().sector_of(node) == 0)
          {
            const Vector3 arm = body.axis.direction.cross(
              body.placement(body.node_positions()[node]) - body.axis.point);
            reading.weights.emplace_back(node,
                                         body.node_masses()[node] / mass / arm.squaredNorm() *
                                           (body.placement.rotation.transpose() * arm));
          }
      return reading;
    }

    /** Adds the rim's waves along r, theta, z. */
    void add_rim_waves(const Body                      &body,
                       const std::vector<unsigned int> &rim,
                       const unsigned int               largest,
                       std::vector<SectorReading>      &readings)
    {
      double mass = 0;
      for (const unsigned int node : rim)
        mass += body.node_masses()[node];
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int n = 0; n <= largest; ++n)
          {
            SectorReading real{reading::of_rim(c, n, false), {}},
              imaginary{reading::of_rim(c, n, true), {}};
            for (const unsigned int node : rim)
              if (body.structure().sector_of(node) == 0)
                {
                  const Matrix3 axes = compute_cylindrical_axes(body, body.node_positions()[node]);
                  const std::complex<double> wave =
                    std::pow(std::complex<double>(axes(0, 0), axes(1, 0)), double(n));
                  const double share = body.node_masses()[node] / mass;
                  real.weights.emplace_back(node, share * wave.real() * axes.col(c));
                  imaginary.weights.emplace_back(node, share * wave.imag() * axes.col(c));
                }
            readings.push_back(std::move(real));
            if (n > 0)
              readings.push_back(std::move(imaginary));
          }
    }

    /** Displacements and stresses at a node of sector 0, of a @p space of the whole body. */
    void add_probe(const FemSpace             &space,
                   const std::string          &probe,
                   const unsigned int          node,
                   std::vector<SectorReading> &readings)
    {
      for (unsigned int c = 0; c < 3; ++c)
        readings.push_back({reading::of_probe(probe, c), {{node, Vector3::Unit(c)}}});

      // The mean over the elements at the node. Stresses are linear in displacements.
      const unsigned int     n         = space.points_per_element();
      const RigidMotion     &place     = space.model().bodies[space.parts().front().body].placement;
      const Matrix3          back      = place.rotation.transpose();
      const Eigen::MatrixXd &to_points = point_extrapolation(space.degree());
      std::map<unsigned int, Eigen::Matrix<double, 6, 3>> derivatives;
      unsigned int                                        n_elements = 0;
      for (unsigned int e = 0; e < space.n_elements(); ++e)
        {
          const unsigned int *const points = space.element_points(e);
          const std::ptrdiff_t      at     = std::find(points, points + n, node) - points;
          if (at == n)
            continue;
          ++n_elements;
          const ElementNodes X = back * (space.element_nodes(e).colwise() - place.translation);
          for (unsigned int k = 0; k < n; ++k)
            {
              auto &derivative =
                derivatives.emplace(points[k], Eigen::Matrix<double, 6, 3>::Zero()).first->second;
              for (unsigned int c = 0; c < 3; ++c)
                derivative.col(c) +=
                  compute_point_stresses(X,
                                         space.material(e),
                                         space.element(),
                                         Eigen::VectorXd::Unit(3 * n, 3 * k + c)) *
                  to_points.col(at);
            }
        }
      for (unsigned int s = 0; s < 6; ++s)
        {
          SectorReading stress{reading::of_probe(probe, 3 + s), {}};
          for (const auto &[point, derivative] : derivatives)
            stress.weights.emplace_back(point, derivative.row(s).transpose() / n_elements);
          readings.push_back(std::move(stress));
        }
    }
  } // namespace

  std::vector<unsigned int> list_touch_nodes(const Model &model, const unsigned int body)
  {
    std::set<unsigned int> nodes;
    const auto             add = [&](const unsigned int b, const std::string &surface) {
      if (b == body)
        for (const unsigned int node : model.bodies[b].mesh().surfaces.at(surface).nodes)
          nodes.insert(model.bodies[b].structure().first_copy(node));
    };
    for (const ContactPair &pair : model.contacts)
      {
        add(pair.slave_body, pair.slave_surface);
        add(pair.master_body, pair.master_surface);
      }
    return {nodes.begin(), nodes.end()};
  }

  std::vector<SectorReading> list_readings(const Model       &model,
                                           const unsigned int b,
                                           const FemOptions  &fem,
                                           const unsigned int largest_diameters)
  {
    const Transmission        &t    = *model.only_transmission();
    const Body                &body = model.bodies[b];
    std::vector<SectorReading> readings;
    const auto                &bore = find_member(t, b).bore;
    if (!bore.empty())
      readings.push_back(make_turn(body, reading::bore_turn, bore));
    if (b == t.driven)
      {
        readings.push_back(make_turn(body, reading::rim_turn, t.driven_rim));
        add_rim_waves(body, t.driven_rim, largest_diameters, readings);
      }
    std::optional<FemSpace> space;
    for (const Probe &probe : model.probes)
      if (probe.body == b)
        {
          if (!space)
            space.emplace(model, std::vector<unsigned int>{b}, fem);
          add_probe(*space, probe.name, body.structure().first_copy(probe.node), readings);
        }
    return readings;
  }

  std::complex<double> find_rim_wave(const std::vector<double> &coefficients,
                                     const unsigned int         component,
                                     const unsigned int         diameters)
  {
    // c_0, c_1, s_1, c_2 ... of each component: c cos + s sin is Re((c - i s) exp(i n alpha)).
    const std::size_t first = component * (coefficients.size() / 3);
    if (diameters == 0)
      return coefficients[first];
    const std::size_t at = first + 2 * diameters - 1;
    return {coefficients[at], -coefficients[at + 1]};
  }
} // namespace vfife
