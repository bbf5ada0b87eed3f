// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_case_h
#define vfife_study_cases_case_h

#include <vfife/base/parameter_handler.h>
#include <vfife/model/model.h>

#include <string>
#include <vector>

namespace vfife
{
  class Log;
  class PairCase;
  class ParameterFile;
  struct DynamicsOptions;
  struct OutputOptions;

  /** What is known of a study before it computes: checks look at what is there. */
  struct RunPlan
  {
    const Model           *model    = nullptr; ///< nullptr: there is no mesh
    const DynamicsOptions *dynamics = nullptr; ///< nullptr: nothing moves
    const OutputOptions   *output   = nullptr; ///< of a motion

    // Of explicit runs; zero of others.
    double element_step  = 0; ///< stable step of the elements times safety [s]
    double stable_step   = 0; ///< the same after the contact's vote [s]
    double step          = 0; ///< of the run [s]
    double expected_time = 0; ///< wall time of the run [s]
  };

  /**
   * What a study is of: the sections of the parameter file that describe bodies, what holds, loads
   * and drives them, and how long they are run. The model that it makes is all that solvers see.
   */
  class Case
  {
  public:
    virtual ~Case() = default;

    /** Declares the sections of the case; names that decide what is declared are read from @p file
     * first. Bound by address: the object must stay until the file is read. */
    virtual void declare(dealii::ParameterHandler &prm, const ParameterFile &file) = 0;

    /** Throws InputError when entries contradict each other. */
    virtual void check() const = 0;

    /** The part of check() that concerns bodies and materials, not what they are run at: enough for
     * make_model(). */
    virtual void check_bodies() const;

    /** Meshes the bodies and puts the model together; logs what a user wants to know about them. */
    virtual Model make_model(Log &log) const = 0;

    /** Sets the defaults of a run's options that are others for cases of this kind; to be called
     * before these are declared. */
    virtual void set_defaults(DynamicsOptions &dynamics, OutputOptions &output) const;

    /** Declares the entries of the case in the sections of a run. */
    virtual void declare_run(dealii::ParameterHandler &prm);

    /** Throws InputError where the options of a run do not fit the case. */
    virtual void check_run(const DynamicsOptions &dynamics) const = 0;

    /** Time at which a run ends [s]. */
    virtual double end_time() const = 0;

    /** Mesh cycles, growing, after each of which a run is looked at and goes on where its ripple
     * is not steady; none where its length is given. */
    virtual std::vector<unsigned int> list_lengths(const DynamicsOptions &dynamics) const;

    /** Makes it a run of so many mesh cycles. */
    virtual void set_length(unsigned int meshes);

    /** Whether a run that goes on may end later than it was begun for: its samples do not depend
     * on its end. */
    virtual bool may_be_made_longer() const;

    /** Time over which the load torque grows where a run starts with a ramp [s]. */
    virtual double ramp_time() const;

    /** The step of a run [s], at most @p stable_step; @p samples of a history lie in a mesh cycle
     * where there is one. */
    virtual double choose_step(double stable_step, unsigned int samples) const = 0;

    /** Itself as a gear pair, whose teeth are in contact; nullptr for a general model. */
    virtual const PairCase *pair() const;

    /** Sentences about entries that contradict each other or will not give what the user expects,
     * although each of them is allowed: logged, and returned for the summary. All
     * kinds of studies look at a case by this function alone. */
    virtual std::vector<std::string> report_checks(const RunPlan &plan, Log &log) const;

    /** Where a computation has failed: what the load alone tells of the cause; empty for nothing.
     */
    virtual std::string find_cause() const;
  };

  /** A line for each constraint, torque, load, bearing with its stiffness and damping, coupling,
   * housing, wall and pair of surfaces: what a user has to look at before a run. */
  void log_parts(const Model &model, Log &log);

  /** Logs a @p sentence of Case::report_checks() and adds it to those @p found; an empty one is no
   * conflict. */
  void report_conflict(const std::string &sentence, std::vector<std::string> &found, Log &log);

  /** Warns of materials that are none of a solid (Material::find_doubts()). */
  void warn_of_materials(const Model &model, Log &log);
} // namespace vfife

#endif
