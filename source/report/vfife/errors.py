# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong between Python and the program, one exception an exit code."""


class VfifeError(Exception):
    """Any of these."""


class ProgramNotFound(VfifeError):
    """There is no program; the message lists where it was looked for."""


class InputError(VfifeError):
    """Exit code 1: the input cannot be used. The message is the program's: file, line, entry, what is allowed."""


class ComputationFailed(VfifeError):
    """Exit code 2: the computation failed. `result` has what there is up to then, None without files."""

    def __init__(self, message, result=None):
        super().__init__(message)
        self.result = result


class Stopped(ComputationFailed):
    """Exit code 3: stopped by a signal after a checkpoint, from which run(restart=True) goes on."""
