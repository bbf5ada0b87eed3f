# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a run against itself: name, value, what is asked for, verdict (met, not met)."""
import numpy as np

from ..data.naming import describe_pair, name_driven
from ..data.table import read_table
from ..data.unused import sweeps_speeds
from .pressures import find_allowed_pressure, find_largest_pressure

LARGEST_ENERGY_ERROR = 0.5  # [%], doc/verification/dynamics.md
LARGEST_TORQUE_DIFFERENCE = 0.5  # [%]


def judge(condition):
    return "met" if condition else "not met"


def list_checks(run):
    summary = run.summary
    if "status" in summary:
        early = read_early_end(run)
        status = f"ended after {early} steps" if early else summary["status"]
        yield "status", status, "finished", judge(status == "finished")
    part = summary.get("steady part")
    if part:
        yield ("means steady within 1 %", f"{part['mesh cycles']} mesh cycles" if part["found"] else "none",
               "found", judge(part["found"]))
        steady = run.is_ripple_steady()
        yield ("ripple, first half against second half",
               {True: "steady", False: "still transient"}.get(steady, "not judged"), "change below 10 %",
               "not judged" if steady is None else judge(steady))
        # What is steady may still be that of the mesh: only a second mesh tells.
        yield "ripple, this mesh against a finer mesh", "one mesh only", "", "not judged"
    if run.history is not None and "energy error" in run.history and not run.is_equilibrium():
        # At the first touch of an impact the energies that the error is divided by are still tiny.
        error = 100 * np.abs(run.history["energy error"])
        rows = run.steady_rows(run.history) if part else slice(-1, None)
        yield ("largest energy error of the steady part" if part and part["found"] else
               "largest energy error of the last third" if part else "energy error at the end",
               f"{error[rows].max():.3g} %", f"below {LARGEST_ENERGY_ERROR} %",
               judge(error[rows].max() < LARGEST_ENERGY_ERROR))
        yield "largest energy error of the whole run", f"{error.max():.3g} %", "", "no criterion"
    yield from check_speeds(run)
    yield from check_torque(run)
    pressure, allowed = find_largest_pressure(run), find_allowed_pressure(run)
    if pressure is not None and allowed:
        yield "contact pressure (Hertz) inside the flanks", f"{pressure:.0f} MPa", f"at most the limit in the input, {allowed:.0f} MPa", judge(pressure <= allowed)
    if run.edge_contact:
        carry = run.edge_contact["edge contact"]
        yield "contact inside the flanks", "edge contact" if carry else "no edge contact", "no edge contact", judge(not carry)
    elif run.teeth is not None and name_driven(run.parameters) == "pinion":
        yield "contact inside the flanks", "not available for a driving gear", "no edge contact", "not judged"
    taken = summary.get("energy", {}).get("removed by the driven speed damping from the torsional mode")
    if taken and taken["value"] is not None and describe_pair(run.parameters):
        yield "energy removed by the speed controller from the torsional mode", f"{taken['value']:.3g} mJ", "not negative", judge(taken["value"] >= 0)
    losses = summary.get("contact losses")
    if losses and (run.value("mesh frequency") or run.changes_speed()):
        yield "tooth separations", str(losses["count"]), "0", judge(losses["count"] == 0)
    if "input conflicts" in summary:
        count = len(summary["input conflicts"])
        yield "input conflicts", str(count), "0", judge(count == 0)


def read_early_end(run):
    """Steps after which Dynamics/maximum number of steps has ended the run; 0 where it came to its end."""
    steps = int(run.parameters.get("Dynamics/maximum number of steps", "0").split()[0])
    return steps if steps and run.summary.get("run", {}).get("steps") == steps else 0


def check_speeds(run):
    """Of a sweep over speeds each speed has an energy error of its own."""
    table = read_table(run.path / "resonance.csv") if sweeps_speeds(run.parameters) else None
    if table is None or "energy error" not in table:
        return
    error = 100 * np.abs(table["energy error"])
    above = error >= LARGEST_ENERGY_ERROR
    value = f"{error.max():.3g} % at {table['speed'][np.argmax(error)]:.5g} rpm"
    yield ("largest energy error of a speed", value + (f", {above.sum()} of {error.size} speeds above the limit" if above.any() else ""),
           f"below {LARGEST_ENERGY_ERROR} %", judge(not above.any()))


def check_torque(run):
    """A steady part of whole meshes has on average the contact torque that the load asks for."""
    driven = name_driven(run.parameters)
    statistics, torque = run.statistics(f"contact torque on the {driven}"), run.value(f"{driven} torque")
    if statistics and torque:
        difference = 100 * (statistics["mean"] / torque - 1)
        yield ("mean contact torque against the load", f"{difference:+.3f} %",
               f"within {LARGEST_TORQUE_DIFFERENCE} %",
               judge(abs(difference) < LARGEST_TORQUE_DIFFERENCE))
