# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What plots and chapters need of a run's folder or of a study: a function each, true or false."""
import numpy as np

from .columns import CONTACT_FORCE, TRANSMISSION_ERROR


def has_history(run):
    return run.history is not None and run.history.n_rows > 2


def has_contact(run):
    """A history of bodies that have touched."""
    return has_history(run) and (has_pair(run) or (CONTACT_FORCE in run.history and bool(np.any(run.history[CONTACT_FORCE]))))


def has_pair(run):
    """A history of a gear pair."""
    return has_history(run) and TRANSMISSION_ERROR in run.history


def has_tooth_mesh(run):
    """A history of a gear pair and the mesh frequency."""
    return has_pair(run) and bool(run.samples_per_mesh())


def has_tooth_pressures(run):
    return has_tooth_mesh(run) and run.teeth is not None and "hertz pressure" in run.teeth


def has_pattern(run):
    return run.pattern is not None


def has_patterns(study):
    """Contact patterns to be looked at beside each other."""
    return len(study.patterns()) > 1


def has_probes(run):
    """Stresses over time; an equilibrium has one instant."""
    return run.probes is not None and bool(np.ptp(run.probes["time"]) > 0)


def has_model_probes(run):
    """A motion of a model without a gear pair, with probes."""
    return has_history(run) and not has_pair(run) and any(name.endswith(" displacement x") for name in run.history.columns)


def has_rim(run):
    return run.rim is not None and run.rim.n_rows > 10


def has_rim_over_meshes(run):
    return has_rim(run) and bool(run.samples_per_mesh())


def has_orders(run):
    """Amplitudes by mesh orders of a run whose speed changes."""
    return run.orders is not None


def changes_speed(run):
    """A history of a gear pair whose speed changes."""
    return has_pair(run) and run.changes_speed() and "mesh frequency" in run.history


def has_bearings(run):
    return run.bearings is not None


def has_misalignment(run):
    return run.misalignment is not None


def has_file(name):
    """That the folder has this file."""
    def need(run):
        return run.has_file(name)
    return need


def has_pairs(study):
    return bool(study.pairs)


def has_pairs_with(table, column=None):
    """That runs of gear pairs have this table, with this column."""
    def need(study):
        return bool(study.pairs_with(table, column))
    return need


def has_responses(study):
    """Variants have responses over speed of their own."""
    return len(study.responses) > 1


def has_axis(study):
    """One number is varied."""
    return study.axis is not None


def has_error_bars(study):
    """Numerical parameters are varied."""
    return study.error_bars is not None


def has_speeds(study):
    """The number that is varied is a speed."""
    return study.speeds is not None
