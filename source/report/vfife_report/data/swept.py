# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sweep varies: one number, perhaps a speed."""
from dataclasses import dataclass

import numpy as np

from .naming import LENGTHS, find_differences, normalize

LEAST_VALUES = 3  # that make a curve


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
    variants = [v for v in variants if v.run.parameters and (v.run.history is not None or v.run.stated)]
    names = [n for n in find_differences([v.run for v in variants]) if n not in LENGTHS]
    if len(names) != 1:
        return None
    cells = [normalize(v.run.parameters.get(names[0])) for v in variants]
    if not all(cell and isinstance(cell[0], float) for cell in cells):
        return None
    if len({cell[1:] for cell in cells}) > 1 or not len(set(cells)) == len(cells) >= LEAST_VALUES:
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
    """The axis as speeds; None where the mesh frequency says that it is none."""
    if axis is None or axis.values[0] <= 0:
        return None
    frequencies = [v.run.value("mesh frequency") for v in axis.variants]
    if not all(frequencies):
        return None
    ratio = np.array(frequencies) / axis.values
    return Speeds(axis, np.array(frequencies)) if np.ptp(ratio) < 1e-6 * ratio[0] else None
