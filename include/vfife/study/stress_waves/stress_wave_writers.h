// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_stress_waves_stress_wave_writers_h
#define vfife_study_stress_waves_stress_wave_writers_h

#include <vfife/output/observers/fillet_writers.h>
#include <vfife/output/observers/sampled_table.h>
#include <vfife/study/stress_waves/stress_wave_places.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  /** A wave of stress at a probe: number of nodal diameters, what StressWavePlaces finds. */
  struct ProbeWaveSample
  {
    std::string          probe;
    unsigned int         diameters = 0;
    double               largest   = 0; ///< von Mises stress of the probe's copies [MPa]
    StressWaves::OfProbe wave;
  };

  /** The same of strain at a facet of a fillet. */
  struct FilletWaveSample
  {
    std::string          fillet;
    unsigned int         facet     = 0; ///< rows of a column together
    unsigned int         diameters = 0;
    double               tension   = 0; ///< of the facet of all teeth [MPa]
    StressWaves::OfFacet wave;
  };

  /** Names of the columns of strain in fillet_waves.csv, less " cos" and " sin". */
  constexpr std::array<const char *, 3> strain_wave_names = {
    {"strain 11", "strain 22", "strain 12"}};

  /** Columns of probe_waves.csv and fillet_waves.csv behind the time: of a wave Re(w exp(i n k
   * alpha)) over the sectors "cos" Re w and "sin" -Im w, as in rim.csv. */
  SampleColumns<ProbeWaveSample>  list_probe_wave_columns();
  SampleColumns<FilletWaveSample> list_fillet_wave_columns();

  /** A sampled table of waves at the start and over the last mesh cycle of a run alone. */
  template <typename Sample, typename Measure>
  class LastMeshTable : public SampledTable<Sample>
  {
  public:
    /** The last mesh cycle begins at @p last_mesh [s]; @p places must outlive the object. */
    LastMeshTable(const OutputFolder              &folder,
                  const std::string               &name,
                  const SampleColumns<Sample>     &columns,
                  const std::uint64_t              steps_between,
                  const double                     last_mesh,
                  const std::vector<unsigned int> &diameters,
                  const StressWavePlaces          &places,
                  Measure                          measure)
      : SampledTable<Sample>(folder, name, columns, steps_between)
      , diameters_(diameters)
      , places_(places)
      , measure_(std::move(measure))
      , last_mesh_(last_mesh)
    {
    }

    bool due(const State &state) const override
    {
      return SampledTable<Sample>::due(state) &&
             (state.step == 0 || state.time > last_mesh_ * (1. + 1e-9));
    }

  protected:
    std::vector<unsigned int> diameters_;
    const StressWavePlaces   &places_;
    Measure                   measure_;

  private:
    double last_mesh_; ///< [s]
  };

  /** probe_waves.csv: a row a sample, probe of the driven body and number of diameters. */
  class ProbeWaveWriter : public LastMeshTable<ProbeWaveSample, ProbeMeasure>
  {
  public:
    /** @p rest: as in LastMeshTable, behind the columns. */
    template <typename... Rest>
    explicit ProbeWaveWriter(const OutputFolder &folder, const Rest &...rest)
      : LastMeshTable(folder, "probe_waves.csv", list_probe_wave_columns(), rest...)
    {
    }

  private:
    void add_rows(const Model &model, const State &state) override;
  };

  /** fillet_waves.csv: a row a sample, facet of the driven body's fillets and number of diameters.
   */
  class FilletWaveWriter : public LastMeshTable<FilletWaveSample, FilletMeasure>
  {
  public:
    /** As that of ProbeWaveWriter. */
    template <typename... Rest>
    explicit FilletWaveWriter(const OutputFolder &folder, const Rest &...rest)
      : LastMeshTable(folder, "fillet_waves.csv", list_fillet_wave_columns(), rest...)
    {
    }

  private:
    void add_rows(const Model &model, const State &state) override;
  };
} // namespace vfife

#endif
