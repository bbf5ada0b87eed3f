// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/dynamics/loads/contact/contact_of_pair.h>
#include <vfife/dynamics/loads/contact/contact_report.h>
#include <vfife/model/tooth_contact.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Ratio of mean facet sizes, slave to master, from which a user is told. */
    constexpr double clearly_coarser = 1.5;

    /** Of the pressed points of a pair of groups by their pressure: 1, x, y, z, xx, yy, zz, xy, yz,
     * zx, width of the slave's facet. */
    using PatchMoments = std::array<double, 11>;

    double width_of(const FacetSurface &surface, const unsigned int facet)
    {
      std::array<Vector3, 4> corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners[k] = surface.positions[surface.facets[facet][k]];
      return facet_width(corners);
    }

    std::vector<PatchMoments> add_patches(const ContactOfPair &pair)
    {
      const auto               &results = pair.contact.results();
      std::vector<PatchMoments> patches(results.size(), PatchMoments{});
      for (const ContactPoint &point : pair.contact.points())
        {
          const FacetSurface &from = point.swapped ? *pair.master.facets : *pair.slave.facets;
          const FacetSurface &to   = point.swapped ? *pair.slave.facets : *pair.master.facets;
          unsigned int slave = from.group[point.slave_facet], master = to.group[point.master_facet];
          if (point.swapped)
            std::swap(slave, master);
          for (std::size_t i = 0; i < results.size(); ++i)
            if (results[i].slave_group == slave && results[i].master_group == master)
              {
                const Vector3     &x     = point.position;
                const PatchMoments added = {{1.,
                                             x[0],
                                             x[1],
                                             x[2],
                                             x[0] * x[0],
                                             x[1] * x[1],
                                             x[2] * x[2],
                                             x[0] * x[1],
                                             x[1] * x[2],
                                             x[2] * x[0],
                                             width_of(from, point.slave_facet)}};
                for (std::size_t k = 0; k < added.size(); ++k)
                  patches[i][k] += point.pressure * added[k];
              }
        }
      return patches;
    }

    /** Of a strip with Hertz's elliptical pressures, <x^2> = (width/2)^2/4, across the narrower way
     * of the patch: along the middle one of the axes of inertia, the least being the normal. */
    double compute_width(const PatchMoments &m)
    {
      if (!(m[0] > 0.))
        return 0.;
      const Vector3 centre = Vector3(m[1], m[2], m[3]) / m[0];
      Matrix3       second;
      second << m[4], m[7], m[9], m[7], m[5], m[8], m[9], m[8], m[6];
      second = second / m[0] - centre * centre.transpose();
      const Eigen::SelfAdjointEigenSolver<Matrix3> axes(second, Eigen::EigenvaluesOnly);
      return 4. * std::sqrt(std::max(0., axes.eigenvalues()[1]));
    }
  } // namespace

  std::vector<ToothContact> collect_pressed_teeth(const Model        &model,
                                                  const ContactPairs &pairs,
                                                  const Communicator &communicator)
  {
    // Pairs of groups are the same on all ranks: one sum and one maximum over the ranks for all.
    std::vector<std::vector<PatchMoments>> patches;
    std::vector<double>                    sums, maxima;
    for (const auto &pair : pairs)
      {
        for (const GroupPairResult &r : pair->contact.results())
          {
            // Forces, moments and areas are parts of the ranks' shares of points and add up;
            // pressure and penetration are those of the worst point.
            sums.insert(sums.end(),
                        {r.force[0],
                         r.force[1],
                         r.force[2],
                         r.moment[0],
                         r.moment[1],
                         r.moment[2],
                         r.normal_force,
                         r.area});
            maxima.insert(maxima.end(), {r.largest_pressure, r.largest_penetration});
          }
        // How wide contacts are is asked of general models: Hertz tells of gear pairs.
        if (model.transmissions.empty())
          patches.push_back(add_patches(*pair));
      }
    communicator.sum(sums);
    communicator.max(maxima);
    for (auto &of_pair : patches)
      for (PatchMoments &patch : of_pair)
        communicator.sum(patch.data(), patch.size());

    std::vector<ToothContact> teeth;
    const double             *s = sums.data(), *largest = maxima.data();
    for (std::size_t p = 0; p < pairs.size(); ++p)
      {
        const auto &results = pairs[p]->contact.results();
        // Those that press, s[6] being the normal force.
        for (std::size_t i = 0; i < results.size(); ++i, s += 8, largest += 2)
          {
            if (!(s[6] > 0))
              continue;
            GroupPairResult sum     = results[i];
            sum.force               = Vector3(s[0], s[1], s[2]);
            sum.moment              = Vector3(s[3], s[4], s[5]);
            sum.normal_force        = s[6];
            sum.area                = s[7];
            sum.largest_pressure    = largest[0];
            sum.largest_penetration = largest[1];
            teeth.push_back(make_tooth_contact(model, p, sum));
            if (!patches.empty())
              {
                const PatchMoments &patch = patches[p][i];
                teeth.back().width        = compute_width(patch);
                teeth.back().facet_width  = patch[0] > 0. ? patch[10] / patch[0] : 0.;
              }
          }
      }
    return teeth;
  }

  std::string describe_deepest_point(const Model        &model,
                                     const ContactPairs &pairs,
                                     const Communicator &communicator)
  {
    // The deepest of this rank in words, relative to the limit of its pair ...
    double             deepest = 0; // over the limit
    std::ostringstream text;
    set_figure_digits(text, 4);
    for (const auto &pair : pairs)
      for (const ContactPoint &point : pair->contact.points())
        {
          const double ratio = -point.gap / pair->penetration_limit();
          if (!(ratio > deepest))
            continue;
          deepest                       = ratio;
          const ContactSurface &pressed = point.swapped ? pair->slave : pair->master;
          const ContactSurface &from    = point.swapped ? pair->master : pair->slave;
          const auto place = [&](const ContactSurface &surface, const unsigned int facet) {
            return "\"" + model.bodies[surface.body].name() + "\", tooth or group " +
                   std::to_string(surface.facets->group[facet]) + ", facet " +
                   std::to_string(facet);
          };
          text.str("");
          text << pair->definition.side << " side: " << place(from, point.slave_facet) << ", is "
               << 1e3 * -point.gap << " um deep in " << place(pressed, point.master_facet)
               << " (limit " << 1e3 * pair->penetration_limit()
               << " um, Contact/abort penetration ratio)";
        }
    // ... then the rank that has the deepest of all.
    const std::vector<double>      all   = communicator.all_gather(deepest);
    const std::vector<std::string> texts = communicator.all_gather(text.str());
    return texts[std::max_element(all.begin(), all.end()) - all.begin()];
  }

  std::vector<std::string> describe_coarse_slaves(const Model &model, const ContactPairs &pairs)
  {
    std::vector<std::string> sentences;
    for (const auto &pair : pairs)
      {
        const Contact &contact = pair->contact;
        if (contact.coarseness() < clearly_coarser)
          continue;
        // How much more than its own area a node of the master must reckon with.
        double                     most    = 1;
        const NodeSprings          springs = contact.node_springs();
        const std::vector<double> &own     = springs.master_areas();
        const std::vector<double>  carried = springs.carried_areas()[1];
        for (std::size_t i = 0; i < own.size(); ++i)
          if (own[i] > 0)
            most = std::max(most, carried[i] / own[i]);
        std::ostringstream text;
        set_figure_digits(text, 3);
        text << "contact " << pair->definition.side << ": facets of the slave \""
             << model.bodies[pair->slave.body].name() << "\" are " << contact.coarseness()
             << " times as wide as those of the master \"" << model.bodies[pair->master.body].name()
             << "\", where the contact area of a node is up to " << most
             << " times its own. Make the finer surface the slave";
        sentences.push_back(text.str());
      }
    return sentences;
  }

  std::vector<std::string> describe_rattling(const ContactPairs &pairs, const double dt)
  {
    std::vector<std::string> sentences;
    for (const auto &pair : pairs)
      {
        const double rattling = pair->rattling(dt);
        if (!pair->is_implicit() || !(rattling > 1.))
          continue;
        std::ostringstream text;
        set_figure_digits(text, 3);
        text << "contact " << pair->definition.side
             << ": after a separation, contact forces may oscillate between steps of " << 1e9 * dt
             << " ns at points stiffer than " << pair->contact.penalty() / rattling
             << " N/mm^3; the stiffest point has " << pair->contact.penalty()
             << " N/mm^3. Set a smaller Dynamics/time step factor";
        sentences.push_back(text.str());
      }
    return sentences;
  }
} // namespace vfife
