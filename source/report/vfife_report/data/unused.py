# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries that a study reads, because its file is that of a run, and does not use: nothing of its case."""

_OF_STEPS = {"Operation/mesh cycles", "Dynamics/start", "Dynamics/end time", "Dynamics/mass proportional damping", "Dynamics/damping ratio",
             "Dynamics/damping frequency", "Dynamics/driven speed damping"}
_OF_ELEMENTS = {"Dynamics/corotational frame", "Dynamics/element type"}
_OF_TORQUE = {"Operation/torque", "Operation/pinion torque"}
_OF_LOAD = _OF_TORQUE | {"Contact/discretization", "Contact/surface", "Contact/friction coefficient"}
_OF_SPEED = {"Operation/speed"}
_BY_KIND = {"loaded tooth contact analysis": _OF_STEPS | _OF_ELEMENTS,
            "mesh": _OF_STEPS | _OF_ELEMENTS | _OF_LOAD | _OF_SPEED | {"Operation/bore rotation"},
            "modal": _OF_STEPS | _OF_ELEMENTS | _OF_LOAD | _OF_SPEED,
            "linear static": _OF_STEPS | _OF_ELEMENTS | _OF_LOAD,
            "static": _OF_STEPS,
            "lumped": _OF_STEPS | _OF_ELEMENTS | _OF_LOAD - _OF_TORQUE | {"Operation/bore rotation"},
            "reduced": _OF_ELEMENTS,
            "waves": _OF_ELEMENTS | {"Operation/mesh cycles", "Dynamics/start"}}
_OF_PAIRS = {"Operation/mesh cycles", "Operation/bore rotation", "Dynamics/driven speed damping"}


def sweeps_speeds(parameters):
    """Whether a reduced pair turns at many speeds, between those of the section Reduced."""
    return parameters.get("Study/kind") == "reduced" and parameters.get("Reduced/sweep", "none") != "none"


def list_unused_entries(parameters, has_pair):
    """Paths of those that the study of these parameters leaves unused, by its kind and whether it is of a gear pair."""
    of_sweep = _OF_SPEED | {"Operation/mesh cycles"} if sweeps_speeds(parameters) else set()
    return _BY_KIND.get(parameters.get("Study/kind"), set()) | of_sweep | (set() if has_pair else _OF_PAIRS)
