// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_output_options_h
#define vfife_output_output_options_h

#include <vfife/base/parameter_handler.h>
#include <vfife/base/process/log.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vfife
{
  struct Transmission;

  /** Files of fields at instants. */
  enum class FieldFormat
  {
    vtu, ///< a file an instant (and rank)
    hdf5 ///< one file, with XDMF beside it
  };

  /** "0", "2", "3"... as numbers of nodal diameters. Throws InputError for what is none. */
  std::vector<unsigned int> parse_diameters(const std::vector<std::string> &texts);

  /** Section Output: how often which file is written. */
  struct OutputOptions
  {
    /** Whether the case is a model without a gear pair: its histories count steps. */
    bool of_model = false;
    /** Samples per mesh cycle; of a model: steps per sample. */
    unsigned int history_every = 50;
    /** Mesh cycles (of a model: samples) between field files, 0: none. */
    double      fields_every = 5;
    FieldFormat field_format = FieldFormat::vtu;
    /** Orders of the gear mesh that are tracked where the speed changes, 0: none; and mesh cycles
     * in a window. */
    unsigned int mesh_orders = 5, order_window = 8;
    /** Of gear pairs: nodal diameters whose waves of stress over the driven body's sectors are
     * written. */
    std::vector<std::string> stress_waves;
    /** Wall time between checkpoints [s], 0: none. */
    double checkpoint_every = 600;
    /** Whether plots and pictures are drawn at the end. */
    bool      pictures  = true;
    Verbosity verbosity = Verbosity::normal;

    void declare(dealii::ParameterHandler &prm);
    /** The name under which history_every is declared. */
    std::string history_entry() const;
    /** Throws InputError when the entries contradict each other. */
    void check(const std::string &section) const;
    /** Throws InputError for waves of stress that are asked for, of a model without a gear pair. */
    void refuse_stress_waves(const std::string &section) const;

    /** mesh_orders, as far as the samples tell them: with at least four in a period. */
    unsigned int count_tracked_orders() const;

    /**
     * Steps between samples of the histories for a step of @p dt [s]: as many as fit into a tooth
     * mesh divided by history_every, at least 1; history_every itself without @p transmission
     * (nullptr).
     */
    std::uint64_t compute_history_steps(const Transmission *transmission, double dt) const;

    /** Steps between field files, a multiple of the history's; 0: no fields. */
    std::uint64_t compute_field_steps(const Transmission *transmission, double dt) const;
  };
} // namespace vfife

#endif
