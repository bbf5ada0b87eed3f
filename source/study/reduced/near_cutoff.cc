// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/table.h>
#include <vfife/base/types.h>
#include <vfife/model/transmission.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/study/reduced/near_cutoff.h>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Cut-off over the highest frequency of what is wanted. */
    constexpr double enough = 3;
  } // namespace

  MeshOrderContent find_strongest_order(const std::vector<double> &samples,
                                        const unsigned int         samples_per_mesh,
                                        const unsigned int         first_order)
  {
    // The mean mesh has all that repeats with the mesh, and Fourier's sums over it are short.
    const std::size_t meshes = samples.size() / samples_per_mesh;
    MeshOrderContent  strongest;
    if (meshes == 0)
      return strongest;
    std::vector<double> mean(samples_per_mesh, 0.);
    for (std::size_t i = 0; i < meshes * samples_per_mesh; ++i)
      mean[i % samples_per_mesh] += samples[i] / meshes;
    for (unsigned int order = first_order; 2 * order < samples_per_mesh; ++order)
      {
        Complex sum = 0;
        for (unsigned int i = 0; i < samples_per_mesh; ++i)
          sum += mean[i] * std::polar(1., -2. * pi * order * i / samples_per_mesh);
        const double peak_to_peak = 4. * std::abs(sum) / samples_per_mesh;
        if (peak_to_peak > strongest.peak_to_peak)
          strongest = {order, peak_to_peak};
      }
    return strongest;
  }

  NearCutoff::NearCutoff(const double cutoff)
    : cutoff_(cutoff)
  {
  }

  void NearCutoff::look(const std::vector<double> &errors,
                        const unsigned int         samples_per_mesh,
                        const double               mesh_frequency,
                        const double               speed,
                        const double               stated)
  {
    const auto first = static_cast<unsigned int>(std::floor(.5 * cutoff_ / mesh_frequency)) + 1;
    const MeshOrderContent found = find_strongest_order(errors, samples_per_mesh, first);
    if (!(found.peak_to_peak > share_ * stated))
      return;
    largest_        = found;
    mesh_frequency_ = mesh_frequency;
    speed_          = speed;
    stated_         = stated;
    share_          = found.peak_to_peak / stated;
  }

  void NearCutoff::tell(NamedFigures &figures, Log &log) const
  {
    if (!(share_ > told_share))
      return;
    const double frequency = largest_.order * mesh_frequency_;
    figures.push_back({figure_name::order_near_cutoff, {double(largest_.order), "-"}});
    figures.push_back({figure_name::error_near_cutoff, {largest_.peak_to_peak, "arcsec"}});
    log.warning("mesh order ",
                largest_.order,
                " (",
                frequency,
                " Hz at ",
                speed_,
                " rpm) has ",
                largest_.peak_to_peak,
                " arcsec of the transmission error, ",
                stated_,
                " arcsec peak to peak; it is above half of the cut-off of ",
                cutoff_,
                " Hz, where reduced bodies are inaccurate. Set Reduced/cutoff frequency = ",
                std::ceil(1e-3 * enough * frequency),
                " kHz");
  }

  void tell_near_cutoff(const Table        &history,
                        const Transmission &pair,
                        const double        cutoff,
                        RunSummary         &summary,
                        Log                &log)
  {
    if (!summary.steady)
      return;
    const std::vector<double> &errors = history.numbers(column::dte),
                              &time   = history.numbers(column::time);
    const double interval             = (time.back() - time.front()) / (time.size() - 1);
    NearCutoff   near(cutoff);
    near.look({errors.begin() + summary.steady->first_row,
               errors.begin() + summary.steady->end_row},
              std::lround(1. / (interval * pair.mesh_frequency())),
              pair.mesh_frequency(),
              pair.driver_rate * 30. / pi,
              summary.steady->column(column::dte).peak_to_peak);
    near.tell(summary.figures, log);
  }
} // namespace vfife
