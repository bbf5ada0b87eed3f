# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The entries of doc/gallery.md: a case, its picture, three numbers, and what is learned of it."""
from dataclasses import dataclass

import numpy as np
from vfife import Quantity


@dataclass(frozen=True)
class Entry:
    name: str      # of the picture, doc/pictures/gallery/NAME.svg or .png
    title: str
    case: str      # below prm/
    picture: str   # as the report has it
    numbers: tuple  # of (what it is, figure of the summary or a function of the result, digits)
    learned: str


def of_column(table, column, what, **where):
    """what() of a column, of the rows that have the given values in other columns."""
    def find(result):
        found = result.table(table)
        rows = np.ones(found.n_rows, dtype=bool)
        for name, text in where.items():
            rows &= found[name.replace("_", " ")] == text
        return Quantity(float(what(found[column][rows])), found.units[column])
    return find


def value_at(place):
    """Of a row: the first, 0, the last, -1."""
    return lambda column: column[place]


def least_positive(column):
    return np.min(column[column > 0])


def first_contact(result):
    """Times of the history with a contact force [s], and the force [N] at all times."""
    time, force = result.history["time"], result.history["contact force total"]
    return time[force > 0], force


def force_in_contact(result):
    """Mean from a quarter to three quarters of the contact."""
    touched, force = first_contact(result)
    middle = np.abs(result.history["time"] - touched.mean()) < np.ptp(touched) / 4
    return Quantity(float(force[middle].mean()), "N")


def time_in_contact(result):
    return Quantity(float(np.ptp(first_contact(result)[0])) * 1e6, "us")


ENTRIES = (
    Entry("proposed_pair", "A pair from tooth numbers and module", "gear/proposed_17_43.prm", "tca.svg",
          (("contact ratio of the drive side", "drive side, contact ratio", 3),
           ("unloaded transmission error, peak to peak", "drive side, peak to peak", 3),
           ("backlash of the gear", "teeth/backlash angle of the gear", 4)),
          "Local synthesis proposes blanks and machine settings. The parabola of each tooth pair shows its crowning. Contact passes to "
          "the next tooth pair where two parabolas intersect. [Gears](theory/gear.md)"),
    Entry("measured_flank", "Measured flanks", "errors/topography.prm", "tca.svg",
          (("transmission error of the drive side, peak to peak", "drive side, peak to peak", 3),
           ("transmission error of the coast side without deviations, peak to peak", "coast side, peak to peak", 3),
           ("contact ratio of the drive side", "drive side, contact ratio", 3)),
          "The gear flank is measured, the pinion flank has five terms of an ease-off. Deviations of some micrometres more than treble "
          "the 1.8 arcsec of the designed flanks. [Errors](theory/errors.md)"),
    Entry("running_pair", "The coarse pair at 20,000 rpm", "spiral_bevel_quick.prm", "teeth_in_mesh.png",
          (("mean transmission error", "dte mean", 3), ("transmission error, peak to peak of the record", "dte peak to peak", 2),
           ("mean contact force", "contact force total mean", 3)),
          "Explicit dynamics of 19,380 elements over 14 mesh cycles. The section and the pressure on the flanks show two to three tooth "
          "pairs in contact. [Run](reference/kinds.md#run-of-a-gear-pair)"),
    Entry("reduced_pair", "The same pair with reduced bodies", "reduced/spiral_bevel_quick.prm", "rim_waves.svg",
          (("mean transmission error", "dte mean", 3),
           ("transmission error, peak to peak of the second half",
            "steady part/ripple/columns/dte/peak to peak of the second half", 2),
           ("mean contact force", "contact force total mean", 3)),
          "136 modes and the residual flexibility of four teeth replace quadratic elements: 60 mesh cycles take a minute. The plots show "
          "the waves of the rim in both directions of travel. [Reduced bodies](theory/reduced.md)"),
    Entry("driven_wave", "Resonance of a travelling wave of the web", "waves/one_wave.prm", "driven_waves.svg",
          (("predicted resonance speed", of_column("waves_lines", "speed in contact", value_at(0)), 4),
           ("speed of the computed peak", of_column("waves_lines", "peak speed", value_at(0)), 4),
           ("amplitude of the rim", of_column("waves_lines", "amplitude", value_at(0)), 3)),
          "Mesh order 1 excites the forward wave of four nodal diameters. The reduced pair is computed around the predicted speed; the "
          "fitted peak agrees with the prediction. [Waves](theory/waves.md)"),
    Entry("root_stress", "Root stress of a tooth during engagement", "stress/root_stress_quick.prm", "root_stress.svg",
          (("root tension of the pinion", "pinion root tension", 3), ("root tension of the gear", "gear root tension", 3),
           ("root stress range of the gear", "gear root stress range", 3)),
          "The root has compression as well as tension during one engagement, so the stress range exceeds the tension. "
          "[Root stress](theory/stress.md)"),
    Entry("ball_passage", "Balls passing the load", "supports/ball_passage.prm", "bearings.svg",
          (("smallest displacement of a seat", of_column("bearings", "displacement x", np.min, bearing="left"), 3),
           ("largest displacement of a seat", of_column("bearings", "displacement x", np.max, bearing="left"), 3),
           ("largest force of a bearing", of_column("bearings", "radial force", np.max), 4)),
          "With clearance the stiffness of a ball bearing varies as its cage rolls. The displacement is largest with one ball under the "
          "load. [Bearings](theory/bearing.md)"),
    Entry("whirl", "A rotor in bearings over speed", "supports/two_discs.prm", "whirl_rotor.svg",
          (("first bending frequency at rest", of_column("modes", "fixed frequency", least_positive, speed=0), 4),
           ("backward whirl at 4000 rpm", of_column("modes", "fixed frequency", np.min, speed=4000, whirl="backward"), 4),
           ("forward whirl at 4000 rpm", of_column("modes", "fixed frequency", np.min, speed=4000, whirl="forward"), 4)),
          "Gyroscopic moments of the discs separate the frequencies of forward and backward whirl. [Bearings](theory/bearing.md)"),
    Entry("loaded_pair", "The loaded pair at rest", "fem/loaded_spiral_bevel_quick.prm", "loaded_contact.svg",
          (("mean transmission error", "transmission error mean", 3),
           ("tangent stiffness of the gear mesh", "tangent stiffness mean", 3),
           ("mean contact force", "contact force total mean", 3)),
          "Static equilibria over one mesh cycle by conventional finite elements on the same mesh. Run and reduced pair oscillate about "
          "their mean. [Conventional finite elements](theory/fem.md)"),
    Entry("jumps", "Loss of contact: jumps over speed", "lumped/torsional_pair.prm", "lumped_response.svg",
          (("largest peak to peak of the transmission error", "sweep/largest peak to peak dte", 3),
           ("pinion speed of this largest value", "sweep/at the speed", 4),
           ("largest difference between rising and falling speed", "sweep/largest difference of both directions", 3)),
          "With backlash the response has two branches: rising and falling speed follow different ones. [Lumped models](theory/lumped.md)"),
    Entry("plate", "A mesh of your own: plate with a hole", "verification/plate_with_hole.prm", "bodies.png",
          (("stress beside the hole at a remote stress of 10 MPa", of_column("history", "beside stress x", value_at(-1)), 3),
           ("stress ahead of the hole", of_column("history", "ahead stress y", value_at(-1)), 3),
           ("strain energy", "energy/strain", 4)),
          "Mesh files of Gmsh, Abaqus and VTK are bodies too; supports and loads refer to their named groups. [Own mesh](how-to/own-mesh.md)"),
    Entry("impact", "Two bars exchange their velocities", "verification/two_bars.prm", "energies.svg",
          (("contact force (wave theory: 1005.3 N)", force_in_contact, 5),
           ("contact duration (wave theory: 39.04 us)", time_in_contact, 3),
           ("largest strain energy, half of the total energy", of_column("history", "strain energy", np.max), 3)),
          "Implicit contact conserves energy within the explicit integration. [Contact](theory/contact.md#in-time)"),
)
