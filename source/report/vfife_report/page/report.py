# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a folder: which chapters, in which order."""
from ..data.naming import describe_pair
from ..data.study import Study
from ..plot_table import draw_folder
from .chapter import add_chapters
from .folder_chapters import LEDGER, TABLE_CHAPTERS
from .glossary import add_words
from .page import Page
from .result_chapters import RESULTS, STUDY_RESULTS
from .run_chapters import CASE_CHAPTERS, PICTURE_CHAPTERS
from .study_chapters import CLOSING_CHAPTERS, STUDY_CHAPTERS
from .words import make_title


def make_report(source):
    """The page of a run or another folder, or of a study; its plots are drawn into the folder."""
    name = source.path.resolve().name
    drawn = draw_folder(source)
    page = Page(title_study(source) if isinstance(source, Study) else make_title(source),
                f"Report of {name}")
    if isinstance(source, Study):
        add_chapters(page, (STUDY_RESULTS,), source, drawn)
        add_chapters(page, (LEDGER,), source.folder, drawn)
        add_chapters(page, STUDY_CHAPTERS, source, drawn)
        add_chapters(page, TABLE_CHAPTERS, source.folder, drawn)
        add_chapters(page, CLOSING_CHAPTERS, source, drawn)
    else:
        add_chapters(page, (RESULTS,) + PICTURE_CHAPTERS + (LEDGER,) + TABLE_CHAPTERS + CASE_CHAPTERS, source, drawn)
    add_words(page)
    return page


def title_study(study):
    pairs = {describe_pair(variant.run.parameters) for variant in study.variants}
    title = pairs.pop() if len(pairs) == 1 else ""
    count = len(study.variants)
    return f"{title or study.path.resolve().name}: {count} variant{'s' * (count > 1)}"


def write_page(page, folder):
    """Beside its place first, so that nobody meets half a page: path of report.html."""
    path = folder / "report.html"
    temporary = path.with_name(".report.html")
    temporary.write_text(page.text(), encoding="utf-8")
    temporary.replace(path)
    return path
