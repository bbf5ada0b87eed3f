# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""How steady and how periodic a history is: mesh cycles laid over each other, trend. doc/theory/steady-part.md
defines every number."""
from dataclasses import dataclass

import numpy as np

LEAST_MESHES = 2  # from which anything is said of what repeats


def count_meshes(n_values, samples_per_mesh):
    """Whole mesh cycles between the first and the last of equally spaced samples."""
    return int((n_values - 1 + 1e-6) // samples_per_mesh)


def fold_meshes(values, samples_per_mesh):
    """Whole mesh cycles at the end of equally spaced samples as rows (meshes, positions), linear
    between samples where a mesh is no whole number of them."""
    meshes = count_meshes(len(values), samples_per_mesh)
    positions = max(int(round(samples_per_mesh)), 2)
    start = len(values) - 1 - meshes * samples_per_mesh
    at = start + np.arange(meshes * positions) * (samples_per_mesh / positions)
    return np.interp(at, np.arange(len(values)), values).reshape(meshes, positions)


@dataclass
class Periodicity:
    """Numbers in the unit of the history; they need LEAST_MESHES."""
    meshes: int
    ripple: float  # peak to peak of the mean mesh
    deviation: float  # standard deviation from the mean
    remainder: float  # standard deviation from the mean mesh: what does not repeat with the mesh
    change: float  # root mean square of the difference of consecutive meshes
    largest_change: float  # largest difference of consecutive meshes at the same position
    trend: float  # slope of the meshes' means by least squares, a mesh

    @property
    def periodic_share(self):
        """Part of the variance that repeats with the mesh cycle; 1: strictly periodic."""
        return 1 - (self.remainder / self.deviation) ** 2 if self.deviation > 0 else 1.0


def measure_periodicity(values, samples_per_mesh):
    """None for less than two meshes."""
    folded = fold_meshes(values, samples_per_mesh)
    if len(folded) < LEAST_MESHES:
        return None
    mean = folded.mean(axis=0)
    change = np.diff(folded, axis=0)
    return Periodicity(
        meshes=len(folded), ripple=np.ptp(mean), deviation=folded.std(),
        remainder=(folded - mean).std(), change=np.sqrt(np.mean(change**2)),
        largest_change=np.abs(change).max(),
        trend=np.polyfit(np.arange(len(folded)), folded.mean(axis=1), 1)[0])


def compute_mesh_average(values, samples_per_mesh):
    """Mean over the mesh cycle centred at each sample, not a number nearer than half a mesh to the
    ends. Trapezoidal rule, exact between samples; a mesh need not be a whole number of them."""
    integral = np.concatenate([[0], np.cumsum(0.5 * (values[1:] + values[:-1]))])
    position = np.arange(len(values), dtype=float)
    half = 0.5 * samples_per_mesh
    inside = (position >= half) & (position <= len(values) - 1 - half)
    average = np.full(len(values), np.nan)

    def integral_at(at):
        low = np.minimum(at.astype(int), len(values) - 2)
        part = at - low
        slope = values[low + 1] - values[low]
        return integral[low] + part * values[low] + 0.5 * part**2 * slope

    centre = position[inside]
    average[inside] = (integral_at(centre + half) - integral_at(centre - half)) / samples_per_mesh
    return average


def measure_column(run, column):
    """Periodicity over the steady part; None where it cannot be measured."""
    if run.history is None or column not in run.history or not run.samples_per_mesh():
        return None
    return measure_periodicity(run.steady_values(column), run.samples_per_mesh())
