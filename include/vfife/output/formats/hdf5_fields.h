// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_formats_hdf5_fields_h
#define vfife_output_formats_hdf5_fields_h

#include <vfife/output/formats/vtu_writer.h>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * Adds @p grid at @p time [s] to the HDF5 file @p path as the instant @p number; 0 begins a new
   * file. Its groups:
   * - mesh: cells (corners in VTK's order) and their data, of instant 0;
   * - instants/00003: attribute time, points [mm], and point data with the attribute unit.
   * The file is closed again, so that others can read it between two instants and after a run that
   * was killed. Throws std::runtime_error where the disk does not take it, or without HDF5.
   */
  void write_hdf5_instant(const std::string &path,
                          const VtuGrid     &grid,
                          unsigned int       number,
                          double             time);

  /** Removes the instants from @p number on. Throws std::runtime_error for a file that is damaged
   * or not there. */
  void remove_hdf5_instants(const std::string &path, unsigned int number);

  /**
   * Writes the XDMF file that shows ParaView the instants 0, 1, ... of @p times [s] in the HDF5
   * file @p name of the same folder, which have @p n_points points, @p n_cells cells and the arrays
   * of @p arrays (values are not looked at).
   */
  void write_xdmf(std::ostream              &out,
                  const std::string         &name,
                  const VtuGrid             &arrays,
                  std::size_t                n_points,
                  std::size_t                n_cells,
                  const std::vector<double> &times);
} // namespace vfife

#endif
