// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/node_springs.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace vfife
{
  namespace
  {
    /** Least mass over area of the nodes; those without area carry no spring. */
    double least_ratio(const std::vector<double> &masses, const std::vector<double> &areas)
    {
      if (masses.size() != areas.size())
        throw InputError("contact: expected one mass per surface node");
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < areas.size(); ++i)
        if (areas[i] > 0.)
          least = std::min(least, masses[i] / areas[i]);
      return least;
    }

    void add_by_node(const std::vector<double> &of_other_pass, std::vector<double> &areas)
    {
      std::transform(
        areas.begin(), areas.end(), of_other_pass.begin(), areas.begin(), std::plus<>());
    }
  } // namespace

  NodeSprings::OfSurfaces NodeSprings::carried_areas() const
  {
    OfSurfaces areas = {
      {passes_[0].slave_points().carried_areas(), passes_[0].master_carried_areas()}};
    if (passes_.size() == 2)
      {
        add_by_node(passes_[1].master_carried_areas(), areas[0]);
        add_by_node(passes_[1].slave_points().carried_areas(), areas[1]);
      }
    return areas;
  }

  NodeSprings::OfSurfaces NodeSprings::stiffness() const
  {
    OfSurfaces stiffness;
    stiffness[0].assign(passes_[0].slave().n_nodes(), 0.);
    stiffness[1].assign(passes_[0].master().n_nodes(), passes_.size() == 1 ? 1. : 0.);
    for (std::size_t i = 0; i < passes_.size(); ++i)
      {
        const SlavePoints &points = passes_[i].slave_points();
        for (unsigned int f = 0; f < points.surface().n_facets(); ++f)
          for (const unsigned int node : points.surface().corners(f))
            stiffness[i][node] = std::max(stiffness[i][node], points.largest_stiffness(f));
      }
    return stiffness;
  }

  double NodeSprings::mass_per_area(const std::vector<double> &slave_masses,
                                    const std::vector<double> &master_masses) const
  {
    return std::min(least_ratio(slave_masses, slave_areas()),
                    least_ratio(master_masses, master_areas()));
  }

  double NodeSprings::carried_mass_per_area(const std::vector<double> &slave_masses,
                                            const std::vector<double> &master_masses) const
  {
    // Each pass adds at most eps (max A/m of its slave + max A/m of its master).
    double sum = 0.;
    for (std::size_t i = 0; i < passes_.size(); ++i)
      sum +=
        1. / least_ratio(i == 0 ? slave_masses : master_masses,
                         passes_[i].slave_points().carried_areas()) +
        1. / least_ratio(i == 0 ? master_masses : slave_masses, passes_[i].master_carried_areas());
    return 2. / sum;
  }
} // namespace vfife
