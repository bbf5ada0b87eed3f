# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of the histories: harmonics of the gear mesh, and what does not repeat with it."""
import numpy as np

from .periodicity import fold_meshes
from .spectrum import amplitudes_of, find_peaks, hann_window

# Spacings from a harmonic to the nearest line: a Hann window resolves two, of which a peak may miss half a one.
NEAREST_LINE = 1.5
HIGHEST_LINE_ORDER = 12  # of the gear mesh, up to which spectra are shown and lines are looked for


def find_harmonics(values, samples_per_mesh, largest=None):
    """Amplitudes of the orders 1 to `largest` of the gear mesh (default: all that the samples resolve): of the mean
    mesh, so that nothing leaks into them from lines that do not repeat."""
    mean = fold_meshes(values, samples_per_mesh).mean(axis=0)
    return amplitudes_of(mean)[1:][:largest]


def is_harmonic(frequency, mesh_frequency, resolution):
    order = round(frequency / mesh_frequency)
    return order > 0 and abs(frequency - order * mesh_frequency) < resolution


def find_lines(values, samples_per_mesh, mesh_frequency, lowest, highest, count, least=0.1):
    """Strongest lines between two frequencies [Hz] of what does not repeat with the mesh, by
    amplitude; at least `least` times the strongest one of the whole spectrum. What lies within the resolution of a
    harmonic is that harmonic, whose amplitude changes."""
    folded = fold_meshes(values, samples_per_mesh)
    rest = (folded - folded.mean(axis=0)).ravel()
    n = len(rest)
    if len(folded) < 4 or not np.any(rest):
        return []
    amplitudes = amplitudes_of(rest * hann_window(n))
    lines = find_peaks(amplitudes, mesh_frequency / len(folded))
    resolution = NEAREST_LINE * mesh_frequency / len(folded)
    lines = [line for line in lines if not is_harmonic(line.frequency, mesh_frequency, resolution)]
    floor = least * max((line.amplitude for line in lines), default=0)
    lines = [line for line in lines
             if lowest <= line.frequency <= highest and line.amplitude >= floor]
    return sorted(lines, key=lambda line: -line.amplitude)[:count]
