# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""vfife from Python: cases are run by the program, their results read from its files.

    import vfife
    case = vfife.Case("prm/spiral_bevel_quick.prm").set("Operation/speed", "8593 rpm")
    result = case.run(output="results/slow", ranks=2)
    print(result.summary["dte mean"])               # -78.4 arcsec
    time, dte = result.history["time"], result.history["dte"]

Needs numpy; frames need pandas, fields meshio. doc/reference/python.md explains it.
"""
from vfife_report.data.files import DamagedFile
from vfife_report.data.table import Table

from .case import Case, Check
from .errors import ComputationFailed, InputError, ProgramNotFound, Stopped, VfifeError
from .program import find_program
from .result import Quantity, Result

__all__ = ["Case", "Check", "ComputationFailed", "DamagedFile", "InputError", "ProgramNotFound", "Quantity", "Result",
           "Stopped", "Table", "VfifeError", "find_program"]
