#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Do the tests find mistakes? One wrong edit of the source after the other, and the tests that have to fail by it.

python3 contrib/mutants [options] [which ...]

Which: folders of source/ (dynamics), parts of paths (watch/energy_book) or numbers (12, 20-35); all without. Edits and
tests stand in contrib/mutants/table. A mutant is killed (a test failed or ran out of time), survives, is stale (its
text is not there any more, or not only once) or is not built (it does not compile). What survives by an argument of
the table is equivalent and does not count. Works in a copy of the tree; nothing is written outside of it. Exit code 0:
all are killed or equivalent; 1: some are not; 2: the lane cannot work.
"""
import argparse
import signal
import sys
import time
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from table import ROOT, TableError, read_tables  # noqa: E402
from workshop import Workshop, WorkshopError  # noqa: E402

FATES = ("killed", "survived", "equivalent", "stale", "not built", "not run")


def read_arguments():
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", nargs="*", help="folders, parts of paths, numbers")
    parser.add_argument("--list", action="store_true", help="the mutants and whether their edits apply, without runs")
    parser.add_argument("--show", action="store_true", help="as --list, with the edits")
    parser.add_argument("--resume", action="store_true", help="only those whose fate is not known from earlier calls")
    parser.add_argument("--known", action="store_true", help="the table of what earlier calls have found, without runs")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="compilations at a time")
    parser.add_argument("--limit", type=int, default=300, help="time of a test [s], when the copy is configured")
    parser.add_argument("--folder", type=Path, default=ROOT / "build/mutants", help="the copy of the tree")
    asked = parser.parse_args()
    asked.folder = asked.folder.resolve()
    return asked


def is_meant(mutant, which):
    first, _, last = which.partition("-")
    if first.isdigit() and (last.isdigit() or not last):
        return int(first) <= mutant.number <= int(last or first)
    return which in mutant.path if "/" in which else which == mutant.folder


def choose(mutants, which):
    for one in which:
        if not any(is_meant(mutant, one) for mutant in mutants):
            raise TableError(f'no mutant is meant by "{one}"')
    return [mutant for mutant in mutants if not which or any(is_meant(mutant, one) for one in which)]


def say(mutant, what):
    print(f"{mutant.number:4} {mutant.file}: {mutant.title}: {what}", flush=True)


def list_mutants(mutants, with_edits):
    stale = 0
    for mutant in mutants:
        state = mutant.state()
        stale += bool(state)
        say(mutant, (state or "applies") + "; " + " ".join(mutant.tests) +
            (f"; equivalent: {mutant.argument}" if mutant.argument else ""))
        if with_edits:
            print("".join(f"       {mark} {line.strip()}\n" for mark, text in (("-", mutant.old), ("+", mutant.new))
                          for line in text.splitlines()))
    print(f"{len(mutants)} mutants, {stale} stale")
    return 1 if stale else 0


def check_tests(workshop, mutants):
    missing = sorted({name for mutant in mutants for name in mutant.tests if not workshop.find_tests(name)})
    if missing:
        raise TableError(f"there is no test {', '.join(missing)}")


def is_sound(workshop, test, results):
    """Whether a test passes on the tree as it is: only then its failure tells a mutant. Once for a state of the tree."""
    known = results["tests"].setdefault(workshop.digest, {})
    if test not in known:
        known[test] = workshop.make([test]) and workshop.passes(test)
        # Other states of the tree are forgotten.
        results["tests"] = {workshop.digest: known}
        workshop.write_results(results)
        if not known[test]:
            print(f"{test} fails without any mutant and tells nothing", flush=True)
    return known[test]


def try_mutant(workshop, mutant, results):
    """Fate and what to say of it. Tests are run as they are named, and the first that fails is enough."""
    known = results["tests"].get(workshop.digest, {})
    tests = [test for name in mutant.tests for test in workshop.find_tests(name) if known.get(test, True)]
    failed, built = None, 0
    workshop.put(mutant)
    try:
        # What a test needs is built when it is its turn: most mutants end with the first.
        for test in tests:
            if workshop.make([test]):
                built += 1
                if not workshop.passes(test):
                    failed = test
                    break
    finally:
        workshop.put_back(mutant)
    if not built:
        return ("not built", "") if tests else ("not run", "none of its tests passes without it")
    if failed and is_sound(workshop, failed, results):
        return "killed", f"by {failed}"
    if failed:
        return "not run", f"{failed} fails without it"
    return ("equivalent", mutant.argument) if mutant.argument else ("survived", " ".join(mutant.tests))


def print_score(mutants, fates):
    """By folder, and the part of those that count which are killed."""
    width = max(map(len, FATES)) + 2
    print("\n" + "folder".ljust(12) + "mutants".rjust(width) + "".join(fate.rjust(width) for fate in FATES))
    total = Counter()
    for folder in dict.fromkeys(mutant.folder for mutant in mutants):
        counts = Counter(fates[mutant.number] for mutant in mutants if mutant.folder == folder)
        total += counts
        print(folder.ljust(12) + str(sum(counts.values())).rjust(width) +
              "".join(str(counts[fate]).rjust(width) for fate in FATES))
    print("all".ljust(12) + str(sum(total.values())).rjust(width) +
          "".join(str(total[fate]).rjust(width) for fate in FATES))
    count = sum(total.values()) - total["equivalent"]
    print(f"\nscore: {total['killed']} of {count} killed" + (f", {100 * total['killed'] / count:.0f} %" if count else ""))
    for mutant in mutants:
        if fates[mutant.number] in ("survived", "stale", "not built", "not run"):
            say(mutant, fates[mutant.number])
    return 0 if total["killed"] == count else 1


def run(asked, mutants):
    workshop = Workshop(asked.folder, asked.jobs, asked.limit)
    results = workshop.read_results()
    fates = {mutant.number: "stale" if mutant.state() else "not run" for mutant in mutants}
    if asked.resume or asked.known:
        fates.update({mutant.number: results["mutants"][mutant.key()] for mutant in mutants
                      if fates[mutant.number] == "not run" and mutant.key() in results["mutants"]})
    if not asked.known:
        workshop.prepare()
        wanted = [mutant for mutant in mutants if fates[mutant.number] == "not run"]
        check_tests(workshop, wanted)
        for mutant in wanted:
            begin = time.monotonic()
            fate, what = try_mutant(workshop, mutant, results)
            fates[mutant.number] = fate
            if fate != "not run":
                results["mutants"][mutant.key()] = fate
            workshop.write_results(results)
            say(mutant, f"{fate} {what}".rstrip() + f" ({time.monotonic() - begin:.0f} s)")
    return print_score(mutants, fates)


def main():
    asked = read_arguments()
    # An end by kill puts the text back as well.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))
    try:
        mutants = choose(read_tables(), asked.which)
        return list_mutants(mutants, asked.show) if asked.list or asked.show else run(asked, mutants)
    except (TableError, WorkshopError) as error:
        print(f"mutants: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
