# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A folder of runs: a sweep, a comparison."""
from functools import cached_property

from .beside import read_beside
from .columns import TRANSMISSION_ERROR
from .error_bars import read_error_bars
from .run_folder import RunFolder
from .swept import find_axis, find_speeds
from .variants import find_variants


class Study:
    """All runs below a folder, and what is varied from one to the next."""

    def __init__(self, path):
        self.folder = RunFolder(path)  # results of its own: what was compared, other studies' tables
        self.path = self.folder.path
        # Runs that differ by numerical parameters alone are no variants.
        self.error_bars = read_error_bars(self.path)
        self.variants = find_variants(self.path, self.error_bars.runs if self.error_bars else None)

    @cached_property
    def axis(self):
        return find_axis(self.variants)

    @cached_property
    def speeds(self):
        return find_speeds(self.axis)

    @cached_property
    def beside(self):
        return read_beside(self.path)

    @cached_property
    def pairs(self):
        """Variants that are runs of a gear pair with a mesh cycle."""
        return [v for v in self.variants
                if v.run.history is not None and TRANSMISSION_ERROR in v.run.history
                and v.run.samples_per_mesh()]

    @cached_property
    def responses(self):
        """Variants that are sweeps over speed."""
        return [v for v in self.variants if v.run.has_file("resonance.csv") and v.run.has_file("wave_response.csv")]

    def patterns(self):
        """Variants with contact patterns of the same bodies as the first of them."""
        found = [v for v in self.variants if v.run.pattern is not None]
        return [v for v in found if set(v.run.pattern["body"]) == set(found[0].run.pattern["body"])]

    def pairs_with(self, table, column=None):
        """Those of them with a table of the run's folder ("teeth") and a column in it."""
        tables = [(v, getattr(v.run, table)) for v in self.pairs]
        return [v for v, found in tables if found is not None and (column is None or column in found)]


def open_folder(path):
    """The study of a folder of runs, else the folder itself as a run's. FileNotFoundError where there
    is no folder."""
    study = Study(path)
    return study if study.variants else study.folder
