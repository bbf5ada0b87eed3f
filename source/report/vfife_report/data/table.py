# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of .csv files whose header names columns as `name [unit]`."""
import csv
import io

import numpy as np

from .files import DamagedFile, read_text
from .former_names import Named, present_name
from .shapes import LARGEST


def write_persons(name):
    """Names of persons and standards with their capital letters, which names of columns and figures have not."""
    return name.replace("von mises", "von Mises").replace("hertz ", "Hertz ").replace("iso 10300 b1", "ISO 10300 B1")


class Table:
    """Columns of a .csv file by name: numbers where the header states a unit, else texts, or numbers where all are;
    `units` holds what stands in the header's brackets. Present names replace former ones of columns and of words in cells.
    DamagedFile with line and column where it cannot be read."""

    def __init__(self, path):
        self.path = path
        rows = list(read_rows(path))
        if not rows or not rows[0][1]:
            raise DamagedFile(f"{path} is empty")
        headers, width = rows[0][1], len(rows[0][1])
        # The last line of a run that was killed may be cut off.
        if len(rows) > 1 and len(rows[-1][1]) != width:
            rows.pop()
        self.lines = [line for line, _ in rows[1:]]
        for line, row in rows[1:]:
            if len(row) != width:
                raise DamagedFile(f"{path}:{line}: {len(row)} cells, but the header has {width}")
        self.columns, self.units = Named(path.name), Named(path.name)
        for position, header in enumerate(headers):
            name, bracket, unit = header.partition(" [")
            name = present_name(path.name, name)
            if name in self.columns:
                raise DamagedFile(f'{path}:1: there is a second column "{name}"')
            cells = [row[position] for _, row in rows[1:]]
            if bracket:
                self.columns[name] = self.read_numbers(name, cells)
            else:
                present = {cell: present_name(path.name, cell) for cell in set(cells)}
                self.columns[name] = guess_kind([present[cell] for cell in cells])
            self.units[name] = unit.rstrip("]")
        self.n_rows = len(rows) - 1

    def read_numbers(self, name, cells):
        """Also nan, where the program had no number."""
        numbers = np.empty(len(cells))
        for row, cell in enumerate(cells):
            try:
                numbers[row] = float(cell)
            except ValueError:
                raise DamagedFile(f'{self.path}:{self.lines[row]}: expected a number in column "{name}", got "{cell[:40]}"') from None
            if abs(numbers[row]) > LARGEST:
                raise DamagedFile(f'{self.path}:{self.lines[row]}: {cell[:40]} in column "{name}" is too large')
        return numbers

    def check_times(self):
        """The times of samples never go back."""
        time = self["time"]
        wrong = np.flatnonzero(~(np.diff(time, prepend=time[0]) >= 0))
        if len(wrong):
            raise DamagedFile(f"{self.path}:{self.lines[wrong[0]]}: the time goes back or is no number")

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        if name not in self.columns:
            raise DamagedFile(f'{self.path}:1: there is no column "{name}"')
        return self.columns[name]

    def label(self, name):
        """Name and unit for readers."""
        unit, name = self.units[name], write_persons(name)
        return name if unit in ("", "-") else f"{name} [{unit}]"


def guess_kind(cells):
    try:
        return np.array(cells, dtype=float)
    except ValueError:
        return np.array(cells, dtype=str)


def read_rows(path):
    """Number of the line and cells of each row that is not empty."""
    reader = csv.reader(io.StringIO(read_text(path), newline=""), strict=True)
    try:
        for row in reader:
            if row:
                yield reader.line_num, row
    except csv.Error as error:
        raise DamagedFile(f"{path}:{reader.line_num}: this is no row of cells ({error})") from error


def read_table(path):
    """None where there is no file or it has no rows."""
    if not path.is_file():
        return None
    table = Table(path)
    return table if table.n_rows > 0 else None
