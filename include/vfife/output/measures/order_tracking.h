// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_measures_order_tracking_h
#define vfife_output_measures_order_tracking_h

#include <complex>
#include <functional>
#include <vector>

namespace vfife
{
  class Table;
  struct Transmission;

  /**
   * Amplitudes of a history by orders of something that turns with changing speed, say of the tooth
   * mesh: the samples, equally spaced in time, are interpolated (cubic spline) at equally spaced
   * angles, and Fourier coefficients are taken over windows of whole turns with Hann's weights,
   * which follow each other in half their length. An amplitude that is constant over a window is
   * exact but for the interpolation; one that changes is its mean with these weights.
   */
  class OrderTracking
  {
  public:
    /** A window of turns. */
    struct Window
    {
      double begin  = 0; ///< [turns]
      double centre = 0; ///< time at its middle [s]
    };

    /**
     * @param time     of the samples, at least four, equally spaced [s]
     * @param turns    from some beginning to a time, growing
     * @param rate     its derivative [1/s]
     * @param length   of a window, whole turns, at least 2
     * @param n_orders 1, 2 ... n_orders turns^-1
     */
    OrderTracking(const std::vector<double>           &time,
                  const std::function<double(double)> &turns,
                  const std::function<double(double)> &rate,
                  unsigned int                         length,
                  unsigned int                         n_orders);

    /** As many as fit between the first and the last sample. */
    const std::vector<Window> &windows() const;

    /** Amplitudes of a column of samples: by window, then by order from 1 on. */
    std::vector<std::vector<double>> compute_amplitudes(const std::vector<double> &samples) const;

    /** Of what goes round, x + i y with these samples, the amplitudes of exp(2 pi i k turns): by
     * window, then by order k = 1, -1, 2, -2 ... */
    std::vector<std::vector<double>> compute_waves(const std::vector<double> &x,
                                                   const std::vector<double> &y) const;

  private:
    /** By window, then by order from 1 on: mean of samples times exp(-2 pi i k turns). */
    std::vector<std::vector<std::complex<double>>>
    compute_coefficients(const std::vector<double> &samples) const;

    double              first_time_, interval_; ///< of the samples [s]
    unsigned int        length_, n_orders_;
    std::vector<Window> windows_;
    /** Times of equally spaced turns [s], from the begin of the first window on. */
    std::vector<double> times_;
  };

  /** Columns of orders.csv: time [s], speed [rpm] and mesh frequency [Hz] at the middle of a
   * window, mesh order, amplitudes of transmission errors [arcsec] and contact force [N]. */
  Table make_order_table();

  /** Mesh orders of the run of a gear pair from its history, in windows of @p length mesh cycles:
   * a row a window and order; no rows where the run is shorter than one. */
  Table track_mesh_orders(const Table        &history,
                          const Transmission &pair,
                          unsigned int        length,
                          unsigned int        n_orders);

  /** Columns of rim_orders.csv: time [s], speed [rpm] and mesh frequency [Hz] at the middle of a
   * window, mesh order, wave (forward, backward), nodal diameter, amplitude [um]. */
  Table make_rim_order_table();

  /** Axial waves of the rim that mesh orders drive: of n diameters against the spin (backward) at
   * (k z + n) times the rate of the body in its turning axes, with it at (k z - n). A row a window,
   * order, number of diameters and direction from rim.csv, as track_mesh_orders(). @p sense: of the
   * driven body's turn about the axis of its sectors. */
  Table track_rim_waves(const Table        &rim,
                        const Transmission &pair,
                        double              sense,
                        unsigned int        length,
                        unsigned int        n_orders);
} // namespace vfife

#endif
