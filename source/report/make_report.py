#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Report of a folder of results: make_report.py DIR writes DIR/report.html, one file that needs nothing
else, with the pictures in DIR/pictures and their data beside them. DIR is the folder of one run or
study, or a folder of such folders, whose variants are compared. Needs numpy and matplotlib, no
display. Exit codes: 0; 1 if not all could be done; 77 if numpy or matplotlib is missing.
"""
import sys
from pathlib import Path

try:
    import numpy  # noqa: F401
    import matplotlib  # noqa: F401
except ImportError as error:
    print(error)
    sys.exit(77)

import run_chapters
import study_chapters
import table_chapters
from page import Page
from plot_run import draw_all, save_all
from run_folder import RunFolder
from variants import find_variants
from words import describe_pair, make_title


def write_page(page, folder):
    path = folder / "report.html"
    temporary = path.with_name(".report.html")
    temporary.write_text(page.text(), encoding="utf-8")
    temporary.replace(path)
    return path


def report_run(run):
    """One run, or one study of another kind."""
    page = Page(make_title(run), f"Report of {run.path.resolve().name}")
    figures = save_all(draw_all(run), run.path / "pictures")
    for add in run_chapters.CHAPTERS:
        add(page, run, figures)
    for add in table_chapters.CHAPTERS:
        add(page, run)
    return page


def report_study(folder, variants):
    pairs = {describe_pair(variant.run.parameters) for variant in variants}
    title = pairs.pop() if len(pairs) == 1 else ""
    page = Page(f"{title or folder.resolve().name}: {len(variants)} variant{'s' * (len(variants) > 1)}",
                f"Report of {folder.resolve().name}")
    figures = save_all(study_chapters.draw_all(folder, variants), folder / "pictures")
    whole = RunFolder(folder)
    table_chapters.add_ledger(page, whole)  # what was compared comes first
    for add in study_chapters.CHAPTERS:
        add(page, folder, variants, figures)
    for add in table_chapters.STUDY_CHAPTERS:
        add(page, whole)
    return page


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    try:
        run = RunFolder(arguments[0])
        variants = find_variants(run.path)
        page = report_study(run.path, variants) if variants else report_run(run)
        if not page.sections:
            sys.exit(f"report: {run.path} has neither results nor folders with results")
        path = write_page(page, run.path)
    except (OSError, ValueError, KeyError) as error:
        # What is no run's folder or was cut off; errors of these scripts show their trace.
        sys.exit(f"report: {error or type(error).__name__}")
    print(f"{page.n_pictures} pictures in {run.path / 'pictures'}, report {path}")


if __name__ == "__main__":
    main(sys.argv[1:])
