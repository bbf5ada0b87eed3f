# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion of the gear's rim by nodal diameters, from rim.csv (axes that turn with the gear)."""
import numpy as np

from lines import find_peaks
from style import COLOURS, GREY, add_legend, plt

COMPONENTS = {"r": "radial", "theta": "tangential", "z": "axial"}
SHOWN_DIAMETERS = 6


def count_diameters(rim):
    """Largest number of nodal diameters in the table."""
    return sum(1 for name in rim.columns if name.startswith("z sin "))


def read_wave(rim, component, n):
    """C = c + i s of u = Re(C exp(-i n alpha)) at each sample. A wave cos(n alpha - w t) has
    C = exp(i w t): positive frequencies travel in the + sense of the gear's axis."""
    cos = rim[f"{component} cos {n}"]
    return cos + 1j * rim[f"{component} sin {n}"] if n else cos + 0j


def split_wave(wave, time, n, rate):
    """The pattern that stands in space (amplitude with phase) and the rest of C(t), in the axes that
    turn with the gear at `rate` [rad/s, + about its axis].

    The load stands in space, so in the turning gear its pattern of n diameters is a wave of
    frequency -n rate; for n = 0 it is the mean. A gear of equal sectors has no pattern of its own that
    would stand in the gear.
    """
    turn = np.exp(1j * n * rate * time)
    standing = np.mean(wave * turn)
    return standing, wave - standing / turn


def compute_wave_spectrum(wave, interval):
    """Frequencies [Hz] from negative to positive and amplitudes, Hann's window. A wave that stands
    in the gear is two equal lines, one on either side."""
    n = len(wave)
    amplitudes = 2 * np.abs(np.fft.fftshift(np.fft.fft(wave * np.hanning(n + 1)[:-1]))) / n
    return np.fft.fftshift(np.fft.fftfreq(n, interval)), amplitudes


def measure_waves(rim, rows, rate):
    """Amplitude that stands in space and root mean square of the rest, by component and nodal
    diameters, (3, n + 1) each [um]."""
    shape = (len(COMPONENTS), count_diameters(rim) + 1)
    standing, moving = np.empty(shape), np.empty(shape)
    for k, component in enumerate(COMPONENTS):
        for n in range(shape[1]):
            wave = read_wave(rim, component, n)[rows]
            pattern, rest = split_wave(wave, rim["time"][rows], n, rate)
            standing[k, n], moving[k, n] = np.abs(pattern), np.sqrt(np.mean(np.abs(rest)**2))
    return standing, moving


def draw_rim_content(run):
    """What stands in space and what moves, by nodal diameters."""
    both = measure_waves(run.rim, run.steady_rows(run.rim), run.gear_rate())
    figure, panels = plt.subplots(1, 2, figsize=(9, 4))
    numbers = np.arange(both[0].shape[1])
    for axes, values, title in zip(panels, both, ("standing in space", "rest, root mean square")):
        for k, component in enumerate(COMPONENTS):
            axes.plot(numbers, values[k], "o-", markersize=4, color=COLOURS[k + 1],
                      label=COMPONENTS[component])
        axes.set(title=title, xlabel="nodal diameters", ylabel="amplitude [um]", yscale="log")
        axes.set_xticks(numbers)
    add_legend(panels[0])
    return figure


def draw_rim_history(run):
    """Amplitudes over time of the axial waves that do not stand in space."""
    rim, rows = run.rim, run.steady_rows(run.rim)
    time = rim["time"][rows]
    figure, axes = plt.subplots()
    for n in range(min(5, count_diameters(rim)) + 1):
        rest = split_wave(read_wave(rim, "z", n)[rows], time, n, run.gear_rate())[1]
        axes.plot(1e3 * time, rest.real if n == 0 else np.abs(rest), color=COLOURS[n % len(COLOURS)],
                  label=f"{n} diameters")
    axes.set(title="Axial waves of the rim that do not stand in space (0 diameters: with sign)",
             xlabel="time [ms]", ylabel="amplitude [um]")
    axes.margins(x=0)
    add_legend(axes, ncol=3, fontsize=9)
    return figure


def list_directions(rate):
    """Name, sign of the frequency, dashes and colour of each direction of travel. The load, which
    stands in space, travels against the turning of the gear."""
    return (("against the turning of the gear", -np.sign(rate), "-", COLOURS[1]),
            ("with it", np.sign(rate), "--", COLOURS[2]))


def list_spectra(run, n):
    """Direction (list_directions), frequencies [Hz] from zero up and amplitudes [um] of the axial
    waves of n diameters that do not stand in space; one direction only for n = 0, which has none."""
    rim, rows, rate = run.rim, run.steady_rows(run.rim), run.gear_rate()
    time = rim["time"][rows]
    rest = split_wave(read_wave(rim, "z", n)[rows], time, n, rate)[1]
    frequency, amplitude = compute_wave_spectrum(rest, (time[-1] - time[0]) / (len(time) - 1))
    for direction in list_directions(rate)[:1] if n == 0 else list_directions(rate):
        sign = direction[1]
        side = sign * frequency >= 0
        order = np.argsort(sign * frequency[side])
        values = (2 if n == 0 else 1) * amplitude[side][order]
        yield direction, (sign * frequency[side])[order], values


def list_wave_lines(run, least=0.3):
    """Nodal diameters, direction, frequency [Hz], amplitude [um] of the strongest lines below 2.2
    times the mesh frequency: two a direction, at least `least` times the strongest of the wave."""
    top = 2.2 * run.figure("mesh frequency")
    for n in range(min(SHOWN_DIAMETERS, count_diameters(run.rim)) + 1):
        found = [(direction[0] if n else "-", line)
                 for direction, frequency, amplitude in list_spectra(run, n)
                 for line in sorted((p for p in find_peaks(amplitude, frequency[1])
                                     if p.frequency < top), key=lambda p: -p.amplitude)[:2]]
        floor = least * max((line.amplitude for _, line in found), default=0)
        for direction, line in found:
            if line.amplitude >= floor:
                yield str(n), direction, line.frequency, line.amplitude


def draw_rim_waves(run):
    """Spectra of these waves in both directions, a panel a number of nodal diameters."""
    count = min(SHOWN_DIAMETERS, count_diameters(run.rim)) + 1
    figure, panels = plt.subplots(count, 1, sharex=True, figsize=(8, 1.35 * count + 0.6))
    top = 2.2 * run.figure("mesh frequency")
    for n, axes in enumerate(panels):
        for (direction, _, dashes, colour), frequency, amplitude in list_spectra(run, n):
            shown = (frequency > 0) & (frequency <= top)
            axes.plot(1e-3 * frequency[shown], amplitude[shown], dashes, color=colour,
                      label=direction)
            spacing = frequency[1]
        axes.set_ylim(bottom=0)
        axes.set_xlim(0, 1e-3 * top)
        axes.set_title(f"{n} nodal diameters", fontsize=9)
    add_legend(panels[-1], fontsize=8, loc="upper right")
    panels[-1].set_xlabel("frequency in the turning gear [kHz]")
    figure.supylabel("amplitude of the axial motion [um]", fontsize=10)
    figure.suptitle(f"Hann's window, bins {spacing:.0f} Hz apart; 0 nodal diameters have no direction",
                    x=0.01, ha="left", fontsize=9, color=GREY)
    return figure
