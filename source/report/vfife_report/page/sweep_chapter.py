# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The chapter of a sweep over one number; over speed also spectra, resonances and what meets what."""
import numpy as np

from ..data.columns import TRANSMISSION_ERROR
from ..measures.critical_speeds import MESH_ORDERS, choose_modes, list_critical_speeds
from ..measures.lines import HIGHEST_LINE_ORDER, find_lines
from ..measures.ripple import RIPPLES, find_steady, read_ripple
from .parts import EXACT, Cells, Paragraph


def title_sweep(study):
    return f"Results over {study.axis.name}"


def tell_sweep(study, plots):
    if not plots:
        return
    if study.speeds:
        for sentence in list_sentences(study.speeds, study.beside):
            yield Paragraph(sentence)
    yield from plots
    if study.speeds:
        yield from list_speed_tables(study.speeds, study.beside)


def list_sentences(speeds, beside):
    """Where the peak to peak value is largest, in the runs and in other models."""
    axis, steady = speeds.axis, find_steady(speeds.axis)
    for column, _ in RIPPLES:
        values = read_ripple(axis, column, "peak to peak")
        if np.any(np.isfinite(values)):
            at = int(np.nanargmax(values))
            unit = axis.variants[at].run.history.units[column]
            yield (f"The peak to peak {column} is largest at {axis.text(at)}: {values[at]:.4g} {unit} at a mesh "
                   f"frequency of {speeds.frequencies[at]:.0f} Hz. It is smallest at {axis.text(int(np.nanargmin(values)))}: "
                   f"{np.nanmin(values):.4g} {unit}.")
    for response in beside.responses:
        table = response.table
        at = int(np.argmax(table["peak to peak dte"]))
        inside = (table["speed"] >= axis.values[0]) & (table["speed"] <= axis.values[-1])
        text = (f"In the {response.model} the peak to peak dte is largest at {table['speed'][at]:.0f} rpm: "
                f"{table['peak to peak dte'][at]:.3g} arcsec at a mesh frequency of {table['mesh frequency'][at]:.0f} Hz.")
        if axis.unit == "rpm" and np.any(inside) and not inside[at]:
            best = int(np.argmax(np.where(inside, table["peak to peak dte"], -1)))
            text += (f" Within the speeds of the runs it is largest at {table['speed'][best]:.0f} rpm: "
                     f"{table['peak to peak dte'][best]:.3g} arcsec.")
        yield text
    if beside.modes:
        at = ", ".join(sorted({modes.speed for modes in beside.modes}))
        yield (f"Coupled modes are the modes of the pair in contact that rotate the gear, computed at {at}. Other speeds have other "
               "centrifugal and gyroscopic forces.")
    if not np.all(steady):
        yield ("No steady part was found at " + ", ".join(axis.text(k) for k in np.flatnonzero(~steady))
               + ". Values at these speeds cover the last third.")


def list_speed_tables(speeds, beside):
    axis, modes = speeds.axis, choose_modes(beside, speeds)
    rows = []
    for k, variant in enumerate(axis.variants):
        run = variant.run
        steady = run.steady_rows(run.history)
        time = run.history["time"][steady]
        lines = find_lines(run.history[TRANSMISSION_ERROR][steady], run.samples_per_mesh(),
                           speeds.frequencies[k], 0, HIGHEST_LINE_ORDER * speeds.frequencies[k], 1)
        line = lines[0] if lines else None
        nearest = (modes[k].frequencies[np.argmin(abs(modes[k].frequencies - line.frequency))]
                   if line and modes else None)
        rows.append([axis.values[k], speeds.frequencies[k], 1 / (time[-1] - time[0])]
                    + [read_ripple(axis, column, what)[k] for column, _ in RIPPLES
                       for what in ("mean", "peak to peak", "standard deviation")]
                    + [line.frequency if line else None, line.amplitude if line else None, nearest])
    yield Cells([axis.label, "mesh frequency [Hz]", "line spacing [Hz]", "dte, mean [arcsec]", "peak to peak",
                 "RMS", "force, mean [N]", "peak to peak", "RMS",
                 "strongest dte line besides mesh harmonics [Hz]", "amplitude [arcsec]",
                 "nearest coupled mode [Hz]"], rows,
                "RMS is the standard deviation in the steady part.", digits=EXACT)
    yield Cells(["coupled mode [Hz]", "mesh order", f"resonant at {axis.label}"],
                [[frequency, order, value] for frequency, order, value
                 in list_critical_speeds(beside, speeds)],
                f"Speeds at which mesh orders {MESH_ORDERS[0]} to {MESH_ORDERS[-1]} are resonant with coupled modes.", digits=EXACT)
