# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Speeds at which orders of the gear mesh meet modes of the pair in contact."""
import numpy as np

from ..data.naming import normalize
from ..data.swept import Axis, Speeds

MESH_ORDERS = (1, 2, 3)


def choose_modes(beside, speeds):
    """For each run the modes that were computed nearest to its speed; empty without modes."""
    def distance(modes, value):
        known = normalize(modes.speed)
        return abs(known[0] - value) if known and known[1:] == (speeds.axis.unit,) else np.inf

    return [min(beside.modes, key=lambda modes: distance(modes, value))
            for value in speeds.axis.values] if beside.modes else []


def list_critical_speeds(beside, speeds):
    """Mode [Hz], mesh order and value of the axis at which they meet, within the axis; of the modes
    computed nearest to that speed."""
    first, last = speeds.axis.values[[0, -1]]
    found = []
    for modes in beside.modes:
        for frequency in modes.frequencies:
            for order in MESH_ORDERS:
                value = frequency / (order * speeds.frequency_of_one)
                at = Speeds(Axis("", speeds.axis.unit, [], np.array([value])), np.empty(0))
                if first <= value <= last and choose_modes(beside, at)[0] is modes:
                    found.append((frequency, order, value))
    return sorted(found, key=lambda one: one[2])
