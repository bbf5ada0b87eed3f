// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>
#include <vfife/study/stress_waves/stress_wave_writers.h>

namespace vfife
{
  namespace
  {
    /** Columns "NAME cos", "NAME sin" of the amplitudes of a wave, times @p factor. */
    template <typename Sample, typename Names>
    void add_amplitudes(const Names           &names,
                        const std::string     &unit,
                        const double           factor,
                        SampleColumns<Sample> &columns)
    {
      for (std::size_t c = 0; c < names.size(); ++c)
        {
          const std::string name = names[c];
          columns.add(name + " cos", unit, [c, factor](const Sample &sample) {
            return factor * sample.wave[c].real();
          });
          columns.add(name + " sin", unit, [c, factor](const Sample &sample) {
            return -factor * sample.wave[c].imag();
          });
        }
    }
  } // namespace

  SampleColumns<ProbeWaveSample> list_probe_wave_columns()
  {
    using Here = const ProbeWaveSample &;
    SampleColumns<ProbeWaveSample> columns;
    columns.add_text(column::probe, [](Here here) { return here.probe; });
    columns.add("nodal diameter", "-", [](Here here) { return here.diameters; });
    columns.add("largest von mises", "MPa", [](Here here) { return here.largest; });
    add_amplitudes(column::stresses(column::cylindrical_axes), "MPa", 1., columns);
    return columns;
  }

  SampleColumns<FilletWaveSample> list_fillet_wave_columns()
  {
    using Here = const FilletWaveSample &;
    SampleColumns<FilletWaveSample> columns;
    columns.add_text("fillet", [](Here here) { return here.fillet; });
    columns.add("facet", "-", [](Here here) { return here.facet; });
    columns.add("nodal diameter", "-", [](Here here) { return here.diameters; });
    columns.add("largest tension", "MPa", [](Here here) { return here.tension; });
    add_amplitudes(strain_wave_names, "um/m", 1e6, columns);
    return columns;
  }

  void ProbeWaveWriter::add_rows(const Model &, const State &state)
  {
    const std::vector<double> largest = places_.measure_probes(measure_);
    for (const unsigned int n : diameters_)
      {
        const StressWaves waves = places_.measure(n, measure_, nullptr);
        for (std::size_t p = 0; p < waves.probes.size(); ++p)
          add_row(state, {places_.names()[p], n, largest[p], waves.probes[p]});
      }
  }

  void FilletWaveWriter::add_rows(const Model &, const State &state)
  {
    const FilletStrains              strains = measure_(state);
    std::vector<std::vector<double>> tensions;
    for (std::size_t f = 0; f < places_.fillets().size(); ++f)
      tensions.push_back(places_.measure_tensions(f, strains));
    for (const unsigned int n : diameters_)
      {
        const StressWaves waves = places_.measure(n, nullptr, &strains);
        for (std::size_t f = 0; f < waves.fillets.size(); ++f)
          for (unsigned int facet = 0; facet < waves.fillets[f].size(); ++facet)
            add_row(state,
                    {places_.names()[places_.n_probes() + f],
                     facet,
                     n,
                     tensions[f][facet],
                     waves.fillets[f][facet]});
      }
  }
} // namespace vfife
