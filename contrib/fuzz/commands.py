# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of the command line of a run that takes no time."""
from job import Job
from mutation import NUMBERS, SMALL_BODY, misspell, pick

CASE = """subsection Study
  set kind = run
  set output folder = out
end
subsection Model
  set bodies = a
  set probes = p
""" + SMALL_BODY + """  subsection Probe p
    set body = a
  end
end
subsection Dynamics
  set end time = 1 us
end
subsection Output
  set report = no
end
"""
OPTIONS = ["-o", "--output", "--set", "--restart", "--check", "--print-parameters", "--parameter-reference", "--version",
           "--help", "-h", "--", "-", "--set=", "-o=", "--output=x", "-ox", "--no-such", "-x", ""]
FOLDERS = ["out", "--help", "-x", "", " ", "a b", "a'b", 'a"b', "$(touch hit)", "a;b", "/dev/null", "/proc/x", "case.prm", ".",
           "a/b/c", "x" * 300, "a\nb", b"\xff", b"out\xc3\x28", "\u00fc", "/", "/dev/full", "~", "*", "-"]
OVERRIDES = ["Study/output folder={}", "Dynamics/end time={}", "Model/Body a/elements x={}", "Model/bodies={}", "Study/kind={}",
             "Model/Body a/initial velocity x={}", "Model/Probe p/point={}", "{}", "={}", "/{}=1", "Model//cells={}",
             "Model/Body {}/elements x=1", "Output/steps per sample={}", "Dynamics/maximum number of steps={}", "Output/report={}"]


class Seeds:
    def __init__(self, runner, folder):
        pass

    def random_override(self, rng):
        text = pick(rng, OVERRIDES)
        value = pick(rng, [*FOLDERS, *NUMBERS, "yes", "no", "run", "static", "modal"])
        before, after = text.split("{}")
        if isinstance(value, bytes):
            return before.encode() + value + after.encode()
        return misspell(rng, before + value + after) if rng.random() < 0.1 else before + value + after

    def make(self, rng, folder):
        (folder / "case.prm").write_text(CASE)
        arguments = [pick(rng, ["case.prm"] * 9 + ["", "missing.prm", ".", "/dev/null", b"\xff", "--help", "out"])]
        for _ in range(rng.randrange(1, 4)):
            how = rng.random()
            if how < 0.4:
                arguments += ["--set", self.random_override(rng)]
            elif how < 0.7:
                arguments += [pick(rng, ["-o", "--output", "--restart"]), pick(rng, FOLDERS)]
            else:
                arguments.append(pick(rng, OPTIONS))
        if rng.random() < 0.1:
            rng.shuffle(arguments)
        arguments = [one.replace("\0", "") if isinstance(one, str) else one for one in arguments]
        return Job(folder, arguments, f"arguments {arguments}")
