# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Ripple of the runs of a sweep, over what it varies."""
import numpy as np

from ..data.columns import CONTACT_FORCE, TRANSMISSION_ERROR

# Ripple of what: column of the history, column of another model's response over speed.
RIPPLES = ((TRANSMISSION_ERROR, "dte"), (CONTACT_FORCE, "force"))


def read_ripple(axis, column, what):
    """A statistic of each run's steady part; not a number where there is none."""
    return np.array([(v.run.statistics(column) or {}).get(what, np.nan) for v in axis.variants],
                    dtype=float)


def find_steady(axis):
    """Which runs have a steady part."""
    return np.array([v.run.is_steady() for v in axis.variants])


def find_steady_ripple(axis):
    """Which runs have a steady part whose ripple has not been found to change."""
    return np.array([v.run.is_steady() and v.run.is_ripple_steady() is not False for v in axis.variants])
