# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""One self-contained HTML page: one column, tables and pictures within, nothing from a network."""
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from .parts import Picture

TEMPLATES = Environment(loader=FileSystemLoader(Path(__file__).parent / "templates"), autoescape=True,
                        undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)


class Page:
    """Sections are appended in reading order; text() is the whole page."""

    def __init__(self, title, subtitle):
        self.title, self.subtitle = title, subtitle
        self.sections = []  # title and parts

    def section(self, title, parts):
        """Nothing where all parts are empty."""
        parts = [part for part in parts if not part.is_empty()]
        if parts:
            self.sections.append((title, parts))

    @property
    def n_pictures(self):
        return sum(isinstance(part, Picture) for _, parts in self.sections for part in parts)

    def text(self):
        return TEMPLATES.get_template("page.html").render(page=self)
