# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Words of the report for names of the result files and values of parameters; a name without one is shown as it is."""

PARTS_OF_ERROR = {
    "total at the start": "total",
    "teeth and rest": "tooth bending, contact, pinion and remainder",
    "web windup": "web windup (twist between hub and rim)",
    "penalty compliance, in teeth and rest": "of the row of the teeth: contact penalty (compliance that the elements lack)"}
ENERGIES = {
    "kinetic": "kinetic energy",
    "kinetic, relative to the turning bodies": "kinetic energy of the vibration in the rotating frames",
    "strain": "strain energy",
    "contact": "energy of the contact penalty",
    "start": "total energy at the start",
    "work of the torques": "work of the load torques",
    "damping loss": "loss by mass proportional damping",
    "removed by the driven speed damping": "removed by the speed controller, rotation and vibration (negative: added)",
    "removed by the driven speed damping from the torsional mode": "removed by the speed controller from the torsional mode",
    "contact loss": "loss in the contact",
    "contact loss by friction": "friction loss in the contact",
    "residual": "residual of the energy balance",
    "error": "residual over the largest energy exchanged"}
# Columns of history.csv in the plot of the energies.
ENERGY_CURVES = {
    "contact energy": "energy of the contact penalty",
    "relative kinetic energy": "kinetic energy of the vibration",
    "damping loss": "loss by mass proportional damping",
    "removed by the driven speed damping": "removed by the speed controller",
    "contact loss": "loss in the contact"}
COMPUTATION = {
    "time": "simulated time", "step": "time step", "steps": "time steps", "run time": "computing time of the steps",
    "ranks": "MPI ranks", "other": "model, equilibrium at the start, files", "total": "total without report",
    "rest of the steps": "other parts of the steps", "nodal update": "update of the nodes", "observers": "histories and files of the steps"}
GEOMETRY_NAMES = {
    "designed normal backlash, mean point": "normal backlash at the mean point, without errors",
    "cutter diameter, mean of the point radii": "cutter diameter, mean of inside and outside point diameters"}
HISTORIES = {"dte": "transmission error (dte)", "contact force total": "sum of the contact forces"}
VALUES = {
    "true flank": "generated flank (true flank)",
    "flat facets": "flat facets of the mesh",
    "polar": "polar decomposition (polar)",
    "incompatible modes": "8-node hexahedra with incompatible modes"}


def label(words, name):
    return words.get(name, name)


def label_quantity(name):
    """Key figures of pinion and gear parts: the place is along the axis."""
    return name.replace(", at height", ", at axial position from the apex")
