# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of a sweep over one number: curves over it; over speed also waterfalls and
resonances."""
import numpy as np

from curves import draw_curves, draw_resonance, find_steady, read_ripple
from lines import find_lines
from swept import MESH_ORDERS, choose_modes, find_axis, find_speeds, list_critical_speeds, read_beside
from waterfalls import draw_waterfall

CAPTIONS = {
    "resonance.svg": "Ripple of transmission error and contact force over speed. Circles: runs without "
                     "steady part. Vertical: speeds at which a mesh order meets a coupled mode.",
    "waterfall_dte.svg": "Spectra of the transmission error at each speed (Hann's window, whole meshes "
                         "of the steady part); rows are equally far from each other whatever the speeds.",
    "waterfall_force.svg": "Spectra of the contact force at each speed.",
    "curves.svg": "Figures of the runs over what is varied.",
}
COLUMNS = {"waterfall_dte.svg": "dte", "waterfall_force.svg": "contact force total"}


def draw_all(folder, variants):
    """Name of the file, what must be there, function that makes the figure."""
    axis = find_axis(variants)
    speeds = find_speeds(axis)
    beside = read_beside(folder)
    yield "resonance.svg", speeds, lambda: draw_resonance(speeds, beside)
    for name, column in COLUMNS.items():
        yield name, speeds, lambda c=column: draw_waterfall(speeds, beside, c)
    yield "curves.svg", axis, lambda: draw_curves(axis)


def add_sweep(page, folder, variants, figures):
    present = [name for name in CAPTIONS if name in figures]
    if not present:
        return
    axis = find_axis(variants)
    speeds, beside = find_speeds(axis), read_beside(folder)
    page.section(f"Over {axis.name}")
    if speeds:
        for sentence in list_sentences(speeds, beside):
            page.paragraph(sentence)
    for name in present:
        data = (folder / "pictures" / name).with_suffix(".csv")
        page.picture(folder / "pictures" / name, CAPTIONS[name],
                     f"pictures/{data.name}" if data.is_file() else None)
    if speeds:
        add_speed_tables(page, speeds, beside)


def list_sentences(speeds, beside):
    """Where the ripple is largest, and what lies near."""
    axis, steady = speeds.axis, find_steady(speeds.axis)
    for column in COLUMNS.values():
        values = read_ripple(axis, column, "peak to peak")
        if np.any(np.isfinite(values)):
            at = int(np.nanargmax(values))
            unit = axis.variants[at].run.history.units[column]
            yield (f"The {column} ripples most at {axis.text(at)} (tooth mesh {speeds.frequencies[at]:.0f} "
                   f"Hz): {values[at]:.4g} {unit} peak to peak; least at "
                   f"{axis.text(int(np.nanargmin(values)))}: {np.nanmin(values):.4g} {unit}.")
    for table in beside.lumped:
        at = int(np.argmax(table["peak to peak dte"]))
        inside = (table["speed"] >= axis.values[0]) & (table["speed"] <= axis.values[-1])
        text = (f"The lumped model's transmission error ripples most at {table['speed'][at]:.0f} rpm (tooth "
                f"mesh {table['mesh frequency'][at]:.0f} Hz): {table['peak to peak dte'][at]:.3g} arcsec")
        if axis.unit == "rpm" and np.any(inside) and not inside[at]:
            best = int(np.argmax(np.where(inside, table["peak to peak dte"], -1)))
            text += (f"; within these speeds at {table['speed'][best]:.0f} rpm: "
                     f"{table['peak to peak dte'][best]:.3g} arcsec")
        yield text + "."
    if beside.modes:
        at = ", ".join(sorted({modes.speed for modes in beside.modes}))
        yield (f"Coupled modes are those of the pair in contact that take part in the gear's turn, computed at "
               f"{at}; other speeds have other centrifugal and gyroscopic forces.")
    if not np.all(steady):
        yield ("No steady part was found at " + ", ".join(axis.text(k) for k in np.flatnonzero(~steady))
               + ": the last third is taken there.")


def add_speed_tables(page, speeds, beside):
    axis, modes = speeds.axis, choose_modes(beside, speeds)
    rows = []
    for k, variant in enumerate(axis.variants):
        run = variant.run
        steady = run.steady_rows(run.history)
        time = run.history["time"][steady]
        lines = find_lines(run.history["dte"][steady], run.samples_per_mesh(), speeds.frequencies[k], 0,
                           3.5 * speeds.frequencies[k], 1)
        line = lines[0] if lines else None
        nearest = (modes[k].frequencies[np.argmin(abs(modes[k].frequencies - line.frequency))]
                   if line and modes else None)
        rows.append([axis.values[k], speeds.frequencies[k], 1 / (time[-1] - time[0])]
                    + [read_ripple(axis, column, what)[k] for column in COLUMNS.values()
                       for what in ("mean", "peak to peak", "standard deviation")]
                    + [line.frequency if line else None, line.amplitude if line else None, nearest])
    page.table([axis.label, "tooth mesh [Hz]", "lines apart [Hz]", "dte, mean [arcsec]", "peak to peak",
                "RMS", "force, mean [N]", "peak to peak", "RMS", "dte: strongest line beside the mesh [Hz]",
                "amplitude [arcsec]", "nearest coupled mode [Hz]"], rows,
               "RMS: standard deviation from the mean of the steady part.")
    page.table(["coupled mode [Hz]", "meets mesh order", f"at {axis.label}"],
               [[frequency, order, value] for frequency, order, value
                in list_critical_speeds(beside, speeds)],
               f"Speeds at which mesh orders {MESH_ORDERS[0]} to {MESH_ORDERS[-1]} meet coupled modes.")
