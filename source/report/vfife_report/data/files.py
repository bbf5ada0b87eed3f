# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of results as text and JSON; one that is damaged is named with the place in it."""
import json

from .former_names import Named
from .shapes import find_mistake


class DamagedFile(ValueError):
    """A file of results cannot be what the program has written. The message begins with its name, and has line and
    column where there is one."""


def find_fields(folder):
    """The file of a run's fields, whether it is there or not."""
    hdf5 = folder / "fields.h5"
    return hdf5 if hdf5.is_file() else folder / "fields.pvd"


def read_text(path):
    content = path.read_bytes()
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        column = error.start - content.rfind(b"\n", 0, error.start)
        raise DamagedFile(f"{path}:{line}:{column}: byte 0x{content[error.start]:02X} is not UTF-8 text") from error


def read_json(path, shape):
    """The content of a .json file, which has this shape (shapes.py), by present names."""
    try:
        content = json.loads(read_text(path), parse_constant=refuse_constant,
                             object_pairs_hook=lambda members: Named(path.name, members))
    except json.JSONDecodeError as error:
        raise DamagedFile(f"{path}:{error.lineno}:{error.colno}: the file is damaged, this is no JSON") from error
    except (OverflowError, RecursionError) as error:
        raise DamagedFile(f"{path} is damaged: its numbers or brackets have no end") from error
    mistake = find_mistake(content, shape)
    if mistake:
        raise DamagedFile(f"{path}: {mistake}")
    return content


def refuse_constant(name):
    """NaN and the like are no JSON: the program writes null."""
    raise json.JSONDecodeError(name, "", 0)
