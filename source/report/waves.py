# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion of the gear's rim by nodal diameters, from rim.csv (axes that turn with the gear)."""
import numpy as np

from style import COLOURS, GREY, plt

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


def compute_wave_spectrum(wave, interval):
    """Frequencies [Hz] from negative to positive and amplitudes, Hann's window, mean kept out.

    A standing wave is two equal lines, one on either side. Waves without nodal diameters have no
    direction: both sides are added onto the positive one.
    """
    n = len(wave)
    window = np.hanning(n + 1)[:-1]
    rest = wave - (wave * window).sum() / window.sum()
    amplitudes = 2 * np.abs(np.fft.fftshift(np.fft.fft(rest * window))) / n
    return np.fft.fftshift(np.fft.fftfreq(n, interval)), amplitudes


def measure_waves(rim, rows):
    """Mean of the amplitude and root mean square of its fluctuation, by component and nodal
    diameters, (3, n + 1) each [um]."""
    numbers = range(count_diameters(rim) + 1)
    waves = np.array([[read_wave(rim, c, n)[rows] for n in numbers] for c in COMPONENTS])
    mean = waves.mean(axis=2)
    return np.abs(mean), np.sqrt(np.mean(np.abs(waves - mean[..., None])**2, axis=2))


def draw_rim_content(run):
    """What stands still in the turning gear, and what moves in it, by nodal diameters."""
    mean, moving = measure_waves(run.rim, run.steady_rows(run.rim))
    figure, panels = plt.subplots(1, 2, figsize=(9, 4))
    numbers = np.arange(mean.shape[1])
    for axes, values, title in zip(panels, (mean, moving), (
            "mean over the time: standing in the turning gear",
            "root mean square of the rest: moving in the gear")):
        for k, component in enumerate(COMPONENTS):
            axes.plot(numbers, values[k], "o-", markersize=4, color=COLOURS[k + 1],
                      label=COMPONENTS[component])
        axes.set(title=title, xlabel="nodal diameters", ylabel="amplitude [um]", yscale="log")
        axes.set_xticks(numbers)
    panels[0].legend(frameon=False)
    return figure


def draw_rim_history(run):
    """Amplitudes of the axial waves over time."""
    rim = run.rim
    time = 1e3 * rim["time"]
    figure, axes = plt.subplots()
    for n in range(min(5, count_diameters(rim)) + 1):
        wave = read_wave(rim, "z", n)
        value = wave.real if n == 0 else np.abs(wave)
        axes.plot(time, value, color=COLOURS[n % len(COLOURS)], label=f"{n} diameters")
    axes.set(title="Axial motion of the rim by nodal diameters (0: mean, with its sign)",
             xlabel="time [ms]", ylabel="amplitude [um]")
    axes.margins(x=0)
    axes.legend(frameon=False, ncol=3, fontsize=9)
    return figure


def draw_rim_waves(run):
    """Spectra of the axial waves in both directions, a panel a number of nodal diameters."""
    rim, rows = run.rim, run.steady_rows(run.rim)
    interval = (rim["time"][-1] - rim["time"][0]) / (rim.n_rows - 1)
    count = min(SHOWN_DIAMETERS, count_diameters(rim)) + 1
    figure, panels = plt.subplots(count, 1, sharex=True, figsize=(8, 1.35 * count + 0.6))
    top = 2.2 * run.figure("mesh frequency")
    # The load, which stands in space, travels against the turning of the gear.
    directions = (("against the turning of the gear", -run.gear_sense(), "-"),
                  ("with it", run.gear_sense(), "--"))
    for n, axes in enumerate(panels):
        frequency, amplitude = compute_wave_spectrum(read_wave(rim, "z", n)[rows], interval)
        for direction, sign, style in directions:
            if n == 0 and style == "--":
                continue
            factor = 2 if n == 0 else 1
            side = (sign * frequency > 0) & (sign * frequency <= top)
            axes.plot(1e-3 * sign * frequency[side], factor * amplitude[side], style,
                      color=COLOURS[1] if style == "-" else COLOURS[2],
                      label=direction)
        axes.set_ylim(bottom=0)
        axes.set_title(f"{n} nodal diameters", fontsize=9)
        axes.margins(x=0)
    panels[-1].legend(frameon=False, fontsize=8, loc="upper right")
    panels[-1].set_xlabel("frequency in the turning gear [kHz]")
    figure.supylabel("amplitude of the axial motion [um]", fontsize=10)
    spacing = 1 / (interval * np.count_nonzero(rows))
    figure.suptitle(f"Hann's window, bins {spacing:.0f} Hz apart; 0 nodal diameters have no direction",
                    x=0.01, ha="left", fontsize=9, color=GREY)
    return figure
