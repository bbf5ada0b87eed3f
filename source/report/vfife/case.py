# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A parameter file with settings, and what the program does with it."""
import os
from dataclasses import dataclass
from pathlib import Path

from vfife_report.data.parameters import parse_parameters

from .errors import ComputationFailed, InputError, Stopped, VfifeError
from .program import call, find_program
from .result import Result


@dataclass(frozen=True)
class Check:
    """What --check says: all its lines, and those that name an input conflict."""
    text: str
    input_conflicts: tuple

    @property
    def contradictions(self):
        """The former name of input_conflicts."""
        return self.input_conflicts


class Case:
    """A parameter file and entries set besides. A case does not change: set() returns another one, so that
    variants are made from one base in a loop."""

    def __init__(self, file, program=None, settings=None):
        """`program`: path of vfife; else it is looked for, find_program()."""
        self.file = Path(file)
        self.settings = dict(settings or {})
        self._program = program

    def set(self, entry, value):
        """The case with "Section/Sub/name" set: a text with or without a unit, a number in the entry's unit, yes or no,
        or a list of these. The program judges it when it reads the case."""
        return Case(self.file, self._program, {**self.settings, entry: write_value(value)})

    def parameters(self):
        """All parameters in force as texts by "Section/Sub/name", a bare number with its unit. InputError."""
        return parse_parameters(self._ask("--print-parameters"), self.file)

    def check(self):
        """Builds the model and computes nothing: sizes, step, expected time, input conflicts. InputError."""
        text = self._ask("--check")
        lines = [line.strip() for line in text.splitlines()]
        mark = "warning: input conflict:"
        return Check(text, tuple(line[len(mark):].strip() for line in lines if line.startswith(mark)))

    def run(self, output=None, ranks=1, restart=False, show=False):
        """Does the case and returns its Result.

        `output`: folder of the results, else the file's own; `restart`: goes on from the checkpoint there; `show`: what
        the program prints goes to the screen (run.log has it in any case). InputError, ComputationFailed, Stopped.
        """
        folder = Path(output if output is not None else self.parameters()["Study/output folder"])
        arguments = self._arguments() + ["-o", os.fspath(folder)] + (["--restart"] if restart else [])
        code, _, message = call(find_program(self._program), arguments, ranks, show)
        if code == 1:
            raise InputError(message)
        if code == 2:
            # The machine may not have let the program begin: there is no folder then.
            raise ComputationFailed(message, Result(folder) if folder.is_dir() else None)
        if code == 3:
            raise Stopped(message, Result(folder))
        if code != 0:
            raise VfifeError(f"the program ended with {code}: {message}")
        return Result(folder)

    def _arguments(self):
        settings = [part for entry, value in self.settings.items() for part in ("--set", f"{entry}={value}")]
        return [os.fspath(self.file), *settings]

    def _ask(self, option):
        code, text, message = call(find_program(self._program), [*self._arguments(), option])
        if code == 1:
            raise InputError(message)
        if code != 0:
            raise VfifeError(f"the program ended with {code}: {message}")
        return text

    def __repr__(self):
        settings = "".join(f".set({entry!r}, {value!r})" for entry, value in self.settings.items())
        return f"Case({str(self.file)!r}){settings}"


def write_value(value):
    """As it stands in a parameter file. numpy's values, whatever their type, are those of Python that tolist() makes of
    them: a number, true or false, a text, a list."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (list, tuple)):
        return ", ".join(map(write_value, value))
    # repr() of a float is the shortest text that is that number
    return repr(float(value)) if isinstance(value, float) else str(value)
