// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_summary_h
#define vfife_output_files_summary_h

#include <vfife/model/state.h>
#include <vfife/output/files/figures.h>
#include <vfife/output/measures/probe_record.h>
#include <vfife/output/measures/steady_part.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;

  /** One body, internal units. */
  struct BodySummary
  {
    std::string  name;
    unsigned int cells = 0, nodes = 0;
    double       mass    = 0; ///< [t]
    double       inertia = 0; ///< about its axis [t mm^2]
    double       rate    = 0; ///< about its axis at the start [rad/s]
    double       added   = 0; ///< by mass scaling, within `mass` [t]
  };

  /**
   * What a run reports in figures; the study fills it, in internal units where no Figure says
   * otherwise. Sections that stay empty are not written.
   */
  struct RunSummary
  {
    std::string status = "finished"; ///< "finished" or "failed"
    std::string failure;             ///< message of a failed run
    std::string study, parameter_file, version, revision, instruction_set;
    int         ranks = 1;
    /** Digests of the files that entries name, by entry (list_digests()). */
    std::vector<std::pair<std::string, std::string>> input_digests;

    std::vector<BodySummary> bodies;
    double                   dt       = 0; ///< [s]
    double                   time     = 0; ///< reached [s]
    std::uint64_t            steps    = 0;
    double                   run_time = 0; ///< of the steps, wall clock [s]

    NamedFigures figures; ///< anything that is given or derived: speeds, torque, penalty, lever arm
    std::optional<SteadyPart>   steady;
    NamedFigures                transmission_error; ///< parts of the mean DTE
    NamedFigures                misalignment;       ///< of a pair on shafts, under load
    std::vector<ProbeRecord>    probes;             ///< of a gear pair
    std::optional<EnergyLedger> energy;
    std::vector<DampingAudit>   damping;
    ContactLosses               contact_losses;
    NamedFigures                timers; ///< seconds by section
    /** What a rank sends in a step, by section. */
    std::vector<std::pair<std::string, NamedFigures>> traffic;
    std::vector<std::string> contradictions; ///< checks of figures against each other that failed
    std::vector<std::string> warnings;
    std::string              nearest_wave; ///< to the speed of operation, in words; or empty
    /** What the load alone tells of the cause of a failure (Case::find_cause()); not written. */
    std::string cause;

    /** Sets status and failure, the cause before the @p message, and returns that text. */
    std::string fail(const std::string &message);

    /** Elements of all bodies times steps over the run time [1/s]; 0 without a run time. */
    double element_steps_per_second() const;
  };

  /** The JSON text of summary.json; numbers that are not finite become null. */
  std::string make_summary_text(const RunSummary &summary);

  /** Writes summary.json; only the writing rank does. */
  void write_summary(const OutputFolder &folder, const RunSummary &summary);

  /** The same with the warnings of @p log: to be called when all has been said. */
  void write_summary(const OutputFolder &folder, RunSummary summary, const Log &log);
} // namespace vfife

#endif
