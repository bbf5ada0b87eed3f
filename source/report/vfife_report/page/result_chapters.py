# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The first chapter of the report of one run, its main results, and the chapter about their accuracy."""
from ..measures.checks import list_checks
from ..measures.main_results import list_main_results, list_trust
from .chapter import Chapter
from .parts import Cells, Paragraph
from .words import list_sentences

RESULT_DIGITS = 4  # of few numbers that are read first


def tell_results(run, plots):
    failure = run.summary.get("failure")
    if failure:
        yield Paragraph(f"The run failed: {failure}", "alarm")
    for sentence in list_sentences(run):
        yield Paragraph(sentence)
    rows = list_main_results(run)
    if any(row[-1] for row in rows):
        yield Cells(["result", "value", "unit", "accuracy"], rows, digits=RESULT_DIGITS)
    else:
        yield Cells(["result", "value", "unit"], [row[:-1] for row in rows], digits=RESULT_DIGITS)
    unmet = [name for name, _, _, verdict in list_checks(run) if verdict == "not met"]
    if unmet:
        yield Paragraph(f"Checks that are not met: {'; '.join(unmet)}.", "alarm")
    yield from plots


def tell_trust(run, plots):
    yield Cells(["result", "steady in time", "converged with the mesh", "page"], list(list_trust(run)))


RESULTS = Chapter("Results", tell_results)
TRUST = Chapter("How far to trust", tell_trust)
