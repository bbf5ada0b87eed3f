# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparison ledger: rows of comparison.json (doc/reference/report.md) and their table."""
from ..data.files import DamagedFile, read_json
from ..data.shapes import COMPARISON
from ..data.table import write_persons

VERDICTS = ("agrees", "differs", "not judged")
HEADER = ["quantity", "value", "reference", "unit", "difference", "%", "tolerance", "verdict"]


def read_ledger(path):
    """Content of a comparison.json; DamagedFile names the row that contradicts itself."""
    content = read_json(path, COMPARISON)
    for row in content["rows"]:
        check_row(path, row)
    return content


def check_row(path, row):
    where = f'{path}, "{row.get("quantity", "?")}"'
    for name in ("quantity", "unit", "value", "reference", "reference kind", "difference",
                 "tolerance", "verdict", "reason"):
        if name not in row:
            raise DamagedFile(f'{where}: "{name}" is missing')
    if row["verdict"] not in VERDICTS:
        raise DamagedFile(f'{where}: verdict "{row["verdict"]}" is none of {", ".join(VERDICTS)}')
    value, reference = row["value"], row["reference"]
    if value is None or reference is None or row["difference"] is None:
        if row["verdict"] != "not judged":
            raise DamagedFile(f"{where}: a verdict without numbers")
        return
    scale = max(abs(value), abs(reference))
    if abs(row["difference"] - (value - reference)) > 1e-6 * scale:
        raise DamagedFile(f"{where}: the difference is not value minus reference")
    if row["verdict"] == "not judged":
        return
    if row["tolerance"] is None:
        raise DamagedFile(f"{where}: a verdict without tolerance")
    if (abs(row["difference"]) <= row["tolerance"]) != (row["verdict"] == "agrees"):
        raise DamagedFile(f"{where}: verdict and tolerance contradict each other")


def list_ledger_rows(rows):
    """Cells of the table with HEADER."""
    for row in rows:
        reference, difference = row["reference"], row["difference"]
        per_cent = 100 * difference / abs(reference) if reference and difference is not None else None
        yield [write_persons(row["quantity"]), row["value"], reference, row["unit"], difference, per_cent,
               row["tolerance"], row["verdict"]]


def list_reasons(rows):
    """What each row is compared with, and why its difference is expected or nothing is judged."""
    return [f"{row['reference kind']}{': ' * bool(row['reason'])}{row['reason']}" for row in rows]
