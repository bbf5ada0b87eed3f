#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the tests find mistakes? Makes one wrong edit of a source after the other and runs tests, of which one must fail.

python3 contrib/mutants [options] FILE...

Edits exchange operators and bounds, drop signs, negations and early exits, and change constants; comments, texts,
#include and the defaults of headers stay. A mutant is killed (a test failed), timed out (as good), not built, or it
survives. Works in a copy of the tree. Exit code 0: none survives; 1: some do; 2: the mutants cannot be tried.
"""
import argparse
import random
import signal
import sys
import time
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from rules import make_mutants  # noqa: E402
from workshop import ROOT, Workshop, WorkshopError  # noqa: E402


def read_arguments():
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="sources (.cc, .h, .py)")
    parser.add_argument("--seed", type=int, default=1, help="another seed selects other mutants")
    parser.add_argument("--count", type=int, default=20, help="number of mutants, 0: all")
    parser.add_argument("--tests", metavar="REGEX", help="names of tests (default: the folder of tests/ named as the source's)")
    parser.add_argument("--defaults", action="store_true", help="change defaults in headers too")
    parser.add_argument("--list", action="store_true", help="print the mutants, build nothing")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="compilations and tests at a time")
    parser.add_argument("--limit", type=int, default=300, help="time of a test [s]")
    parser.add_argument("--folder", type=Path, default=ROOT / "build/mutants", help="the copy of the tree")
    return parser.parse_args()


def tests_of(file):
    """source/study/reduced/x.cc: the tests in tests/study/reduced, or else those in tests/study."""
    folder = Path(*Path(file).parent.parts[1:])
    if Path(file).parts[0] == "include":
        folder = folder.relative_to("vfife")
    while folder.parts and not (ROOT / "tests" / folder / "CMakeLists.txt").is_file():
        folder = folder.parent
    if not folder.parts:
        raise WorkshopError(f"{file} has no folder of tests: use --tests")
    return f"^{folder.as_posix()}/"


def choose(asked):
    mutants = []
    for path in asked.files:
        file = path.resolve().relative_to(ROOT).as_posix()
        mutants += make_mutants(file, path.read_text(encoding="utf-8"), asked.defaults)
    if 0 < asked.count < len(mutants):
        chosen = random.Random(asked.seed).sample(range(len(mutants)), asked.count)
        mutants = [mutants[number] for number in sorted(chosen)]
    return mutants


def run(asked, mutants):
    workshop = Workshop(asked.folder.resolve(), asked.jobs, asked.limit)
    workshop.tree.mkdir(parents=True, exist_ok=True)
    workshop.prepare()
    tests = {mutant.file: asked.tests or tests_of(mutant.file) for mutant in mutants}
    for pattern in dict.fromkeys(tests.values()):
        verdict, failed = workshop.verdict(pattern)
        if verdict != "survived":
            raise WorkshopError(f'without a mutant the tests "{pattern}": {verdict} {failed}'.rstrip())
    verdicts = []
    for mutant in mutants:
        content, begin = (ROOT / mutant.file).read_text(encoding="utf-8"), time.monotonic()
        workshop.put(mutant.file, mutant.apply(content))
        try:
            verdict, failed = workshop.verdict(tests[mutant.file])
        finally:
            workshop.put(mutant.file, content)
        verdicts.append(verdict)
        print(f"{mutant}: {verdict}{' by ' + failed if failed else ''} ({time.monotonic() - begin:.0f} s)", flush=True)
    print("\n" + ", ".join(f"{number} {verdict}" for verdict, number in Counter(verdicts).most_common()))
    survivors = [mutant for mutant, verdict in zip(mutants, verdicts) if verdict == "survived"]
    for mutant in survivors:
        print(f"survived: {mutant}")
    return 1 if survivors else 0


def main():
    asked = read_arguments()
    # An end by kill puts the text back as well.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))
    try:
        mutants = choose(asked)
        if asked.list:
            print("\n".join(map(str, mutants)))
            return 0
        return run(asked, mutants)
    except (OSError, ValueError, WorkshopError) as error:
        print(f"mutants: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
