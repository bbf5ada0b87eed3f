# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What .json files of results hold, as far as the report reads them.

A shape is a type (a number is int or float, never a truth value; null where the program had no number), a list with
the shape of all its members, a dictionary with the shape of each known member ("name?" may be missing), or Each(shape)
for a dictionary with members of any name. Members that no shape knows may be anything.
"""
import math
from dataclasses import dataclass

LARGEST = 1e100  # of a number: squares and products of such numbers are still numbers


@dataclass(frozen=True)
class Each:
    shape: object


NUMBER = "number"  # or null
COUNT = "count"  # a whole number, not negative
QUANTITY = {"value": NUMBER, "unit": str}
STATISTICS = {"mean": NUMBER, "peak to peak": NUMBER, "standard deviation": NUMBER, "unit": str}

SUMMARY = {
    "status?": str, "failure?": str, "version?": str, "revision?": str,
    "figures?": Each(QUANTITY), "transmission error?": Each(QUANTITY), "energy?": Each(QUANTITY),
    "mesh?": {"cells?": COUNT, "bodies?": [
        {"name": str, "cells": COUNT, "nodes": COUNT, "mass": {"value": float, "unit": str},
         "speed at the start?": {"value": float, "unit": str}}]},
    "run?": {"time": {"value": float, "unit": str}, "steps": COUNT, "run time": QUANTITY, "ranks": COUNT,
             "element-steps per second?": {"value": float, "unit": str}, "timers?": Each(QUANTITY),
             "instruction set?": str},
    "steady part?": {"start": {"value": float, "unit": str}, "end": {"value": float, "unit": str}, "found": bool,
                     "mesh cycles": COUNT, "explanation": str, "ripple?": {"judged": bool, "steady": bool}, "columns?": Each(STATISTICS)},
    "damping audit?": [{"body": str, "net torque": QUANTITY, "power": QUANTITY, "drift of rotation speed": QUANTITY}],
    "contact losses?": {"count": COUNT},
    "input conflicts?": [str], "warnings?": [str]}
STATED = Each(QUANTITY)  # figures.json
EDGE_CONTACT = {"edge contact": bool, "explanation": str}
# Members have one entry that is a word.
GEOMETRY = {"pair": Each(QUANTITY), "pinion": {"hand of spiral": str}, "gear": {"hand of spiral": str}}
PARAMETERS = Each({"value": str, "unit": str})
COMPARISON = {"title?": str, "cases?": [{"name": str, "kind": str, "folder": str}], "remarks?": [str], "rows": [
    {"quantity?": str, "unit?": str, "value?": NUMBER, "reference?": NUMBER, "reference kind?": str,
     "difference?": NUMBER, "tolerance?": NUMBER, "verdict?": str, "reason?": str}]}
# Of a tooth contact analysis: groups of a side hold quantities, words and flags.
_SIDE = {"mean contact on the generated pinion flank": Each(QUANTITY), "mean contact on the generated gear flank": Each(QUANTITY),
         "ellipse at the mean contact": Each(QUANTITY), "path": {}, "beyond the start": {"border": str},
         "beyond the end": {"border": str}, "lag over pitches": Each(QUANTITY), "has a transfer point": bool,
         "transfer point inside the flanks": bool, "transfer point?": Each(QUANTITY)}
_SECTIONS = {"toe": Each(QUANTITY), "middle": Each(QUANTITY), "heel": Each(QUANTITY)}
CONTACT_ANALYSIS = {"working": {"driving member": str, "direction of rotation": str, "side": str},
                    "drive?": _SIDE, "coast?": _SIDE, "unequal teeth?": Each(QUANTITY),
                    "teeth": {"pinion": _SECTIONS, "gear": _SECTIONS}}
LUMPED = {"model": Each(QUANTITY), "response": Each(QUANTITY), "modes": [
    {"frequency [Hz]": NUMBER, "damping ratio [-]": NUMBER,
     "critical pinion speeds of mesh orders 1, 2, 3 [rpm]": [NUMBER]}],
    "sweep?": {"largest peak to peak dte?": QUANTITY, "at the speed?": QUANTITY, "largest difference of both directions?": QUANTITY}}


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= LARGEST \
        and not (isinstance(value, float) and math.isnan(value))


def find_mistake(value, shape, place=""):
    """What is wrong, with the names that lead there; empty where all is right."""
    wrong = f'{place or "it"} is {describe(value)}, but '
    if isinstance(shape, Each):
        if not isinstance(value, dict):
            return wrong + "should be a group of entries"
        return next(filter(None, (find_mistake(one, shape.shape, join(place, name)) for name, one in value.items())), "")
    if isinstance(shape, dict):
        if not isinstance(value, dict):
            return wrong + "should be a group of entries"
        for name, inner in shape.items():
            known = name.rstrip("?")
            if known in value:
                mistake = find_mistake(value[known], inner, join(place, known))
                if mistake:
                    return mistake
            elif known == name:
                return f"{join(place, name)} is missing"
        return ""
    if isinstance(shape, list):
        if not isinstance(value, list):
            return wrong + "should be a list"
        return next(filter(None, (find_mistake(one, shape[0], f"{place}, entry {k + 1}")
                                  for k, one in enumerate(value))), "")
    return "" if fits(value, shape) else wrong + f"should be {NAMES[shape]}"


NAMES = {NUMBER: "a number or null", COUNT: "a whole number, not negative", str: "a text", bool: "true or false",
         float: "a number"}


def fits(value, shape):
    if shape == NUMBER:
        return value is None or is_number(value)
    if shape == COUNT:
        return isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= 1e18
    if shape is float:
        return is_number(value)
    return isinstance(value, shape)


def join(place, name):
    return f'{place}, "{name}"' if place else f'"{name}"'


def describe(value):
    text = {list: "a list", dict: "a group of entries", type(None): "null"}.get(type(value)) or f"{value!r}"
    return text if len(text) <= 40 else text[:40] + "..."
