# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What a picture of fields is taken of."""
import numpy as np

from .hexahedra import find_axis


class Scene:
    """Fields of a gear pair and where its axes and its contact are, found from the fields."""

    def __init__(self, run, fields):
        if not np.all(np.isfinite(fields.points)):
            raise ValueError("positions of the last fields are no numbers")
        self.run, self.fields = run, fields
        names = {run.body_name(b): b for b in fields.bodies()}
        self.is_pair = {"pinion", "gear"} <= set(names)
        pressure = fields.data.get("contact pressure")
        self.contact = None
        if pressure is not None and np.any(pressure > 0):
            self.contact = (fields.points * pressure[..., None]).sum(axis=(0, 1)) / pressure.sum()
        if self.is_pair:
            self.pinion, self.gear = names["pinion"], names["gear"]
            self.pinion_axis = find_axis(fields.body(self.pinion).points)[1]
            self.gear_centre, self.gear_axis = find_axis(fields.body(self.gear).points)

    def when(self):
        """Times of kinds without motion are parts of the load."""
        if self.run.summary.get("study") in ("static", "linear static"):
            return "in equilibrium"
        if self.run.summary.get("study") == "loaded tooth contact analysis":
            return f"mesh cycle {self.fields.time:g}"
        return "at rest" if self.fields.time is None else f"time {1e3 * self.fields.time:.3f} ms"


def is_in_mesh(scene):
    """A gear pair in contact."""
    return scene.is_pair and scene.contact is not None


def find_meridian(scene):
    """Plane through the gear's axis and the contact: origin, normal, axis, radial direction."""
    axis = scene.gear_axis
    radial = scene.contact - scene.gear_centre
    radial -= (radial @ axis) * axis
    radial /= np.linalg.norm(radial)
    return scene.gear_centre, np.cross(axis, radial), axis, radial
