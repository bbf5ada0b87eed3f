// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/dynamics_options.h>
#include <vfife/dynamics/operator/congruence.h>
#include <vfife/dynamics/operator/mass_scaling.h>
#include <vfife/element/stable_step.h>
#include <vfife/model/model.h>

#include <numeric>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Masses that the elements of a body gain, by node [t], and how many elements do. */
    struct Gain
    {
      std::vector<double> masses;
      std::size_t         n_elements = 0;
    };

    Gain compute_gain(const Body &body, const StiffnessKind stiffness, const double step)
    {
      // 1. Gain of an element over its mass, (step/own step)^2 - 1 with the own step 2/omega: once
      // for each class of congruent ones.
      std::vector<std::uint32_t> elements(body.n_elements());
      std::iota(elements.begin(), elements.end(), 0U);
      const CongruenceClasses            classes = find_congruence_classes(body, elements);
      std::vector<double>                factor;
      std::vector<std::array<double, 8>> masses;
      for (const std::uint32_t e : classes.representative)
        {
          const HexahedronNodes X     = body.element_nodes(e);
          const auto            mass  = compute_lumped_mass(X, body.material(e).density);
          const double          omega = compute_largest_frequency(
            compute_stiffness(body.stress_free_nodes(e), body.material(e), stiffness), mass);
          factor.push_back(std::pow(0.5 * omega * step, 2) - 1.);
          masses.emplace_back();
          std::copy_n(mass.data(), 8, masses.back().begin());
        }

      // 2. Those that gain share it out to their nodes as their lumped mass.
      Gain gain;
      gain.masses.assign(body.n_nodes(), 0.);
      for (std::size_t e = 0; e < elements.size(); ++e)
        {
          const std::uint32_t c = classes.class_of[e];
          if (!(factor[c] > 0))
            continue;
          ++gain.n_elements;
          for (unsigned int i = 0; i < 8; ++i)
            gain.masses[body.elements()[e][i]] += factor[c] * masses[c][i];
        }
      return gain;
    }
  } // namespace

  void scale_masses(const DynamicsOptions &options, Model &model, Log &log)
  {
    if (!(options.mass_scaling_step > 0))
      return;
    for (Body &body : model.bodies)
      {
        const Gain   gain = compute_gain(body, options.stiffness, options.mass_scaling_step);
        const double share =
          std::accumulate(gain.masses.begin(), gain.masses.end(), 0.) / body.mass();
        // Refused is what would change the body's inertia, and with it vibrations and centrifugal
        // load, beyond the limit.
        if (share > options.largest_added_mass)
          {
            std::ostringstream text;
            set_figure_digits(text, 4);
            text << "body \"" << body.name() << "\" would gain " << 100 * share
                 << " % of its mass, in " << gain.n_elements << " of its " << body.n_elements()
                 << " elements; the limit is " << 100 * options.largest_added_mass
                 << " % (Dynamics/maximum added mass). Choose a smaller step, or improve the mesh";
            throw InputError("Dynamics/mass scaling step", text.str());
          }
        log.line("mass scaling: ",
                 body.name(),
                 " gains ",
                 100 * share,
                 " % of its mass, in ",
                 gain.n_elements,
                 " elements");
        // The operator scales the masses of its elements by the same rule: step and masses agree.
        body.add_masses(gain.masses);
      }
  }
} // namespace vfife
