# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""How steady and how periodic a history is: tooth meshes laid over each other, trend, lines.

doc/report.md defines every number.
"""
from dataclasses import dataclass

import numpy as np


def fold_meshes(values, samples_per_mesh):
    """Whole tooth meshes at the end of equally spaced samples as rows (meshes, positions), linear
    between samples where a mesh is no whole number of them."""
    meshes = int((len(values) - 1 + 1e-6) // samples_per_mesh)
    positions = max(int(round(samples_per_mesh)), 2)
    start = len(values) - 1 - meshes * samples_per_mesh
    at = start + np.arange(meshes * positions) * (samples_per_mesh / positions)
    return np.interp(at, np.arange(len(values)), values).reshape(meshes, positions)


@dataclass
class Periodicity:
    """Numbers in the unit of the history; they need at least two meshes."""
    meshes: int
    ripple: float  # peak to peak of the mean mesh
    deviation: float  # standard deviation from the mean
    remainder: float  # standard deviation from the mean mesh: what does not repeat with the mesh
    change: float  # root mean square of the difference of consecutive meshes
    largest_change: float  # largest difference of consecutive meshes at the same position
    trend: float  # slope of the meshes' means by least squares, a mesh

    @property
    def periodic_share(self):
        """Part of the variance that repeats with the tooth mesh; 1: strictly periodic."""
        return 1 - (self.remainder / self.deviation) ** 2 if self.deviation > 0 else 1.0


def measure_periodicity(values, samples_per_mesh):
    """None for less than two meshes."""
    folded = fold_meshes(values, samples_per_mesh)
    if len(folded) < 2:
        return None
    mean = folded.mean(axis=0)
    change = np.diff(folded, axis=0)
    return Periodicity(
        meshes=len(folded), ripple=np.ptp(mean), deviation=folded.std(),
        remainder=(folded - mean).std(), change=np.sqrt(np.mean(change**2)),
        largest_change=np.abs(change).max(),
        trend=np.polyfit(np.arange(len(folded)), folded.mean(axis=1), 1)[0])


def find_harmonics(values, samples_per_mesh, largest):
    """Amplitudes of the orders 1 to `largest` of the tooth mesh: of the mean mesh, so that nothing
    leaks into them from lines that do not repeat."""
    mean = fold_meshes(values, samples_per_mesh).mean(axis=0)
    amplitudes = 2 * np.abs(np.fft.rfft(mean)) / len(mean)
    return amplitudes[1:largest + 1]


@dataclass
class Line:
    frequency: float  # [Hz]
    amplitude: float


def find_lines(values, samples_per_mesh, mesh_frequency, lowest, highest, count, least=0.1):
    """Strongest lines between two frequencies [Hz] of what does not repeat with the mesh, by
    amplitude; at least `least` times the strongest one of the whole spectrum.

    Hann's window; a line is a maximum of its spectrum, frequency and amplitude by a parabola through
    the logarithms of three neighbours (error of the amplitude below 1.5 %). Below 1.5/T there is no
    maximum to be seen, and lines closer than 2/T are one.
    """
    folded = fold_meshes(values, samples_per_mesh)
    rest = (folded - folded.mean(axis=0)).ravel()
    n = len(rest)
    if len(folded) < 4 or not np.any(rest):
        return []
    window = np.hanning(n + 1)[:-1]
    amplitudes = 4 * np.abs(np.fft.rfft(rest * window)) / n
    spacing = mesh_frequency / len(folded)
    lines = []
    for k in range(2, len(amplitudes) - 1):
        left, centre, right = amplitudes[k - 1:k + 2]
        if not (left < centre >= right) or left == 0 or right == 0:
            continue
        a, b, c = np.log([left, centre, right])
        shift = 0.5 * (a - c) / (a - 2 * b + c)
        lines.append(Line((k + shift) * spacing, np.exp(b - 0.25 * (a - c) * shift)))
    floor = least * max((line.amplitude for line in lines), default=0)
    lines = [line for line in lines
             if lowest <= line.frequency <= highest and line.amplitude >= floor]
    return sorted(lines, key=lambda line: -line.amplitude)[:count]
