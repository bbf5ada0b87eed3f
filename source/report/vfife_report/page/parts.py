# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What chapters are made of: paragraphs, tables, pictures; templates/page.html shows them."""
import base64
from dataclasses import dataclass
from pathlib import Path

# A cell that is a verdict: class of the style sheet, text.
MARKS = {"agrees": ("good", "✓ agrees"), "differs": ("bad", "✗ differs"),
         "met": ("good", "✓ met"), "not met": ("bad", "✗ not met"),
         "not judged": ("open", "– not judged"), "no criterion": ("open", "– no criterion")}
MEDIA = {".svg": "image/svg+xml", ".png": "image/png"}
LONG_TEXT = 40  # letters from which a cell is kept wide
DIGITS = 3  # significant ones of a figure
EXACT = 5  # of numbers that are compared with each other or taken from here: geometry, frequencies, variants


def format_number(value, digits=EXACT):
    """Digits as one reads them: no exponent between 1e-4 and 1e7; a dash for what is no number."""
    if value is None or value != value:
        return "–"
    if isinstance(value, int):
        text = f"{value:,}".replace(",", "\u202f")
    else:
        text = f"{value:.{digits}g}"
        if "e" in text and 1e-4 <= abs(value) < 1e7:
            text = f"{value:.0f}"
    return text.replace("-", "\u2212", 1) if text.startswith("-") else text


@dataclass
class Paragraph:
    text: str
    kind: str = ""  # alarm, soft
    template = "paragraph"

    def is_empty(self):
        return not self.text


@dataclass
class Cells:
    """A table; cells are numbers, None or texts, and a text that is a verdict is marked."""
    header: list
    rows: list
    caption: str = ""
    notes: list = None  # a text below each row, as wide as the table may be seen
    digits: int = DIGITS
    short: frozenset = frozenset()  # columns with DIGITS, whatever the others have
    template = "cells"

    def __post_init__(self):
        self.rows = list(self.rows)  # looked at more than once

    def is_empty(self):
        return not self.rows

    def columns(self):
        """Header and whether all below it are numbers."""
        return [(text, all(isinstance(row[k], (int, float, type(None))) for row in self.rows))
                for k, text in enumerate(self.header)]

    def show(self, value, column=None):
        """Class and text of a cell in the column of that number."""
        if not isinstance(value, str):
            is_short = column is not None and self.header[column] in self.short
            return "number", format_number(value, DIGITS if is_short else self.digits)
        return MARKS.get(value, ("long" if len(value) > LONG_TEXT else "", value))


@dataclass
class Picture:
    """A .svg or .png within the page, on a narrow screen larger when touched; `data`: names of the
    files with its numbers."""
    path: Path
    caption: str
    data: str = ""
    template = "picture"

    def is_empty(self):
        return False

    def address(self):
        code = base64.b64encode(self.path.read_bytes()).decode()
        return f"data:{MEDIA[self.path.suffix]};base64,{code}"


def list_values(values, words=None):
    """Rows of the summary's numbers with units, with the words for their names."""
    return [[(words or {}).get(name, name), one["value"], one["unit"]] for name, one in values.items()]
