// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_study_kinds_h
#define vfife_study_study_kinds_h

#include <vfife/base/parameters/parameters.h>
#include <vfife/study/study_kind.h>

#include <memory>
#include <string>

namespace vfife
{
  class CaseRunner;

  /** Study kind `run`: explicit dynamics of a gear pair or a general model from the start to the
   * end, with all results. */
  std::unique_ptr<StudyKind> make_run_study();

  /** Study kind `reduced`: the gear pair of an explicit run with its bodies reduced to modes and
   * residual flexibilities, with the results of a run but for fields. */
  std::unique_ptr<StudyKind> make_reduced_study();

  /** Study kind `waves`: speeds at which orders of the gear mesh meet travelling waves of the
   * driven gear, what the pair, reduced or as explicit runs, does at and around each, and which
   * speeds to avoid. Runs have folders of their own, line_1_speed_1 and so on; with --restart
   * finished ones with the same entries are kept, and others go on from their checkpoints. */
  std::unique_ptr<StudyKind> make_waves_study(const CaseRunner &runner);

  /**
   * Study kind `static`: equilibrium of a general model by dynamic relaxation, load step by load
   * step. Bodies with a speed are in equilibrium with their centrifugal force. A row of the
   * histories a load step; its time is the part of the loads.
   */
  std::unique_ptr<StudyKind> make_static_study();

  /**
   * Study kind `tooth contact analysis`: unloaded contact of both sides of a gear pair; writes
   * tca.csv, path.csv and tca.json.
   */
  std::unique_ptr<StudyKind> make_tooth_contact_study();

  /**
   * Study kind `flank fit`: writes the measuring grids of all flanks of a pair
   * (grid_MEMBER_FLANK.csv) and, where a measured flank is given, finds the machine settings that
   * cut it (flank_fit.csv, flank_fit.json, fitted_pair.prm).
   */
  std::unique_ptr<StudyKind> make_flank_fit_study();

  /** Study kind `mesh`: builds the bodies of a gear pair, reports their quality, mass and inertia
   * (mesh.csv, mesh.json) and exports them. Speed and torque are not needed. */
  std::unique_ptr<StudyKind> make_mesh_study();

  /** Study kind `modal`: natural vibrations of the bodies of a gear pair or a general model, each
   * for itself, at rest and at speed. */
  std::unique_ptr<StudyKind> make_modal_study();

  /**
   * Study kind `linear static`: small displacements of a general model, or of the members of a
   * gear pair in their turning axes without contact and torque, by conventional finite elements.
   * The file is that of a run: section Dynamics is read and not used.
   */
  std::unique_ptr<StudyKind> make_linear_static_study();

  /**
   * Study kind `loaded tooth contact analysis`: static equilibrium of the loaded pair by
   * conventional finite elements at positions over one mesh cycle, with the penalties of a run of
   * the same file.
   */
  std::unique_ptr<StudyKind> make_loaded_contact_study();

  /**
   * Study kind `lumped`: a gear pair of few degrees of freedom (doc/theory/lumped.md), by values or
   * with inertias and geometry of a section Gear pair; writes lumped.csv, resonance.csv,
   * lumped.json.
   */
  std::unique_ptr<StudyKind> make_lumped_study();

  /** Study kind `sweep`: see SweepStudy. */
  std::unique_ptr<StudyKind> make_sweep_study(const CaseRunner &runner);

  /**
   * Study kind `compare`: does explicit, conventional and lumped cases of the same thing, or reads
   * what they have left, and writes their numbers beside each other: comparison.json,
   * comparison.csv.
   *
   * Each case has a folder of its name in that of the study. A case that is finished there with the
   * same parameters is read; one with a checkpoint goes on.
   */
  std::unique_ptr<StudyKind> make_compare_study(const CaseRunner &runner);

  /** Makes a study; one that is made of cases does them by the runner, which outlives it. */
  using MakeStudy = std::unique_ptr<StudyKind> (*)(const CaseRunner &);

  /** A kind of study as the table has it. */
  struct KnownStudy
  {
    MakeStudy make = nullptr;
    /** The file that a study writes last: where it is, all results are. A summary.json says so
     * itself, by its status. Empty for kinds of which no file tells. */
    std::string last_file;

    bool operator==(const KnownStudy &other) const
    {
      return make == other.make;
    }
  };

  /** All kinds of studies by their words in `Study/kind`. */
  const Choices<KnownStudy> &study_kinds();

  /** Section Study. */
  struct StudyOptions
  {
    KnownStudy  kind          = study_kinds().front().second;
    std::string output_folder = "results";

    void declare(dealii::ParameterHandler &prm);
  };
} // namespace vfife

#endif
