// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_files_result_places_h
#define vfife_output_files_result_places_h

#include <string>

/**
 * Where numbers stand in .json files of results that are read again, as JSON pointers, for writers
 * and readers. At a place is a number, a switch or a figure {"value": , "unit": }; read_figure()
 * reads all three. All places of summary.json are in doc/columns.json.
 */
namespace vfife
{
  namespace summary_place
  {
    constexpr char status[]           = "/status";     ///< text: "finished", "failed"
    constexpr char failure[]          = "/failure";    ///< text
    constexpr char n_cells[]          = "/mesh/cells"; ///< of all bodies
    constexpr char time[]             = "/run/time";
    constexpr char steps[]            = "/run/steps";
    constexpr char run_time[]         = "/run/run time";
    constexpr char is_steady[]        = "/steady part/found";
    constexpr char is_ripple_steady[] = "/steady part/ripple/steady";
    constexpr char steady_start[]     = "/steady part/start";
    constexpr char energy_error[]     = "/energy/error";
    constexpr char n_contact_losses[] = "/contact losses/count";

    constexpr char nearest_wave[] = "/nearest wave"; ///< in words

    // What holds figures by their names.
    constexpr char figures[]            = "/figures";
    constexpr char transmission_error[] = "/transmission error"; ///< parts of the mean DTE
    constexpr char misalignment[]       = "/misalignment";       ///< of a pair on shafts
    constexpr char steady_columns[]     = "/steady part/columns";
    constexpr char probes[]             = "/probes"; ///< by name

    // Of a probe.
    constexpr char passes_mesh[]           = "time at the mean contact"; ///< [s]
    constexpr char largest_of_revolution[] = "largest per revolution";
    constexpr char median_of_revolution[]  = "median per revolution";

    /** When a probe passes the mesh. */
    std::string passage_of(const std::string &probe);

    /** A figure of the run, figure_name. */
    std::string figure(const std::string &name);

    /** A part of the transmission error, error_part. */
    std::string part_of_error(const std::string &name);

    /** A number of the misalignment, named as its column. */
    std::string misalignment_of(const std::string &column);

    /** Of a column of history.csv over the steady part. */
    std::string steady_mean(const std::string &column);
    std::string steady_peak_to_peak(const std::string &column);
  } // namespace summary_place

  /** Figures of the run of a gear pair. */
  namespace figure_name
  {
    constexpr char mesh_frequency[]      = "mesh frequency";
    constexpr char torsional_frequency[] = "torsional mode frequency, estimated";
    constexpr char effective_arm[]       = "effective lever arm"; ///< of the unloaded mean contact
    constexpr char least_arm[]           = "least lever arm on the path of contact";
    constexpr char largest_arm[]         = "largest lever arm on the path of contact";
    /** That the ripple needs to be steady. */
    constexpr char steady_meshes[] = "mesh cycles that a steady ripple needs";
    constexpr char force_on_arm[]  = "torque over effective lever arm"; ///< of the contact

    /** Of a reduced pair: the strongest mesh order above half the cut-off, and its peak to peak
     * value in the transmission error, where this is a noticeable part. */
    constexpr char order_near_cutoff[] = "mesh order near the cut-off";
    constexpr char error_near_cutoff[] = "transmission error near the cut-off";

    // What the springs of the contact points add to the excitation, peak to peak.
    constexpr char spring_error_at_rest[] = "transmission error by the contact points, at rest";
    constexpr char spring_error[]         = "transmission error by the contact points";
    constexpr char spring_force[]         = "contact force by the contact points";

    constexpr char degree_of_elements[] = "degree of the finite elements";

    /** Of Contact/penalty elements = quadratic. */
    constexpr char reference_error[] = "mean transmission error at rest, quadratic elements";

    // Of a sweep over speeds.
    constexpr char lowest_speed[]   = "lowest speed";
    constexpr char highest_speed[]  = "highest speed";
    constexpr char counted_meshes[] = "mesh cycles counted at each speed";

    /** Behind the name of a part of a gear body. */
    constexpr char stress_of_part[] = ", largest von Mises stress";

    constexpr char nearest_wave_speed[] = "speed of the nearest wave";
    constexpr char nearest_wave_distance[] =
      "distance of the speed of operation from the nearest wave";

    constexpr char on_own_grid[] = " on its own grid"; ///< behind the name of a pressure

    /** "pinion speed" */
    std::string speed_of(const std::string &body);

    /** "gear torque" */
    std::string torque_of(const std::string &body);
  } // namespace figure_name

  /** Parts of the transmission error at the start of a gear pair. */
  namespace error_part
  {
    constexpr char total[]              = "total at the start";
    constexpr char teeth_and_rest[]     = "teeth and rest";
    constexpr char web_windup[]         = "web windup";
    constexpr char rim_tilt_and_shift[] = "rim tilt and shift";
    constexpr char rim_bending[]        = "rim bending"; ///< of two and more nodal diameters
    constexpr char centrifugal_shift[]  = "centrifugal shift";
    constexpr char bearings[]           = "bearings";      ///< of pairs on shafts
    constexpr char shaft_bending[]      = "shaft bending"; ///< of pairs on shafts
  }                                                        // namespace error_part

  /** In lumped.json; names of members and where they lead to. */
  namespace lumped_place
  {
    constexpr char modes[]     = "modes";
    constexpr char frequency[] = "frequency [Hz]"; ///< of a mode
    constexpr char response[]  = "response"; ///< figures named as the columns of resonance.csv

    std::string first_frequency();
    std::string response_figure(const std::string &column);
  } // namespace lumped_place
} // namespace vfife

#endif
