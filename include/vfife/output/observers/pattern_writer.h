// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_pattern_writer_h
#define vfife_output_observers_pattern_writer_h

#include <vfife/base/types.h>
#include <vfife/model/observer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vfife
{
  class OutputFolder;

  /**
   * pattern.csv: the contact pattern of a gear pair, i.e. what every place of a flank has carried
   * during the last tooth mesh of the run on whichever tooth: body, side, r [mm] and z [mm] of the
   * undeformed place in the body's axial section, largest pressure [MPa] (nodal contact force over
   * the node's area). In one tooth mesh the teeth in contact pass through all mesh positions.
   */
  class PatternWriter : public Observer
  {
  public:
    /** Samples from @p start [s] on are looked at. */
    PatternWriter(const OutputFolder &folder,
                  const Model        &model,
                  double              start,
                  std::uint64_t       steps_between);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;
    void        finish(const Model &model, const State &state) override;

  private:
    /** Flank of one side on one body; its places are nodes of a single tooth. */
    struct Flank
    {
      unsigned int              body = 0;
      std::string               side;
      std::vector<unsigned int> nodes;            ///< of the body, of all teeth
      std::vector<double>       areas;            ///< of the nodes [mm^2]
      std::vector<unsigned int> places;           ///< of the nodes
      std::vector<Vector2>      r_z;              ///< of the places [mm]
      std::vector<double>       largest_pressure; ///< of the places [MPa]
    };

    static Flank make_flank(const Model       &model,
                            unsigned int       body,
                            const std::string &surface,
                            const std::string &side);

    const OutputFolder &folder_;
    double              start_;
    std::uint64_t       steps_between_;
    std::vector<Flank>  flanks_;
  };
} // namespace vfife

#endif
