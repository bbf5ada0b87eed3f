// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/dynamics/equilibrium/standing_pattern.h>
#include <vfife/dynamics/loop/explicit_solver.h>
#include <vfife/model/pair_measures.h>
#include <vfife/output/files/result_places.h>
#include <vfife/output/files/summary.h>
#include <vfife/output/measures/pair_mounting.h>
#include <vfife/output/observers/progress_line.h>
#include <vfife/study/run/pair_preload.h>
#include <vfife/study/run/pair_start.h>

#include <cmath>
#include <optional>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** The pattern changes its own forces of inertia by (n Omega/omega_n)^2, n waves around a body
     * of frequency omega_n: a few per cent. */
    constexpr unsigned int pattern_rounds = 2;

    /** Teeth share the load the better, the larger it is: the swing sees the slope at full torque,
     * which is taken from here to there. */
    constexpr double partial_load = 0.9;

    /** Of the torque, where flanks just touch. */
    constexpr double touching_load = 1e-3;
  } // namespace

  double compute_penalty_lag(const double contact_energy, const double torque)
  {
    // Springs k of depth d hold k d^2/2, and T psi, force times way, is k d^2: psi = 2 energy/T.
    return 2. * contact_energy / torque;
  }

  void add_preload(const PairPreload &preload, const bool on_shafts, RunSummary &summary)
  {
    const DeflectionParts &parts    = preload.parts;
    const SupportParts    &supports = preload.supports;
    const auto             add      = [&](const char *name, const double part) {
      if (std::isfinite(part))
        summary.transmission_error.push_back({name, {part / arcsecond, "arcsec"}});
    };
    add(error_part::total, parts.total);
    add(error_part::teeth_and_rest, parts.teeth);
    add(error_part::web_windup, parts.web_windup);
    add(error_part::rim_tilt_and_shift, parts.rim_tilt);
    add(error_part::centrifugal_shift, parts.centrifugal);
    add(error_part::rim_bending, preload.rim_bending);
    if (on_shafts)
      {
        add(error_part::bearings, supports.bearings);
        add(error_part::shaft_bending, supports.bending);
        for (const MountingNumber &one : list_numbers(preload.misalignment))
          summary.misalignment.push_back({one.name, {one.value, one.unit}});
      }
    const Swing &swing = preload.swing;
    summary.figures.push_back({"torsional stiffness", {1e-3 * swing.stiffness, "N m/rad"}});
    summary.figures.push_back({"inertia of the torsional mode", {1e-3 * swing.inertia, "kg m^2"}});
    summary.figures.push_back({figure_name::torsional_frequency, {swing.frequency(), "Hz"}});
  }

  PreloadedPair::PreloadedPair(const StartMeans &means)
    : means_(means)
  {
  }

  void PreloadedPair::prepare(State &state)
  {
    const auto      start = WallClock::now();
    Relaxation      relaxation(means_.model,
                          means_.options.relaxation,
                          means_.solver.vfife_operator(),
                          means_.solver.contact(),
                          means_.solver.walls(),
                          means_.communicator,
                          means_.log);
    DeflectionProbe probe(means_.model, means_.communicator);
    const double    torque = load_torque(means_.model);
    means_.log.line("equilibrium before the start:");
    std::optional<PairStart> factors;
    if (means_.options.start_solver == StartSolver::factorization)
      factors.emplace(means_.model,
                      means_.options,
                      relaxation,
                      std::move(means_.compliance),
                      means_.communicator,
                      means_.log);
    // Each equilibrium starts from the one before. Both ways to it have the same result up to their
    // tolerance.
    const auto relax = [&](const char *name, const Relaxation::Loads &loads) {
      means_.log.line("  ",
                      name,
                      ": ",
                      factors ? factors->solve(state, loads)
                              : relaxation.solve(state, loads).describe());
    };

    // 1. Centrifugal force alone.
    // Contact and torque are away and the hub is held: what the flanks do here is the centrifugal
    // part of the transmission error.
    Relaxation::Loads spinning;
    spinning.torque        = 0;
    spinning.contact       = false;
    spinning.hold_rotation = true;
    relax("spinning", spinning);
    probe.take_spun(state);

    // 2. A part of the torque, then all of it: the slope between both is the swing's stiffness.
    Relaxation::Loads partly;
    partly.torque = partial_load;
    // A state that is passed through: a tenth of the torque moves far more than the tolerance
    // leaves.
    partly.looseness = 10;
    relax("at 0.9 of the torque", partly);
    probe.take_partly_loaded(state, partly.torque * torque);
    relax("loaded", Relaxation::Loads());
    preload_.parts       = probe.take_loaded(state);
    preload_.supports    = probe.supports();
    preload_.rim_bending = probe.rim_bending();
    if (PairMounting::changes(means_.model))
      preload_.misalignment = PairMounting(means_.model).measure(state, means_.communicator);
    // The springs' energy is that of the state just found: to be asked before the next one.
    preload_.penalty_lag = compute_penalty_lag(means_.solver.contact().sums().energy(), torque);
    preload_.swing       = probe.compute_swing(state, torque);

    // 3. Where the run begins.
    StandingPattern   pattern(means_.model, means_.communicator);
    const SwingMotion swing = find_swing(factors ? &*factors : nullptr, torque);
    begin(swing, torque, relax, pattern, state);
    means_.log.line("  took ", duration_text(seconds_since(start)));
    // Velocities come last, of the places found: omega x r, and Omega u' of the standing pattern,
    // which a ramp has not.
    means_.solver.set_windings(relaxation.windings());
    means_.solver.set_initial_velocities(state);
    pattern.add_velocities(state.velocity);
    log_preload();
  }

  SwingMotion PreloadedPair::find_swing(const PairStart *const factors, const double torque) const
  {
    if (factors == nullptr || factors->static_errors().empty())
      return {};
    const SwingMotion swing = find_steady_swing(factors->static_errors(),
                                                preload_.swing,
                                                means_.model.only_transmission()->mesh_frequency(),
                                                means_.options.mesh_damping,
                                                torque);
    means_.log.line("  the torsional oscillation starts in its steady state: transmission error ",
                    swing.error / arcsecond,
                    " arcsec beyond the static one, flank torque ",
                    swing.torque,
                    " of the load torque");
    return swing;
  }

  void PreloadedPair::begin(const SwingMotion &swing,
                            const double       torque,
                            const Relax       &relax,
                            StandingPattern   &pattern,
                            State             &state) const
  {
    if (means_.options.start == Start::ramp)
      {
        // So little torque closes the flanks of the spun shapes and hardly deforms them.
        Relaxation::Loads touching;
        touching.torque = touching_load;
        relax("touching", touching);
        return;
      }
    const Transmission &t = *means_.model.only_transmission();
    // The pattern follows from the shape and its forces of inertia change the shape: in turn.
    for (unsigned int round = 0; round < pattern_rounds; ++round)
      {
        pattern.update(state);
        pattern.add_turn(state,
                         t.driven,
                         t.driven_sense * swing.rate,
                         t.driven_sense * (swing.torque - 1.) * torque);
        Relaxation::Loads standing;
        standing.pattern = &pattern;
        relax("stationary in the fixed frame", standing);
      }
  }

  void PreloadedPair::serialize(ByteStream &stream)
  {
    stream.pass(preload_.parts, preload_.swing, preload_.penalty_lag);
    if (PairMounting::changes(means_.model))
      stream.pass(preload_.supports, preload_.misalignment);
  }

  void PreloadedPair::serialize_later(ByteStream &stream)
  {
    stream.pass(preload_.rim_bending);
  }

  const PairPreload *PreloadedPair::preload() const
  {
    return &preload_;
  }

  void PreloadedPair::log_preload() const
  {
    const DeflectionParts &parts = preload_.parts;
    means_.log.line("transmission error under load ",
                    parts.total / arcsecond,
                    means_.model.has_initial_strains() ? " arcsec: centrifugal and thermal shift "
                                                       : " arcsec: centrifugal shift ",
                    parts.centrifugal / arcsecond,
                    ", web windup ",
                    parts.web_windup / arcsecond,
                    ", rim tilt and shift ",
                    parts.rim_tilt / arcsecond,
                    ", rim bending ",
                    preload_.rim_bending / arcsecond,
                    ", teeth, pinion and remainder ",
                    parts.teeth / arcsecond,
                    "; of these the contact penalty causes ",
                    -preload_.penalty_lag / arcsecond,
                    " arcsec");
    if (PairMounting::changes(means_.model))
      {
        std::ostringstream misalignment;
        set_figure_digits(misalignment, 4);
        for (const MountingNumber &one : list_numbers(preload_.misalignment))
          misalignment << (misalignment.tellp() > 0 ? ", " : "") << one.name << " " << one.value
                       << " " << one.unit;
        means_.log.line("bearings account for ",
                        preload_.supports.bearings / arcsecond,
                        " arcsec and shaft bending for ",
                        preload_.supports.bending / arcsecond,
                        " arcsec of the whole; misalignment under load: ",
                        misalignment.str());
      }
    means_.log.line("torsional natural frequency of the driven member about ",
                    preload_.swing.frequency(),
                    " Hz, ",
                    means_.model.only_transmission()->mesh_frequency() / preload_.swing.frequency(),
                    " mesh cycles per period: stiffness ",
                    1e-3 * preload_.swing.stiffness,
                    " N m/rad, inertia of the torsional mode ",
                    1e3 * preload_.swing.inertia,
                    " kg mm^2");
  }
} // namespace vfife
