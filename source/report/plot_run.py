#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots and pictures of a run: plot_run.py DIR reads the files of the run's folder DIR and writes
into DIR/pictures. Needs numpy and matplotlib, no display. Exit codes: 0; 1 if not all could be drawn;
77 if numpy or matplotlib is missing.
"""
import sys
from pathlib import Path

try:
    import numpy  # noqa: F401
    import matplotlib  # noqa: F401
except ImportError as error:
    print(error)
    sys.exit(77)

import histories
import pictures
import sidebands
import spectra
import style
import tooth_contact
import waves
from fields import read_last_fields
from figure_data import write_figure_data
from run_folder import RunFolder


def draw_all(run):
    """Name of the file, what must be there, function that makes the figure."""
    history = run.history is not None and run.history.n_rows > 2
    pair = history and "dte" in run.history
    yield "dte.svg", pair, lambda: histories.draw_transmission_error(run)
    yield "contact_force.svg", history, lambda: histories.draw_contact_force(run)
    sharing = pair and run.teeth is not None and "mean pressure" in run.teeth
    yield "load_sharing.svg", sharing, lambda: tooth_contact.draw_load_sharing(run)
    yield "tooth_engagement.svg", sharing, lambda: tooth_contact.draw_tooth_engagement(run)
    yield "contact_pattern.svg", run.pattern is not None, lambda: tooth_contact.draw_contact_pattern(run)
    yield "energies.svg", history, lambda: histories.draw_energies(run)
    yield "probes.svg", run.probes is not None, lambda: histories.draw_probes(run)
    yield "spectra.svg", pair and run.samples_per_mesh(), lambda: spectra.draw_spectra(run)
    yield "sidebands.svg", pair and run.samples_per_mesh(), lambda: sidebands.draw_sidebands(run)
    rim = run.rim is not None and run.rim.n_rows > 10
    yield "rim_content.svg", rim, lambda: waves.draw_rim_content(run)
    yield "rim_history.svg", rim, lambda: waves.draw_rim_history(run)
    yield "rim_waves.svg", rim and run.samples_per_mesh(), lambda: waves.draw_rim_waves(run)
    yield from draw_fields(run)


def draw_fields(run):
    """The same for the pictures of the last fields."""
    fields = read_last_fields(run.fields) if run.fields.is_file() else None
    if fields is None:
        return
    scene = pictures.Scene(run, fields)
    in_mesh = scene.is_pair and scene.contact is not None
    yield "bodies.png", True, lambda: pictures.draw_bodies(scene)
    yield "teeth_in_mesh.png", in_mesh, lambda: pictures.draw_teeth_in_mesh(scene)
    yield "meridian_section.png", in_mesh, lambda: pictures.draw_meridian_section(scene)
    yield "deformation.png", in_mesh, lambda: pictures.draw_deformation(scene)


def save_all(figures, folder):
    """Draws what is possible into the folder, the numbers of plots beside them as .csv: names."""
    drawn = []
    for name, possible, draw in figures:
        figure = draw() if possible else None
        if figure is not None:
            folder.mkdir(exist_ok=True)
            if name.endswith(".svg"):
                write_figure_data(figure, (folder / name).with_suffix(".csv"))
            style.save(figure, folder / name)
            drawn.append(name)
    return drawn


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    drawn = []
    try:
        run = RunFolder(arguments[0])
        folder = run.path / "pictures"
        drawn = save_all(draw_all(run), folder)
    except (OSError, ValueError, KeyError) as error:
        # What is no run's folder or was cut off; errors of these scripts show their trace.
        sys.exit(f"pictures: {error or type(error).__name__}")
    if not drawn:
        sys.exit(f"pictures: {run.path} has neither histories nor fields")
    print(f"{len(drawn)} pictures in {folder}: {', '.join(drawn)}")


if __name__ == "__main__":
    main(sys.argv[1:])
