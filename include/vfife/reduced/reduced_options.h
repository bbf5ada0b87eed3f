// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduced_options_h
#define vfife_reduced_reduced_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/fem/fem_options.h>

#include <string>

namespace vfife
{
  class Log;

  /** Elements of reduced bodies. */
  enum class BodyElements
  {
    automatic, ///< ReducedOptions::choose_elements()
    as_run,    ///< the 8-node elements and mass points of explicit runs
    quadratic, ///< curved, with consistent masses
    cubic
  };

  /** Section Reduced. */
  struct ReducedOptions
  {
    double       cutoff         = 0;   ///< modes below are kept [Hz]; 0: find_cutoff()
    unsigned int steps_per_mesh = 150; ///< at least
    unsigned int steps_per_mode = 6;   ///< at least, in the shortest period of a kept mode
    unsigned int reach          = 4;   ///< sectors on each side whose residual flexibility is kept
    BodyElements elements       = BodyElements::automatic;
    std::string  store;           ///< folder in which reduced bodies are kept; empty: none
    bool         exports = false; ///< whether their matrices are written

    // Of sweeps over speed, mesh cycles at each of them:
    unsigned int settling_meshes = 40; ///< before what is counted
    unsigned int counted_meshes  = 20;

    void declare(dealii::ParameterHandler &prm);

    /** Cut-off over the frequency at which a free ring at the gear's pitch circle breathes, at
     * least: of motions, whose eight orders of the mesh and more have to be right, and of studies
     * of waves alone (doc/reference/kinds.md, reduced). */
    static constexpr double rings_of_motions = 7, rings_of_waves = 3;

    /** The cut-off of the entry, or six orders of the mesh frequency and at least @p least [Hz]. */
    double find_cutoff(double mesh_frequency, double least) const;

    /** Elements of element type auto: quadratic elements where affords_quadratic_elements() and
     * where the model has no bearings and couplings, whose shafts need 10 GB; else, and where a
     * study is to have the elements @p as_runs, those of runs. */
    void choose_elements(const Model &model, Log &log, bool as_runs = false);

    /** Finite elements of the bodies; those of a run have this @p stiffness. Elements must have
     * been chosen. */
    FemOptions fem(StiffnessKind stiffness) const;

    /** Steps in a mesh cycle: a multiple of the @p samples of a history. */
    unsigned int find_steps(double mesh_frequency, double cutoff, unsigned int samples) const;
  };
} // namespace vfife

#endif
