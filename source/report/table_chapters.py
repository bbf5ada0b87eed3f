# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters that every folder can have: comparison ledger, tooth contact analysis, loaded tooth contact,
natural frequencies, lumped model."""
import json

import plot_campbell
import plot_loaded_contact
import plot_lumped
import plot_tca
from figure_data import write_figure_data
from ledger import HEADER, list_ledger_rows, read_ledger
from style import WIDE, plt, save


def add_picture(page, folder, name, figure, caption, data):
    """Draws into the folder's pictures; `data`: the study's own tables."""
    pictures = folder / "pictures"
    pictures.mkdir(exist_ok=True)
    write_figure_data(figure, pictures / f"{name}.csv")
    save(figure, pictures / f"{name}.svg")
    page.picture(pictures / f"{name}.svg", caption, data)


def add_ledger(page, run):
    path = run.path / "comparison.json"
    if not path.is_file():
        return
    title, rows = read_ledger(path)
    page.section("Comparison ledger")
    page.paragraph(title)
    differing = sum(row["verdict"] == "differs" for row in rows)
    page.paragraph(f"{len(rows)} comparisons, {differing} differ by more than their tolerance.",
                   "alarm" if differing else "")
    page.table(HEADER, list(list_ledger_rows(rows)),
               "Difference: value less reference, and over the reference's magnitude.")


def add_tooth_contact_analysis(page, run):
    if (run.path / "tca.csv").is_file():
        page.section("Unloaded tooth contact")
        with plt.rc_context(WIDE):
            figure = plot_tca.draw(run.path)
        add_picture(page, run.path, "tca", figure,
                    "Lag of neighbouring tooth pairs, path of contact with ellipses, ease-off.",
                    "tca.csv, path.csv, ease_off.csv")


def add_loaded_contact(page, run):
    if (run.path / "loaded_contact.csv").is_file():
        page.section("Loaded tooth contact by finite elements")
        add_picture(page, run.path, "loaded_contact", plot_loaded_contact.draw(run.path),
                    "Transmission error, load sharing, mesh stiffness and stresses over a tooth mesh.",
                    "loaded_contact.csv, loaded_teeth.csv")


def add_natural_frequencies(page, run):
    if (run.path / "campbell.csv").is_file():
        page.section("Natural frequencies")
        for body, figure in plot_campbell.draw_bodies(run.path):
            add_picture(page, run.path, f"campbell_{body}", figure,
                        f"Natural frequencies of the {body} over its speed, and resonances with the "
                        "tooth mesh.", "campbell.csv, resonances.csv")


def add_lumped_model(page, run):
    if not (run.path / "lumped.csv").is_file():
        return
    page.section("Lumped model")
    for name, caption, draw in plot_lumped.FIGURES:
        figure = draw(run.path)
        if figure is not None:
            add_picture(page, run.path, name, figure, caption, f"pictures/{name}.csv")
    results = json.loads((run.path / "lumped.json").read_text(encoding="utf-8"))
    for part, caption in (("model", "The model."), ("response", "Response at the speed of operation.")):
        page.table(["", "value", "unit"], [[name, figure["value"], figure["unit"]]
                                           for name, figure in results[part].items()], caption)
    page.table(["natural frequency [Hz]", "damping ratio [-]", "met by mesh order 1 at [rpm]",
                "by 2", "by 3"],
               [[mode["frequency [Hz]"], mode["damping ratio [-]"]]
                + mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"]
                for mode in results["modes"]], "Natural frequencies about the loaded state.")


STUDY_CHAPTERS = (add_tooth_contact_analysis, add_loaded_contact, add_natural_frequencies,
                  add_lumped_model)
CHAPTERS = (add_ledger,) + STUDY_CHAPTERS
