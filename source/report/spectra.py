# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Spectra of the histories in orders of the tooth mesh."""
import numpy as np

from style import COLOURS, GREY, plt

LARGEST_ORDER = 12


def compute_spectrum(values, samples_per_mesh, windowed=False, points_per_line=1):
    """Orders of the mesh frequency and amplitudes of as many whole meshes as there are at the end.

    No trend taken out and no window: whole meshes make harmonics of the mesh exact lines, and what
    is no harmonic spreads to its neighbours. With Hann's window it does not spread far, and a harmonic
    has a neighbour of half its size on either side. More points a line show the shape between the lines,
    not more of them. Empty for less than two meshes.
    """
    meshes = int((len(values) + 1e-6) // samples_per_mesh)
    n = int(round(meshes * samples_per_mesh))
    if meshes < 2:
        return np.empty(0), np.empty(0)
    part = values[-n:] - values[-n:].mean()
    window = 2 * np.hanning(n + 1)[:-1] if windowed else 1
    amplitudes = 2 * np.abs(np.fft.rfft(part * window, points_per_line * n)) / n
    return np.arange(len(amplitudes)) / (points_per_line * meshes), amplitudes


def draw_spectra(run):
    history, samples = run.history, run.samples_per_mesh()
    found = (run.steady_part() or (0, 0, False))[2]
    rows = run.steady_rows(history)
    shown = (("dte", "arcsec"), ("rim dte", "arcsec"), ("contact force total", "N"))
    figure, panels = plt.subplots(len(shown), 1, sharex=True, figsize=(8, 7))
    for axes, colour, (name, unit) in zip(panels, COLOURS[1:], shown):
        orders, amplitudes = compute_spectrum(history[name][rows], samples)
        if len(orders) == 0:
            plt.close(figure)
            return None
        visible = (orders > 0) & (orders <= LARGEST_ORDER)
        axes.vlines(orders[visible], 0, amplitudes[visible], color=colour, linewidth=2, label=name)
        axes.set_ylim(bottom=0)
        axes.set_ylabel(f"amplitude [{unit}]")
        axes.set_title(name)
    panels[-1].set_xlabel("order of the mesh frequency")
    panels[-1].set_xlim(0, LARGEST_ORDER + 0.2)
    panels[-1].set_xticks(range(LARGEST_ORDER + 1))
    frequency = run.figure("mesh frequency")
    above = panels[0].secondary_xaxis("top", functions=(lambda order: 1e-3 * frequency * order,
                                                        lambda kilo: 1e3 * kilo / frequency))
    above.set_xlabel("frequency [kHz]", fontsize=8, color=GREY)
    above.tick_params(labelsize=8, colors=GREY)
    spacing = frequency * orders[1]
    part = "steady part" if found else "last third, not steady"
    figure.suptitle(f"Amplitudes over whole meshes ({part}), lines {spacing:.0f} Hz apart",
                    x=0.01, ha="left", fontsize=9, color=GREY)
    return figure
