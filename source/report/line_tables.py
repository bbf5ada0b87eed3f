# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of tables of spectral lines of the histories, over the steady part of a run."""
import numpy as np

from key_figures import JUDGED
from lines import find_harmonics, find_lines

HARMONICS_HEADER = ["order", "frequency [Hz]", "amplitude", "unit"]
LINES_HEADER = ["line", "frequency [Hz]", "amplitude", "unit"]


def list_columns(run):
    """Name, unit and values of the histories that are looked at; none without two tooth meshes."""
    rows = run.steady_rows(run.history)
    samples = run.samples_per_mesh()
    if not samples or np.count_nonzero(rows) <= 2 * samples:
        return
    for column in JUDGED:
        if column in run.history:
            yield column, run.history.units[column], run.history[column][rows]


def list_harmonics(run, largest):
    frequency, samples = run.figure("mesh frequency"), run.samples_per_mesh()
    return [[column, order, order * frequency, amplitude, unit]
            for column, unit, values in list_columns(run)
            for order, amplitude in enumerate(find_harmonics(values, samples, largest), 1)]


def list_other_lines(run, low=4, high=3):
    """The strongest lines below three quarters of the mesh frequency, and sidebands up to order 3.5 by
    their distance from the nearest harmonic."""
    frequency, samples = run.figure("mesh frequency"), run.samples_per_mesh()
    rows = []
    for column, unit, values in list_columns(run):
        for line in find_lines(values, samples, frequency, 0, 0.75 * frequency, low):
            rows.append([column, "low", line.frequency, line.amplitude, unit])
        for line in find_lines(values, samples, frequency, 0.75 * frequency, 3.5 * frequency, high):
            order = max(round(line.frequency / frequency), 1)
            offset = line.frequency - order * frequency
            rows.append([column, f"{order} mesh {offset:+.0f} Hz", line.frequency, line.amplitude,
                         unit])
    return rows


def describe_resolution(run):
    """Which lines the length of the steady part cannot tell apart."""
    time = run.history["time"][run.steady_rows(run.history)]
    resolution = 2 / (time[-1] - time[0])
    bodies = run.summary.get("mesh", {}).get("bodies", [])
    turns = [abs(body["speed at the start"]["value"]) / 60 for body in bodies]
    text = f"Lines closer than {resolution:.0f} Hz are one line here."
    hidden = [f"{body['name']} ({turn:.0f} Hz)" for body, turn in zip(bodies, turns)
              if turn < resolution]
    if hidden:
        text += (" Sidebands at the rotation of " + " and ".join(hidden)
                 + " cannot be told from the harmonics: the record is too short.")
    return text
