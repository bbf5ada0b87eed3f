# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Spectra of equally spaced values, and lines in them."""
from dataclasses import dataclass

import numpy as np

from .periodicity import LEAST_MESHES


def hann_window(n):
    """Hann's window of n values for a periodic record, of mean one: amplitudes stay as they are."""
    return 2 * np.hanning(n + 1)[:-1]


def amplitudes_of(values):
    """Amplitudes of the frequencies k/(n interval), k = 0 to n/2, of n values. Mean and, of an even number, the
    frequency of half the sampling rate are once in the transform, all others twice, with both signs."""
    amplitudes = 2 * np.abs(np.fft.rfft(values)) / len(values)
    amplitudes[0] /= 2
    if len(values) % 2 == 0:
        amplitudes[-1] /= 2
    return amplitudes


def compute_spectrum(values, samples_per_mesh, windowed=False, points_per_line=1):
    """Orders of the mesh frequency and amplitudes of as many whole meshes as there are at the end.

    No trend taken out and no window: whole meshes make harmonics of the mesh exact lines, and what
    is no harmonic spreads to its neighbours. With Hann's window it does not spread far, and a harmonic
    has a neighbour of half its size on either side. More points a line show the shape between the lines,
    not more of them. Empty for less than two meshes.
    """
    meshes = int((len(values) + 1e-6) // samples_per_mesh)
    n = int(round(meshes * samples_per_mesh))
    if meshes < LEAST_MESHES:
        return np.empty(0), np.empty(0)
    part = values[-n:] - values[-n:].mean()
    window = hann_window(n) if windowed else 1
    amplitudes = points_per_line * amplitudes_of(np.append(part * window, np.zeros((points_per_line - 1) * n)))
    return np.arange(len(amplitudes)) / (points_per_line * meshes), amplitudes


def compute_directed_spectrum(values, interval):
    """Frequencies [Hz] from negative to positive and amplitudes of complex values, Hann's window."""
    n = len(values)
    amplitudes = np.abs(np.fft.fftshift(np.fft.fft(values * hann_window(n)))) / n
    return np.fft.fftshift(np.fft.fftfreq(n, interval)), amplitudes


def measure_amplitudes(values, interval, frequencies):
    """Amplitudes at given frequencies [Hz] of equally spaced values under Hann's window; lines closer
    than 2/T are not separated. The frequencies lie between the bins of a fast transform: a sum each."""
    n = len(values)
    window = hann_window(n) * (values - values.mean())
    phase = 2j * np.pi * np.outer(np.asarray(frequencies), interval * np.arange(n))
    return 2 * np.abs(np.exp(-phase) @ window) / n


@dataclass
class Line:
    frequency: float  # [Hz]
    amplitude: float


def find_peaks(amplitudes, spacing):
    """Maxima of the amplitudes of a record of length T = 1/spacing under Hann's window, bin k at
    k spacing.

    A lone line d bins from its maximum towards the larger neighbour has the ratio r = (1 + d)/(2 - d)
    of that neighbour to the maximum, and sin(pi d)/(pi d)/(1 - d^2) of its amplitude there: both are
    solved for. Below 1.5/T there is no maximum to be seen, as near half the sampling rate, where a line meets its
    image, and lines closer than 2/T are one.
    """
    peaks = []
    for k in range(2, len(amplitudes) - 2):
        left, centre, right = amplitudes[k - 1:k + 2]
        if not left < centre >= right:
            continue
        ratio = max(left, right) / centre
        d = (2 * ratio - 1) / (ratio + 1)
        side = 1 if right > left else -1
        peaks.append(Line((k + side * d) * spacing, centre * (1 - d**2) / np.sinc(d)))
    return peaks
