#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns and places of .json files that the report reads are such that the program writes:
doc/columns.json, which a test of the writers holds true (tests/output/columns)."""
import ast
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "source/report"))

PACKAGE = ROOT / "source/report/vfife_report"
# Tables of a run by the names under which the package has them (data/run_folder.py).
RUN_TABLES = {"history": "history.csv", "teeth": "teeth.csv", "probes": "probes.csv", "rim": "rim.csv",
              "pattern": "pattern.csv"}
# Tables of other studies by the names under which a file has them.
TABLES = {
    "data/beside.py": {"table": "coupled_modes.csv"},
    "data/error_bars.py": {"bars": "error_bars.csv", "pairs": "differences.csv", "runs": "sweep.csv"},
    "page/sweep_chapter.py": {"table": "resonance.csv"},
    "measures/kind_results.py": {"lines": "waves_lines.csv", "met": "waves_in_contact.csv", "orders": "orders.csv", "refined": "adaptive_refinement.csv",
                                 "meshes": "mesh.csv"},
    "measures/trust.py": {"lines": "waves_lines.csv", "refined": "adaptive_refinement.csv"},
    "measures/speed_peaks.py": {"response": "resonance.csv", "stress": "stress_response.csv", "ranges": "exceedances.csv"},
    "plots/speed_curves.py": {"stress": "stress_response.csv"},
    "plots/campbell.py": {"branches": "campbell.csv", "modes": "modes.csv", "resonances": "resonances.csv"},
    "plots/lumped.py": {"motion": "lumped.csv"},
    "plots/driven_waves.py": {"frequencies": "waves_frequencies.csv", "lines": "waves_lines.csv",
                              "waves": "waves_response.csv", "growth": "waves_build_up.csv"},
    "plots/speed_response.py": {"sweep": "resonance.csv", "waves": "wave_response.csv"},
    "plots/meridian.py": {"table": "meridian.csv"},
    "plots/resonance.py": {"table": "resonance.csv"},
}
# The same in single functions, where a name has another table in each.
TABLES_IN = {
    "plots/loaded_contact.py": {"plot_columns": "loaded_contact.csv", "plot_deviations": "loaded_contact.csv",
                                "plot_shares": "loaded_teeth.csv", "draw_loaded_contact": "loaded_contact.csv"},
}
# Names of columns that are handed on: of which table, in which file.
NAMED = {
    "data/columns.py": {None: "history.csv"},
    "plots/lumped.py": {"MOTIONS": "lumped.csv"},
    "plots/speed_response.py": {"RESPONSES": "resonance.csv"},
    "plots/loaded_contact.py": {"plot_columns": "loaded_contact.csv", "plot_deviations": "loaded_contact.csv",
                                "stresses": "loaded_contact.csv"},
    "plots/meridian.py": {"read_parts": "meridian.csv"},
}
# Values inside .json files by the names under which a file has them, where it does not say itself.
PLACES = {
    "data/run_folder.py": {"summary": "summary.json"},
    "measures/checks.py": {"statistics": "summary.json/steady part/columns/COLUMN"},
    "measures/kind_results.py": {"results": "lumped.json"},
    "measures/quantities.py": {"statistics": "summary.json/steady part/columns/COLUMN"},
    "measures/sidebands.py": {"body": "summary.json/mesh/bodies/0"},
    "page/folder_chapters.py": {"results": "lumped.json"},
    "page/study_chapters.py": {"statistics": "summary.json/steady part/columns/COLUMN"},
    "page/words.py": {"body": "summary.json/mesh/bodies/0"},
    "plots/lumped.py": {"modes": "lumped.json/modes", "mode": "lumped.json/modes/0"},
}


def name_of(node):
    """history, run.history: the last name."""
    return node.id if isinstance(node, ast.Name) else getattr(node, "attr", None)


def text_of(node):
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def columns_read(tree, tables):
    """(table, column, line) wherever a table is asked for a column by its name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript):
            table, column = name_of(node.value), text_of(node.slice)
        elif isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In):
            table, column = name_of(node.comparators[0]), text_of(node.left)
        else:
            continue
        if table in tables and column is not None:
            yield tables[table], column, node.lineno


def columns_named(tree, names):
    """(table, column, line) of texts that stand for columns: of constants of a module, in lists and
    loops of functions."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            name = node.targets[0].id
            if None in names and text_of(node.value) is not None:
                yield names[None], node.value.value, node.lineno
            elif name in names and name.isupper():
                for row in node.value.elts:
                    yield names[name], row.elts[0].value, row.lineno
            elif name in names:
                for one in ast.walk(node.value):
                    if isinstance(one, ast.Tuple):
                        yield from ((names[name], e.value, e.lineno) for e in one.elts)
        elif isinstance(node, ast.Call) and name_of(node.func) in names:
            for one in node.args:
                if isinstance(one, ast.List):
                    yield from ((names[name_of(node.func)], e.value, e.lineno) for e in one.elts)
        elif isinstance(node, ast.FunctionDef) and node.name in names:
            for one in ast.walk(node):
                if isinstance(one, ast.comprehension) and isinstance(one.iter, ast.Tuple):
                    yield from ((names[node.name], e.value, e.lineno) for e in one.iter.elts)


class Places(ast.NodeVisitor):
    """Places of .json files that a module reads, "summary.json/run/time": subscripts and get() of
    run.summary, of what is assigned from it, and of the given names."""

    def __init__(self, known):
        self.known, self.found = dict(known), []

    def visit_FunctionDef(self, node):
        before = dict(self.known)
        self.generic_visit(node)
        self.known = before

    def visit_Assign(self, node):
        self.generic_visit(node)
        targets, values = node.targets[:1], [node.value]
        if isinstance(targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple):
            targets, values = targets[0].elts, node.value.elts
        for target, value in zip(targets, values):
            self.bind(target, self.place(value))

    def visit_comprehension(self, node):
        self.bind(node.target, self.place(node.iter), "/0")

    def visit_For(self, node):
        self.bind(node.target, self.place(node.iter), "/0")
        self.generic_visit(node)

    def visit_ListComp(self, node):
        for one in node.generators:
            self.visit(one)
        self.generic_visit(node)

    visit_GeneratorExp = visit_SetComp = visit_ListComp

    def bind(self, target, place, below=""):
        if isinstance(target, ast.Name) and place is not None:
            self.known[target.id] = place + below

    def place(self, node):
        """Of an expression; None where it is of no .json file."""
        if isinstance(node, (ast.Name, ast.Attribute)):
            name = name_of(node)
            if name == "summary" or name not in self.known:
                return "summary.json" if name == "summary" else None
            return self.known[name] if isinstance(node, ast.Name) else None
        if isinstance(node, ast.Subscript):
            below = node.slice
        elif isinstance(node, ast.Call) and name_of(node.func) == "get" and node.args:
            node, below = node.func, node.args[0]
        else:
            return None
        above = self.place(node.value)
        if above is None or isinstance(below, ast.Slice):
            return None
        if isinstance(below, ast.Constant):
            return f"{above}/{0 if isinstance(below.value, int) else below.value}"
        return f"{above}/*"

    def visit_Subscript(self, node):
        self.note(node)
        self.generic_visit(node)

    def visit_Call(self, node):
        self.note(node)
        if name_of(node.func) == "figure" and node.args and text_of(node.args[0]):
            self.found.append((f"summary.json/figures/{node.args[0].value}", node.lineno))
        self.generic_visit(node)

    def visit_Compare(self, node):
        above = self.place(node.comparators[0])
        if isinstance(node.ops[0], ast.In) and above is not None and text_of(node.left):
            self.found.append((f"{above}/{node.left.value}", node.lineno))
        self.generic_visit(node)

    def note(self, node):
        place = self.place(node)
        if place is not None:
            self.found.append((place, node.lineno))


def is_listed(place, listed):
    """Whether something stands at the place or below it; a figure has a value and a unit, a text
    letters."""
    words = place.split("/")
    if words[-1] in ("value", "unit", "0") and is_listed("/".join(words[:-1]), listed):
        return True
    return any(len(one) >= len(words) and all(a in (b, "*") for a, b in zip(words, one)) for one in listed)


def main():
    lists = json.loads((ROOT / "doc/columns.json").read_text())
    written = {}
    for table in lists["tables"]:
        written.setdefault(table["file"], set()).update(column["name"] for column in table["columns"])
    listed = [(name + one["place"]).split("/")
              for name in ("summary.json", "lumped.json") for one in lists[name]]

    read, breaches = {}, []
    for path in sorted(PACKAGE.rglob("*.py")):
        name, tree = path.relative_to(PACKAGE).as_posix(), ast.parse(path.read_text())
        uses = list(columns_read(tree, {**RUN_TABLES, **TABLES.get(name, {})}))
        uses += columns_named(tree, NAMED.get(name, {}))
        for function in ast.walk(tree):
            if isinstance(function, ast.FunctionDef) and function.name in TABLES_IN.get(name, {}):
                uses += columns_read(function, {"table": TABLES_IN[name][function.name]})
        for table, column, line in uses:
            read[table] = read.get(table, 0) + 1
            if column not in written[table]:
                breaches.append(f"{path.relative_to(ROOT)}:{line}: {table} has no column \"{column}\"")
        places = Places(PLACES.get(name, {}))
        places.visit(tree)
        for place, line in places.found:
            file = place.split("/")[0]
            read[file] = read.get(file, 0) + 1
            if not is_listed(place, listed):
                breaches.append(f"{path.relative_to(ROOT)}:{line}: nothing is written at {place}")

    # Uses that are not found are not checked either.
    least = {"history.csv": 10, "teeth.csv": 10, "probes.csv": 3, "rim.csv": 1, "pattern.csv": 1,
             "coupled_modes.csv": 5, "resonance.csv": 10, "lumped.csv": 4, "campbell.csv": 8,
             "resonances.csv": 5, "meridian.csv": 4, "loaded_contact.csv": 6, "loaded_teeth.csv": 4,
             "waves_lines.csv": 8, "waves_frequencies.csv": 5, "waves_response.csv": 3, "waves_build_up.csv": 2,
             "summary.json": 30, "lumped.json": 5}
    for name, count in least.items():
        if read.get(name, 0) < count:
            breaches.append(f"only {read.get(name, 0)} uses of {name} were found: does the package read it "
                            "otherwise now?")
    print("\n".join(breaches) or f"{sum(read.values())} uses of columns and places: all are written")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main())
