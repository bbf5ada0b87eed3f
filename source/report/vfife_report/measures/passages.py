# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Single events of a run: the mesh passing a probe, a tooth going through its engagement."""
from dataclasses import dataclass

import numpy as np

DURATION_LEVEL, DURATION_LEVEL_IN_WORDS = 0.1, "a tenth"  # of the rise over the steady value


@dataclass
class Passage:
    """Stress at a probe [MPa] while its sector passes the mesh: a rise above the steady stress, or a dip below it."""
    peak: float  # largest of the record
    peak_time: float  # [s]
    least: float  # of the record
    steady: float  # median of a whole turn, or of the record outside the passage
    is_dip: bool  # the passage is where the stress is least
    duration: float  # time around the largest deviation with |stress - steady| above the level [s]
    whole: bool  # begins and ends within the record


def find_passage(time, stress, median_of_turn=None):
    """The passage with the largest deviation from the median: that of a whole turn where it is known, since a record of a
    part of one may have little outside the passage; else the steady value and the passage depend on each other, and both
    are repeated until they stay. None without at least ten samples."""
    if len(time) < 10 or np.ptp(stress) == 0:
        return None
    outside = np.ones(len(time), dtype=bool)
    top = np.argmax(np.abs(stress - (np.median(stress) if median_of_turn is None else median_of_turn)))
    for _ in range(20):
        steady = np.median(stress[outside]) if np.any(outside) else np.median(stress)
        steady = steady if median_of_turn is None else median_of_turn
        quiet = np.abs(stress - steady) < DURATION_LEVEL * abs(stress[top] - steady)
        before, after = np.flatnonzero(quiet[:top]), np.flatnonzero(quiet[top:])
        first = before[-1] + 1 if len(before) else 0
        last = top + after[0] - 1 if len(after) else len(time) - 1
        inside = (np.arange(len(time)) >= first) & (np.arange(len(time)) <= last)
        if np.array_equal(inside, ~outside):
            break
        outside = ~inside
    whole = bool(len(before) and len(after))
    peak = np.argmax(stress)
    return Passage(stress[peak], time[peak], stress.min(), steady, bool(stress[top] < steady), time[last] - time[first], whole)


def find_passages(run):
    """Name and passage of each probe of a run that has one."""
    if run.probes is None:
        return
    for name in dict.fromkeys(run.probes["probe"]):
        rows = run.probes["probe"] == name
        turn = run.summary.get("probes", {}).get(name)
        passage = find_passage(run.probes["time"][rows], run.probes["von mises"][rows],
                               turn["median per revolution"]["value"] if turn else None)
        if passage:
            yield name, passage


@dataclass
class Engagement:
    """Rows of teeth.csv of one tooth pair of the drive side, in the order of time."""
    pinion_tooth: int
    gear_tooth: int
    rows: np.ndarray
    whole: bool  # first and last touch lie within the record


def find_run_engagement(run):
    """That of a run over its whole record."""
    return find_engagement(run.teeth, run.history["time"][0], run.history["time"][-1])


def find_engagement(teeth, start, end):
    """The last tooth pair whose first and last touch lie within the record; without one the pair
    that was longest in contact. None without contact."""
    drive = teeth["side"] == "drive"
    interval = np.diff(np.unique(teeth["time"]))
    slack = 0.5 * interval.min() if len(interval) else 0
    found = []
    for pinion, gear in dict.fromkeys(zip(teeth["pinion tooth"][drive], teeth["gear tooth"][drive])):
        rows = np.flatnonzero(drive & (teeth["pinion tooth"] == pinion) & (teeth["gear tooth"] == gear))
        time = teeth["time"][rows]
        whole = bool(time[0] > start + slack and time[-1] < end - slack)
        found.append(Engagement(int(pinion), int(gear), rows, whole))
    whole = [one for one in found if one.whole]
    if whole:
        return whole[-1]
    return max(found, key=lambda one: len(one.rows), default=None)
