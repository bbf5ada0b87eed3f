# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters that every folder can have: comparison ledger, tooth contact analysis, loaded tooth contact,
natural frequencies, lumped model."""
from ..data.files import read_json
from ..data.shapes import LUMPED
from ..measures.ledger import HEADER, list_ledger_rows, read_ledger
from ..plots.bearings import list_bearings
from .chapter import Chapter
from .parts import Cells, Paragraph, list_values


def tell_ledger(run, plots):
    path = run.path / "comparison.json"
    if not path.is_file():
        return
    title, rows = read_ledger(path)
    yield Paragraph(title)
    differing = sum(row["verdict"] == "differs" for row in rows)
    yield Paragraph(f"{len(rows)} comparisons, {differing} differ by more than their tolerance.",
                    "alarm" if differing else "")
    yield Cells(HEADER, list(list_ledger_rows(rows)),
                "Difference: value less reference, and over the reference's magnitude.")


def tell_lumped_model(run, plots):
    yield from plots
    if not run.has_file("lumped.csv"):
        return
    results = read_json(run.path / "lumped.json", LUMPED)
    for part, caption in (("model", "The model."), ("response", "Response at the speed of operation.")):
        yield Cells(["", "value", "unit"], [[name, one["value"], one["unit"]]
                                            for name, one in results[part].items()], caption)
    yield Cells(["natural frequency [Hz]", "damping ratio [-]", "met by mesh order 1 at [rpm]",
                 "by 2", "by 3"],
                [[mode["frequency [Hz]"], mode["damping ratio [-]"]]
                 + mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"]
                 for mode in results["modes"]], "Natural frequencies about the loaded state.")


def tell_bearings(run, plots):
    yield from plots
    yield Cells(["misalignment at the start", "value", "unit"], list_values(run.summary.get("misalignment", {})))
    if run.bearings is None:
        return
    shown = ("radial force", "force z", "radial displacement")
    yield Cells(["bearing, means"] + [run.bearings.label(name) for name in shown],
                [[bearing] + [float(run.bearings[name][run.bearings["bearing"] == bearing].mean()) for name in shown]
                 for bearing in list_bearings(run.bearings)])


LEDGER = Chapter("Comparison ledger", tell_ledger)
TABLE_CHAPTERS = (
    Chapter("Unloaded tooth contact"),
    Chapter("Loaded tooth contact by finite elements"),
    Chapter("Bearings", tell_bearings),
    Chapter("Natural frequencies"),
    Chapter("Response over speed"),
    Chapter("Lumped model", tell_lumped_model))
