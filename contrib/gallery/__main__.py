#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery, doc/gallery.md: pictures and numbers of real runs.

contrib/gallery make [NAME...]     runs the cases of all entries, or of those named, one at a time on one core; draws their
                                   pictures into doc/pictures/gallery and writes numbers to doc/gallery.json and the page
contrib/gallery page               writes the page again from doc/gallery.json
contrib/gallery check [NAME...]    whether page and pictures are those of doc/gallery.json; runs the cases of the entries
                                   named again, whose numbers must be the same as far as the page states them

Each is called as python3 contrib/gallery ...; results go to results/gallery.
"""
import argparse
import json
import resource
import shutil
import sys
import warnings
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "source" / "report"))
sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401
    from matplotlib.image import thumbnail
    import meshio  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

import vfife  # noqa: E402
from entries import ENTRIES  # noqa: E402
from vfife_report.data.study import open_folder  # noqa: E402
from vfife_report.plot_table import TABLE_PLOTS, draw_folder  # noqa: E402
from vfife_report.plots import style  # noqa: E402

PAGE, STORE, PICTURES = ROOT / "doc/gallery.md", ROOT / "doc/gallery.json", ROOT / "doc/pictures/gallery"
LARGEST = 150_000  # bytes of a picture
HEAD = """# Gallery

Each example is one command. Times are processor time on one core, with report and pictures.
"""


def run_case(entry, output):
    """Result and core seconds."""
    def used():
        spent = resource.getrusage(resource.RUSAGE_CHILDREN)
        return spent.ru_utime + spent.ru_stime
    before = used()
    result = vfife.Case(ROOT / "prm" / entry.case).run(output=output)
    return result, used() - before


def find_numbers(entry, result):
    found = [(what, source(result) if callable(source) else result.summary[source], digits)
             for what, source, digits in entry.numbers]
    return [{"quantity": what, "value": round_number(number.value, digits), "unit": number.unit} for what, number, digits in found]


def round_number(value, digits):
    """Significant digits, without an exponent as far as one reads it better so."""
    return f"{float(f'{value:.{digits}g}'):,.12g}"


def draw_picture(entry, result):
    """The report's picture; a plot of very many curves as pixels, pixels made fewer until the file is small enough."""
    source, name = open_folder(result.path), entry.picture
    draw_folder(source, [name])
    drawn = result.path / "pictures" / name
    if drawn.suffix == ".svg" and drawn.stat().st_size > LARGEST:
        (row,) = [row for row in TABLE_PLOTS if row.name == name]
        drawn = drawn.with_suffix(".png")
        style.save(row.draw(source), drawn)
    PICTURES.mkdir(parents=True, exist_ok=True)
    picture = PICTURES / f"{entry.name}{drawn.suffix}"
    for other in PICTURES.glob(f"{entry.name}.*"):
        other.unlink()
    shutil.copyfile(drawn, picture)
    scale = 1.0
    warnings.simplefilter("ignore")  # what matplotlib thinks of the layout of a picture without axes
    while picture.suffix == ".png" and picture.stat().st_size > LARGEST:
        scale *= 0.9
        thumbnail(drawn, picture, scale)
    return picture.name


def choose(names):
    unknown = set(names) - {entry.name for entry in ENTRIES}
    if unknown:
        sys.exit(f"gallery: no entry {', '.join(sorted(unknown))}; there are {', '.join(entry.name for entry in ENTRIES)}")
    return [entry for entry in ENTRIES if entry.name in names]


def make(names):
    stored = read_store() if STORE.is_file() else {}
    for entry in choose(names or [entry.name for entry in ENTRIES]):
        result, seconds = run_case(entry, ROOT / "results/gallery" / entry.name)
        stored[entry.name] = {"case": f"prm/{entry.case}", "picture": draw_picture(entry, result),
                              "core seconds": round(seconds, 1), "numbers": find_numbers(entry, result)}
        print(entry.name, *(f"{one['quantity']} {one['value']} {one['unit']};" for one in stored[entry.name]["numbers"]))
        ordered = {entry.name: stored[entry.name] for entry in ENTRIES if entry.name in stored}
        STORE.write_text(json.dumps(ordered, indent=2) + "\n", encoding="utf-8")
    if len(stored) == len(ENTRIES):
        page()


def read_store():
    return json.loads(STORE.read_text(encoding="utf-8"))


def describe_time(seconds):
    return f"{seconds:.2g} s" if seconds < 60 else f"{seconds / 60:.0f} min"


def write_page(stored):
    """The page as text."""
    parts = [HEAD]
    for entry in ENTRIES:
        one = stored[entry.name]
        numbers = "; ".join(f"{number['quantity']} {number['value']}" + ("" if number["unit"] == "-" else f" {number['unit']}")
                            for number in one["numbers"])
        parts.append(f"## {entry.title}\n\n![{entry.title}](pictures/gallery/{one['picture']})\n\n```\n./run {one['case']}\n```\n\n"
                     f"{describe_time(one['core seconds'])}. {numbers[0].upper()}{numbers[1:]}.\n\n{entry.learned}\n")
    return "\n".join(parts)


def page(_=()):
    PAGE.write_text(write_page(read_store()), encoding="utf-8")


def check(names):
    """Exit code 1 and a line each for what is not so."""
    stored, wrong = read_store(), []
    if set(stored) != {entry.name for entry in ENTRIES}:
        wrong.append("doc/gallery.json has other entries than contrib/gallery/entries.py")
    elif PAGE.read_text(encoding="utf-8") != write_page(stored):
        wrong.append("doc/gallery.md is not what doc/gallery.json says: contrib/gallery page writes it again")
    pictures = {path.name: path.stat().st_size for path in PICTURES.iterdir()}
    if set(pictures) != {one["picture"] for one in stored.values()}:
        wrong.append(f"doc/pictures/gallery has {sorted(pictures)}")
    wrong += [f"{name} has {size} bytes, at most {LARGEST} are allowed" for name, size in pictures.items() if size > LARGEST]
    for entry in choose(names):
        result, _ = run_case(entry, Path("gallery") / entry.name)
        numbers = find_numbers(entry, result)
        if numbers != stored[entry.name]["numbers"]:
            wrong.append(f"{entry.name}: {numbers}, but doc/gallery.json has {stored[entry.name]['numbers']}")
    print("\n".join(wrong) or "gallery: ok")
    sys.exit(1 if wrong else 0)


def main():
    parser = argparse.ArgumentParser(prog="contrib/gallery", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("make", "page", "check"))
    parser.add_argument("names", nargs="*", metavar="NAME")
    asked = parser.parse_args()
    {"make": make, "page": page, "check": check}[asked.what](asked.names)


if __name__ == "__main__":
    main()
