# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of a study: folders below one folder, in the order of sweep.csv where there is one."""
from dataclasses import dataclass

from .naming import name_variants
from .run_folder import RunFolder
from .table import read_rows


@dataclass
class Variant:
    number: int
    name: str
    run: RunFolder


def is_run(folder):
    return any((folder / name).is_file() for name in ("summary.json", "history.csv", "figures.json"))


def list_sweep_order(folder):
    """Folders that cells of sweep.csv name, whatever its columns are called."""
    path = folder / "sweep.csv"
    if not path.is_file():
        return []
    cells = [cell for _, row in read_rows(path) for cell in row if cell.strip() and "\0" not in cell]
    return list(dict.fromkeys(folder / cell for cell in cells if (folder / cell).is_dir()))


def find_variants(folder, chosen=None):
    """Empty where the folder is a run itself or has none below; of the chosen folders alone, where there are any."""
    if (folder / "history.csv").is_file() or (folder / "figures.json").is_file():
        return []
    below = sorted(path for path in folder.iterdir() if path.is_dir())
    folders = list(dict.fromkeys([path for path in (chosen or list_sweep_order(folder) + below) if is_run(path)]))
    runs = [RunFolder(path) for path in folders]
    return [Variant(number, *pair) for number, pair in enumerate(zip(name_variants(runs), runs))]
