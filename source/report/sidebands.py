# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Sidebands of the mesh harmonics at the rotations of pinion and gear, where the record is long enough to
tell them apart: two revolutions."""
from dataclasses import dataclass

import numpy as np

from key_figures import JUDGED
from lines import find_harmonics, measure_amplitudes
from periodicity import fold_meshes
from spectra import compute_spectrum
from style import COLOURS, GREY, add_legend, plt

ORDERS = (1, 2, 3)
SIDEBANDS_HEADER = ["history", "mesh order", "turns of the", "apart [Hz]", "lower", "harmonic", "upper",
                    "unit"]


@dataclass
class Shaft:
    name: str
    frequency: float  # of its rotation [Hz]
    resolved: bool  # whether its sidebands are told from the harmonics
    meshes: float  # that resolve them


def find_resolution(run):
    """Lines closer than this are one [Hz]: two over the length of the whole meshes of the steady part;
    infinite for less than two meshes."""
    rows, samples = run.steady_rows(run.history), run.samples_per_mesh()
    meshes = int((np.count_nonzero(rows) - 1 + 1e-6) // samples)
    return 2 * run.figure("mesh frequency") / meshes if meshes > 1 else np.inf


def list_shafts(run):
    """Pinion and gear as they turn at the start."""
    resolution, mesh = find_resolution(run), run.figure("mesh frequency")
    for body in run.summary.get("mesh", {}).get("bodies", []):
        turn = abs(body["speed at the start"]["value"]) / 60
        if turn > 0:
            yield Shaft(body["name"], turn, turn >= (1 - 1e-6) * resolution, 2 * mesh / turn)


def name_offset(run, offset):
    """Distance from a harmonic [Hz] as turns of a shaft where it is that and can be told, else in Hz."""
    for shaft in list_shafts(run):
        turns = round(offset / shaft.frequency)
        if shaft.resolved and 0 < abs(turns) <= 3 and (
                abs(offset - turns * shaft.frequency) < 0.25 * find_resolution(run)):
            return f"{turns:+d} turn{'s' if abs(turns) > 1 else ''} of the {shaft.name}"
    return f"{offset:+.0f} Hz"


def list_sidebands(run):
    """Amplitudes one rotation below and above the harmonics, without what repeats with the mesh."""
    mesh, samples = run.figure("mesh frequency"), run.samples_per_mesh()
    shafts = [shaft for shaft in list_shafts(run) if shaft.resolved]
    rows = run.steady_rows(run.history)
    for column in JUDGED if shafts else ():
        if column not in run.history:
            continue
        values = run.history[column][rows]
        folded = fold_meshes(values, samples)
        rest = (folded - folded.mean(axis=0)).ravel()
        harmonics = find_harmonics(values, samples, max(ORDERS))
        interval = len(folded) / (mesh * len(rest))
        for shaft in shafts:
            for order in ORDERS:
                lower, upper = measure_amplitudes(
                    rest, interval, [order * mesh - shaft.frequency, order * mesh + shaft.frequency])
                yield [column, order, shaft.name, shaft.frequency, lower, harmonics[order - 1], upper,
                       run.history.units[column]]


def draw_sidebands(run, column="dte"):
    """Spectrum around the first harmonics of the mesh over turns of the pinion; None where no sideband
    can be told."""
    shafts = [shaft for shaft in list_shafts(run) if shaft.resolved]
    if not shafts:
        return None
    mesh = run.figure("mesh frequency")
    fastest = max(shaft.frequency for shaft in shafts)
    orders, amplitudes = compute_spectrum(run.history[column][run.steady_rows(run.history)],
                                          run.samples_per_mesh(), windowed=True)
    figure, panels = plt.subplots(len(ORDERS), 1, figsize=(8, 7.5), sharex=True)
    for axes, order in zip(panels, ORDERS):
        offset = (orders - order) * mesh
        shown = (np.abs(offset) < 3.6 * fastest) & (amplitudes > 0)
        axes.plot(offset[shown], amplitudes[shown], color=COLOURS[0])
        axes.axvline(0, color=GREY, linestyle="--", label="mesh harmonic")
        for shaft, colour in zip(shafts, COLOURS[1:]):
            for turns in (-3, -2, -1, 1, 2, 3):
                axes.axvline(turns * shaft.frequency, color=colour, linestyle=":", linewidth=0.9,
                             label=f"turns of the {shaft.name}" if turns == 1 else None)
        axes.set(yscale="log", ylabel=f"[{run.history.units[column]}]",
                 title=f"{column} around mesh order {order} ({order * mesh:.0f} Hz)")
    panels[-1].set_xlabel("distance from the harmonic [Hz]")
    add_legend(panels[0], fontsize=8, ncol=3, loc="upper right")
    return figure
