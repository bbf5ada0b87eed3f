# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Single events of a run: the mesh passing a probe, a tooth going through its engagement."""
from dataclasses import dataclass

import numpy as np

DURATION_LEVEL, DURATION_LEVEL_IN_WORDS = 0.1, "a tenth"  # of the rise over the steady value


@dataclass
class Passage:
    """How the stress at a probe leaves its median while its sector passes the mesh: it rises, or falls."""
    is_dip: bool  # the largest deviation is below the median
    duration: float  # time around the largest deviation with |stress - median| above the level [s]
    whole: bool  # begins and ends within the record


def find_passage(time, stress, median):
    """The passage with the largest deviation from the median of a whole turn. None without at least ten samples."""
    if len(time) < 10 or np.ptp(stress) == 0:
        return None
    deviation = np.abs(stress - median)
    top = np.argmax(deviation)
    quiet = np.flatnonzero(deviation < DURATION_LEVEL * deviation[top])
    before, after = quiet[quiet < top], quiet[quiet > top]
    first = before[-1] + 1 if len(before) else 0
    last = after[0] - 1 if len(after) else len(time) - 1
    return Passage(bool(stress[top] < median), time[last] - time[first], bool(len(before) and len(after)))


def find_passages(run):
    """Name, record in the summary and passage of each probe of a run that has one."""
    for name, record in run.summary.get("probes", {}).items() if run.probes is not None else ():
        rows = run.probes["probe"] == name
        passage = find_passage(run.probes["time"][rows], run.probes["von mises"][rows], record["median per revolution"]["value"])
        if passage:
            yield name, record, passage


@dataclass
class Engagement:
    """Rows of teeth.csv of one tooth pair of the working side, in the order of time."""
    pinion_tooth: int
    gear_tooth: int
    rows: np.ndarray
    whole: bool  # first and last touch lie within the record


def find_working_side(teeth):
    """Side of the flanks that transmit the torque, "drive" or "coast": that with the larger sum of forces."""
    sides = list(dict.fromkeys(teeth["side"]))
    return max(sides, key=lambda side: teeth["force"][teeth["side"] == side].sum(), default="drive")


def find_run_engagement(run):
    """That of a run over its whole record."""
    return find_engagement(run.teeth, run.history["time"][0], run.history["time"][-1])


def find_engagement(teeth, start, end):
    """The last tooth pair whose first and last touch lie within the record; without one the pair
    that was longest in contact. None without contact."""
    works = teeth["side"] == find_working_side(teeth)
    interval = np.diff(np.unique(teeth["time"]))
    slack = 0.5 * interval.min() if len(interval) else 0
    found = []
    for pinion, gear in dict.fromkeys(zip(teeth["pinion tooth"][works], teeth["gear tooth"][works])):
        rows = np.flatnonzero(works & (teeth["pinion tooth"] == pinion) & (teeth["gear tooth"] == gear))
        time = teeth["time"][rows]
        whole = bool(time[0] > start + slack and time[-1] < end - slack)
        found.append(Engagement(int(pinion), int(gear), rows, whole))
    whole = [one for one in found if one.whole]
    if whole:
        return whole[-1]
    return max(found, key=lambda one: len(one.rows), default=None)
