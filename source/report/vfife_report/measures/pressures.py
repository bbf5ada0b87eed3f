# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact pressure that a report states: Hertz's, of the largest force of a tooth pair, and what is allowed. Pressures of
nodes, points and areas depend on the mesh (doc/theory/contact.md, Pressures): they stay in the tables of the run."""
import numpy as np

from ..data.naming import is_open

ALLOWED = "Operation/contact stress limit"


def find_allowed_pressure(run):
    """[MPa], None where none is known."""
    if is_open(run.parameters.get(ALLOWED, "none")):
        return None
    number, unit = (run.parameters[ALLOWED] + " MPa").split()[:2]
    factor = {"MPa": 1.0, "GPa": 1e3, "Pa": 1e-6, "kPa": 1e-3, "N/mm^2": 1.0}.get(unit)
    return float(number) * factor if factor else None


def find_largest_pressure(run):
    """Hertz's of all tooth pairs of the side that carries most over the record, or over the positions of a loaded tooth
    contact analysis [MPa]; None without either."""
    if run.teeth is None or "hertz pressure" not in run.teeth:
        return run.stated.get("hertz pressure of the largest force of a tooth pair", {}).get("value")
    side, force = run.teeth["side"], run.teeth["force"]
    carrying = side == max(dict.fromkeys(side), key=lambda one: force[side == one].sum())
    pressures = run.teeth["hertz pressure"][carrying]
    return float(np.nanmax(pressures)) if np.any(np.isfinite(pressures)) else None
