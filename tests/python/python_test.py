# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of the package vfife share: PROGRAM CMAKE BUILD_FOLDER are their arguments; without numpy they are
skipped (77). Makes the package of the tree importable."""
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, CMAKE, BUILD = sys.argv[1:]
os.environ["VFIFE_PROGRAM"] = PROGRAM
sys.path.insert(0, str(ROOT / "source" / "report"))
sys.dont_write_bytecode = True
try:
    import numpy  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)
