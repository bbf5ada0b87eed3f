# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""All plots and pictures of the report, a row each. A new one is a function and a row here."""
from functools import partial

from .data.columns import CONTACT_FORCE, TRANSMISSION_ERROR
from .data.fields import read_fields_of_bodies, read_last_fields
from .data.needs import (changes_speed, has_axis, has_bearings, has_contact, has_error_bars, has_file, has_history, has_misalignment, has_model_probes,
                         has_orders, has_pair, has_pairs, has_pairs_with, has_pattern, has_patterns, has_probes,
                         has_responses, has_rim, has_rim_over_meshes, has_speeds, has_tooth_mesh, has_tooth_pressures)
from .data.study import Study
from .pictures.bodies import draw_bodies, draw_meshes
from .pictures.meridian_section import draw_deformation, draw_meridian_section
from .pictures.mode_shapes import draw_mode_shapes, list_shaped_bodies
from .pictures.scene import Scene, is_in_mesh
from .pictures.teeth_in_mesh import draw_teeth_in_mesh
from .plots import (bearings, campbell, comparisons, driven_waves, grid_pressure, histories, lumped, rim, root_stress,
                    run_up, spectra, speed_curves, speed_response, tooth_contact)
from .plots.curves import draw_curves
from .plots.error_bars import draw_error_bars
from .plots.loaded_contact import draw_loaded_contact
from .plots.meridian import draw_run_meridians
from .plots.plot_row import PlotRow, draw_rows
from .plots.resonance import draw_resonance
from .plots.static_curve import draw_static_curve, has_static_curve
from .plots.tooth_contact_analysis import draw_tooth_contact_analysis
from .plots.waterfalls import draw_waterfall

# For the folder of a run.
RUN_PLOTS = (
    PlotRow("dte.svg", (has_pair,), histories.draw_transmission_error,
            "Dynamic transmission error of hub and rim: actual minus ideal rotation. A lag of the driven member is negative.",
            "Transmission error"),
    PlotRow("contact_force.svg", (has_contact,), histories.draw_contact_force,
            "Contact force: sum of all tooth pairs, and each tooth pair.", "Contact"),
    PlotRow("tooth_engagement.svg", (has_tooth_pressures,), tooth_contact.draw_tooth_engagement,
            "Force and Hertzian pressure of one tooth pair during its engagement. The pressure follows from force and "
            "curvatures, not from mesh and penalty.", "Contact"),
    PlotRow("load_sharing.svg", (has_tooth_pressures,), tooth_contact.draw_load_sharing,
            "Load share and Hertzian pressure of all tooth pairs, superposed by whole tooth pitches.", "Contact"),
    PlotRow("contact_pattern.svg", (has_pattern, has_history), tooth_contact.draw_contact_pattern,
            "Contact pattern over the last mesh cycle: L is the distance along the pitch cone, h the height above it. Nodal pressures are "
            "divided by their largest value. The pattern is qualitative, because nodal pressures depend on the mesh.", "Contact",
            data="pattern.csv"),
    PlotRow("spectra.svg", (has_tooth_mesh,), spectra.draw_spectra,
            "Amplitudes over the whole mesh cycles of the steady part, without window.",
            "Spectra and periodicity"),
    PlotRow("sidebands.svg", (has_tooth_mesh,), spectra.draw_sidebands,
            "Spectrum of the transmission error around the first mesh harmonics (Hann window).",
            "Spectra and periodicity"),
    PlotRow("orders.svg", (has_orders,), run_up.draw_orders,
            "Amplitudes of the mesh orders over the speed.", "Variable speed",
            data="orders.csv"),
    PlotRow("waterfall.svg", (changes_speed,), run_up.draw_waterfall,
            "Spectra of the transmission error over the speed (Hann windows).",
            "Variable speed"),
    PlotRow("waterfall_force.svg", (changes_speed,), partial(run_up.draw_waterfall, column=CONTACT_FORCE),
            "Spectra of the contact force over the speed (Hann windows).", "Variable speed"),
    PlotRow("probes.svg", (has_probes,), histories.draw_probes,
            "Von Mises stress at the probes.", "Stress at the probes"),
    PlotRow("model_probes.svg", (has_model_probes,), histories.draw_model_probes,
            "Displacements and von Mises stresses of the probes.", "Motion of the probes"),
    PlotRow("rim_content.svg", (has_rim,), rim.draw_rim_content,
            "Displacement of the rim by nodal diameters: static deflection in the fixed frame, caused by the load, and vibration.",
            "Motion of the rim"),
    PlotRow("rim_history.svg", (has_rim,), rim.draw_rim_history,
            "Axial vibration of the rim by nodal diameters, without the static deflection in the fixed frame.", "Motion of the rim"),
    PlotRow("rim_waves.svg", (has_rim_over_meshes,), rim.draw_rim_waves,
            "Spectra of the axial vibration of the rim: forward and backward travelling waves, in the rotating frame.", "Motion of the rim"),
    PlotRow("energies.svg", (has_history,), histories.draw_energies,
            "Energy error, and changes of the energies. A negative value of the speed controller is added energy.", "Energy and damping"),
    PlotRow("bearings.svg", (has_bearings,), bearings.draw_bearings,
            "Forces of the bearings on their shafts, and displacements of their seats.", "Bearings"),
    PlotRow("misalignment.svg", (has_misalignment,), bearings.draw_misalignment,
            "Misalignment of the members under load, with the signs of mounting errors.", "Bearings"),
    PlotRow("bearing_curves.svg", (has_file("bearing_curves.csv"),), bearings.draw_bearing_curves,
            "Load of the rolling bearings over displacement from the unloaded state.", "Bearings"),
)

# For the last fields of a run.
FIELD_PICTURES = (
    PlotRow("bodies.png", (), draw_bodies,
            "Von Mises stress of the bodies, with element edges. The largest value is that of all nodes.", "Results"),
    PlotRow("teeth_in_mesh.png", (is_in_mesh,), draw_teeth_in_mesh,
            "Teeth in contact: von Mises stress in a normal section, and contact pressure on the gear.", "Contact"),
    PlotRow("meridian_section.png", (is_in_mesh,), draw_meridian_section,
            "Von Mises stress in the section through gear axis and contact.", "Sections"),
    PlotRow("deformation.png", (is_in_mesh,), draw_deformation,
            "Deformation of the gear in the section through its axis and the contact.", "Sections"),
)

# For a folder with the tables of a study other than a run.
TABLE_PLOTS = (
    PlotRow("meshes.png", (has_file("mesh.csv"), has_file("pair.vtu")), draw_meshes, "Meshes of both members, mounted.", "Meshes"),
    PlotRow("meridian.svg", (has_file("mesh.csv"), has_file("meridian.csv")), draw_run_meridians,
            "Sections through the axes of the bodies.", "Meshes", data="meridian.csv"),
    PlotRow("tca.svg", (has_file("tca.csv"),), draw_tooth_contact_analysis,
            "Lag of successive tooth pairs, path of contact with contact ellipses, and ease-off.",
            "Unloaded tooth contact", data="tca.csv, path.csv, ease_off.csv"),
    PlotRow("loaded_contact.svg", (has_file("loaded_contact.csv"),), draw_loaded_contact,
            "Transmission error, load sharing, gear mesh stiffness and stresses over a mesh cycle.",
            "Loaded tooth contact by finite elements", data="loaded_contact.csv, loaded_teeth.csv"),
    PlotRow("loaded_pattern.svg", (has_pattern, has_file("loaded_contact.csv")),
            tooth_contact.draw_contact_pattern,
            "Contact pattern on the drive flanks over one mesh cycle: L is the distance along the pitch cone, h the height above it. A cross "
            "marks the centre. Nodal pressures are divided by their largest value. The pattern is qualitative, because nodal pressures "
            "depend on the mesh.",
            "Loaded tooth contact by finite elements", data="pattern.csv"),
    PlotRow("grid_pressure.svg", (has_file("pressure.csv"),), grid_pressure.draw_pressure,
            "Pressure on the own grid and force of each tooth pair during its engagement. The pressure inside the flank does not depend "
            "on the penalty. At a sharp edge the pressure is unbounded, so the value depends on the cell size.",
            "Contact pressure on the own grid", data="pressure.csv"),
    PlotRow("grid_pressure_field.svg", (has_file("pressure_field.csv"),), grid_pressure.draw_pressure_field,
            "Pressure on the own grid on the flanks of all teeth in contact, along face and profile.",
            "Contact pressure on the own grid", data="pressure_field.csv"),
    PlotRow("root_stress.svg", (has_file("root_stress.csv"),), root_stress.draw_root_stress,
            "Largest tension and compression in the fillets of both members during the engagement of a tooth. At each position the largest "
            "value of all teeth is shown.", "Root stress"),
    PlotRow("fillet_envelope.svg", (has_file("fillet_envelope.csv"),), root_stress.draw_envelope,
            "Largest tension and compression of each facet on the unrolled fillets.", "Root stress",
            data="fillet_envelope.csv"),
    PlotRow("root_sections.svg", (has_file("root_sections.csv"),), root_stress.draw_sections,
            "Largest tension and compression of the fillet sections along the face.", "Root stress",
            data="root_sections.csv"),
    PlotRow("gauges.svg", (has_file("gauges.csv"),), root_stress.draw_gauges,
            "Strain of the gauges.", "Root stress"),
    PlotRow("mode_shapes_{}.png", (has_file("modes.csv"),), draw_mode_shapes,
            "Lowest vibration modes of the {} at the lowest speed, magnified. Double modes are shown once.",
            "Natural frequencies", each=list_shaped_bodies),
    PlotRow("campbell_{}.svg", (has_file("campbell.csv"),), campbell.draw_campbell,
            "Natural frequencies of the {0} over its speed, in the rotating frame. Circles mark resonances with a force that is stationary "
            "in the fixed frame. A wave of n diameters is then n rotation frequencies above or below the line of the order.",
            "Natural frequencies", data="campbell.csv, resonances.csv", each=campbell.list_bodies),
    PlotRow("whirl_{}.svg", (has_file("modes.csv"),), campbell.draw_whirl,
            "Lowest frequencies of the {0} over its speed, in the fixed frame. A mode on the line of the rotation is resonant with "
            "unbalance.", "Natural frequencies", data="modes.csv", each=campbell.list_whirling_bodies),
    PlotRow("lumped_motion.svg", (has_file("lumped.csv"),), lumped.draw_motion,
            "Motion of the lumped model at the operating speed.", "Lumped model"),
    PlotRow("lumped_response.svg", (has_file("lumped.csv"), has_file("resonance.csv")),
            lumped.draw_response, "Response of the lumped model over speed.", "Lumped model"),
    PlotRow("reduced_response.svg", (has_file("resonance.csv"), has_file("wave_response.csv")),
            speed_response.draw_reduced_response,
            "Response of the reduced pair over speed. Each speed starts from the motion at the previous speed.",
            "Response over speed", data="resonance.csv"),
    PlotRow("wave_response.svg", (has_file("wave_response.csv"),), speed_response.draw_wave_response,
            "Travelling waves of the rim over speed. A peak is a resonance of a wave with a mesh order.", "Response over speed",
            data="wave_response.csv"),
    PlotRow("stress_response.svg", (has_file("stress_response.csv"),), speed_curves.draw_stress_response,
            "Largest stress of all sectors over speed, and stress without vibration.", "Response over speed",
            data="stress_response.csv"),
    PlotRow("waves_met.svg", (has_file("waves_frequencies.csv"),), driven_waves.draw_waves_met,
            "Frequencies of the web's waves in the fixed frame over speed, and mesh orders. Thin lines are for the free gear, thick lines "
            "for the pair in contact. Points mark resonances in contact, stars the torsional mode. Circles mark the selected waves, discs "
            "the computed amplitudes of the rim.", "Travelling waves",
            data="waves_frequencies.csv, waves_lines.csv, waves_in_contact.csv"),
    PlotRow("driven_waves.svg", (has_file("waves_response.csv"),), driven_waves.draw_driven_waves,
            "Amplitude of the excited waves of the rim over speed. A vertical line marks the resonance of the free gear.",
            "Travelling waves", data="waves_response.csv"),
    PlotRow("waves_build_up.svg", (has_file("waves_build_up.csv"),), driven_waves.draw_growth,
            "Build-up of the excited waves from equilibrium, at their resonance speeds.", "Travelling waves",
            data="waves_build_up.csv"),
)

# For a study: all its runs on shared axes.
STUDY_PLOTS = (
    PlotRow("static_curve.svg", (has_static_curve,), draw_static_curve,
            "Transmission error of the run and of the static pair over the mesh cycle.", "Comparison"),
    PlotRow("error_bars.svg", (has_error_bars,), draw_error_bars,
            "Quantities of all variants with their numerical errors. A cross marks a value with unknown error.", "Error bars",
            data="error_bars.csv, differences.csv"),
    PlotRow("speed_curves.svg", (has_responses,), speed_curves.draw_speed_curves,
            "Responses of all variants over rising speed. A dot marks the largest value.", "Responses over speed",
            data="resonance.csv, stress_response.csv of each variant"),
    PlotRow("resonance.svg", (has_speeds,), draw_resonance,
            "Peak to peak and RMS of transmission error and contact force over speed, with other models. Circles mark runs without steady part "
            "or with transient ripple. Vertical lines mark resonances of a mesh order with a coupled mode.", "Over one parameter"),
    PlotRow("waterfall_dte.svg", (has_speeds,), partial(draw_waterfall, column=TRANSMISSION_ERROR),
            "Spectra of the transmission error at each speed (Hann window, whole mesh cycles of the steady part). The distance of the rows "
            "is not to scale.", "Over one parameter"),
    PlotRow("waterfall_force.svg", (has_speeds,), partial(draw_waterfall, column=CONTACT_FORCE),
            "Spectra of the contact force at each speed.", "Over one parameter"),
    PlotRow("curves.svg", (has_axis,), draw_curves,
            "Key figures of the runs over the varied parameter.", "Over one parameter"),
    PlotRow("dte.svg", (has_pairs,), partial(comparisons.draw_histories, column=TRANSMISSION_ERROR),
            "Dynamic transmission error of all variants: mean over a mesh cycle for the whole run, and last mesh cycles without averaging.",
            "Transmission error"),
    PlotRow("dte_spectra.svg", (has_pairs,),
            partial(comparisons.draw_spectra, column=TRANSMISSION_ERROR),
            "Spectra of the transmission error over whole mesh cycles of the steady part.",
            "Transmission error"),
    PlotRow("contact_force.svg", (has_pairs,), partial(comparisons.draw_histories, column=CONTACT_FORCE),
            "Total contact force of all variants: mean over a mesh cycle for the whole run, and last mesh cycles without averaging.",
            "Contact"),
    PlotRow("force_spectra.svg", (has_pairs,), partial(comparisons.draw_spectra, column=CONTACT_FORCE),
            "Spectra of the contact force over whole mesh cycles of the steady part.", "Contact"),
    PlotRow("contact_patterns.svg", (has_patterns,), tooth_contact.draw_contact_patterns,
            "Contact patterns on the drive flanks over one mesh cycle, relative to the largest pressure of each variant. Dots are nodes, a "
            "cross is the centre in loaded tooth contact analyses.", "Contact"),
    PlotRow("tooth_stress.svg", (has_pairs_with("teeth", "hertz pressure"),),
            comparisons.draw_tooth_stress,
            "Hertzian pressure of one tooth pair from first to last contact.", "Stresses"),
    PlotRow("probes.svg", (has_pairs_with("probes"),), comparisons.draw_probes,
            "Von Mises stress at the probes over the time from the peak.", "Stresses"),
    PlotRow("rim_content.svg", (has_pairs_with("rim"),), comparisons.draw_rim_content,
            "Motion of the rim by nodal diameters: static part in the fixed frame, caused by the load, and vibration.",
            "Motion of the rim"),
)


def draw_folder(source, names=()):
    """All plots and pictures of a study, or of a run's or another folder: list of DrawnPlot."""
    if isinstance(source, Study):
        return (draw_rows(STUDY_PLOTS, source, source.path, names)
                + draw_rows(TABLE_PLOTS, source.folder, source.path, names))
    drawn = draw_rows(RUN_PLOTS, source, source.path, names)
    fields = (read_last_fields(source.fields) if source.fields.is_file() else
              read_fields_of_bodies(sorted((source.path / "fields").glob("*.vtu"))))
    if fields is not None:
        drawn += draw_rows(FIELD_PICTURES, Scene(source, fields), source.path, names)
    return drawn + draw_rows(TABLE_PLOTS, source, source.path, names)
