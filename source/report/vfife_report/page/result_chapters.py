# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The first chapter of the report, the main results, and the chapter about their accuracy: for one run, and for a folder of runs."""
from ..data.labels import HISTORIES, label
from ..data.naming import describe_pair
from ..measures.accuracy import FREQUENCY_ERROR, FREQUENCY_EXCESS, MESH_PAGE, NO_ESTIMATE, VARIANTS_PAGE, find_degree
from ..measures.checks import list_checks
from ..measures.ledger import HEADER, read_ledger
from ..measures.main_results import list_main_results
from ..measures.study_results import (RANGES_HEADER, VALUES_HEADER, count_verdicts, list_farthest, list_ranges, list_single_values)
from ..measures.trust import TRUST_HEADER, list_study_trust, list_trust
from .chapter import Chapter
from .parts import EXACT, Cells, Paragraph
from .words import list_sentences

RESULT_DIGITS = 4  # of few numbers that are read first


def tell_results(run, plots):
    failure = run.summary.get("failure")
    if failure:
        yield Paragraph(f"The study failed: {failure}", "alarm")
    for sentence in list_sentences(run):
        yield Paragraph(sentence)
    rows = list_main_results(run)
    yield Cells(["result", "value", "unit", "accuracy"], rows, digits=RESULT_DIGITS)
    if any(NO_ESTIMATE in row[-1] for row in rows):
        page = MESH_PAGE if describe_pair(run.parameters) else VARIANTS_PAGE
        yield Paragraph(f"{page} explains how to compare two meshes.", "soft")
    yield from tell_farthest(run)
    unmet = [name for name, _, _, verdict in list_checks(run) if verdict == "not met"]
    yield from tell_resonance(run)
    yield from tell_ripple(run)
    if unmet:
        yield Paragraph(f"These checks are not met: {'; '.join(unmet)}.", "alarm")
    yield from plots


NEAR = (" The operating speed is near it: compute Study/kind = waves. A resonance grows over many mesh cycles, so a short record may not "
        "show it.")


def tell_resonance(run):
    """The wave resonance nearest to the operating speed; an alarm where the speed is within the error of frequencies."""
    nearest, speed = run.summary.get("nearest wave"), run.value("speed of the nearest wave")
    distance = run.value("distance of the speed of operation from the nearest wave")
    if nearest:
        degree = find_degree(run)
        excess = FREQUENCY_EXCESS[degree]
        at_resonance = distance is not None and abs(distance) < max(excess)
        words = f"Nearest computed resonance of the loaded pair at mesh orders 1 to 3: {nearest}."
        if speed:
            highest, lowest = (speed / (1 + one / 100) for one in excess)
            words += (f" Computed frequencies are {FREQUENCY_ERROR[degree]}, so expect the true resonance between {lowest:.0f} and "
                      f"{highest:.0f} rpm.")
        yield Paragraph(words + NEAR * at_resonance, "alarm" if at_resonance else "")


def tell_ripple(run):
    """Both halves of the steady part of a run, and the length that a steady ripple needs."""
    ripple = run.summary.get("steady part", {}).get("ripple", {})
    rows = [[label(HISTORIES, name), one["peak to peak of the first half"]["value"], one["peak to peak of the second half"]["value"],
             one["peak to peak of the first half"]["unit"], 100 * one["largest change"]["value"]]
            for name, one in ripple.get("columns", {}).items()]
    if not rows:
        return
    needed = run.value("mesh cycles that a steady ripple needs")
    words = "The ripple (curve minus mean) is steady." if run.is_ripple_steady() else "The ripple (curve minus mean) is still transient."
    yield Cells(["peak to peak", "first half", "second half", "unit", "largest change, also of single harmonics [%]"], rows,
                words + (f" A steady ripple needs at least {needed:.0f} mesh cycles." if needed else "")
                + " Below a change of 10 % the ripple is steady.")


def tell_farthest(folder):
    """How many comparisons of a folder agree, and those farthest from it."""
    path = folder.path / "comparison.json"
    rows = read_ledger(path)["rows"] if path.is_file() else []
    if not rows:
        return
    agreeing, differing, open_ones = count_verdicts(rows)
    yield Paragraph(f"The comparison has {len(rows)} row{'s' * (len(rows) > 1)}: {agreeing} within the tolerance, {differing} beyond it, "
                    f"{open_ones} not judged.", "alarm" if differing else "")
    yield Cells(HEADER, list_farthest(rows), "Rows with the largest difference over tolerance. The tolerance is the accuracy that the "
                "comparison requires.", digits=EXACT, short={"difference", "%", "tolerance"})


def tell_study_results(study, plots):
    yield from tell_farthest(study.folder)
    if study.error_bars:
        yield Cells(VALUES_HEADER, list_single_values(study.error_bars), digits=RESULT_DIGITS)
    if not study.folder.has_file("comparison.json"):
        yield Cells(RANGES_HEADER, list_ranges(study), digits=RESULT_DIGITS)
    if not study.error_bars and not study.folder.has_file("comparison.json") and len(study.variants) > 1:
        yield Paragraph("Differences between variants have no error estimate. To get one, name numerical parameters "
                        f"({VARIANTS_PAGE}).", "soft")
    failed = [variant.name for variant in study.variants if variant.run.summary.get("status", "finished") != "finished"]
    if failed:
        yield Paragraph(f"These variants are not finished: {'; '.join(failed)}.", "alarm")
    yield from plots


def tell_trust(run, plots):
    yield Cells(TRUST_HEADER, list_trust(run))


def tell_study_trust(study, plots):
    yield Cells(TRUST_HEADER, list_study_trust(study))


RESULTS = Chapter("Results", tell_results)
TRUST = Chapter("Accuracy and validity", tell_trust)
STUDY_RESULTS = Chapter("Results", tell_study_results)
STUDY_TRUST = Chapter("Accuracy and validity", tell_study_trust)
