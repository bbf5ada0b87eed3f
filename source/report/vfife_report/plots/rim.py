# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of the motion of the gear's rim by nodal diameters."""
import numpy as np

from ..measures.waves import (COMPONENTS, HIGHEST_WAVE_ORDER, count_diameters, count_shown_diameters,
                              find_axial_rest, list_wave_spectra, measure_waves)
from .style import COLOURS, GREY, add_legend, plt

LOOKS = (("-", COLOURS[1]), ("--", COLOURS[2]))  # of the directions of travel
SHOWN_HISTORIES = 5  # largest number of nodal diameters


def draw_rim_content(run):
    """The part that is stationary in the fixed frame and the remainder, by nodal diameters."""
    rows = run.steady_rows(run.rim)
    both = measure_waves(run.rim, rows, run.gear_turn(run.rim["time"][rows]))
    plot, panels = plt.subplots(1, 2, figsize=(9, 4))
    numbers = np.arange(both[0].shape[1])
    for axes, values, title in zip(panels, both, ("static part in the fixed frame", "vibration, rms")):
        for k, component in enumerate(COMPONENTS):
            axes.plot(numbers, values[k], "o-", markersize=4, color=COLOURS[k + 1],
                      label=COMPONENTS[component])
        axes.set(title=title, xlabel="nodal diameters", ylabel="amplitude [um]", yscale="log")
        axes.set_xticks(numbers)
    add_legend(panels[-1])
    return plot


def draw_rim_history(run):
    """Amplitudes over time of the axial waves without their stationary part."""
    plot, axes = plt.subplots()
    for n in range(min(SHOWN_HISTORIES, count_diameters(run.rim)) + 1):
        time, rest = find_axial_rest(run, n)
        axes.plot(1e3 * time, rest.real if n == 0 else np.abs(rest), color=COLOURS[n % len(COLOURS)],
                  label=f"{n} nodal diameter{'s' * (n != 1)}")
    axes.set(title="Axial vibration of the rim (0 nodal diameters: signed displacement, others: wave amplitude)",
             xlabel="time [ms]", ylabel="amplitude [um]")
    axes.margins(x=0)
    add_legend(axes, ncol=3, fontsize=9)
    return plot


def draw_rim_waves(run):
    """Spectra of these waves in both directions, a panel a number of nodal diameters."""
    count = count_shown_diameters(run.rim) + 1
    plot, panels = plt.subplots(count, 1, sharex=True, figsize=(8, 1.35 * count + 0.6))
    top = HIGHEST_WAVE_ORDER * run.value("mesh frequency")
    for n, axes in enumerate(panels):
        for (direction, frequency, amplitude), (dashes, colour) in zip(list_wave_spectra(run, n), LOOKS):
            shown = (frequency > 0) & (frequency <= top)
            axes.plot(1e-3 * frequency[shown], amplitude[shown], dashes, color=colour,
                      label=direction)
            spacing = frequency[1]
        axes.set_ylim(bottom=0)
        axes.set_xlim(0, 1e-3 * top)
        axes.set_title(f"{n} nodal diameter{'s' * (n != 1)}", fontsize=9)
    add_legend(panels[-1], fontsize=8, loc="upper right")
    panels[-1].set_xlabel("frequency in the rotating frame [kHz]")
    plot.supylabel("amplitude of the axial motion [um]", fontsize=10)
    plot.suptitle(f"Hann window, line spacing {spacing:.0f} Hz. Waves of 0 nodal diameters have no direction.",
                  x=0.01, ha="left", fontsize=9, color=GREY)
    return plot
