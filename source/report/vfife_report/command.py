# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports, plots and pictures of folders of results.

make_report.py DIR                  writes DIR/report.html, one self-contained file, and DIR/pictures
                                    with the pictures and their data
make_report.py plots DIR [NAME...]  draws only the pictures, all or the named ones
make_report.py meridian [--body NAME] PICTURE DIR[=TITLE]...
                                    draws meridian sections from studies of kind `mesh`, one panel per study

DIR is the folder of one run or study, or a folder of such folders, whose variants are compared. The
script needs numpy, matplotlib, Jinja2 and meshio, and h5py for fields in HDF5. It needs no display.
Exit codes: 0 success, 1 failure, 77 missing library.
"""
import argparse
import logging
import os
import sys
import warnings
from pathlib import Path

try:
    import numpy  # noqa: F401
    import matplotlib  # noqa: F401
    import jinja2  # noqa: F401
    import meshio  # noqa: F401
except ImportError as error:
    print(error)
    sys.exit(77)

from .data.files import DamagedFile
from .data.study import open_folder
from .page.report import make_report, write_page
from .plot_table import draw_folder
from .plots import style
from .plots.meridian import draw_meridians, read_parts


def write_report(asked):
    source = open_folder(asked.folder)
    page = make_report(source)
    if not page.sections:
        sys.exit(f"report: {source.path} has neither results nor folders with results")
    path = write_page(page, source.path)
    print(f"{page.n_pictures} picture{'s' * (page.n_pictures != 1)} in {source.path / 'pictures'}, report {path}")


def draw_plots(asked):
    source = open_folder(asked.folder)
    drawn = draw_folder(source, asked.names)
    if not drawn:
        sys.exit(f"plots: {source.path} has neither histories nor fields nor tables for "
                 f"{' '.join(asked.names) or 'any plot'}")
    print(f"{len(drawn)} picture{'s' * (len(drawn) != 1)} in {source.path / 'pictures'}: "
          f"{', '.join(plot.path.name for plot in drawn)}")


def draw_meridian_sections(asked):
    bodies = []
    for text in asked.folders:
        folder, _, title = text.partition("=")
        bodies.append((title or Path(folder).name, read_parts(Path(folder), asked.body)))
    style.save(draw_meridians(bodies), asked.picture)


def read_arguments(arguments):
    """What is asked for. A single argument is a folder, whatever its name."""
    parser = argparse.ArgumentParser(prog="make_report.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    report = commands.add_parser("report", help="the report of a folder")
    report.add_argument("folder")
    report.set_defaults(do=write_report)
    plots = commands.add_parser("plots", help="plots and pictures alone")
    plots.add_argument("folder")
    plots.add_argument("names", nargs="*", help="such as dte.svg")
    plots.set_defaults(do=draw_plots)
    meridian = commands.add_parser("meridian", help="meridian sections of gear bodies")
    meridian.add_argument("--body", default="gear")
    meridian.add_argument("picture", type=Path)
    meridian.add_argument("folders", nargs="+", metavar="DIR[=TITLE]")
    meridian.set_defaults(do=draw_meridian_sections)
    if len(arguments) == 1 and not arguments[0].startswith("-"):
        arguments = ["report"] + arguments
    return parser.parse_args(arguments)


def describe(asked, error):
    """What is no run's folder or is damaged, in one line."""
    if isinstance(error, (OSError, DamagedFile)):
        return str(error)
    missing = f" (there is no {error})" if isinstance(error, KeyError) else ""
    return (f"{getattr(asked, 'folder', 'a folder')}: the files are inconsistent or incomplete{missing}. Set "
            "VFIFE_REPORT_TRACE=1 to see the place.")


def main(arguments):
    if not arguments:
        sys.exit(__doc__)
    asked = read_arguments(arguments)
    # Numbers that are none are shown as such; what libraries think of them is no message of this program.
    warnings.simplefilter("ignore")
    logging.disable(logging.WARNING)
    try:
        asked.do(asked)
    except ImportError as error:
        print(error)
        sys.exit(77)
    except Exception as error:  # of whatever kind: what is damaged shows in many ways
        if "VFIFE_REPORT_TRACE" in os.environ:
            raise
        sys.exit(f"{asked.command}: {describe(asked, error)}")
