# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report in their order, and how they are filled."""
from dataclasses import dataclass
from typing import Callable

from .parts import Picture


def show_plots(source, plots):
    """A chapter of plots alone."""
    return plots


@dataclass(frozen=True)
class Chapter:
    """Its parts are what `tell` lists, given what the report is of (a run's folder, a study) and the
    pictures of this chapter that could be drawn. Without any part there is no chapter."""
    name: str  # by which rows of plots name it
    tell: Callable = show_plots
    title: Callable = None  # of what the report is of, where it is not the name


def add_chapters(page, chapters, source, drawn):
    """Appends them to the page; `drawn`: all plots (DrawnPlot)."""
    for chapter in chapters:
        plots = [Picture(plot.path, plot.caption, plot.data) for plot in drawn
                 if plot.chapter == chapter.name]
        parts = list(chapter.tell(source, plots))
        if parts:
            page.section(chapter.title(source) if chapter.title else chapter.name, parts)
