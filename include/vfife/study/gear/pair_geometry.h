// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_pair_geometry_h
#define vfife_study_gear_pair_geometry_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/text/json.h>
#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/output/files/figures.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  struct GearPairOptions;
  class Log;
  class ParameterFile;

  /**
   * The main dimensions of a pair with everything that was derived or proposed: what a drawing
   * states. Lengths in mm, angles in deg.
   */
  class PairGeometry
  {
  public:
    /** Bodies under the teeth of pinion and gear. */
    using Bodies = std::array<GearBodyOptions, 2>;

    /** Completes the options; throws InputError where a proposal has no settings. Without @p bodies
     * nothing is said of them. */
    PairGeometry(const GearPairOptions &options, const std::optional<Bodies> &bodies);

    /** A line for the shafts, mounting and errors of manufacture that are given; then a table of
     * both members. */
    void show(Log &log) const;

    /** {"pair": {figures}, "pinion": {"hand of spiral": , figures}, "gear": likewise} */
    Json json() const;

  private:
    struct Member
    {
      std::string  name, hand;
      NamedFigures figures; ///< the same names for both
    };

    /** What of the input no model shows. */
    std::vector<std::string> settings_;
    NamedFigures             pair_;
    std::array<Member, 2>    members_;
  };

  /** The spiral bevel pair of a file. */
  GearPairOptions read_pair_options(const ParameterFile &file);

  /** Of the pair that a study reads which has declared @p prm; nothing where it reads none. Entries
   * alone do not tell what was derived or proposed. */
  std::optional<PairGeometry> find_pair_geometry(const ParameterFile            &file,
                                                 const dealii::ParameterHandler &prm);
} // namespace vfife

#endif
