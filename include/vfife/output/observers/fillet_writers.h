// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_fillet_writers_h
#define vfife_output_observers_fillet_writers_h

#include <vfife/output/measures/root_stress.h>
#include <vfife/output/observers/sampled_table.h>

#include <functional>
#include <vector>

namespace vfife
{
  class Communicator;

  /** The strains of the fillets' surfaces in a state; on all ranks. */
  using FilletMeasure = std::function<FilletStrains(const State &)>;

  /** The strains from where a run's nodes are: places of all nodes of the fillets, of all ranks. */
  class FilletPlaces
  {
  public:
    /** Everything given must outlive the object. */
    FilletPlaces(const Model &model, const RootStress &stress, const Communicator &communicator);

    /** Collective; holds until the next call. */
    FilletStrains measure(const State &state);

  private:
    const Model              &model_;
    const Communicator       &communicator_;
    std::vector<unsigned int> nodes_;  ///< of the model
    std::vector<unsigned int> index_;  ///< among these, of each node of the model
    std::vector<double>       places_; ///< [mm]
  };

  /** root_stress.csv, a row a sample and recorded tooth; fillet_envelope.csv and root_sections.csv
   * at the end. */
  class RootStressWriter : public SampledTable<RootStressSample>
  {
  public:
    /** @p stress must outlive the object. */
    RootStressWriter(const OutputFolder &folder,
                     std::uint64_t       steps_between,
                     RootStress         &stress,
                     FilletMeasure       measure);

    void serialize(ByteStream &stream) override;
    void finish(const Model &model, const State &state) override;

  private:
    void add_rows(const Model &model, const State &state) override;

    const OutputFolder &folder_;
    RootStress         &stress_;
    FilletMeasure       measure_;
  };

  /** gauges.csv: a row a sample and gauge. */
  class GaugeWriter : public SampledTable<GaugeSample>
  {
  public:
    /** @p stress must outlive the object. */
    GaugeWriter(const OutputFolder &folder,
                std::uint64_t       steps_between,
                const RootStress   &stress,
                FilletMeasure       measure);

  private:
    void add_rows(const Model &model, const State &state) override;

    const RootStress &stress_;
    FilletMeasure     measure_;
  };
} // namespace vfife

#endif
