# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The chapter of words: what the glossary says of those that the report uses."""
import re
from pathlib import Path

from .parts import Cells, Picture

REPORT = Path(__file__).resolve().parents[2]
# Beside the report where it is installed, else in the tree of the sources.
PLACES = (REPORT / "glossary.md", REPORT.parents[1] / "doc/reference/glossary.md")
OWN_WORDS = "Words of vfife's own"


def read_glossary():
    """Names (of one meaning) and meaning, without links, of the words that are not the field's; nothing where it is not installed."""
    path = next((path for path in PLACES if path.is_file()), None)
    if path is None:
        return []
    section = path.read_text(encoding="utf-8").partition(f"## {OWN_WORDS}\n")[2].partition("\n## ")[0]
    entries = re.findall(r"^\*\*(.+?)\*\* - (.+?)(?:\n\n|\Z)", section, re.M | re.S)
    return [(names, make_plain(meaning)) for names, meaning in entries]


def make_plain(text):
    """Without links to pages at the end and marks of Markdown, in one line."""
    text = re.sub(r" \(\[[^()]*\]\([^)]*\)(, \[[^()]*\]\([^)]*\))*\)$", "", " ".join(text.split()))
    return re.sub(r"[`*]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text))


def list_texts(page):
    """All texts of a page's chapters."""
    for title, parts in page.sections:
        yield title
        for part in parts:
            if isinstance(part, Cells):
                yield from (text for row in [part.header, *part.rows, part.notes or []] for text in row if isinstance(text, str))
            yield part.caption if isinstance(part, (Cells, Picture)) else part.text


def add_words(page):
    """A chapter of the words that the page uses, behind all others."""
    text = "\n".join(list_texts(page))
    used = [[names, meaning] for names, meaning in read_glossary()
            if any(re.search(rf"\b{re.escape(name)}\b", text, re.I) for name in names.split(", "))]
    page.section("Words", [Cells(["word", "meaning"], used, "The glossary, doc/reference/glossary.md, also defines terms of the field.")])
