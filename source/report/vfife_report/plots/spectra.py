# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Spectra of the histories in orders of the gear mesh, and around its harmonics."""
import numpy as np

from ..data.columns import CONTACT_FORCE, RIM_TRANSMISSION_ERROR, TRANSMISSION_ERROR
from ..measures.lines import HIGHEST_LINE_ORDER
from ..measures.sidebands import ORDERS, TURNS, list_shafts
from ..measures.spectrum import compute_spectrum
from .style import COLOURS, GREY, add_legend, plt


def draw_spectra(run):
    """None for less than two mesh cycles."""
    samples = run.samples_per_mesh()
    shown = ((TRANSMISSION_ERROR, "arcsec"), (RIM_TRANSMISSION_ERROR, "arcsec"), (CONTACT_FORCE, "N"))
    plot, panels = plt.subplots(len(shown), 1, sharex=True, figsize=(8, 7))
    for axes, colour, (name, unit) in zip(panels, COLOURS[1:], shown):
        orders, amplitudes = compute_spectrum(run.steady_values(name), samples)
        if len(orders) == 0:
            plt.close(plot)
            return None
        visible = (orders > 0) & (orders <= HIGHEST_LINE_ORDER)
        axes.vlines(orders[visible], 0, amplitudes[visible], color=colour, linewidth=2, label=name)
        axes.set_ylim(bottom=0)
        axes.set_ylabel(f"amplitude [{unit}]")
        axes.set_title(name)
    panels[-1].set_xlabel("mesh order")
    panels[-1].set_xlim(0, HIGHEST_LINE_ORDER + 0.2)
    panels[-1].set_xticks(range(HIGHEST_LINE_ORDER + 1))
    frequency = run.value("mesh frequency")
    above = panels[0].secondary_xaxis("top", functions=(lambda order: 1e-3 * frequency * order,
                                                        lambda kilo: 1e3 * kilo / frequency))
    above.set_xlabel("frequency [kHz]", fontsize=8, color=GREY)
    above.tick_params(labelsize=8, colors=GREY)
    spacing = frequency * orders[1]
    part = "steady part" if run.is_steady() else "last third, not steady"
    plot.suptitle(f"Amplitudes over whole mesh cycles ({part}), line spacing {spacing:.0f} Hz",
                  x=0.01, ha="left", fontsize=9, color=GREY)
    return plot


def draw_sidebands(run, column=TRANSMISSION_ERROR):
    """Spectrum around the first harmonics of the mesh over turns of the pinion; None where no sideband
    can be told."""
    shafts = [shaft for shaft in list_shafts(run) if shaft.resolved]
    if not shafts:
        return None
    mesh = run.value("mesh frequency")
    fastest = max(shaft.frequency for shaft in shafts)
    orders, amplitudes = compute_spectrum(run.steady_values(column), run.samples_per_mesh(),
                                          windowed=True)
    plot, panels = plt.subplots(len(ORDERS), 1, figsize=(8, 7.5), sharex=True)
    for axes, order in zip(panels, ORDERS):
        offset = (orders - order) * mesh
        shown = (np.abs(offset) < (TURNS + 0.6) * fastest) & (amplitudes > 0)
        axes.plot(offset[shown], amplitudes[shown], color=COLOURS[0])
        axes.axvline(0, color=GREY, linestyle="--", label="mesh harmonic")
        for shaft, colour in zip(shafts, COLOURS[1:]):
            for turns in (t for t in range(-TURNS, TURNS + 1) if t != 0):
                axes.axvline(turns * shaft.frequency, color=colour, linestyle=":", linewidth=0.9,
                             label=f"rotations of the {shaft.name}" if turns == 1 else None)
        axes.set(yscale="log", ylabel=f"[{run.history.units[column]}]",
                 title=f"{column} around mesh order {order} ({order * mesh:.0f} Hz)")
    panels[-1].set_xlabel("distance from the harmonic [Hz]")
    add_legend(panels[0], fontsize=8, ncol=3, loc="upper right")
    return plot
