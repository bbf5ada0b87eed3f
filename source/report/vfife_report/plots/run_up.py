# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a run whose speed changes: amplitudes of mesh orders and spectra over the speed."""
import numpy as np

from ..data.columns import CONTACT_FORCE, TRANSMISSION_ERROR
from ..measures.spectrum import amplitudes_of, hann_window
from .plot_data import attach_numbers
from .style import COLOURS, GREY, PRESSURE_MAP, add_legend, plt
from .waterfalls import DECADES

WINDOWS = 24  # of a record, laid over each other by half
SHOWN_ORDERS = 4.5  # of the gear mesh at the largest speed


def draw_orders(run):
    """A panel a quantity, a curve a mesh order."""
    orders = run.orders
    shown = [f"{name} amplitude" for name in (TRANSMISSION_ERROR, CONTACT_FORCE)]
    plot, panels = plt.subplots(len(shown), 1, sharex=True, figsize=(8, 6.5))
    for axes, name in zip(panels, shown):
        for k in np.unique(orders["mesh order"]):
            rows = orders["mesh order"] == k
            axes.plot(orders["speed"][rows], orders[name][rows], color=COLOURS[int(k) % len(COLOURS)],
                      label=f"mesh order {k:.0f}")
        axes.set_ylabel(orders.label(name))
        axes.set_ylim(bottom=0)
    add_legend(panels[0], ncol=2, fontsize=9)
    panels[0].set_title("Amplitudes of the mesh orders in windows of whole mesh cycles")
    panels[-1].set_xlabel(f"{orders.label('speed')} of the driver")
    return plot


def compute_window_spectra(time, values):
    """Times of the middles of windows, frequencies [Hz] without zero and amplitudes, a row a window
    (Hann's weights, mean and straight line of the ends taken out)."""
    n = max(2 * len(values) // (WINDOWS + 1), 8)
    interval = (time[-1] - time[0]) / (len(time) - 1)
    starts = np.arange(0, len(values) - n + 1, max(n // 2, 1))
    window = hann_window(n)
    rows = []
    for start in starts:
        part = values[start:start + n]
        slope = np.polyfit(np.arange(n), part, 1)
        rows.append(amplitudes_of((part - np.polyval(slope, np.arange(n))) * window))
    return (time[starts] + 0.5 * n * interval, np.fft.rfftfreq(n, interval)[1:],
            np.array(rows)[:, 1:])


def draw_waterfall(run, column=TRANSMISSION_ERROR):
    """Spectra of windows of the record, one above the other by their speeds, with the lines of the
    mesh orders."""
    history = run.history
    values = history[column]
    if not np.all(np.isfinite(values)) or len(values) < 4 * WINDOWS:
        return None
    time, frequency, amplitude = compute_window_spectra(history["time"], values)
    order = np.argsort(np.interp(time, history["time"], history["speed"]), kind="stable")
    speed = np.interp(time, history["time"], history["speed"])[order]
    mesh = np.interp(time, history["time"], history["mesh frequency"])[order]
    amplitude = amplitude[order]
    top = SHOWN_ORDERS * mesh.max()
    shown = frequency <= top
    largest = amplitude[:, shown].max()
    if not largest > 1e-9 * np.abs(values).max():  # nothing but round-off
        return None
    plot, axes = plt.subplots(figsize=(8, 6))
    level = np.log10(np.maximum(amplitude[:, shown], largest * 10.0**-DECADES))
    shades = axes.pcolormesh(1e-3 * frequency[shown], speed, level, shading="nearest", cmap=PRESSURE_MAP,
                             rasterized=True)
    for k in range(1, int(SHOWN_ORDERS) + 1):
        axes.plot(1e-3 * k * mesh, speed, ":", color=GREY, linewidth=1)
        axes.annotate(f"{k}", (1e-3 * k * mesh[-1], speed[-1]), xytext=(0, 12), textcoords="offset points",
                      ha="center", fontsize=8, color=GREY, annotation_clip=False)
    axes.set_xlim(0, 1e-3 * top)
    axes.grid(False)
    axes.set(xlabel="frequency [kHz]", ylabel=f"{history.label('speed')} of the driver")
    axes.set_title(f"Spectra of the {column} over the speed (dotted: mesh orders)", pad=18)
    plot.colorbar(shades, ax=axes, label=f"logarithm of the amplitude [{history.units[column]}]")
    attach_numbers(plot, ["speed [rpm]", "frequency [Hz]", f"amplitude [{history.units[column]}]"],
                   ([f"{s:.9g}", f"{f:.9g}", f"{a:.6g}"] for s, row in zip(speed, amplitude[:, shown])
                    for f, a in zip(frequency[shown], row)))
    return plot
