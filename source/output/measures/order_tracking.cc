// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/output/measures/order_tracking.h>

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <string>

namespace vfife
{
  namespace
  {
    /** Angles in a turn at which samples are interpolated, of the highest order's period. */
    constexpr unsigned int points_per_period = 16;

    constexpr std::array<const char *, 3> tracked = {
      {column::dte, column::rim_dte, column::contact_force_total}};

    /** The time at which so many turns have passed, by Newton's method from a time nearby [s]. */
    double find_time(const double                         wanted,
                     const double                         nearby,
                     const std::function<double(double)> &turns,
                     const std::function<double(double)> &rate)
    {
      constexpr unsigned int most_steps = 50; // where the rate jumps
      double                 time       = nearby;
      for (unsigned int i = 0; i < most_steps; ++i)
        {
          const double step = (wanted - turns(time)) / rate(time);
          time += step;
          if (std::abs(step) * rate(time) < 1e-12)
            break;
        }
      return time;
    }

    const char *unit_of(const char *name)
    {
      return name == column::contact_force_total ? "N" : "arcsec";
    }
  } // namespace

  OrderTracking::OrderTracking(const std::vector<double>           &time,
                               const std::function<double(double)> &turns,
                               const std::function<double(double)> &rate,
                               const unsigned int                   length,
                               const unsigned int                   n_orders)
    : first_time_(time.at(0))
    , interval_((time.back() - time.front()) / (time.size() - 1))
    , length_(length)
    , n_orders_(n_orders)
  {
    if (time.size() < 4 || length < 2 || n_orders == 0)
      throw InputError("orders are tracked from four samples on, in windows of two turns and more");
    // Windows that end within the record, in half their length: n + 1 halves.
    const double first = turns(time.front()), last = turns(time.back());
    if (last - first < length * (1. - 1e-12))
      return;
    const std::size_t per_turn = points_per_period * n_orders, half = per_turn * length / 2,
                      n = static_cast<std::size_t>(
                            std::floor((last - first) * (1. + 1e-12) / length * 2. - 2.)) +
                          1;
    double nearby = time.front();
    for (std::size_t i = 0; i < (n + 1) * half; ++i)
      {
        nearby = find_time(first + static_cast<double>(i) / per_turn, nearby, turns, rate);
        times_.push_back(nearby);
      }
    for (std::size_t w = 0; w < n; ++w)
      windows_.push_back({first + 0.5 * length * w, times_[(w + 1) * half]});
  }

  const std::vector<OrderTracking::Window> &OrderTracking::windows() const
  {
    return windows_;
  }

  std::vector<std::vector<double>>
  OrderTracking::compute_amplitudes(const std::vector<double> &samples) const
  {
    const boost::math::interpolators::cardinal_cubic_b_spline<double> spline(samples.begin(),
                                                                             samples.end(),
                                                                             first_time_,
                                                                             interval_);
    std::vector<double>                                               values;
    for (const double t : times_)
      values.push_back(spline(t));

    // a_k = |2/sum w sum w y exp(-2 pi i k theta)|, w = 1 - cos(2 pi (theta - begin)/length), the
    // sums over the equally spaced angles of a window.
    const unsigned int               per_turn = points_per_period * n_orders_;
    const std::size_t                n        = static_cast<std::size_t>(length_) * per_turn;
    std::vector<std::vector<double>> amplitudes;
    for (std::size_t w = 0; w < windows_.size(); ++w)
      {
        std::vector<double> of_orders;
        for (unsigned int k = 1; k <= n_orders_; ++k)
          {
            std::complex<double> sum = 0.;
            for (std::size_t i = 0; i < n; ++i)
              sum += (1. - std::cos(2 * pi * i / n)) * values[w * n / 2 + i] *
                     std::polar(1., -2 * pi * k * i / per_turn);
            of_orders.push_back(2. * std::abs(sum) / n);
          }
        amplitudes.push_back(of_orders);
      }
    return amplitudes;
  }

  Table make_order_table()
  {
    Table table;
    table.add_column(column::time, "s");
    table.add_column(column::speed, "rpm");
    table.add_column(column::mesh_frequency, "Hz");
    table.add_column("mesh order", "-");
    for (const char *name : tracked)
      table.add_column(std::string(name) + " amplitude", unit_of(name));
    return table;
  }

  Table track_mesh_orders(const Table        &history,
                          const Transmission &pair,
                          const unsigned int  length,
                          const unsigned int  n_orders)
  {
    Table                      table = make_order_table();
    const std::vector<double> &time  = history.numbers(column::time);
    if (time.size() < 4)
      return table;
    const OrderTracking tracking(
      time,
      [&pair](const double t) { return pair.meshes(t); },
      [&pair](const double t) { return pair.mesh_frequency(t); },
      length,
      n_orders);
    std::vector<std::vector<std::vector<double>>> amplitudes;
    for (const char *name : tracked)
      amplitudes.push_back(tracking.compute_amplitudes(history.numbers(name)));
    for (std::size_t w = 0; w < tracking.windows().size(); ++w)
      for (unsigned int k = 1; k <= n_orders; ++k)
        {
          const double             at     = tracking.windows()[w].centre;
          const double             factor = pair.rate_history.value(at);
          std::vector<Table::Cell> row    = {at,
                                             pair.driver_rate * factor * 30 / pi,
                                             pair.mesh_frequency(at),
                                             k};
          for (const auto &of_column : amplitudes)
            row.emplace_back(of_column[w][k - 1]);
          table.add_row(row);
        }
    return table;
  }
} // namespace vfife
