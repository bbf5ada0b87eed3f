# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The text files of a run's folder (doc/output.md)."""
import csv
import json
from pathlib import Path

import numpy as np

from parameters import read_parameters


class Table:
    """Columns of a .csv file by name; `units` holds what stands in the header's brackets."""

    def __init__(self, path):
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
        if not rows:
            raise ValueError(f"{path} is empty")
        # The last line of a run that was killed may be cut off.
        body = [row for row in rows[1:] if len(row) == len(rows[0])]
        self.columns, self.units = {}, {}
        for position, header in enumerate(rows[0]):
            name, _, unit = header.partition(" [")
            cells = [row[position] for row in body]
            try:
                self.columns[name] = np.array(cells, dtype=float)
            except ValueError:
                self.columns[name] = np.array(cells)
            self.units[name] = unit.rstrip("]")
        self.n_rows = len(body)

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]

    def label(self, name):
        """Name and unit for an axis."""
        unit = self.units[name]
        return name if unit in ("", "-") else f"{name} [{unit}]"


class RunFolder:
    """A run's folder; tables that are missing or have no rows are None."""

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise FileNotFoundError(f"{self.path} is no folder")
        self.history = self._read("history.csv")
        self.teeth = self._read("teeth.csv")
        self.probes = self._read("probes.csv")
        self.pattern = self._read("pattern.csv")
        self.rim = self._read("rim.csv")
        summary = self.path / "summary.json"
        self.summary = json.loads(summary.read_text(encoding="utf-8")) if summary.is_file() else {}
        parameters = self.path / "parameters.prm"
        self.parameters = read_parameters(parameters) if parameters.is_file() else {}
        self.fields = self.path / "fields.pvd"

    def _read(self, name):
        path = self.path / name
        if not path.is_file():
            return None
        table = Table(path)
        return table if table.n_rows > 0 else None

    def figure(self, name):
        """A figure of the summary, e.g. "mesh frequency"; None where there is none."""
        return self.summary.get("figures", {}).get(name, {}).get("value")

    def samples_per_mesh(self):
        """Samples of the history in a tooth mesh; None without a gear pair."""
        frequency = self.figure("mesh frequency")
        if not frequency or self.history is None or self.history.n_rows < 2:
            return None
        interval = (self.history["time"][-1] - self.history["time"][0]) / (self.history.n_rows - 1)
        return 1 / (frequency * interval)

    def steady_part(self):
        """Start and end [s] of the part that the summary's means are of, and whether it is steady."""
        part = self.summary.get("steady part")
        if not part:
            return None
        return part["start"]["value"], part["end"]["value"], part["found"]

    def steady_rows(self, table):
        """Which rows of a table with a column of times lie in that part; all without one."""
        start, end, _ = self.steady_part() or (table["time"][0], table["time"][-1], False)
        slack = 1e-9 * table["time"][-1]
        return (table["time"] >= start - slack) & (table["time"] <= end + slack)

    def gear_rate(self):
        """Angular velocity of the driven gear about its axis at the start [rad/s]; 0 if unknown."""
        bodies = self.summary.get("mesh", {}).get("bodies", [])
        speed = bodies[1].get("speed at the start") if len(bodies) > 1 else None
        return speed["value"] * np.pi / 30 if speed else 0.0

    def body_name(self, index):
        bodies = self.summary.get("mesh", {}).get("bodies", [])
        return bodies[index]["name"] if index < len(bodies) else f"body {index}"
