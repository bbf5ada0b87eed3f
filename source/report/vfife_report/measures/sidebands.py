# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Sidebands of the mesh harmonics at the rotations of pinion and gear, where the record is long enough to
tell them apart: two revolutions."""
from dataclasses import dataclass

import numpy as np

from ..data.columns import JUDGED
from .lines import find_harmonics
from .periodicity import LEAST_MESHES, count_meshes, fold_meshes
from .spectrum import measure_amplitudes

ORDERS = (1, 2, 3)
TURNS = 3  # of a shaft on either side of a harmonic, by which lines are named
SIDEBANDS_HEADER = ["history", "mesh order", "rotation of the", "distance [Hz]", "lower sideband", "harmonic", "upper sideband", "unit"]


@dataclass
class Shaft:
    name: str
    frequency: float  # of its rotation [Hz]
    resolved: bool  # whether its sidebands are told from the harmonics
    meshes: float  # that resolve them


def find_resolution(run):
    """Lines closer than this are one [Hz]: two over the length of the whole meshes of the steady part;
    infinite for less than two meshes."""
    meshes = count_meshes(np.count_nonzero(run.steady_rows(run.history)), run.samples_per_mesh())
    return 2 * run.value("mesh frequency") / meshes if meshes >= LEAST_MESHES else np.inf


def list_shafts(run):
    """Pinion and gear as they turn at the start."""
    resolution, mesh = find_resolution(run), run.value("mesh frequency")
    for body in run.bodies():
        turn = abs(body["speed at the start"]["value"]) / 60
        if turn > 0:
            yield Shaft(body["name"], turn, turn >= (1 - 1e-6) * resolution, 2 * mesh / turn)


def name_offset(run, offset):
    """Distance from a harmonic [Hz] as turns of a shaft where it is that and can be told, else in Hz."""
    for shaft in list_shafts(run):
        turns = round(offset / shaft.frequency)
        if shaft.resolved and 0 < abs(turns) <= TURNS and (
                abs(offset - turns * shaft.frequency) < 0.25 * find_resolution(run)):
            return f"{turns:+d} rotation{'s' if abs(turns) > 1 else ''} of the {shaft.name}"
    return f"{abs(offset):.0f} Hz {'below' if offset < 0 else 'above'}"


def list_sidebands(run):
    """Amplitudes one rotation below and above the harmonics, without what repeats with the mesh."""
    mesh, samples = run.value("mesh frequency"), run.samples_per_mesh()
    shafts = [shaft for shaft in list_shafts(run) if shaft.resolved]
    for column in JUDGED if shafts else ():
        if column not in run.history:
            continue
        values = run.steady_values(column)
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
