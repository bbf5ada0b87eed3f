# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot or picture of the report as a row of a table, and how rows are drawn into a folder."""
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from ..data.files import DamagedFile
from . import style
from .plot_data import write_plot_data


@dataclass(frozen=True)
class PlotRow:
    """Functions get what the table is of: a run's folder, a scene or a study."""
    name: str  # of the file, .svg for plots, .png for pictures; {} stands for one of `each`
    needs: tuple  # functions that must all be true
    draw: Callable  # matplotlib's figure; None where there is nothing to be seen after all
    caption: str  # {} as in the name
    chapter: str  # of the report that shows it
    data: str = ""  # files of the folder that are drawn, where not pictures/NAME.csv
    each: Callable = None  # names of which each has a plot of its own, the second argument of `draw`


@dataclass(frozen=True)
class DrawnPlot:
    """A plot that is there."""
    path: Path
    caption: str
    chapter: str
    data: str  # names of the files with its numbers; empty for pictures and maps


def draw_rows(rows, source, folder, names=()):
    """Draws what is possible (of the given names, if there are any) into the folder's pictures, the
    numbers of plots beside them as .csv: list of DrawnPlot."""
    drawn = []
    for row in rows:
        if not all(need(source) for need in row.needs):
            continue
        for one in row.each(source) if row.each else [None]:
            name = row.name.format(one)
            if names and name not in names:
                continue
            try:
                plot = row.draw(source) if one is None else row.draw(source, one)
            except (ArithmeticError, LookupError, TypeError) as error:
                raise DamagedFile(f"{folder}: {name} cannot be drawn: its numbers"
                                  f"{' in ' + row.data if row.data else ''} are inconsistent") from error
            if plot is not None:
                path = save_plot(plot, folder / "pictures" / name)
                data = path.with_suffix(".csv")
                drawn.append(DrawnPlot(path, row.caption.format(one), row.chapter, row.data or (
                    f"pictures/{data.name}" if data.is_file() else "")))
    return drawn


def save_plot(plot, path):
    """Its file, and beside that of a plot its numbers."""
    path.parent.mkdir(exist_ok=True)
    if path.suffix == ".svg":
        write_plot_data(plot, path.with_suffix(".csv"))
    style.save(plot, path)
    return path
