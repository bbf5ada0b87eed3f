#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns that the report reads are columns that the program writes: doc/columns.json, which a test of
the writers holds true (tests/output/columns)."""
import ast
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "source/report/vfife_report"
# Tables of a run by the names under which the package has them (data/run_folder.py).
FILES = {"history": "history.csv", "teeth": "teeth.csv", "probes": "probes.csv", "rim": "rim.csv",
         "pattern": "pattern.csv"}


def table_of(node):
    """history["time"], run.history["time"]: the name of the table."""
    return node.id if isinstance(node, ast.Name) else getattr(node, "attr", None)


def columns_read(path):
    """(table, column, line) wherever a table of a run is asked for a column by its name."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            table, column = table_of(node.value), node.slice.value
        elif (isinstance(node, ast.Compare) and isinstance(node.left, ast.Constant)
              and isinstance(node.ops[0], ast.In)):
            table, column = table_of(node.comparators[0]), node.left.value
        else:
            continue
        if table in FILES and isinstance(column, str):
            yield table, column, node.lineno


def main():
    written = {}
    for table in json.loads((ROOT / "doc/columns.json").read_text())["tables"]:
        written.setdefault(table["file"], set()).update(column["name"] for column in table["columns"])

    read, breaches = 0, []
    for path in sorted(PACKAGE.rglob("*.py")):
        for table, column, line in columns_read(path):
            read += 1
            if column not in written[FILES[table]]:
                breaches.append(f"{path.relative_to(ROOT)}:{line}: {FILES[table]} has no column \"{column}\"")

    named = PACKAGE / "data/columns.py"
    for node in ast.parse(named.read_text()).body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
            if node.value.value not in written["history.csv"]:
                breaches.append(f"{named.relative_to(ROOT)}:{node.lineno}: history.csv has no column "
                                f"\"{node.value.value}\"")

    if read < 40:
        breaches.append(f"only {read} uses of columns were found: does the package read them otherwise now?")
    print("\n".join(breaches) or f"{read} uses of columns: all are written")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
