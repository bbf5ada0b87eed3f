# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of spectra: harmonics of the tooth mesh, and what does not repeat with it."""
from dataclasses import dataclass

import numpy as np

from periodicity import fold_meshes


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


def find_peaks(amplitudes, spacing):
    """Maxima of the amplitudes of a record of length T = 1/spacing under Hann's window, bin k at
    k spacing.

    A lone line d bins from its maximum towards the larger neighbour has the ratio r = (1 + d)/(2 - d)
    of that neighbour to the maximum, and sin(pi d)/(pi d)/(1 - d^2) of its amplitude there: both are
    solved for. Below 1.5/T there is no maximum to be seen, and lines closer than 2/T are one.
    """
    peaks = []
    for k in range(2, len(amplitudes) - 1):
        left, centre, right = amplitudes[k - 1:k + 2]
        if not left < centre >= right:
            continue
        ratio = max(left, right) / centre
        d = (2 * ratio - 1) / (ratio + 1)
        side = 1 if right > left else -1
        peaks.append(Line((k + side * d) * spacing, centre * (1 - d**2) / np.sinc(d)))
    return peaks


def measure_amplitudes(values, interval, frequencies):
    """Amplitudes at given frequencies [Hz] of equally spaced values under Hann's window; lines closer
    than 2/T are not separated."""
    n = len(values)
    window = 2 * np.hanning(n + 1)[:-1] * (values - values.mean())
    phase = 2j * np.pi * np.outer(np.asarray(frequencies), interval * np.arange(n))
    return 2 * np.abs(np.exp(-phase) @ window) / n


def find_lines(values, samples_per_mesh, mesh_frequency, lowest, highest, count, least=0.1):
    """Strongest lines between two frequencies [Hz] of what does not repeat with the mesh, by
    amplitude; at least `least` times the strongest one of the whole spectrum."""
    folded = fold_meshes(values, samples_per_mesh)
    rest = (folded - folded.mean(axis=0)).ravel()
    n = len(rest)
    if len(folded) < 4 or not np.any(rest):
        return []
    amplitudes = 4 * np.abs(np.fft.rfft(rest * np.hanning(n + 1)[:-1])) / n
    lines = find_peaks(amplitudes, mesh_frequency / len(folded))
    floor = least * max((line.amplitude for line in lines), default=0)
    lines = [line for line in lines
             if lowest <= line.frequency <= highest and line.amplitude >= floor]
    return sorted(lines, key=lambda line: -line.amplitude)[:count]
