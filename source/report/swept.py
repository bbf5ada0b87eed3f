# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sweep varies, and the results of other studies that stand beside those of its runs."""
from dataclasses import dataclass

import numpy as np

from run_folder import Table
from parameters import read_parameters
from words import LENGTHS, find_differences, normalize

LEAST_SHARE = 0.02  # of a mode in the static turn of the gear, as in comparisons (doc/study.md)
MESH_ORDERS = (1, 2, 3)


@dataclass
class Axis:
    """The one number that is varied: runs by rising value."""
    name: str
    unit: str
    variants: list
    values: np.ndarray

    @property
    def label(self):
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def text(self, position):
        return f"{self.values[position]:g} {self.unit}".strip()


def find_axis(variants):
    """None unless the runs differ in one number (and how long they are), with one unit and three values
    or more. Runs without results do not count."""
    variants = [v for v in variants if v.run.parameters and v.run.history is not None]
    names = [n for n in find_differences([v.run for v in variants]) if n not in LENGTHS]
    if len(names) != 1:
        return None
    cells = [normalize(v.run.parameters.get(names[0])) for v in variants]
    if not all(cell and isinstance(cell[0], float) for cell in cells):
        return None
    if len({cell[1:] for cell in cells}) > 1 or not len(set(cells)) == len(cells) >= 3:
        return None
    order = np.argsort([cell[0] for cell in cells])
    return Axis(names[0].split("/")[-1], " ".join(cells[0][1:]), [variants[k] for k in order],
                np.array([cells[k][0] for k in order]))


@dataclass
class Speeds:
    """Runs over the speed: mesh frequencies [Hz] grow in proportion to the values of the axis."""
    axis: Axis
    frequencies: np.ndarray

    @property
    def frequency_of_one(self):
        return self.frequencies[0] / self.axis.values[0]


def find_speeds(axis):
    """The axis as speeds; None where the tooth mesh's frequency says that it is none."""
    if axis is None or axis.values[0] <= 0:
        return None
    frequencies = [v.run.figure("mesh frequency") for v in axis.variants]
    if not all(frequencies):
        return None
    ratio = np.array(frequencies) / axis.values
    return Speeds(axis, np.array(frequencies)) if np.ptp(ratio) < 1e-6 * ratio[0] else None


@dataclass
class Modes:
    """Natural frequencies [Hz] of the pair in contact that turn the gear, at one speed."""
    speed: str
    frequencies: np.ndarray
    shares: np.ndarray  # of the static turn


@dataclass
class Beside:
    modes: list  # of Modes
    lumped: list  # tables of resonance.csv


def read_beside(folder):
    """Coupled modes and lumped sweeps of the folders below `beside`."""
    folders = sorted((folder / "beside").iterdir()) if (folder / "beside").is_dir() else []
    return Beside([read_modes(path) for path in folders if (path / "coupled_modes.csv").is_file()],
                  [Table(path / "resonance.csv") for path in folders
                   if (path / "resonance.csv").is_file()])


def read_modes(folder):
    """Those that stand in space where there are any: the load does."""
    table = Table(folder / "coupled_modes.csv")
    rows = table["share of the static turn"] > LEAST_SHARE
    if np.any(table["axes"] == "standing"):
        rows &= table["axes"] == "standing"
    parameters = folder / "parameters.prm"
    speed = read_parameters(parameters).get("Operation/speed", "") if parameters.is_file() else ""
    return Modes(speed, table["frequency"][rows], table["share of the static turn"][rows])


def choose_modes(beside, speeds):
    """For each run the modes that were computed nearest to its speed; empty without modes."""
    def distance(modes, value):
        known = normalize(modes.speed)
        return abs(known[0] - value) if known and known[1:] == (speeds.axis.unit,) else np.inf

    return [min(beside.modes, key=lambda modes: distance(modes, value))
            for value in speeds.axis.values] if beside.modes else []


def list_critical_speeds(beside, speeds):
    """Mode [Hz], mesh order and value of the axis at which they meet, within the axis; of the modes
    computed nearest to that speed."""
    first, last = speeds.axis.values[[0, -1]]
    found = []
    for modes in beside.modes:
        for frequency in modes.frequencies:
            for order in MESH_ORDERS:
                value = frequency / (order * speeds.frequency_of_one)
                at = Speeds(Axis("", speeds.axis.unit, [], np.array([value])), np.empty(0))
                if first <= value <= last and choose_modes(beside, at)[0] is modes:
                    found.append((frequency, order, value))
    return sorted(found, key=lambda one: one[2])
