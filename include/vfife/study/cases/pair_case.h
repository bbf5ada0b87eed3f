// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_pair_case_h
#define vfife_study_cases_pair_case_h

#include <vfife/base/text/table.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/gear/blank_outline.h>
#include <vfife/output/files/figures.h>
#include <vfife/study/cases/case.h>
#include <vfife/study/cases/edges_under_load.h>
#include <vfife/study/cases/operation_options.h>

#include <array>
#include <optional>
#include <vector>

namespace vfife
{
  struct BodyFigures;
  struct PairFacts;

  /**
   * Two gears in mesh, of whatever kind: all that studies of gear pairs ask for beyond a model.
   * Member 0, body 0 of the model, is the pinion. Gears of another kind are a class derived from
   * this one, a section in pair_sections and a line in make_pair_case().
   */
  class PairCase : public Case
  {
  public:
    const PairCase *pair() const override
    {
      return this;
    }

    /** Throws InputError as check(), but for a pair at rest, which a static analysis may have. */
    virtual void check_at_rest() const = 0;

    // Operation.

    const OperationOptions &operation() const
    {
      return operation_;
    }
    double mesh_frequency() const; ///< at time zero [Hz]
    /** Mesh cycles of a run. */
    double run_meshes() const;
    /** The largest speed of a run over that at time zero. */
    double largest_speed_factor() const;
    /** Torque on a member that balances the load without friction [N mm]. */
    double torque_on(unsigned int member) const;
    /** That on the driven member at time zero, given there or at the pinion, and its change with
     * time. */
    double                  driven_torque() const;
    const ParameterHistory &driven_torque_history() const;

    void                      check_run(const DynamicsOptions &dynamics) const override;
    double                    end_time() const override;
    bool                      may_be_made_longer() const override;
    std::vector<unsigned int> list_lengths(const DynamicsOptions &dynamics) const override;
    void                      set_length(unsigned int meshes) override;
    double                    ramp_time() const override;
    double                    choose_step(double stable_step, unsigned int samples) const override;

    /** Damping over ring_rate() up to which the compliance stays (doc/how-to/choose-damping.md). */
    static constexpr double recommended_damping = 0.05;

    // Checks.

    /** What these look at; the path of contact where @p with_path. */
    virtual PairFacts facts(bool with_path) const = 0;
    /** Logs both torques and Hertz's contact besides, where there is a torque. */
    std::vector<std::string> report_checks(const RunPlan &plan, Log &log) const override;
    std::string              find_cause() const override;

    // Teeth.

    virtual std::array<unsigned int, 2> teeth() const = 0; ///< numbers by member
    /** Rate sqrt(E/rho)/r at which a free ring at the pitch circle of the gear breathes [rad/s]:
     * rates of a pair are large or small against it, whatever its size is. */
    virtual double ring_rate() const = 0;

    // Contact.

    /** Of one tooth pair at the mean contact of the unloaded flanks. */
    virtual HertzContact hertz_contact() const = 0;
    /** Whether the penalty of the contact is to be found by the contact's own grid. */
    virtual bool leaves_penalty_open() const = 0;
    /** Least and largest arm of the contact force over the unloaded path of contact, parts of that
     * at the mean contact. */
    virtual Vector2 arm_range() const = 0;
    /** Turn of the gear between its flanks at the mean contact [rad]. */
    virtual double backlash_angle() const = 0;
    /** What tells whether edges of teeth carry; nothing where no pinion drives by its drive side.
     */
    virtual std::optional<EdgesUnderLoad> edges_under_load() const = 0;
    /** Nominal stresses of the standard for these gears under the torque at time zero, logged; none
     * where it does not apply, and why is logged. */
    virtual NamedFigures rate(Log &log) const = 0;

    // Bodies and their meshes.

    virtual std::array<BlankOutline, 2> outlines() const = 0;
    /** The same bodies on the mesh on which elements of reference_degree() tell how compliant the
     * springs of runs have to be; nothing where these make up for the contact alone. */
    virtual std::optional<Model> make_reference_model() const = 0;
    virtual unsigned int         reference_degree() const     = 0; ///< 2 or 3
    /** The same pair on the mesh of which submodels of its teeth are taken (RootSubmodels); nothing
     * without teeth that are generated. */
    virtual std::optional<Model> make_submodel_mesh(unsigned int cells_lengthwise) const = 0;
    /** Quality, mass and inertias of the bodies of make_model(). */
    virtual std::vector<BodyFigures> measure_bodies(const Model &model) const = 0;
    /** Outlines of the bodies in the meridian plane: meridian.csv. */
    virtual Table meridian_table() const = 0;
    /** Points of the true flanks of a member, so many lengthwise and along the profile:
     * flank_points_MEMBER.csv. */
    virtual Table
    flank_points(unsigned int member, unsigned int lengthwise, unsigned int profile) const = 0;

  protected:
    OperationOptions operation_; ///< section Operation

  private:
    void check_histories(const DynamicsOptions &dynamics) const;
    void check_dampers(const DynamicsOptions &dynamics) const;
  };
} // namespace vfife

#endif
