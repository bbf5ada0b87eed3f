# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Where responses over speed are largest."""
import numpy as np

from ..data.table import read_table

PEAKS_HEADER = ["quantity", "place", "largest", "unit", "at [rpm]"]
PEAKS_CAPTION = "Largest values over all speeds."
EXCEEDANCES_HEADER = ["quantity", "from [rpm]", "to [rpm]", "largest amplification", "at [rpm]"]
EXCEEDANCES_CAPTION = ("Speed ranges in which an amplification exceeds Reduced/allowed amplification. The amplification is contact force "
                       "over its mean, or stress over stress without vibration.")


def find_response(run, name="resonance.csv"):
    """One of the tables over speed of a folder; None where it has none."""
    return read_table(run.path / name)


def list_places(variants):
    """Places whose stresses are known of any variant, in the order of their tables."""
    stresses = [find_response(variant.run, "stress_response.csv") for variant in variants]
    return list(dict.fromkeys(str(place) for stress in stresses if stress is not None for place in stress["place"]))


def find_largest(values):
    """Place of the largest value; None where there is no number."""
    return int(np.nanargmax(values)) if np.any(np.isfinite(values)) else None


def list_peaks(run):
    """Figure, where, largest value, unit and speed of a folder's responses."""
    response, stress = find_response(run), find_response(run, "stress_response.csv")
    for column in ("peak to peak dte", "largest force"):
        row = find_largest(response[column])
        if row is not None:
            yield column, "", float(response[column][row]), response.units[column], float(response["speed"][row])
    if stress is None:
        return
    for column in ("largest stress", "amplification"):
        row = find_largest(stress[column])
        if row is not None:
            yield (column, str(stress["place"][row]), float(stress[column][row]), stress.units[column],
                   float(stress["speed"][row]))


def list_exceedances(run):
    """Quantity, first and last speed, largest amplification and its speed; of rising speeds."""
    ranges = find_response(run, "exceedances.csv")
    if ranges is None:
        return []
    return [[str(ranges["quantity"][k])] + [float(ranges[name][k]) for name in ("from", "to", "largest amplification", "at")]
            for k in range(ranges.n_rows) if ranges["direction"][k] == "up"]
