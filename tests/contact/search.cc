// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// No contact is missed: random sliding, lifting and turning of grouped (toothed) surfaces, with
// kept lists and warm starts, against a search through all facets at every position.
#include "../tests.h"
#include "surfaces.h"

#include <vfife/contact/search/local_search.h>

#include <map>

using namespace test_surfaces;

std::mt19937 random_engine(3);

double uniform(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(random_engine);
}

using Key = std::pair<unsigned int, unsigned int>; // slave facet, master facet

/** Slave points in contact (facet by facet, their gaps summed) by looking at all facets of the
 * master. */
void brute_force(const SurfaceGeometry              &slave,
                 SurfaceGeometry                    &master,
                 const ContactOptions               &options,
                 const double                        depth_limit,
                 std::map<Key, std::vector<double>> &found)
{
  const auto   rule   = facet_quadrature(options.discretization, options.points_per_facet.number);
  const double reach2 = std::pow(1.5 * master.mean_facet_size(), 2);
  for (unsigned int f = 0; f < slave.n_facets(); ++f)
    for (const auto &q : rule)
      {
        Vector3 x = Vector3::Zero();
        for (unsigned int k = 0; k < 4; ++k)
          x += q.shape[k] * slave.node(slave.corners(f)[k]);
        for (unsigned int m = 0; m < master.n_facets(); ++m)
          {
            const FacetState &state = master.state(m);
            if ((x - state.position(0.5, 0.5)).squaredNorm() > reach2)
              continue;
            Projection p;
            p.facet = m;
            if (!project_on_facet(state, master.border_sides(m), x, p) || !p.inside)
              continue;
            const Vector3 n   = state.normal(p.xi, p.eta).normalized();
            const double  gap = p.lambda * state.normal(p.xi, p.eta).norm() -
                               master.offset(m, p.xi, p.eta) - slave.offset(f, q.xi, q.eta);
            if (gap < 0. && gap > -depth_limit && n.dot(slave.vector_area(f)) < 0.)
              found[{f, m}].push_back(gap);
          }
      }
}

/** The surface cut into columns of facets that touch, numbered by groups: four "teeth". */
FacetSurface grouped(FacetSurface surface, const unsigned int n, const unsigned int n_groups)
{
  surface.n_groups = n_groups;
  for (unsigned int f = 0; f < surface.facets.size(); ++f)
    surface.group[f] = (f % n) * n_groups / n;
  return surface;
}

void check_random_sliding(const std::string &name,
                          FacetSurface       slave_surface,
                          FacetSurface       master_surface,
                          const double       r)
{
  MovingSurface  slave(slave_surface), master(master_surface);
  ContactOptions options = with_penalty(1e6);
  options.edge_fading = 0.; // a point with weight zero would carry no pressure and not be reported
  Contact         contact(slave.surface, master.surface, options);
  SurfaceGeometry slave_geometry(slave.surface, options.surface),
    master_geometry(master.surface, options.surface);

  double       angle_x = 0.15, angle_y = -0.1, twist = 0., depth = 0.02, speed_x = 0., speed_y = 0.;
  unsigned int n_contacts = 0, n_missed = 0, n_false = 0, n_open = 0, n_pairs = 0;
  double       gap_error   = 0.;
  const int    n_positions = 600;
  for (int i = 0; i < n_positions; ++i)
    {
      // steps of up to 50 um along, 3 um across, so that lists live for some steps (the skin is
      // 0.3 mm); now and then the slave jumps up by more than the skin and comes back
      speed_x = std::max(-8e-4, std::min(8e-4, speed_x + uniform(-2e-4, 2e-4) - 1e-3 * angle_x));
      speed_y = std::max(-8e-4, std::min(8e-4, speed_y + uniform(-2e-4, 2e-4) - 1e-3 * angle_y));
      angle_x += speed_x;
      angle_y += speed_y;
      twist += uniform(-0.002, 0.002);
      depth             = std::max(0.005, std::min(0.06, depth + uniform(-0.003, 0.003)));
      const double lift = i % 50 == 25 ? 1. : 0.;
      RigidMotion  common, relative;
      common.rotation    = rotation_about(Vector3::UnitX(), 0.3 * i); // the pair spins fast
      common.translation = Vector3(0., 0., 100.);
      relative.rotation =
        rotation_about(Vector3::UnitY(), angle_x) * rotation_about(Vector3::UnitX(), angle_y);
      relative.translation = relative.rotation * Vector3(0., 0., 50. + r - depth + lift);
      relative.rotation    = relative.rotation * rotation_about(Vector3::UnitZ(), twist);
      RigidMotion slave_motion;
      slave_motion.rotation    = common.rotation * relative.rotation;
      slave_motion.translation = common(relative.translation);
      slave.place(slave_motion);
      master.place(common);
      if (i % 10 == 0)
        contact.find_candidates(slave.body, master.body, 4.);
      add_forces(contact, slave, master);
      n_pairs = std::max<unsigned int>(n_pairs, contact.candidate_pairs().size());

      slave_geometry.bind(slave.motion());
      master_geometry.bind(master.motion());
      std::map<Key, std::vector<double>> reference, found;
      brute_force(slave_geometry, master_geometry, options, contact.depth_limit(), reference);
      for (const ContactPoint &point : contact.points())
        found[{point.slave_facet, point.master_facet}].push_back(point.gap);
      for (auto &entry : reference)
        {
          auto &gaps = found[entry.first];
          n_contacts += entry.second.size();
          // a point on the edge between two facets (to 1e-9) belongs to both
          if (gaps.size() < entry.second.size())
            n_missed += entry.second.size() - gaps.size();
          std::sort(gaps.begin(), gaps.end());
          std::sort(entry.second.begin(), entry.second.end());
          for (std::size_t k = 0; k < std::min(gaps.size(), entry.second.size()); ++k)
            raise_to(gap_error, std::abs(gaps[k] - entry.second[k]));
        }
      for (const auto &entry : found)
        if (entry.second.size() > reference[entry.first].size())
          n_false += entry.second.size() - reference[entry.first].size();
      n_open += reference.empty();
    }
  check(name + ": many contacts were compared", n_contacts > 10000);
  check(name + ": lists were kept for several steps",
        contact.n_wide_searches() < 0.4 * n_positions * n_pairs);
  check(name + ": some positions were open", n_open > 3);
  check_close(name + ": missed contacts", n_missed, 0., 0.);
  check_close(name + ": false contacts", n_false, 0., 0.);
  check_below(name + ": gaps [mm]", gap_error, 1e-12);
}

void check_broad_search()
{
  // two bodies with five groups each on a line, 10 mm apart
  FacetSurface row = plane(2, 2, 0., 4., 0., 4., 0.);
  const auto   one = row;
  for (unsigned int g = 1; g < 5; ++g)
    {
      const auto first = static_cast<unsigned int>(row.positions.size());
      for (unsigned int n = 0; n < one.positions.size(); ++n)
        {
          row.nodes.push_back(first + n);
          row.positions.push_back(one.positions[n] + Vector3(10. * g, 0., 0.));
          row.normals.push_back(one.normals[n]);
        }
      for (auto facet : one.facets)
        {
          for (auto &n : facet)
            n += first;
          row.facets.push_back(facet);
          row.group.push_back(g);
        }
    }
  row.n_groups = 5;
  find_neighbours(row);
  ContactOptions options = with_penalty(1e6);
  Contact        contact(row, row, options);
  RigidMotion    slave, master;
  slave.rotation    = rotation_about(Vector3::UnitZ(), 1.);
  master.rotation   = slave.rotation;
  slave.translation = slave.rotation * Vector3(7., 0., 0.5);
  contact.find_candidates(slave, master, 1.1);
  // slave 0 (7..11) is near master 1 (10..14) and no other: 4 pairs
  check_close("broad search: pairs", contact.candidate_pairs().size(), 4, 0.);
  check("broad search: first pair", contact.candidate_pairs().at(0) == std::make_pair(0u, 1u));
  check_close("broad search: active nodes", contact.active_master_nodes().size(), 36, 0.);
  contact.find_candidates(slave, master, 3.1);
  check_close("broad search: a larger margin finds both neighbours",
              contact.candidate_pairs().size(),
              9,
              0.);
  slave.translation[2] = 5.;
  contact.find_candidates(slave, master, 1.1);
  check_close("broad search: nothing near", contact.candidate_pairs().size(), 0, 0.);
}

void check_smallest_gap()
{
  MovingSurface  slave(sphere_patch_down(30., 0.1, 9)), master(sphere_patch(50., 0.2, 8));
  ContactOptions options = with_penalty(1e6);
  options.points_per_facet.number =
    3; // 9 x 9 facets: the middle point of the middle one is the pole
  Contact     contact(slave.surface, master.surface, options);
  RigidMotion motion;
  motion.translation[2] = 80. + 0.4;
  slave.place(motion);
  contact.find_candidates(slave.body, master.body, 1.);
  const ContactPoint open = contact.smallest_gap(slave.motion(), master.motion(), 0.6);
  check_close("smallest gap, open", open.gap, 0.4, 1e-7);
  motion.translation[2] = 80. - 0.2;
  slave.place(motion);
  const ContactPoint closed = contact.smallest_gap(slave.motion(), master.motion(), 0.6);
  check_close("smallest gap, overlapping", closed.gap, -0.2, 1e-7);
  check_below("its point is at the pole [mm]", closed.position.head<2>().norm(), 1e-10);
  motion.translation[2] = 82.;
  slave.place(motion);
  check("smallest gap, out of reach",
        std::isinf(contact.smallest_gap(slave.motion(), master.motion(), 0.6).gap));
}

/** A sphere over another: the gap at the distance r from the axis is g + r^2 (1/30 + 1/50)/2. */
void check_near_nodes()
{
  MovingSurface  slave(sphere_patch_down(30., 0.2, 24)), master(sphere_patch(50., 0.12, 20));
  ContactOptions options          = with_penalty(1e6);
  options.points_per_facet.number = 3;
  Contact      contact(slave.surface, master.surface, options);
  RigidMotion  motion;
  const double open = 0.01, reach = 0.3;
  motion.translation[2] = 80. + open;
  slave.place(motion);
  contact.find_candidates(slave.body, master.body, 1.);
  const auto   near        = contact.find_near_nodes(slave.motion(), master.motion(), reach);
  const double radius      = std::sqrt(2. * (reach - open) / (1. / 30. + 1. / 50.));
  const auto   check_nodes = [&](const std::string               &name,
                               const MovingSurface             &surface,
                               const double                     facet,
                               const std::vector<unsigned int> &nodes) {
    check(name + ": each once",
          std::is_sorted(nodes.begin(), nodes.end()) &&
            std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
    unsigned int n_within = 0, n_found = 0;
    double       farthest = 0;
    for (unsigned int i = 0; i < surface.surface.positions.size(); ++i)
      {
        const double r     = surface.surface.positions[i].head<2>().norm();
        const bool   found = std::binary_search(nodes.begin(), nodes.end(), i);
        n_within += r < radius - facet;
        n_found += found && r < radius - facet;
        farthest = found ? largest_of(farthest, r) : farthest;
      }
    check(name + ": all that are near", n_found == n_within && n_within > 20);
    check(name + ": and not many more", farthest < radius + 2. * facet);
  };
  check_nodes("near nodes of the slave", slave, 30. * .4 / 24, near.first);
  check_nodes("near nodes of the master", master, 50. * .24 / 20, near.second);
  motion.translation[2] = 80.35;
  slave.place(motion);
  const auto none = contact.find_near_nodes(slave.motion(), master.motion(), reach);
  check("none are near", none.first.empty() && none.second.empty());
}

/** Two passes find what one pass finds with either surface as the slave. */
void check_two_passes()
{
  // The smaller radius is in turn that of the slave and of the master; neither has a point at the
  // pole.
  for (const bool swapped : {false, true})
    {
      MovingSurface small(sphere_patch_down(30., 0.2, 8)), large(sphere_patch(50., 0.12, 20));
      RigidMotion   motion;
      motion.translation = Vector3(0.31, -0.23, 80.01);
      (swapped ? large : small).place(motion);
      if (swapped)
        {
          // The small sphere stays and the large one comes from below.
          RigidMotion below;
          below.translation = -motion.translation;
          small.place({});
          large.place(below);
        }
      MovingSurface &slave = swapped ? large : small, &master = swapped ? small : large;
      ContactOptions options          = with_penalty(1e6);
      options.points_per_facet.number = 2;
      Contact one(slave.surface, master.surface, options),
        other(master.surface, slave.surface, options);
      options.discretization = ContactDiscretization::two_pass;
      Contact both(slave.surface, master.surface, options);
      one.find_candidates(slave.body, master.body, 1.);
      other.find_candidates(master.body, slave.body, 1.);
      both.find_candidates(slave.body, master.body, 1.);

      const ContactPoint of_one   = one.smallest_gap(slave.motion(), master.motion(), 0.3),
                         of_other = other.smallest_gap(master.motion(), slave.motion(), 0.3),
                         of_both  = both.smallest_gap(slave.motion(), master.motion(), 0.3);
      const std::string name      = swapped ? "two passes, swapped: " : "two passes: ";
      check(name + "the passes differ", of_one.gap != of_other.gap);
      check(name + "smallest gap", of_both.gap == std::min(of_one.gap, of_other.gap));
      check(name + "pass of the smallest gap", of_both.swapped == (of_other.gap < of_one.gap));

      const auto join = [](std::vector<unsigned int> a, const std::vector<unsigned int> &b) {
        a.insert(a.end(), b.begin(), b.end());
        std::sort(a.begin(), a.end());
        a.erase(std::unique(a.begin(), a.end()), a.end());
        return a;
      };
      const auto near_one   = one.find_near_nodes(slave.motion(), master.motion(), 0.1),
                 near_other = other.find_near_nodes(master.motion(), slave.motion(), 0.1),
                 near_both  = both.find_near_nodes(slave.motion(), master.motion(), 0.1);
      check(name + "near nodes of the slave",
            !near_both.first.empty() && near_both.first == join(near_one.first, near_other.second));
      check(name + "near nodes of the master",
            !near_both.second.empty() &&
              near_both.second == join(near_one.second, near_other.first));
    }
}

/** Straight towards each other from 0.05 mm on, less than the skin of the wide search: a point
 * that sleeps is awake when its gap closes. */
void check_approach()
{
  MovingSurface slave(plane(1, 1, -0.5, 0.5, 1.5, 2.5, 0., true)),
    master(plane(2, 2, -1., 1., 1., 3., 0.));
  ContactOptions options = with_penalty(1e5);
  options.surface        = ContactSurfaceKind::flat_facets;
  options.edge_fading    = 0.;
  Contact      contact(slave.surface, master.surface, options);
  unsigned int wrong = 0;
  for (int i = 100; i >= -5; --i)
    {
      RigidMotion motion;
      motion.translation[2] = 5e-4 * (i - 0.5);
      slave.place(motion);
      if (i == 100)
        contact.find_candidates(slave.body, master.body, 0.5);
      slave.clear_forces();
      add_forces(contact, slave, master);
      wrong += (slave.force()[2] > 0.) != (i <= 0);
    }
  check("straight approach: pressed from the first overlap on", wrong == 0);
}

int main()
{
  check_approach();
  FacetSurface master = sphere_patch(50., 0.25, 16), slave = sphere_patch_down(30., 0.15, 12);
  check_random_sliding("one group", slave, master, 30.);
  check_random_sliding("groups", grouped(slave, 12, 3), grouped(master, 16, 4), 30.);
  turn_facets(master, random_engine);
  add_sphere_offsets(master, Vector3::Zero(), 50., 5);
  check_random_sliding("turned facets", slave, master, 30.);
  check_broad_search();
  check_smallest_gap();
  check_near_nodes();
  check_two_passes();
  return 0;
}
