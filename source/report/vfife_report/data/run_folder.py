# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The text files of a run's folder (doc/reference/files.md)."""
from pathlib import Path

import numpy as np

from .files import DamagedFile, find_fields, read_json
from .naming import is_open
from .parameters import read_parameters
from .shapes import EDGE_CONTACT, GEOMETRY, STATED, SUMMARY
from .table import read_table


class RunFolder:
    """A run's folder, or any other with results; tables that are missing or have no rows are None."""

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise FileNotFoundError(f"{self.path} is no folder")
        self.history = read_table(self.path / "history.csv")
        self.teeth = read_table(self.path / "teeth.csv")
        self.probes = read_table(self.path / "probes.csv")
        self.pattern = read_table(self.path / "pattern.csv")
        self.rim = read_table(self.path / "rim.csv")
        self.orders = read_table(self.path / "orders.csv")
        self.bearings = read_table(self.path / "bearings.csv")
        self.meshes = read_table(self.path / "mesh.csv")
        self.misalignment = read_table(self.path / "misalignment.csv")
        # Loaded tooth contact analyses have the last two over positions.
        timed = [table for table in (self.bearings, self.misalignment) if table is not None and "time" in table]
        for table in (self.history, self.teeth, self.probes, self.rim, *timed):
            if table is not None:
                table.check_times()
        summary = self.path / "summary.json"
        self.summary = read_json(summary, SUMMARY) if summary.is_file() else {}
        self.parameters = read_parameters(self.path)
        geometry = self.path / "geometry.json"
        self.geometry = read_json(geometry, GEOMETRY) if geometry.is_file() else {}
        self.fill_sizes()
        stated = self.path / "figures.json"
        self.stated = read_json(stated, STATED) if stated.is_file() else {}
        edges = self.path / "edge_contact.json"
        self.edge_contact = read_json(edges, EDGE_CONTACT) if edges.is_file() else {}
        self.fields = find_fields(self.path)

    def fill_sizes(self):
        """Sizes of bodies that entries leave open: as they were derived from the blank."""
        for section in ("Pinion", "Gear"):
            for name, one in self.geometry.get(section.lower(), {}).items():
                path = f"Gear pair/{section}/Body/{name}"
                if isinstance(one, dict) and one["value"] is not None and is_open(self.parameters.get(path)):
                    self.parameters[path] = f"{one['value']:g} {one['unit']}"

    def is_equilibrium(self):
        """Of a study without a motion: its history has one row, and energies that no work and no loss balances."""
        return self.summary.get("study") in ("static", "linear static")

    def has_file(self, name):
        return (self.path / name).is_file()

    def value(self, name):
        """Of the summary's figures, e.g. "mesh frequency"; None where there is none."""
        return self.summary.get("figures", {}).get(name, {}).get("value")

    def samples_per_mesh(self):
        """Samples of the history in a mesh cycle; None without a gear pair."""
        frequency = self.value("mesh frequency")
        if not frequency or self.history is None or self.history.n_rows < 2:
            return None
        interval = (self.history["time"][-1] - self.history["time"][0]) / (self.history.n_rows - 1)
        if not (interval > 0 and 0.5 <= 1 / (frequency * interval) < self.history.n_rows * 1e6):
            raise DamagedFile(f"{self.path / 'history.csv'}: its samples do not fit the mesh frequency {frequency:g} Hz "
                              "of summary.json")
        return 1 / (frequency * interval)

    def steady_part(self):
        """Start and end [s] of the part that the summary's means are of, and whether it is steady."""
        part = self.summary.get("steady part")
        if not part:
            return None
        return part["start"]["value"], part["end"]["value"], part["found"]

    def is_steady(self):
        """Whether a steady part was found; else means are of the last third."""
        part = self.steady_part()
        return bool(part and part[2])

    def is_ripple_steady(self):
        """Whether peak to peak and harmonics stay over that part; None where nothing was judged (also by versions
        that judged the means alone)."""
        ripple = self.summary.get("steady part", {}).get("ripple")
        return ripple["steady"] if ripple and ripple["judged"] else None

    def steady_rows(self, table):
        """Which rows of a table with a column of times lie in that part; all without one."""
        start, end, _ = self.steady_part() or (table["time"][0], table["time"][-1], False)
        slack = 1e-9 * table["time"][-1]
        return (table["time"] >= start - slack) & (table["time"] <= end + slack)

    def steady_values(self, column):
        """A column of the history over that part."""
        return self.history[column][self.steady_rows(self.history)]

    def statistics(self, column):
        """Mean, peak to peak, standard deviation and unit of a column over that part, as the program
        has computed them; None."""
        return self.summary.get("steady part", {}).get("columns", {}).get(column)

    def bodies(self):
        """What the summary says of each body, or the table of the kind `mesh`."""
        if self.meshes is None:
            return self.summary.get("mesh", {}).get("bodies", [])
        rows = zip(*(self.meshes[name] for name in ("body", "elements", "nodes", "mass")))
        return [{"name": name, "cells": int(cells), "nodes": int(nodes), "mass": {"value": mass, "unit": self.meshes.units["mass"]}}
                for name, cells, nodes, mass in rows]

    def body_name(self, index):
        bodies = self.bodies()
        return bodies[index]["name"] if index < len(bodies) else f"body {index}"

    def changes_speed(self):
        """Whether the prescribed speed of the gear pair is not the same throughout."""
        return self.history is not None and "speed" in self.history and bool(np.ptp(self.history["speed"]) > 0)

    def gear_turn(self, time):
        """Angles by which the driven gear has turned about its axis since the start [rad]; 0 if unknown."""
        if not self.changes_speed():
            return self.gear_rate() * time
        at, speed = self.history["time"], self.history["speed"]
        turned = np.concatenate([[0], np.cumsum(0.5 * np.diff(at) * (speed[1:] + speed[:-1]))])
        return self.gear_rate() / speed[0] * np.interp(time, at, turned)

    def gear_rate(self):
        """Angular velocity of the driven gear about its axis at the start [rad/s]; 0 if unknown."""
        bodies = self.bodies()
        speed = bodies[1].get("speed at the start") if len(bodies) > 1 else None
        return speed["value"] * np.pi / 30 if speed else 0.0
