# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Main results of a folder of runs: ranges over the variants with errors, and the comparisons farthest from agreement."""
import re

import numpy as np

from ..data.table import read_table
from .ledger import VERDICTS, list_ledger_rows
from .main_results import MOST_RESULTS, list_main_results

RANGES_HEADER = ["result", "smallest", "variant", "largest", "variant", "unit", "accuracy"]
VALUES_HEADER = ["result", "value", "error", "unit", "accuracy"]
NO_ERROR_BARS = "no error estimate: name numerical parameters"


def list_ranges(study):
    """Rows with RANGES_HEADER."""
    bars = study.error_bars.quantities if study.error_bars else []
    found = [bars_range(one) for one in bars if len(one.variants) > 1 and not one.is_constant()]
    return (found or list(list_asked_ranges(study)) or list(list_plain_ranges(study)))[:MOST_RESULTS]


def make_range(name, unit, names, values, accuracy):
    low, high = int(np.nanargmin(values)), int(np.nanargmax(values))
    return [name, float(values[low]), names[low], float(values[high]), names[high], unit, accuracy]


def bars_range(one):
    """With the largest error bar, and how many differences are significant."""
    known = one.errors[np.isfinite(one.errors)]
    words = list(one.verdicts.values())
    accuracy = f"error at most {known.max():.2g}" if len(known) else "error unknown"
    if len(known) < len(one.errors) and len(known):
        accuracy += f" ({len(one.errors) - len(known)} unknown)"
    if words:
        accuracy += (f"; {words.count('significant')} of {len(words)} differences significant, {words.count('sign significant')} only by "
                     "their sign")
    return make_range(one.name, one.unit, one.variants, one.values, accuracy)


def list_asked_ranges(study):
    """Numbers of the histories that the sweep names; with a reference, the error of the last run."""
    table = read_table(study.path / "sweep.csv")
    if table is None or "run" not in table:
        return
    names = {variant.run.path.name: variant.name for variant in study.variants}
    rows = [k for k in range(table.n_rows) if str(table["run"][k]) in names]
    asked = [name.strip() for name in study.folder.parameters.get("Sweep/figures", "").split(",")]
    for name in asked:
        if name not in table or not rows or not np.any(np.isfinite(table[name][rows])):
            continue
        error = table[f"{name} error"][rows[-1]] if f"{name} error" in table else np.nan
        yield make_range(name, table.units[name], [names[str(table["run"][k])] for k in rows], table[name][rows],
                         f"last run: {100 * error:+.2g} % from the reference" if np.isfinite(error) else NO_ERROR_BARS)


def list_plain_ranges(study):
    """Main results of the variants, which have no errors of differences."""
    found = {}
    for variant in study.variants:
        for name, value, unit, accuracy in list_main_results(variant.run):
            # The speed of a largest value may differ.
            found.setdefault((re.sub(r", at \S+ rpm$", "", name), unit), []).append((variant.name, value, accuracy))
    for (name, unit), rows in found.items():
        if len(rows) > 1:
            reasons = {accuracy for _, _, accuracy in rows}
            yield make_range(name, unit, [row[0] for row in rows], np.array([row[1] for row in rows], dtype=float),
                             reasons.pop() if len(reasons) == 1 else "differs: see the report of each variant")


def list_single_values(bars):
    """Rows with VALUES_HEADER of a case without variants."""
    single = [one for one in bars.quantities if len(one.variants) == 1]
    return [[one.name, float(one.values[0]), float(one.errors[0]), one.unit, one.methods[0]] for one in single[:MOST_RESULTS]]


def count_verdicts(rows):
    """How many rows of a comparison agree, differ and are not judged."""
    return [sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS]


def list_farthest(rows):
    """Rows of a comparison as in its table: those judged whose difference is largest beside its tolerance, then others."""
    def distance(row):
        judged = row["verdict"] != "not judged" and row["tolerance"]
        return -abs(row["difference"]) / row["tolerance"] if judged else 0
    return list(list_ledger_rows(sorted(rows, key=distance)[:MOST_RESULTS]))
