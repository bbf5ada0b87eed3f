// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_gear_errors_member_error_options_h
#define vfife_gear_errors_member_error_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/gear/errors/flank_deviation.h>

#include <string>
#include <vector>

namespace vfife
{
  /** A grid of deviations [um]: a row per profile position from tip to root, a column per position
   * from toe to heel. Throws InputError, also where columns L and h of a table have another order.
   */
  Eigen::MatrixXd read_deviation_grid(const std::string &path);

  /** Errors of one flank of all teeth of a member: content of "Errors/MEMBER/Concave flank". */
  struct FlankErrorOptions
  {
    std::string              pitch_list;          ///< single deviations of teeth 0, 1, ... [um]
    std::string              pitch_table;         ///< file with the same, or cumulative ones
    double                   pitch_amplitude = 0; ///< of a cosine over the teeth, cumulative [mm]
    unsigned int             pitch_order     = 1; ///< its periods in a revolution
    double                   pitch_phase     = 0; ///< [rad]
    std::string              topography;          ///< file of a grid
    std::vector<std::string> topography_teeth;    ///< the grid is of these; empty: of all
    FlankMargins             margins{0.1, 0.1};   ///< of the grid
    EaseOffTerms             terms;

    void declare(dealii::ParameterHandler &prm);

    /**
     * Cumulative pitch deviations of all teeth, against tooth 0, > 0 is metal [mm]; empty where
     * none are given. With f_k of the flanks of teeth k - 1 and k, F_k = f_1 + ... + f_k. Throws
     * InputError naming the entry below @p section where numbers do not fit @p teeth teeth, or
     * single deviations do not add up to zero over a revolution.
     */
    std::vector<double> read_pitch(const std::string &section, unsigned int teeth) const;

    /** The grid, its first row at the root, first column at the toe [mm]; empty where there is
     * none. Throws InputError naming the entry. */
    Eigen::MatrixXd read_topography(const std::string &section) const;

    /** Which teeth have the grid. Throws InputError for teeth that are not there. */
    std::vector<bool> read_teeth(const std::string &section, unsigned int teeth) const;
  };

  /** Errors of manufacture of one member: content of "Errors/Pinion" and "Errors/Gear". */
  struct MemberErrorOptions
  {
    double eccentricity           = 0; ///< of the toothing to the axis of rotation [mm]
    double eccentricity_direction = 0; ///< to which it lies, from tooth 0 about + the axis [rad]
    double wobble           = 0; ///< axial displacement of the mean pitch circle, amplitude [mm]
    double wobble_direction = 0; ///< where it is farthest from the apex, from tooth 0 [rad]
    FlankErrorOptions concave, convex;

    void declare(dealii::ParameterHandler &prm);

    const FlankErrorOptions &flank(const FlankSide side) const
    {
      return side == FlankSide::concave ? concave : convex;
    }

    /** Reads all files and lists; throws InputErrors with what is wrong, naming the entries. */
    void check(const std::string &section, unsigned int teeth) const;
  };
} // namespace vfife

#endif
