// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrature, offsets, local search and nodal normals against closed forms.
#include "../parts.h"
#include "../tests.h"
#include "surfaces.h"

#include <vfife/contact/search/local_search.h>

using namespace test_surfaces;

std::mt19937 random_engine(1);

double uniform(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(random_engine);
}

void check_rules()
{
  double largest = 0.;
  for (unsigned int n = 1; n <= 10; ++n)
    for (unsigned int degree = 0; degree < 2 * n; ++degree)
      {
        std::vector<double> points, weights;
        gauss_legendre(n, points, weights);
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += weights[i] * std::pow(points[i], degree);
        raise_to(largest, std::abs(sum - 1. / (degree + 1.)));
      }
  check_below("Gauss rules integrate degree 2n-1", largest, 1e-14);

  const auto lobatto = gauss_lobatto_points(5);
  check_close("five Gauss-Lobatto points", lobatto[1], 0.5 * (1. - std::sqrt(3. / 7.)), 1e-15);

  // x^3 y^2 lies in the space of five points per direction
  std::vector<double> values;
  for (const double y : lobatto)
    for (const double x : lobatto)
      values.push_back(x * x * x * y * y);
  const OffsetPolynomials offsets(5, values);
  const double            x = 0.37, y = 0.81;
  check_close("offset polynomial", offsets.value(0, x, y), x * x * x * y * y, 1e-14);
}

void check_twisted_facet()
{
  FacetSurface surface;
  surface.positions = {{0, 0, 0}, {2, 0.1, 0.2}, {2.2, 1.5, -0.1}, {-0.1, 1.3, 0.15}};
  surface.normals   = {{-.05, .1, 1}, {.1, .1, 1}, {.1, -.1, 1}, {-.1, -.05, 1}};
  for (Vector3 &n : surface.normals)
    n.normalize();
  surface.facets = {{{0, 1, 2, 3}}};
  find_neighbours(surface);
  SurfaceGeometry geometry(surface, ContactSurfaceKind::true_flank);
  MovingSurface   moving(surface);
  geometry.bind(moving.motion());

  double largest  = 0.;
  bool   all_good = true;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      const double xi = uniform(-0.3, 1.3), eta = uniform(-0.3, 1.3), lambda = uniform(-0.2, 0.2);
      const FacetState &state = geometry.state(0);
      Projection        p;
      p.facet         = 0;
      const Vector3 x = state.position(xi, eta) + lambda * state.normal(xi, eta);
      const double  out =
        std::max({-xi, xi - 1., -eta, eta - 1.}); // beyond the border; its tolerance is 1e-3
      const bool in = out <= 1e-3;
      all_good      = all_good && project_walking(geometry, x, p) && p.inside == in;
      largest       = largest_of(
        {largest, std::abs(p.xi - xi), std::abs(p.eta - eta), std::abs(p.lambda - lambda)});
    }
  check("points over a twisted facet are found inside or outside as they are", all_good);
  check_below("their parameters", largest, 1e-12);
}

void check_sphere()
{
  const double radius  = 50.;
  FacetSurface surface = sphere_patch(radius, 0.2, 8, false);
  turn_facets(surface, random_engine);
  add_sphere_offsets(surface, Vector3::Zero(), radius, 5);
  RigidMotion motion;
  motion.rotation    = rotation_about(Vector3(1, 2, -1).normalized(), 2.);
  motion.translation = Vector3(30., -80., 12.);
  MovingSurface moving(surface);
  moving.place(motion);

  SurfaceGeometry geometry(surface, ContactSurfaceKind::true_flank);
  geometry.bind(moving.motion());
  SurfaceGeometry facets(surface, ContactSurfaceKind::flat_facets);
  facets.bind(moving.motion());
  double gap_error = 0., flat_error = 0., offline = 0.;
  bool   all_found = true;
  for (unsigned int i = 0; i < 3000; ++i)
    {
      const double  height = uniform(-0.05, 0.05);
      const Vector3 d      = Vector3(uniform(-0.19, 0.19), uniform(-0.19, 0.19), 1.).normalized();
      const Vector3 x      = motion(Vector3((radius + height) * d));
      const auto    gap    = [&](SurfaceGeometry &g) {
        Projection p;
        p.facet         = random_engine() % g.n_facets(); // far away: the walk has to get there
        all_found       = all_found && project_walking(g, x, p) && p.inside;
        const Vector3 n = g.state(p.facet).normal(p.xi, p.eta).normalized();
        const Vector3 r = x - g.state(p.facet).position(p.xi, p.eta);
        raise_to(offline, r.cross(n).norm());
        return r.dot(n) - g.offset(p.facet, p.xi, p.eta);
      };
      raise_to(gap_error, std::abs(gap(geometry) - height));
      raise_to(flat_error, std::abs(gap(facets) - height));
    }
  check("all points over the sphere are found from any facet", all_found);
  // 1e-6 of the radius was asked for; interpolation of the offsets leaves far less
  check_below("gap over the faceted sphere with offsets [mm]", gap_error, 1e-7);
  // the sag of a facet with edges of 2.5 mm is 2 * 2.5^2 / (8 * 50) = 31 um: the offsets matter
  check("without offsets the gap is wrong by the sag", flat_error > 0.02 && flat_error < 0.04);
  // coordinates of 100 mm have a round-off of 1.4e-14
  check_below("point and foot are on one normal [mm]", offline, 1e-12);
}

void check_normals()
{
  const FacetSurface surface = sphere_patch(50., 0.2, 6);
  SurfaceGeometry    geometry(surface, ContactSurfaceKind::true_flank);
  MovingSurface      moving(surface);
  RigidMotion        motion;
  motion.rotation    = rotation_about(Vector3(3, -1, 2).normalized(), -1.3);
  motion.translation = Vector3(5., 6., 7.);
  moving.place(motion);
  geometry.bind(moving.motion());
  double largest = 0.;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    raise_to(
      largest,
      (geometry.state(f).m[0] - motion.rotation * surface.normals[surface.facets[f][0]]).norm());
  check_below("nodal normals after a rigid motion are the true ones, rotated", largest, 1e-14);

  // stretched to an ellipsoid (1, 1, 1.1): the normals of the deformed surface are known
  motion = {};
  moving.place(motion);
  for (unsigned int n = 0; n < surface.positions.size(); ++n)
    moving.positions[3 * n + 2] *= 1.1;
  geometry.bind(moving.motion());
  double followed = 0., kept = 0.;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    {
      Vector3 n = surface.normals[surface.facets[f][0]];
      raise_to(kept, (n - Vector3(n[0], n[1], n[2] / 1.1).normalized()).norm());
      n = Vector3(n[0], n[1], n[2] / 1.1).normalized();
      raise_to(followed, (geometry.state(f).m[0] - n).norm());
    }
  // at the border the facets lie on one side only, and their difference to the true normal is not
  // stretched: an error of the stretch times half a facet's angle, 0.1 * 0.033, against the
  // effect 0.1 * 0.27
  check("nodal normals follow a stretch of 10 % to a fifth of its effect", followed < 0.2 * kept);
}

int main()
{
  return run_parts({check_rules, check_twisted_facet, check_sphere, check_normals});
}
