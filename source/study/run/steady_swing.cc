// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/sample_measures.h>
#include <vfife/base/types.h>
#include <vfife/model/model.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/run/deflection_parts.h>
#include <vfife/study/run/steady_swing.h>

#include <cmath>
#include <complex>

namespace vfife
{
  namespace
  {
    /** Of the load, that the inertia may take from the flanks or add to them at the start. */
    constexpr double largest_part = .5;

    /** An order of the gear mesh. */
    struct Order
    {
      unsigned int         number;
      double               omega;             ///< [rad/s]
      std::complex<double> amplitude, answer; ///< of the static error and of the swing [rad]
    };

    /** s_n exp(i n omega t) and x_n = w^2 / (w^2 - (n omega)^2 + i n omega zeta_k) s_n. */
    std::vector<Order> find_orders(const std::vector<double> &errors,
                                   const Swing               &swing,
                                   const double               mesh_frequency,
                                   const double               mesh_damping)
    {
      const std::size_t  n      = errors.size();
      const double       square = swing.stiffness / swing.inertia;
      std::vector<Order> orders;
      for (unsigned int number = 1; 2 * number <= n; ++number)
        {
          Order order{number, 2. * pi * number * mesh_frequency, 0., 0.};
          for (std::size_t k = 0; k < n; ++k)
            order.amplitude += errors[k] * std::polar(1., -2. * pi * number * k / n);
          order.amplitude *= (2 * number == n ? 1. : 2.) / n;
          order.answer =
            square /
            std::complex<double>(square - order.omega * order.omega, order.omega * mesh_damping) *
            order.amplitude;
          orders.push_back(order);
        }
      return orders;
    }
  } // namespace

  std::vector<double> find_swing_errors(const std::vector<double> &errors,
                                        const Swing               &swing,
                                        const double               mesh_frequency,
                                        const double               mesh_damping)
  {
    const std::size_t   n = errors.size();
    std::vector<double> found(n, mean_of(errors));
    for (const Order &order : find_orders(errors, swing, mesh_frequency, mesh_damping))
      for (std::size_t k = 0; k < n; ++k)
        found[k] += std::real(order.answer * std::polar(1., 2. * pi * order.number * k / n));
    return found;
  }

  void add_spring_excitation(const Model &model,
                             const Swing &swing,
                             const double mesh_damping,
                             RunSummary  &summary,
                             Log         &log)
  {
    if (model.transmissions.empty() || model.contacts.empty() || !(swing.frequency() > 0))
      return;
    const std::vector<double> &errors = model.contacts.front().spring_errors;
    if (errors.empty())
      return;
    const Transmission       &t = *model.only_transmission();
    const std::vector<double> moving =
      find_swing_errors(errors, swing, t.mesh_frequency(), mesh_damping);
    std::vector<double> forces;
    for (std::size_t k = 0; k < errors.size(); ++k)
      forces.push_back(swing.stiffness / t.arm * (moving[k] - errors[k]));
    const double at_rest = peak_to_peak_of(errors) / arcsecond,
                 in_run  = peak_to_peak_of(moving) / arcsecond;
    summary.figures.push_back({figure_name::spring_error_at_rest, {at_rest, "arcsec"}});
    summary.figures.push_back({figure_name::spring_error, {in_run, "arcsec"}});
    summary.figures.push_back({figure_name::spring_force, {peak_to_peak_of(forces), "N"}});
    const ContactPair &pair = model.contacts.front();
    for (unsigned int side = 0; side < 2; ++side)
      for (unsigned int way = 0; way < 2; ++way)
        summary.figures.push_back(
          {model.bodies[side == 0 ? pair.slave_body : pair.master_body].name() +
             (way == 0 ? " facets passed per gear mesh along the face"
                       : " facets passed per gear mesh along the profile"),
           {pair.facets_passed[side][way], "-"}});
    log.line("numerical noise by the contact points, peak to peak: transmission error ",
             at_rest,
             " arcsec at rest, ",
             in_run,
             " arcsec at this speed, contact force ",
             peak_to_peak_of(forces),
             " N");
  }

  SwingMotion find_steady_swing(const std::vector<double> &errors,
                                const Swing               &swing,
                                const double               mesh_frequency,
                                const double               mesh_damping,
                                const double               torque)
  {
    SwingMotion motion;
    if (!(swing.frequency() > 0) || !(mesh_frequency > 0))
      return motion;
    const std::size_t n = errors.size();
    for (const Order &order : find_orders(errors, swing, mesh_frequency, mesh_damping))
      {
        motion.error += std::real(order.answer - order.amplitude);
        // The order of half the positions has no phase.
        if (2 * order.number != n)
          motion.rate += std::real(std::complex<double>(0., order.omega) * order.answer);
      }
    const double change = swing.stiffness * motion.error / torque;
    const double scale  = std::abs(change) > largest_part ? largest_part / std::abs(change) : 1.;
    motion.error *= scale;
    motion.rate *= scale;
    // The error is negative: a larger one is a smaller windup.
    motion.torque = 1. - scale * change;
    return motion;
  }
} // namespace vfife
