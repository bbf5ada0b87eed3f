# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a study's results."""
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from vfife_report.data.files import find_fields, read_json
from vfife_report.data.former_names import Named
from vfife_report.data.parameters import read_parameters
from vfife_report.data.table import Table

# What they say is of the case, not of its results.
NO_FIGURES = ("parameters.json", "geometry.json")
# Whose quantities have names of their own; all others are named with the groups they stand in.
PLAIN_GROUPS = ("figures",)
STATISTICS = ("mean", "peak to peak", "standard deviation")


class Quantity(NamedTuple):
    """A number (None: the program had none) with its unit, "-" without one."""
    value: float
    unit: str

    def __str__(self):
        number = "none" if self.value is None else f"{self.value:g}"
        return number if self.unit == "-" else f"{number} {self.unit}"


class Result:
    """What a study has written, read when it is asked for. Files that are damaged: DamagedFile."""

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise FileNotFoundError(f"{self.path} is no folder of results")

    def json(self, name):
        """The content of NAME.json."""
        return read_json(self._find(f"{name}.json"), {})

    def table(self, name):
        """NAME.csv: columns as numpy arrays, table["dte"], with table.units["dte"]."""
        return Table(self._find(f"{name}.csv"))

    def frame(self, name):
        """NAME.csv as a frame of pandas, with units in its attrs."""
        import pandas  # noqa: PLC0415 - for those who have it
        table = self.table(name)
        frame = pandas.DataFrame(table.columns)
        frame.attrs["units"] = dict(table.units)
        return frame

    def fields(self):
        """Fields of the last instant: points (cells, 8, 3) in mm and fields["von mises"] at the cells' corners. Needs
        meshio, for fields.h5 also h5py."""
        from vfife_report.data.fields import read_last_fields  # noqa: PLC0415
        return read_last_fields(self._find(find_fields(self.path).name))

    @property
    def tables(self):
        """Names of all tables."""
        return sorted(path.stem for path in self.path.glob("*.csv"))

    @property
    def history(self):
        return self.table("history")

    @cached_property
    def parameters(self):
        """The parameters in force as texts by "Section/Sub/name"."""
        return read_parameters(self.path)

    @cached_property
    def summary(self):
        """All figures of the study with values and units: those of figures.json and of the group "figures" of
        summary.json by their names, "dte mean" and its like of the steady part, others by their place, "energy/error".
        Figures with another name in the previous version are found by that name, too.
        """
        figures = Named(None)
        for path in sorted(self.path.glob("*.json")):
            if path.name not in NO_FIGURES:
                collect_figures(read_json(path, {}), "", figures)
        return figures

    @property
    def status(self):
        """"finished", "failed" or what else summary.json says; empty for kinds without one."""
        return self.json("summary").get("status", "") if (self.path / "summary.json").is_file() else ""

    def _find(self, name):
        path = self.path / name
        if not path.is_file():
            there = ", ".join(sorted(one.name for one in self.path.glob(f"*{path.suffix}"))) or "none"
            raise FileNotFoundError(f"{self.path} has no {name}; of these files there are: {there}")
        return path

    def __repr__(self):
        return f"Result({str(self.path)!r})"


def collect_figures(group, place, figures):
    """Adds the quantities of a group of a .json file and of the groups in it."""
    for name, member in group.items():
        if not isinstance(member, dict):
            continue
        if set(member) == {"value", "unit"}:
            figures[place + name] = Quantity(member["value"], member["unit"])
        elif set(STATISTICS) <= set(member) and "unit" in member:
            for statistic in STATISTICS:
                figures[f"{name} {statistic}"] = Quantity(member[statistic], member["unit"])
        else:
            collect_figures(member, place if name in PLAIN_GROUPS else f"{place}{name}/", figures)
