# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the compiled module _vfife is."""
import importlib.machinery
import importlib.util
import sys

from .errors import VfifeError
from .program import PREFIX, TREE

NAME = "_vfife"


def list_folders():
    """Where it may be beside sys.path: built in the tree that this package lies in, installed with it."""
    return [TREE / "build" / "release" / "python", PREFIX / "lib" / "python3" / "dist-packages"]


def load_extension():
    """The module, loaded once. VfifeError where there is none for this Python."""
    if NAME in sys.modules:
        return sys.modules[NAME]
    spec = importlib.util.find_spec(NAME)
    for folder in list_folders():
        spec = spec or importlib.machinery.PathFinder.find_spec(NAME, [str(folder)])
    if spec is None:
        raise VfifeError(f"there is no module {NAME} for Python {sys.version_info[0]}.{sys.version_info[1]} in "
                         f"{', '.join(map(str, list_folders()))} nor in sys.path: it is built with vfife where pybind11 "
                         "and Python's headers are (Debian: pybind11-dev python3-dev)")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[NAME] = module
    return module
