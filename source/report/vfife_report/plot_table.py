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

# Of a run's folder.
RUN_PLOTS = (
    PlotRow("dte.svg", (has_pair,), histories.draw_transmission_error,
            "Dynamic transmission error of hub and rim; a lag of the driven member is negative.",
            "Transmission error"),
    PlotRow("contact_force.svg", (has_contact,), histories.draw_contact_force,
            "Contact force: sum, and each tooth pair.", "Contact"),
    PlotRow("tooth_engagement.svg", (has_tooth_pressures,), tooth_contact.draw_tooth_engagement,
            "One tooth pair through its engagement. Hertz's pressure follows from its force, whatever mesh and penalty are.",
            "Contact"),
    PlotRow("load_sharing.svg", (has_tooth_pressures,), tooth_contact.draw_load_sharing,
            "Share of each tooth pair and Hertz's pressure, all pairs laid over each other.", "Contact"),
    PlotRow("contact_pattern.svg", (has_pattern, has_history), tooth_contact.draw_contact_pattern,
            "Contact pattern over the last mesh cycle, along and over the pitch cone: where the flanks carry. Pressures of "
            "nodes are spread over their facets; how large the pressure is says Hertz's.", "Contact",
            data="pattern.csv"),
    PlotRow("spectra.svg", (has_tooth_mesh,), spectra.draw_spectra,
            "Amplitudes over the whole mesh cycles of the steady part, no window.",
            "Spectra and periodicity"),
    PlotRow("sidebands.svg", (has_tooth_mesh,), spectra.draw_sidebands,
            "Transmission error around the first harmonics of the mesh (Hann's window).",
            "Spectra and periodicity"),
    PlotRow("orders.svg", (has_orders,), run_up.draw_orders,
            "Amplitudes of the mesh orders over the speed, angle by angle.", "Over the speed",
            data="orders.csv"),
    PlotRow("waterfall.svg", (changes_speed,), run_up.draw_waterfall,
            "Spectra of the transmission error over the speed (windows of the record, Hann's).",
            "Over the speed"),
    PlotRow("waterfall_force.svg", (changes_speed,), partial(run_up.draw_waterfall, column=CONTACT_FORCE),
            "Spectra of the contact force over the speed.", "Over the speed"),
    PlotRow("probes.svg", (has_probes,), histories.draw_probes,
            "Von Mises stress at the probes.", "Stress at the probes"),
    PlotRow("model_probes.svg", (has_model_probes,), histories.draw_model_probes,
            "Displacements and von Mises stresses of the probes.", "Motion of the probes"),
    PlotRow("rim_content.svg", (has_rim,), rim.draw_rim_content,
            "Displacement of the rim by nodal diameters: the pattern that stands in space with the load "
            "(0: the mean), and what moves besides.", "Motion of the rim"),
    PlotRow("rim_history.svg", (has_rim,), rim.draw_rim_history,
            "Axial waves of the rim that do not stand in space.", "Motion of the rim"),
    PlotRow("rim_waves.svg", (has_rim_over_meshes,), rim.draw_rim_waves,
            "Spectra of these waves by direction of travel.", "Motion of the rim"),
    PlotRow("energies.svg", (has_history,), histories.draw_energies,
            "Energy error and energies.", "Energy and damping"),
    PlotRow("bearings.svg", (has_bearings,), bearings.draw_bearings,
            "Forces of the bearings on their shafts and displacements of their seats.", "Bearings"),
    PlotRow("misalignment.svg", (has_misalignment,), bearings.draw_misalignment,
            "How the members of the pair stand to each other, less the undeformed pair: signs of mounting "
            "errors.", "Bearings"),
    PlotRow("bearing_curves.svg", (has_file("bearing_curves.csv"),), bearings.draw_bearing_curves,
            "Laws of the rolling bearings: load over displacement from the state without load.", "Bearings"),
)

# Of the scene of a run's last fields.
FIELD_PICTURES = (
    PlotRow("bodies.png", (), draw_bodies,
            "The bodies with the elements' edges and von Mises stress.", "Results"),
    PlotRow("teeth_in_mesh.png", (is_in_mesh,), draw_teeth_in_mesh,
            "Teeth in mesh: section and contact pressure.", "Contact"),
    PlotRow("meridian_section.png", (is_in_mesh,), draw_meridian_section,
            "Section through the gear's axis and the contact.", "Sections"),
    PlotRow("deformation.png", (is_in_mesh,), draw_deformation,
            "Deformation of the gear in that section.", "Sections"),
)

# Of a folder with the tables of a study other than a run.
TABLE_PLOTS = (
    PlotRow("meshes.png", (has_file("mesh.csv"), has_file("pair.vtu")), draw_meshes, "Both meshes, mounted.", "Meshes"),
    PlotRow("meridian.svg", (has_file("mesh.csv"), has_file("meridian.csv")), draw_run_meridians,
            "Sections through the bodies' axes.", "Meshes", data="meridian.csv"),
    PlotRow("tca.svg", (has_file("tca.csv"),), draw_tooth_contact_analysis,
            "Lag of neighbouring tooth pairs, path of contact with ellipses, ease-off.",
            "Unloaded tooth contact", data="tca.csv, path.csv, ease_off.csv"),
    PlotRow("loaded_contact.svg", (has_file("loaded_contact.csv"),), draw_loaded_contact,
            "Transmission error, load sharing, mesh stiffness and stresses over a mesh cycle.",
            "Loaded tooth contact by finite elements", data="loaded_contact.csv, loaded_teeth.csv"),
    PlotRow("loaded_pattern.svg", (has_pattern, has_file("loaded_contact.csv")),
            tooth_contact.draw_contact_pattern,
            "Contact pattern on the drive flanks over one mesh cycle, along and over the pitch cone; cross: its centre. Pressures of nodes "
            "are spread over their facets: they say where the flanks carry.",
            "Loaded tooth contact by finite elements", data="pattern.csv"),
    PlotRow("grid_pressure.svg", (has_file("pressure.csv"),), grid_pressure.draw_pressure,
            "Pressures on their own grid, which neither mesh nor penalty makes, and forces of a tooth pair along its engagement. At a "
            "sharp edge pressure has no bound: what stands there is one of cells and elements of this size.",
            "Pressures on their own grids", data="pressure.csv"),
    PlotRow("grid_pressure_field.svg", (has_file("pressure_field.csv"),), grid_pressure.draw_pressure_field,
            "Pressures on their own grid on the flanks of all teeth that carry, along and over the pitch cone.",
            "Pressures on their own grids", data="pressure_field.csv"),
    PlotRow("root_stress.svg", (has_file("root_stress.csv"),), root_stress.draw_root_stress,
            "Largest tension and compression in the fillets of both members while a tooth passes through the mesh; teeth at "
            "the same place count once, by their largest.", "Root stress"),
    PlotRow("fillet_envelope.svg", (has_file("fillet_envelope.csv"),), root_stress.draw_envelope,
            "The fillets unrolled: largest tension and compression that each facet has seen.", "Root stress",
            data="fillet_envelope.csv"),
    PlotRow("root_sections.svg", (has_file("root_sections.csv"),), root_stress.draw_sections,
            "Along the face: largest tension and compression that each section of the fillets has seen.", "Root stress",
            data="root_sections.csv"),
    PlotRow("gauges.svg", (has_file("gauges.csv"),), root_stress.draw_gauges,
            "Strain gauges.", "Root stress"),
    PlotRow("mode_shapes_{}.png", (has_file("modes.csv"),), draw_mode_shapes,
            "Lowest vibrations of the {} at the lowest speed, magnified; of a wave and the same wave turned one is shown.",
            "Natural frequencies", each=list_shaped_bodies),
    PlotRow("campbell_{}.svg", (has_file("campbell.csv"),), campbell.draw_campbell,
            "Natural frequencies of the {0} over its speed. Circles: resonances with a force that stands in space; in axes that "
            "turn, a wave of n diameters is met n turns of the {0} above or below the line of an order.",
            "Natural frequencies", data="campbell.csv, resonances.csv", each=campbell.list_bodies),
    PlotRow("whirl_{}.svg", (has_file("modes.csv"),), campbell.draw_whirl,
            "Lowest frequencies of the {0} for an observer at rest over its speed. On the line of the rotation unbalance "
            "meets a mode.", "Natural frequencies", data="modes.csv", each=campbell.list_whirling_bodies),
    PlotRow("lumped_motion.svg", (has_file("lumped.csv"),), lumped.draw_motion,
            "Motion of the lumped model at the speed of operation.", "Lumped model"),
    PlotRow("lumped_response.svg", (has_file("lumped.csv"), has_file("resonance.csv")),
            lumped.draw_response, "Response of the lumped model over speed.", "Lumped model"),
    PlotRow("reduced_response.svg", (has_file("resonance.csv"), has_file("wave_response.csv")),
            speed_response.draw_reduced_response,
            "Response of the reduced pair over speed, each speed from the motion at the one before.",
            "Response over speed", data="resonance.csv"),
    PlotRow("wave_response.svg", (has_file("wave_response.csv"),), speed_response.draw_wave_response,
            "Waves of the rim over speed: where a mesh order meets one, it runs.", "Response over speed",
            data="wave_response.csv"),
    PlotRow("stress_response.svg", (has_file("stress_response.csv"),), speed_curves.draw_stress_response,
            "Stresses over speed: largest of all sectors, and without vibration.", "Response over speed",
            data="stress_response.csv"),
    PlotRow("waves_met.svg", (has_file("waves_frequencies.csv"),), driven_waves.draw_waves_met,
            "Frequencies of the web's waves over speed, less or more the turn of the gear, and mesh orders. Thin lines: the gear by "
            "itself; thick lines: in contact. Points: all resonances in contact, stars: the swing. Circles: waves asked for; discs: "
            "amplitudes of the rim where they were driven.", "Travelling waves",
            data="waves_frequencies.csv, waves_lines.csv, waves_in_contact.csv"),
    PlotRow("driven_waves.svg", (has_file("waves_response.csv"),), driven_waves.draw_driven_waves,
            "Driven waves of the rim around their speeds. Vertical: where the mesh order meets the wave of the free gear.",
            "Travelling waves", data="waves_response.csv"),
    PlotRow("waves_build_up.svg", (has_file("waves_build_up.csv"),), driven_waves.draw_growth,
            "Driven waves from the equilibrium on, at the speeds of their lines.", "Travelling waves",
            data="waves_build_up.csv"),
)

# Of a study: all its runs on shared axes.
STUDY_PLOTS = (
    PlotRow("static_curve.svg", (has_static_curve,), draw_static_curve,
            "Transmission error of the run beside that of the static pair in the same positions.", "Comparison ledger"),
    PlotRow("error_bars.svg", (has_error_bars,), draw_error_bars,
            "Quantities of all variants with their numerical errors; crosses: without a known error.", "Error bars",
            data="error_bars.csv, differences.csv"),
    PlotRow("speed_curves.svg", (has_responses,), speed_curves.draw_speed_curves,
            "Responses of all variants over speed, rising; dots: where each is largest.", "Responses over speed",
            data="resonance.csv, stress_response.csv of each variant"),
    PlotRow("resonance.svg", (has_speeds,), draw_resonance,
            "Ripple of transmission error and contact force over speed, beside those of other models where there are any. Circles: runs "
            "without steady part or with a ripple that is not steady. Vertical lines: a mesh order meets a coupled mode.", "Over what is varied"),
    PlotRow("waterfall_dte.svg", (has_speeds,), partial(draw_waterfall, column=TRANSMISSION_ERROR),
            "Spectra of the transmission error at each speed (Hann's window, whole meshes of the steady "
            "part); rows are equally far from each other whatever the speeds.", "Over what is varied"),
    PlotRow("waterfall_force.svg", (has_speeds,), partial(draw_waterfall, column=CONTACT_FORCE),
            "Spectra of the contact force at each speed.", "Over what is varied"),
    PlotRow("curves.svg", (has_axis,), draw_curves,
            "Key figures of the runs over what is varied.", "Over what is varied"),
    PlotRow("dte.svg", (has_pairs,), partial(comparisons.draw_histories, column=TRANSMISSION_ERROR),
            "Dynamic transmission error of all variants: means over a mesh cycle for the whole run, and "
            "the last mesh cycles as they are.", "Transmission error"),
    PlotRow("dte_spectra.svg", (has_pairs,),
            partial(comparisons.draw_spectra, column=TRANSMISSION_ERROR),
            "Spectra of the transmission error, whole mesh cycles of the steady part.",
            "Transmission error"),
    PlotRow("contact_force.svg", (has_pairs,), partial(comparisons.draw_histories, column=CONTACT_FORCE),
            "Total contact force of all variants, in the same way.", "Contact"),
    PlotRow("force_spectra.svg", (has_pairs,), partial(comparisons.draw_spectra, column=CONTACT_FORCE),
            "Spectra of the contact force.", "Contact"),
    PlotRow("contact_patterns.svg", (has_patterns,), tooth_contact.draw_contact_patterns,
            "Contact patterns on the drive flanks over one mesh cycle, each over its own largest pressure. Dots: nodes; a cross, of a "
            "loaded tooth contact analysis: the centre.",
            "Contact"),
    PlotRow("tooth_stress.svg", (has_pairs_with("teeth", "hertz pressure"),),
            comparisons.draw_tooth_stress,
            "Contact stress of one tooth pair from its first to its last touch.", "Stresses"),
    PlotRow("probes.svg", (has_pairs_with("probes"),), comparisons.draw_probes,
            "Von Mises stress at the probes, time from the peak.", "Stresses"),
    PlotRow("rim_content.svg", (has_pairs_with("rim"),), comparisons.draw_rim_content,
            "Motion of the rim by nodal diameters: the pattern that stands in space with the load, and "
            "what moves besides.", "Motion of the rim"),
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
