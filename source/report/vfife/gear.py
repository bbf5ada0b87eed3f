# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Flanks and contact of gear pairs computed inside Python, without files: for loops that call them often.

    from vfife import gear
    pair = gear.Pair("prm/gear/proposed_17_43.prm").set("Gear pair/Proposal/module", "4.5 mm")
    points = pair.flank_points("gear")["convex"].points        # (15, 9, 3) mm
    tca = pair.unloaded()
    print(tca.summary["drive side, peak to peak"])              # 8.1 arcsec
    error = tca.table("transmission")["transmission error"]     # numpy array

Needs the compiled module _vfife, which is built where pybind11 is. doc/reference/python.md explains it.
"""
import json
import os
from dataclasses import dataclass

import numpy as np

from .case import Case, write_value
from .extension import load_extension
from .result import collect_figures

MEMBERS = ("pinion", "gear")


@dataclass(frozen=True)
class Flank:
    """Points of a flank of tooth 0 in the body frame of its member (doc/theory/gear.md): from toe to heel and from the start
    of the flank to the tip. `L`, `h`: their places in the meridian plane [mm]; `points` [mm] and unit `normals` out of
    the metal, with a last axis x, y, z."""
    L: np.ndarray
    h: np.ndarray
    points: np.ndarray
    normals: np.ndarray


class KeptTable:
    """A table as Result.table() has it, that was never in a file: columns by name, `units`."""

    def __init__(self, columns, units):
        self.columns = {name: np.asarray(values) for name, values in columns.items()}
        self.units = units

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]


class Analysis:
    """What a study has found. Tables and figures have the names of the program's files (doc/reference/files.md)."""

    def __init__(self, tables, texts, log):
        self.log = log
        self._tables = {name.removesuffix(".csv"): KeptTable(*table) for name, table in tables.items()}
        self._json = {name.removesuffix(".json"): text for name, text in texts.items() if name.endswith(".json")}
        self.texts = {name: text for name, text in texts.items() if not name.endswith(".json")}

    @property
    def tables(self):
        """Names of all tables."""
        return sorted(self._tables)

    def table(self, name):
        """Columns as numpy arrays, table["transmission error"], with table.units."""
        return self._tables[name]

    def json(self, name):
        """The content that NAME.json would have."""
        return json.loads(self._json[name])

    @property
    def summary(self):
        """The figures of the study by name, with value and unit, as Result.summary has them."""
        figures = {}
        for name in self._json:
            if name != "geometry":
                collect_figures(self.json(name), "", figures)
        return figures


class Pair:
    """A gear pair of a parameter file or of a text, with entries set besides. A pair does not change: set() returns
    another one. Messages are the program's: InputError, ComputationFailed."""

    def __init__(self, source, settings=None, text=None):
        """`source`: path of a parameter file, or a Case; from_text() is for texts."""
        case = source if isinstance(source, Case) else Case(source)
        self.path = os.fspath(case.file)
        self.settings = {**case.settings, **(settings or {})}
        self._text = text

    @classmethod
    def from_text(cls, text, name="text"):
        """Of a parameter file's text. Messages call it `name`; files that it names are looked for in the folder of
        `name`, which need not be there itself."""
        return cls(name, text=text)

    def set(self, entry, value):
        """As Case.set()."""
        return Pair(self.path, {**self.settings, entry: write_value(value)}, self._text)

    def flank_points(self, member, lengthwise=15, profile=9):
        """Both flanks of a "pinion" or "gear" by side, "concave" and "convex": Flank with lengthwise x profile points.
        Errors of manufacture are not in them."""
        if member not in MEMBERS:
            raise ValueError(f'a member is one of {", ".join(MEMBERS)}, not "{member}"')
        source = self._source("tooth contact analysis")
        columns, _ = load_extension().flank_points(source, member == "pinion", lengthwise, profile)
        return {side: cut_flank(columns, np.array(columns["side"]) == side, (lengthwise, profile))
                for side in ("concave", "convex")}

    def unloaded(self):
        """Tooth contact analysis without load: tables transmission, path, tca, ease_off, figures in `summary`."""
        return self._analyse("tooth contact analysis")

    def loaded(self):
        """Loaded tooth contact analysis: tables loaded_contact (transmission error, stiffness), loaded_teeth, pattern,
        root_stress ... The pair needs bodies, meshes and a torque."""
        return self._analyse("loaded tooth contact analysis")

    def _source(self, kind):
        # pictures are drawn of files
        settings = {**self.settings, "Study/kind": kind, "Output/report": "no"}
        return load_extension().Source(self.path, self._text, [f"{entry}={value}" for entry, value in settings.items()])

    def _analyse(self, kind):
        return Analysis(*load_extension().analyse(self._source(kind)))

    def __repr__(self):
        settings = "".join(f".set({entry!r}, {value!r})" for entry, value in self.settings.items())
        made = f"Pair({self.path!r})" if self._text is None else f"Pair.from_text(..., name={self.path!r})"
        return made + settings


def cut_flank(columns, rows, shape):
    """The rows of one side of a table of flank points."""
    def stack(*names):
        return np.stack([columns[name][rows].reshape(shape) for name in names], axis=-1)

    return Flank(columns["L"][rows].reshape(shape), columns["h"][rows].reshape(shape),
                 stack("x", "y", "z"), stack("normal x", "normal y", "normal z"))
