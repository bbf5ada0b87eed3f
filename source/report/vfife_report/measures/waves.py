# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion of the gear's rim by nodal diameters, from rim.csv (axes that turn with the gear)."""
import numpy as np

from .spectrum import compute_directed_spectrum, find_peaks

COMPONENTS = {"r": "radial", "theta": "tangential", "z": "axial"}
SHOWN_DIAMETERS = 6  # of spectra
HIGHEST_WAVE_ORDER = 2.2  # of the gear mesh, up to which spectra are shown


def count_diameters(rim):
    """Largest number of nodal diameters in the table."""
    return sum(1 for name in rim.columns if name.startswith("z sin "))


def count_shown_diameters(rim):
    """Largest number of nodal diameters whose spectrum is shown."""
    return min(SHOWN_DIAMETERS, count_diameters(rim))


def read_wave(rim, component, n):
    """C = c + i s of u = Re(C exp(-i n alpha)) at each sample. A wave cos(n alpha - w t) has
    C = exp(i w t): positive frequencies travel in the + sense of the gear's axis."""
    cos = rim[f"{component} cos {n}"]
    return cos + 1j * rim[f"{component} sin {n}"] if n else cos + 0j


def split_wave(wave, n, turn):
    """The pattern that stands in space (amplitude with phase) and the rest of C(t), in the axes that
    turn with the gear, which has turned by the angles `turn` [rad, + about its axis].

    The load stands in space, so in the turning gear its pattern of n diameters is a wave of phase
    -n turn; for n = 0 it is the mean. A gear of equal sectors has no pattern of its own that would
    stand in the gear.
    """
    phase = np.exp(1j * n * turn)
    standing = np.mean(wave * phase)
    return standing, wave - standing / phase


def measure_waves(rim, rows, turn):
    """Amplitude that stands in space and root mean square of the rest, by component and nodal
    diameters, (3, n + 1) each [um]; `turn`: RunFolder.gear_turn() at these rows."""
    shape = (len(COMPONENTS), count_diameters(rim) + 1)
    standing, moving = np.empty(shape), np.empty(shape)
    for k, component in enumerate(COMPONENTS):
        for n in range(shape[1]):
            wave = read_wave(rim, component, n)[rows]
            pattern, rest = split_wave(wave, n, turn)
            standing[k, n], moving[k, n] = np.abs(pattern), np.sqrt(np.mean(np.abs(rest)**2))
    return standing, moving


def find_axial_rest(run, n):
    """Times of the steady part and the axial wave of n diameters less what stands in space."""
    rim, rows = run.rim, run.steady_rows(run.rim)
    time = rim["time"][rows]
    return time, split_wave(read_wave(rim, "z", n)[rows], n, run.gear_turn(time))[1]


def list_peaks_beyond(lines, response):
    """Driven waves (waves_lines.csv) whose peak lies outside the speeds at which they were driven (waves_response.csv), in words."""
    if response is None:
        return
    keys = ("wave", "nodal diameter", "mesh order", *(["solver"] if "solver" in lines else []))
    for k in range(lines.n_rows):
        mine = np.logical_and.reduce([response[key] == lines[key][k] for key in keys])
        speeds, peak = np.abs(response["speed"][mine]), np.abs(lines["peak speed"][k])
        if len(speeds) and np.isfinite(peak) and not speeds.min() <= peak <= speeds.max():
            diameters = lines["nodal diameter"][k]
            yield (f"{lines['wave'][k]}, {diameters:.0f} diameter{'s' * (diameters != 1)}, order {lines['mesh order'][k]:.0f} "
                   f"({peak:.0f} rpm, computed from {speeds.min():.0f} to {speeds.max():.0f})")


def list_directions(rate):
    """Name and sign of the frequency of each direction of travel. The load, which stands in space,
    travels against the turning of the gear."""
    return (("backward", -np.sign(rate)), ("forward", np.sign(rate)))


def list_wave_spectra(run, n):
    """Name of the direction, frequencies [Hz] from zero up and amplitudes [um] of the axial waves of n
    diameters that do not stand in space; a wave that stands in the gear is two equal lines, one in either
    direction. One direction only for n = 0, which has none."""
    time, rest = find_axial_rest(run, n)
    frequency, amplitude = compute_directed_spectrum(rest, (time[-1] - time[0]) / (len(time) - 1))
    directions = list_directions(run.gear_rate())
    for name, sign in directions[:1] if n == 0 else directions:
        side = sign * frequency >= 0
        order = np.argsort(sign * frequency[side])
        values = (2 if n == 0 else 1) * amplitude[side][order]
        yield name, (sign * frequency[side])[order], values


def list_wave_lines(run, least=0.3):
    """Nodal diameters, direction, frequency [Hz], amplitude [um] of the strongest lines: two a
    direction, at least `least` times the strongest of the wave."""
    top = HIGHEST_WAVE_ORDER * run.value("mesh frequency")
    for n in range(count_shown_diameters(run.rim) + 1):
        found = [(direction if n else "-", line)
                 for direction, frequency, amplitude in list_wave_spectra(run, n)
                 for line in sorted((p for p in find_peaks(amplitude, frequency[1])
                                     if p.frequency < top), key=lambda p: -p.amplitude)[:2]]
        floor = least * max((line.amplitude for _, line in found), default=0)
        for direction, line in found:
            if line.amplitude >= floor:
                yield str(n), direction, line.frequency, line.amplitude
