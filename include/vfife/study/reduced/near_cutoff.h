// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_reduced_near_cutoff_h
#define vfife_study_reduced_near_cutoff_h

#include <vfife/output/files/figures.h>

#include <vector>

namespace vfife
{
  class Log;
  class Table;
  struct RunSummary;
  struct Transmission;

  /** An order of the gear mesh in samples of a quantity. */
  struct MeshOrderContent
  {
    unsigned int order        = 0; ///< times the mesh frequency; 0: there is none
    double       peak_to_peak = 0; ///< in the quantity's unit
  };

  /**
   * The strongest order of the gear mesh from @p first_order up to half the sampling rate, by
   * Fourier's sum over the whole mesh cycles among the samples.
   *
   * @param samples          equally spaced
   * @param samples_per_mesh samples in one mesh cycle, > 1
   */
  MeshOrderContent find_strongest_order(const std::vector<double> &samples,
                                        unsigned int               samples_per_mesh,
                                        unsigned int               first_order);

  /**
   * Orders of the gear mesh above half the cut-off of reduced bodies: there their vibrations are
   * not those of the meshes (doc/reference/kinds.md, reduced). What a transmission error has of
   * them is said beside it.
   */
  class NearCutoff
  {
  public:
    /** @p cutoff: of the bodies' modes [Hz]. */
    explicit NearCutoff(double cutoff);

    /** Looks at a transmission error [arcsec] over whole mesh cycles at @p speed of the driver
     * [rpm] and a mesh frequency [Hz], whose peak to peak value is stated as @p stated [arcsec]. */
    void look(const std::vector<double> &errors,
              unsigned int               samples_per_mesh,
              double                     mesh_frequency,
              double                     speed,
              double                     stated);

    /** Warns of the largest share that was seen, if it is one, and adds it to @p figures. */
    void tell(NamedFigures &figures, Log &log) const;

    /** Share of the stated peak to peak value from which on an order is told. */
    static constexpr double told_share = 0.05;

  private:
    double           cutoff_;
    MeshOrderContent largest_;
    double           mesh_frequency_ = 0, speed_ = 0, stated_ = 0, share_ = 0;
  };

  /** Tells it of the steady part of a @p history at one speed, if there is one. */
  void tell_near_cutoff(
    const Table &history, const Transmission &pair, double cutoff, RunSummary &summary, Log &log);
} // namespace vfife

#endif
