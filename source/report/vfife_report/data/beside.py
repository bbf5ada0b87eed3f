# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of other studies that stand beside the runs of a sweep."""
from dataclasses import dataclass

import numpy as np

from .parameters import read_parameters
from .table import Table

LEAST_SHARE = 0.02  # of a mode in the static rotation of the gear, as in comparisons (doc/reference/sweep-and-compare.md)


@dataclass
class Modes:
    """Natural frequencies [Hz] of the pair in contact that turn the gear, at one speed."""
    speed: str
    frequencies: np.ndarray
    shares: np.ndarray  # of the static rotation


@dataclass
class Response:
    """Response of another model over speed."""
    model: str
    table: Table  # resonance.csv


@dataclass
class Beside:
    modes: list  # of Modes
    responses: list  # of Response


def read_beside(folder):
    """Coupled modes and sweeps over speed of the folders below `beside`."""
    folders = sorted((folder / "beside").iterdir()) if (folder / "beside").is_dir() else []
    return Beside([read_modes(path) for path in folders if (path / "coupled_modes.csv").is_file()],
                  [read_response(path) for path in folders if (path / "resonance.csv").is_file()])


def read_response(folder):
    kind = read_parameters(folder).get("Study/kind", "")
    return Response("reduced pair" if kind == "reduced" else "lumped model", Table(folder / "resonance.csv"))


def read_modes(folder):
    """Those that stand in space where there are any: the load does."""
    table = Table(folder / "coupled_modes.csv")
    rows = table["share of the static rotation"] > LEAST_SHARE
    if np.any(table["axes"] == "fixed"):
        rows &= table["axes"] == "fixed"
    return Modes(read_parameters(folder).get("Operation/speed", ""), table["frequency"][rows],
                 table["share of the static rotation"][rows])
