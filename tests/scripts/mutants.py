# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits that contrib/mutants makes of a made-up source, a header and a Python source, without a build."""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "contrib/mutants"))

from rules import make_mutants  # noqa: E402

SOURCE = '''#include <a-b> // - 1
/* x + 1 */
int f(const double *x, const std::array<int, 3> &n, bool &&quiet)
{
  if (!quiet && n[0] <= 1.5e-3)
    return -1;
  Assert(n[0] > 0, ExcMessage("none"));
  if (n[1] != 4)
    throw std::runtime_error("n + 1 is " + std::to_string(n[1] + 1));
  x->y += std::max(*x, 2.) * "a - b"[0];
  return std::min<double>(1e3, *x);
}
'''
SOURCE_EDITS = [(5, "!", ""), (5, "&&", "||"), (5, "0", "1"), (5, "<=", "<"), (5, "1.5e-3", "(1.01 * 1.5e-3)"),
                (5, "1.5e-3", "(2. * 1.5e-3)"), (6, "return -1;", ";"), (6, "-", ""), (6, "1", "0"), (8, "1", "0"),
                (8, "!=", "=="), (8, "4", "5"), (10, "+=", "-="), (10, "max", "min"), (10, "2.", "(1.01 * 2.)"),
                (10, "2.", "(2. * 2.)"), (10, "*", "/"), (10, "0", "1"), (11, "min", "max"), (11, "1e3", "(1.01 * 1e3)"),
                (11, "1e3", "(2. * 1e3)")]
HEADER = '''struct Options
{
  double       safety = .9, share{1.};
  unsigned int n_steps = 7;
  void go(double time = 0., bool loud = !quiet);
  double half() const { return .5 * safety; }
};
'''
HEADER_EDITS = [(6, ".5", "(1.01 * .5)"), (6, ".5", "(2. * .5)"), (6, "*", "/")]
PYTHON = '''def f(x):
    """x - 1"""
    if not x and "a - b":  # x - 2
        return 0.
    return -x[1] // 3
'''
PYTHON_EDITS = [(3, "not ", ""), (3, "and", "or"), (4, "return 0.", "pass"), (4, "0.", "1."), (5, "-", ""),
                (5, "1", "0"), (5, "3", "4")]


def edits(file, content, defaults=False):
    mutants = make_mutants(file, content, defaults)
    for mutant in mutants:
        assert content[mutant.begin:mutant.end] == mutant.old
        assert mutant.apply(content) == content[:mutant.begin] + mutant.new + content[mutant.end:] != content
    return [(mutant.line, mutant.old, mutant.new) for mutant in mutants]


def expect(found, wanted):
    assert found == wanted, f"missing: {[one for one in wanted if one not in found]}, too many: " \
                            f"{[one for one in found if one not in wanted]}"


expect(edits("a.cc", SOURCE), SOURCE_EDITS)
expect(edits("a.h", HEADER), HEADER_EDITS)
expect(edits("a.py", PYTHON), PYTHON_EDITS)
assert (4, "7", "8") in edits("a.h", HEADER, defaults=True)
