# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of .csv files whose header names columns as `name [unit]`."""
import csv

import numpy as np


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


def read_table(path):
    """None where there is no file or it has no rows."""
    if not path.is_file():
        return None
    table = Table(path)
    return table if table.n_rows > 0 else None
