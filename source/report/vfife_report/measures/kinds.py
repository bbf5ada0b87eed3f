# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The kind of results that a folder has."""
from ..data.columns import TRANSMISSION_ERROR

# Name and test of each kind; a folder has the first that fits.
RESULT_KINDS = (
    ("pair run", lambda run: run.statistics(TRANSMISSION_ERROR) is not None and run.value("mesh frequency") is not None),
    ("loaded analysis", lambda run: "transmission error mean" in run.stated),
    ("contact analysis", lambda run: run.has_file("tca.json")),
    ("waves", lambda run: run.has_file("waves_lines.csv")),
    ("modes", lambda run: run.has_file("modes.csv")),
    ("lumped model", lambda run: run.has_file("lumped.json")),
    ("speeds", lambda run: run.has_file("resonance.csv") and run.has_file("wave_response.csv")),
    ("orders", lambda run: run.orders is not None),
    ("mesh", lambda run: run.meshes is not None),
    ("model", lambda run: True))


def find_kind(run):
    """A name of RESULT_KINDS; a pair run is a run or reduced pair at one speed."""
    return next(name for name, fits in RESULT_KINDS if fits(run))
