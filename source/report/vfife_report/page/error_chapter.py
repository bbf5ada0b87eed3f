# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The chapter of a sweep with numerical parameters: values with errors, which variants differ."""
import math

from .parts import Cells, Paragraph, format_number

NONE = "–"


def format_with_error(value, error):
    """Two digits of the error, the value to the same place: "-80.7 ± 2.2"."""
    if not math.isfinite(value) or not math.isfinite(error):
        return f"{format_number(value)} ± ?"
    if error == 0:
        return f"{format_number(value)} ± 0"
    places = max(1 - math.floor(math.log10(error)), 0)
    return f"{value:.{places}f} ± {error:.{places}f}".replace("-", "\u2212", 1)


def tell_error_bars(study, plots):
    bars = study.error_bars
    if bars is None:
        return
    parameters = ", ".join(bars.quantities[0].parts) if bars.quantities else ""
    yield Paragraph(f"Each value is from the finest numerical parameters ({parameters}). Its error is the sum of the errors by each "
                    "parameter. An error is 1.25 times the Richardson estimate if three values are monotone with an order between 0.5 and 2.1. "
                    "Otherwise it is the spread of the values.")
    yield Paragraph("A difference between two variants is significant if it exceeds the sum of both errors. Only its sign is significant "
                    "if it exceeds the error of the difference, in which common errors cancel.")
    if bars.unfinished:
        yield Paragraph("These runs have no results, and the errors do not include them: " + ", ".join(
            f"{run} ({status})" for run, status in bars.unfinished) + ".", "alarm")
    yield from plots
    yield tell_single_variant(bars)
    for one in bars.quantities:
        if len(one.variants) == 1 or one.is_constant():
            continue
        unit = "" if one.unit in ("", "-") else f" [{one.unit}]"
        # Others by their numbers: names of variants are long.
        number = {variant: str(k) for k, variant in enumerate(one.variants, 1)}
        rows = [[number[variant], variant, format_with_error(one.values[k], one.errors[k])]
                + [float(errors[k]) for errors in one.parts.values()]
                + [", ".join(number[other] for other in one.list_others(variant, word)) or NONE
                   for word in ("sign significant", "not significant")]
                + [one.methods[k]] for k, variant in enumerate(one.variants)]
        yield Cells(["", "variant", f"{one.name}{unit}"] + [f"error by {name}" for name in one.parts]
                    + ["only the sign of the difference is significant", "no significant difference", "method"], rows,
                    f"{one.name[:1].upper()}{one.name[1:]} of all variants. Numbers in the columns before the method name other variants.")


def tell_single_variant(bars):
    """For a case without variants: a row per quantity."""
    single = [one for one in bars.quantities if len(one.variants) == 1]
    parts = list(single[0].parts) if single else []
    return Cells(["quantity", "value", "unit"] + [f"error by {name}" for name in parts] + ["method"],
                 [[one.name, format_with_error(one.values[0], one.errors[0]), one.unit]
                  + [float(one.parts[name][0]) for name in parts] + [one.methods[0]] for one in single])
