// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_reduced_pair_of_bodies_h
#define vfife_tests_reduced_pair_of_bodies_h

#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/model/state.h>
#include <vfife/reduced/body_reduction.h>
#include <vfife/reduced/pair_readings.h>
#include <vfife/reduced/reduced_pair.h>

#include <cmath>
#include <utility>
#include <vector>

/** Pairs of reduced bodies that differ in their models and steps. */
namespace pair_of_bodies
{
  using namespace vfife;

  constexpr char given_penalty[] = "subsection Contact\n set penalty = 3e5\nend\n";

  inline std::vector<ReducedBody>
  reduce(const Model        &model,
         const double        cutoff,
         const unsigned int  reach,
         const Communicator &world,
         const FemOptions   &fem = make_fem_options(StiffnessKind::incompatible_modes))
  {
    std::vector<ReducedBody> bodies;
    for (unsigned int b = 0; b < 2; ++b)
      bodies.push_back(reduce_body(model,
                                   b,
                                   {list_touch_nodes(model, b),
                                    list_readings(model, b, fem, 2),
                                    fem,
                                    model.bodies[b].rate,
                                    2. * pi * cutoff,
                                    reach},
                                   world));
    return bodies;
  }

  inline ReducedPair
  make_pair(const Model &model, std::vector<ReducedBody> bodies, const ReducedPairOptions &options)
  {
    return ReducedPair(model, std::move(bodies), options);
  }

  inline State measure(ReducedPair &pair)
  {
    State state;
    pair.measure(state);
    return state;
  }

  /** Transmission error of whole bodies in an equilibrium [rad]. */
  inline double
  error_of(const Model &model, const Compliance &compliance, const PairEquilibriumResult &at)
  {
    const Transmission &t = *model.only_transmission();
    return t.driven_start - t.ratio() * t.driver_start +
           lead_of_driven(compliance.space(), at.turn, at.displacements);
  }

  /** Root of the mean square. */
  inline double distance(const std::vector<double> &a, const std::vector<double> &b)
  {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / a.size());
  }
} // namespace pair_of_bodies

#endif
