// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_ring_parts_h
#define vfife_reduced_ring_parts_h

#include <vfife/fem/cyclic/cyclic_harmonic.h>
#include <vfife/reduced/reduced_body.h>

#include <array>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;

  /** Names, centres, springs and inertia of the rings of a body, and where they are in the state of
   * spin; returns six rows a ring, of its part in sector 0. */
  std::vector<SectorRow> describe_rings(const Model        &model,
                                        unsigned int        number,
                                        const CyclicBody   &body,
                                        double              rate,
                                        ReducedBody::Rings &rings);

  /**
   * What the harmonics 0 and 1 of a body give its rings. With a the axis and e = (x + i y)/sqrt(2)
   * across it, R e = e exp(-i alpha), a ring of N sectors moves by N Pi B z, B the part of sector
   * 0, Pi = a a^T for h = 0 and e e^H for h = 1, and loads w on it are forces B^T w_h on sector 0
   * with the phase h alpha from one sector to the next, w_0 = a a^T w, w_1 = 2 e e^H w, both of
   * displacements and turns alike (doc/theory/reduced.md, On bearings).
   */
  class RingParts
  {
  public:
    /** @p ring_rows: of describe_rings(), behind the other rows of the sector. All must outlive the
     * object. */
    RingParts(const CyclicBody             &body,
              const std::vector<SectorRow> &rows,
              const std::vector<SectorRow> &ring_rows)
      : body_(body)
      , rows_(rows)
      , ring_rows_(ring_rows)
    {
    }

    /** Sets Harmonic::rings, of which eigenvalues and shapes are known. */
    void
    add(const CyclicHarmonic &sector, const CyclicModes &modes, ReducedBody::Harmonic &harmonic);

    /** h = 0: under a torque and an angular acceleration about the axis. */
    void add_axial(const CyclicHarmonic &sector, const ReducedBody::Harmonic &harmonic);

    void pass(ByteStream &stream);
    /** Adds the parts. */
    void move_to(ReducedBody::Rings &rings);

  private:
    const CyclicBody               &body_;
    const std::vector<SectorRow>   &rows_, &ring_rows_;
    std::array<Eigen::MatrixXcd, 2> answers_;
    Eigen::MatrixXd                 residual_;
    Eigen::VectorXd                 torque_, euler_;
  };
} // namespace vfife

#endif
