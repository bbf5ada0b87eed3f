# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Waterfalls: spectra of runs at several speeds, one above the other, over frequency and mesh order."""
import numpy as np

from ..measures.critical_speeds import choose_modes
from ..measures.spectrum import compute_spectrum
from .plot_data import attach_numbers
from .style import COLOURS, GREY, plt

DECADES = 3  # of the amplitude, from the base line of a row to the largest line of all
ROWS_PER_DECADE = 0.6
SHOWN_MESH_ORDERS = 6


def list_spectra(speeds, column):
    """Frequencies [Hz] without zero and amplitudes of the steady part of each run, None where it has
    less than two whole meshes."""
    for variant, frequency in zip(speeds.axis.variants, speeds.frequencies):
        run = variant.run
        orders, amplitudes = compute_spectrum(run.steady_values(column), run.samples_per_mesh(),
                                              windowed=True, points_per_line=4)
        yield (orders[1:] * frequency, amplitudes[1:]) if len(orders) else None


def draw_rows(axes, speeds, spectra, base, as_order):
    """A row a speed, each hiding what is behind it; heights are logarithms of the amplitude."""
    for row in reversed(range(len(spectra))):
        if spectra[row] is None:
            continue
        frequency, amplitude = spectra[row]
        x = frequency / speeds.frequencies[row] if as_order else 1e-3 * frequency
        height = row + ROWS_PER_DECADE * np.log10(np.maximum(amplitude / base, 1))
        axes.fill_between(x, row, height, facecolor="white", alpha=0.8, edgecolor="none", zorder=3 - 0.1 * row)
        axes.plot(x, height, color=COLOURS[1], linewidth=0.9, zorder=3 - 0.1 * row)
    axes.set_yticks(range(len(spectra)), [speeds.axis.text(row) for row in range(len(spectra))])
    axes.set_ylim(-0.2, len(spectra) - 1 + ROWS_PER_DECADE * DECADES + 0.2)
    axes.grid(False)


def mark_orders(axes, speeds, largest):
    """Where the mesh orders are at each speed."""
    rows = np.arange(len(speeds.frequencies))
    for order in range(1, SHOWN_MESH_ORDERS + 1):
        x = 1e-3 * order * speeds.frequencies
        axes.plot(x, rows, color=GREY, linewidth=0.7, zorder=3.5)
        if x[-1] <= largest:
            axes.annotate(f"{order}", (x[-1], rows[-1]), xytext=(0, 22), color=GREY, fontsize=8,
                          textcoords="offset points", ha="center")


def mark_modes(axes, speeds, modes, as_order):
    """Frequencies of the modes computed nearest to each speed."""
    for row, of_row in enumerate(modes):
        scale = 1 / speeds.frequencies[row] if as_order else 1e-3
        axes.vlines(of_row.frequencies * scale, row, row + 0.85, color=COLOURS[2], linewidth=1.1,
                    zorder=4, alpha=0.8)


def draw_waterfall(study, column):
    """Above over frequency, below over mesh order; None where no run has a spectrum."""
    speeds, beside = study.speeds, study.beside
    spectra = list(list_spectra(speeds, column))
    known = [spectrum for spectrum in spectra if spectrum is not None]
    if not known:
        return None
    top = max(amplitude.max() for _, amplitude in known)
    base = top * 10.0**-DECADES
    count = len(spectra)
    plot, (above, below) = plt.subplots(2, 1, figsize=(8, 3 + 0.75 * count))
    modes = choose_modes(beside, speeds)
    for axes, as_order in ((above, False), (below, True)):
        draw_rows(axes, speeds, spectra, base, as_order)
        mark_modes(axes, speeds, modes, as_order)
        axes.set_ylabel(speeds.axis.name)
    lowest = 0.5 * min([speeds.frequencies[0]] + [m.frequencies.min() for m in beside.modes])
    largest = 3.3 * speeds.frequencies[-1]
    above.set(xscale="log", xlim=(1e-3 * lowest, 1e-3 * largest), xlabel="frequency [kHz]",
              title="Spectra over frequency (grey: mesh orders" + (", red: coupled modes" if modes else "") + ")")
    ticks = [tick for tick in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if 1e-3 * lowest <= tick <= 1e-3 * largest]
    above.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    mark_orders(above, speeds, 1e-3 * largest)
    below.set(xlim=(0, SHOWN_MESH_ORDERS + 0.2), xlabel="mesh order",
              title="Spectra over mesh order")
    below.xaxis.grid(True)
    unit = speeds.axis.variants[0].run.history.units[column]
    plot.suptitle(f"{column}: amplitudes above {base:.2g} {unit}, {ROWS_PER_DECADE:g} row heights per factor of ten, "
                  f"largest amplitude {top:.3g} {unit}", x=0.01, ha="left", fontsize=9, color=GREY)
    rows = [[f"{value:g}", f"{f:.9g}", f"{f / mesh:.9g}", f"{a:.9g}"]
            for value, mesh, spectrum in zip(speeds.axis.values, speeds.frequencies, spectra)
            if spectrum is not None for f, a in zip(*spectrum) if f <= SHOWN_MESH_ORDERS * mesh]
    attach_numbers(plot, [speeds.axis.label, "frequency [Hz]", "mesh order [-]",
                          f"amplitude [{unit}]"], rows)
    return plot
