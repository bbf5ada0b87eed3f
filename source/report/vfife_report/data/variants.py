# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of a study: folders below one folder, in the order of sweep.csv where there is one."""
from dataclasses import dataclass

from .files import read_json
from .naming import name_variants
from .parameters import read_parameters
from .run_folder import RunFolder
from .shapes import COMPARISON
from .table import read_rows

STUDIES_OF_CASES = ("sweep", "compare")  # kinds whose cases have folders of their own
# Where the program keeps results of an earlier study in the same folder.
PUT_AWAY = ("previous", "previous.old", "previous.waste", "before_restart")


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


def list_compared(folder):
    """Folders below this one that comparison.json names."""
    path = folder / "comparison.json"
    cases = read_json(path, COMPARISON).get("cases", []) if path.is_file() else []
    return [folder / one["name"] for one in cases if (folder / one["name"]).is_dir()]


def list_below(folder):
    """All folders that are no results of an earlier study."""
    return sorted(path for path in folder.iterdir() if path.is_dir() and path.name not in PUT_AWAY)


def find_variants(folder, chosen=None):
    """Empty where the folder is a run itself or has none below; of the chosen folders alone, where there are any. A
    study of cases names its own; other folders have all that lie in them."""
    if (folder / "history.csv").is_file() or (folder / "figures.json").is_file():
        return []
    kind = read_parameters(folder).get("Study/kind")
    if kind is not None and kind not in STUDIES_OF_CASES:
        return []
    named = list_sweep_order(folder) + list_compared(folder)
    folders = list(dict.fromkeys(path for path in chosen or named or list_below(folder) if is_run(path)))
    runs = [RunFolder(path) for path in folders]
    return [Variant(number, *pair) for number, pair in enumerate(zip(name_variants(runs), runs))]
