# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Numerical errors of a sweep's quantities, and which variants they tell apart (doc/reference/sweep-and-compare.md)."""
from dataclasses import dataclass

import numpy as np

from .table import read_table

ERROR_BY = "error by "  # begins the columns of the single numerical parameters


@dataclass
class QuantityErrors:
    """One quantity of all variants."""
    name: str
    unit: str
    variants: list
    values: np.ndarray
    errors: np.ndarray
    parts: dict  # numerical parameter -> errors by it alone
    methods: list
    verdicts: dict  # (variant, other variant) -> "significant", "sign significant", "not significant", "not known"

    def list_others(self, variant, verdict):
        """Variants that have this verdict with one."""
        return [b if a == variant else a for (a, b), word in self.verdicts.items()
                if word == verdict and variant in (a, b)]

    def is_constant(self):
        """Whether all values are the same."""
        known = self.values[np.isfinite(self.values)]
        return len(known) == 0 or np.ptp(known) == 0


@dataclass
class ErrorBars:
    quantities: list  # of QuantityErrors
    runs: list  # folders of the variants' own runs
    unfinished: list  # (folder, status) of runs that are missing in them


def read_error_bars(folder):
    """None where a folder is no sweep with numerical parameters."""
    bars = read_table(folder / "error_bars.csv")
    if bars is None:
        return None
    pairs = read_table(folder / "differences.csv")
    quantities = []
    for name in dict.fromkeys(bars["quantity"]):
        rows = bars["quantity"] == name
        verdicts = {}
        if pairs is not None:
            own = pairs["quantity"] == name
            verdicts = {(str(a), str(b)): str(word) for a, b, word in zip(
                pairs["variant"][own], pairs["other variant"][own], pairs["verdict"][own])}
        quantities.append(QuantityErrors(
            str(name), str(bars["unit"][rows][0]), [str(one) for one in bars["variant"][rows]],
            bars["value"][rows], bars["error"][rows],
            {column[len(ERROR_BY):]: bars[column][rows] for column in bars.columns if column.startswith(ERROR_BY)},
            [str(one) for one in bars["method"][rows]], verdicts))
    runs = read_table(folder / "sweep.csv")
    unfinished = [] if runs is None else [(str(run), str(status)) for run, status in zip(runs["run"], runs["status"])
                                          if status != "finished"]
    return ErrorBars(quantities, [folder / str(run) for run in dict.fromkeys(bars["run"])], unfinished)
