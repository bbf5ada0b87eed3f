# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of tables of spectral lines of the histories, over the steady part of a run."""
import numpy as np

from ..data.columns import JUDGED
from .lines import HIGHEST_LINE_ORDER, find_harmonics, find_lines
from .periodicity import LEAST_MESHES
from .sidebands import find_resolution, list_shafts, name_offset

HARMONICS_HEADER = ["order", "frequency [Hz]", "amplitude", "unit"]
HARMONICS_CAPTION = "Largest mesh harmonics of the mean mesh cycle (average of all mesh cycles, synchronous with the gear mesh)."
LINES_HEADER = ["line", "frequency [Hz]", "amplitude", "unit"]
LINES_CAPTION = f"Strongest lines between the mesh harmonics, up to mesh order {HIGHEST_LINE_ORDER} (Hann window)."
LOW_ORDER = 0.75  # of the gear mesh, up to which a line is no sideband of a harmonic


def list_columns(run):
    """Name, unit and values of the histories that are looked at; none without two mesh cycles."""
    rows = run.steady_rows(run.history)
    samples = run.samples_per_mesh()
    if not samples or np.count_nonzero(rows) <= LEAST_MESHES * samples:
        return
    for column in JUDGED:
        if column in run.history:
            yield column, run.history.units[column], run.history[column][rows]


def list_harmonics(run, count):
    """The `count` harmonics of each history that have the largest amplitudes, whatever their orders."""
    frequency, samples = run.value("mesh frequency"), run.samples_per_mesh()
    rows = []
    for column, unit, values in list_columns(run):
        amplitudes = find_harmonics(values, samples)
        largest = np.argsort(-amplitudes, kind="stable")[:count]
        rows += [[column, int(i) + 1, (i + 1) * frequency, amplitudes[i], unit] for i in largest]
    return rows


def list_other_lines(run, low=4, high=3):
    """The strongest lines below three quarters of the mesh frequency, and above by their distance from the nearest harmonic."""
    frequency, samples = run.value("mesh frequency"), run.samples_per_mesh()
    border, top = LOW_ORDER * frequency, HIGHEST_LINE_ORDER * frequency
    rows = []
    for column, unit, values in list_columns(run):
        for line in find_lines(values, samples, frequency, 0, border, low):
            rows.append([column, "below the mesh frequency", line.frequency, line.amplitude, unit])
        for line in find_lines(values, samples, frequency, border, top, high):
            order = max(round(line.frequency / frequency), 1)
            offset = line.frequency - order * frequency
            rows.append([column, f"mesh order {order}, {name_offset(run, offset)}", line.frequency,
                         line.amplitude, unit])
    return rows


def describe_resolution(run):
    """Which lines the length of the steady part does not resolve."""
    resolution = find_resolution(run)
    if not np.isfinite(resolution):
        return "The record is too short for a spectrum, which needs two whole mesh cycles."
    text = f"Spectral lines less than {resolution:.0f} Hz apart are not resolved (two line spacings, Hann window)."
    for shaft in list_shafts(run):
        if not shaft.resolved:
            text += (f" Sidebands at the rotation of the {shaft.name} ({shaft.frequency:.0f} Hz) are not resolved; "
                     f"they need {shaft.meshes:.0f} mesh cycles, two rotations.")
    return text
