// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/output/measures/order_tracking.h>

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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
      throw InputError(
        "order tracking requires at least four samples and windows of at least two revolutions");
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

  std::vector<std::vector<std::complex<double>>>
  OrderTracking::compute_coefficients(const std::vector<double> &samples) const
  {
    const boost::math::interpolators::cardinal_cubic_b_spline<double> spline(samples.begin(),
                                                                             samples.end(),
                                                                             first_time_,
                                                                             interval_);
    std::vector<double>                                               values;
    for (const double t : times_)
      values.push_back(spline(t));

    // c_k = sum w y exp(-2 pi i k theta)/sum w, w = 1 - cos(2 pi (theta - begin)/length), the sums
    // over the equally spaced angles of a window.
    const unsigned int                             per_turn = points_per_period * n_orders_;
    const std::size_t                              n = static_cast<std::size_t>(length_) * per_turn;
    std::vector<std::vector<std::complex<double>>> coefficients;
    for (std::size_t w = 0; w < windows_.size(); ++w)
      {
        std::vector<std::complex<double>> of_orders;
        for (unsigned int k = 1; k <= n_orders_; ++k)
          {
            std::complex<double> sum = 0.;
            for (std::size_t i = 0; i < n; ++i)
              sum += (1. - std::cos(2 * pi * i / n)) * values[w * n / 2 + i] *
                     std::polar(1., -2 * pi * k * i / per_turn);
            of_orders.push_back(sum / double(n));
          }
        coefficients.push_back(of_orders);
      }
    return coefficients;
  }

  std::vector<std::vector<double>>
  OrderTracking::compute_amplitudes(const std::vector<double> &samples) const
  {
    std::vector<std::vector<double>> amplitudes;
    for (const auto &of_window : compute_coefficients(samples))
      {
        amplitudes.emplace_back();
        for (const std::complex<double> &c : of_window)
          amplitudes.back().push_back(2. * std::abs(c));
      }
    return amplitudes;
  }

  std::vector<std::vector<double>> OrderTracking::compute_waves(const std::vector<double> &x,
                                                                const std::vector<double> &y) const
  {
    const std::complex<double>       i(0., 1.);
    const auto                       of_x = compute_coefficients(x), of_y = compute_coefficients(y);
    std::vector<std::vector<double>> amplitudes(of_x.size());
    for (std::size_t w = 0; w < of_x.size(); ++w)
      for (std::size_t k = 0; k < of_x[w].size(); ++k)
        {
          // Of real samples that of -k is the conjugate.
          amplitudes[w].push_back(std::abs(of_x[w][k] + i * of_y[w][k]));
          amplitudes[w].push_back(std::abs(std::conj(of_x[w][k]) + i * std::conj(of_y[w][k])));
        }
    return amplitudes;
  }

  namespace
  {
    /** The columns that say where a row is. */
    Table make_table_of_orders()
    {
      return {{column::time, "s"},
              {column::speed, "rpm"},
              {column::mesh_frequency, "Hz"},
              {"mesh order", "-"}};
    }

    std::vector<Table::Cell>
    start_row(const double at, const unsigned int order, const Transmission &pair)
    {
      const double factor = pair.rate_history.value(at);
      return {at, pair.driver_rate * factor * 30 / pi, pair.mesh_frequency(at), order};
    }

    /** By mesh cycles. */
    OrderTracking track(const std::vector<double> &time,
                        const Transmission        &pair,
                        const unsigned int         length,
                        const unsigned int         n_orders)
    {
      return {time,
              [&pair](const double t) { return pair.meshes(t); },
              [&pair](const double t) { return pair.mesh_frequency(t); },
              length,
              n_orders};
    }
  } // namespace

  Table make_order_table()
  {
    Table table = make_table_of_orders();
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
    const OrderTracking                           tracking = track(time, pair, length, n_orders);
    std::vector<std::vector<std::vector<double>>> amplitudes;
    for (const char *name : tracked)
      amplitudes.push_back(tracking.compute_amplitudes(history.numbers(name)));
    for (std::size_t w = 0; w < tracking.windows().size(); ++w)
      for (unsigned int k = 1; k <= n_orders; ++k)
        {
          std::vector<Table::Cell> row = start_row(tracking.windows()[w].centre, k, pair);
          for (const auto &of_column : amplitudes)
            row.emplace_back(of_column[w][k - 1]);
          table.add_row(row);
        }
    return table;
  }

  Table make_rim_order_table()
  {
    Table table = make_table_of_orders();
    table.add_text_column("wave");
    table.add_column("nodal diameter", "-");
    table.add_column("amplitude", "um");
    return table;
  }

  Table track_rim_waves(const Table        &rim,
                        const Transmission &pair,
                        const double        sense,
                        const unsigned int  length,
                        const unsigned int  n_orders)
  {
    Table                      table = make_rim_order_table();
    const std::vector<double> &time  = rim.numbers(column::time);
    if (time.size() < 4)
      return table;
    const OrderTracking tracking = track(time, pair, length, n_orders);
    const auto          has      = [&rim](const std::string &name) {
      return std::any_of(rim.columns().begin(), rim.columns().end(), [&](const auto &column) {
        return column.name == name;
      });
    };
    // Waves Re(w exp(i n alpha)) in axes that stand in space are w exp(-i n phi), with whole mesh
    // orders: + sense k of those against the spin.
    std::vector<std::vector<std::vector<double>>> amplitudes;
    for (unsigned int n = 1; has("z cos " + std::to_string(n)); ++n)
      {
        const std::vector<double> &c = rim.numbers("z cos " + std::to_string(n)),
                                  &s = rim.numbers("z sin " + std::to_string(n));
        std::vector<double> x, y;
        for (std::size_t k = 0; k < time.size(); ++k)
          {
            const double turned = sense * 2. * pi * pair.meshes(time[k]) / pair.driven_teeth;
            const std::complex<double> wave =
              std::complex<double>(c[k], -s[k]) * std::polar(1., -(n * turned));
            x.push_back(wave.real());
            y.push_back(wave.imag());
          }
        amplitudes.push_back(tracking.compute_waves(x, y));
      }
    for (std::size_t w = 0; w < tracking.windows().size(); ++w)
      for (unsigned int k = 1; k <= n_orders; ++k)
        for (std::size_t n = 0; n < amplitudes.size(); ++n)
          for (const bool backward : {true, false})
            {
              std::vector<Table::Cell> row = start_row(tracking.windows()[w].centre, k, pair);
              row.emplace_back(backward ? "backward" : "forward");
              row.emplace_back(static_cast<double>(n + 1));
              row.emplace_back(amplitudes[n][w][2 * (k - 1) + (backward == (sense > 0) ? 0 : 1)]);
              table.add_row(row);
            }
    return table;
  }
} // namespace vfife
