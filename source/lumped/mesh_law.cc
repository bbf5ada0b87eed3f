// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_table.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/types.h>
#include <vfife/lumped/mesh_law.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Part of s by which one of the sides is compressed, with its sign. */
    double pressed(const double s, const double backlash)
    {
      return s > 0 ? s : s < -backlash ? s + backlash : 0.;
    }

    /**
     * Throws unless they are 0, 1/N, 2/N...: only then the Fourier series meets the table at each.
     */
    void check_positions(const std::vector<double> &positions, const std::string &path)
    {
      for (std::size_t i = 0; i < positions.size(); ++i)
        if (std::abs(positions[i] - static_cast<double>(i) / positions.size()) > 1e-9)
          throw InputError("positions in the table \"" + path +
                           "\" must begin at 0 and divide one mesh cycle equally");
    }
  } // namespace

  MeshLaw MeshLaw::from_table(const Table &table, const std::string &path, const LoadLaw law)
  {
    check_positions(find_column(table, path, column::position, "mesh cycles"), path);
    const auto find = [&](const std::string_view name, const std::string &unit) {
      return find_column(table, path, name, unit);
    };
    const std::vector<double> unloaded = find(column::unloaded_transmission_error, "arcsec");
    const std::vector<double> loaded   = find(column::transmission_error, "arcsec");
    const std::vector<double> torque   = find(column::contact_torque_on("gear"), "N m");
    const std::vector<double> tangent  = find(column::tangent_stiffness, "N m/rad");
    MeshLaw                   result;
    result.reference_torque = 1e3 * std::abs(torque.front());
    const double        T0  = result.reference_torque;
    std::vector<double> stiffness, exponent, error;
    for (std::size_t i = 0; i < loaded.size(); ++i)
      {
        // At each position: s under T0, secant T0/s, tangent from the analysis, exponent p =
        // tangent/secant.
        const double windup = (unloaded[i] - loaded[i]) * arcsecond;
        if (!(windup > 0) || !(tangent[i] > 0) ||
            std::abs(1e3 * std::abs(torque[i]) - T0) > 1e-3 * T0)
          throw InputError("the table \"" + path +
                           "\" must have one torque, lags that grow under this torque, and "
                           "positive tangent stiffnesses");
        const double slope = 1e3 * tangent[i];
        const bool   line  = law == LoadLaw::tangent;
        stiffness.push_back(line ? slope : T0 / windup);
        exponent.push_back(law == LoadLaw::power ? slope * windup / T0 : 1.);
        // The tangent reaches zero torque beyond the touch of the unloaded flanks.
        error.push_back(unloaded[i] * arcsecond - (line ? windup - T0 / slope : 0.));
      }
    result.stiffness      = FourierSeries::interpolate(stiffness);
    result.exponent       = FourierSeries::interpolate(exponent);
    result.unloaded_error = FourierSeries::interpolate(error);
    return result;
  }

  double MeshLaw::torque(const double s, const double x) const
  {
    const double d = pressed(s, backlash);
    if (d == 0)
      return 0;
    // M = k d (k |d|/T0)^(p - 1), odd in d
    const double linear = stiffness.value(x) * d;
    return linear * std::pow(std::abs(linear) / reference_torque, exponent.value(x) - 1);
  }

  double MeshLaw::slope(const double s, const double x) const
  {
    const double d = pressed(s, backlash);
    // A power law: dM/dd = p M/d, and the energy is M d/(p + 1).
    return d == 0 ? 0. : exponent.value(x) * torque(s, x) / d;
  }

  double MeshLaw::energy(const double s, const double x) const
  {
    return torque(s, x) * pressed(s, backlash) / (exponent.value(x) + 1);
  }

  double MeshLaw::energy_slope(const double s, const double x) const
  {
    // energy = T0^(1-p) k^p |d|^(p+1)/(p+1)
    const double d = pressed(s, backlash);
    if (d == 0)
      return 0;
    const double k = stiffness.value(x), p = exponent.value(x);
    return energy(s, x) *
           (p * stiffness.slope(x) / k +
            exponent.slope(x) * (std::log(k * std::abs(d) / reference_torque) - 1 / (p + 1)));
  }

  double MeshLaw::compression(const double torque, const double x) const
  {
    // s = T0/k (T/T0)^(1/p)
    return reference_torque / stiffness.value(x) *
           std::pow(torque / reference_torque, 1 / exponent.value(x));
  }
} // namespace vfife
