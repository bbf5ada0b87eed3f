// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_touch_rows_h
#define vfife_reduced_touch_rows_h

#include <vfife/fem/cyclic/roots_of_unity.h>
#include <vfife/reduced/reduced_body.h>

#include <complex>
#include <map>
#include <utility>
#include <vector>

namespace vfife
{
  /** Along what the rows of rings are. */
  struct RingAxes
  {
    Matrix3 placement = Matrix3::Identity(); ///< of the body: turns its frame into that of the rows
    double  arm       = 1; ///< turns are counted as ways there, moments as forces [mm]
  };

  /**
   * Nodes of a reduced body that may touch now, on some of its sectors, as rows: three each, along
   * the axes of the body frame turned with the node's sector; behind them six of each ring that is
   * the seat of a bearing. What forces there do to the modes, what the modes are there, and how far
   * the rows give way at once.
   */
  class TouchRows
  {
  public:
    /** @p gains: what a modal force does at once to the coordinates of its harmonic, in the order
     * of ReducedBody::harmonics. The body must outlive the object. */
    TouchRows(const ReducedBody &body, std::vector<Eigen::MatrixXcd> gains, RingAxes axes = {});

    /** From now on modal forces do this at once. */
    void set_gains(std::vector<Eigen::MatrixXcd> gains);

    /** The nodes of the body, sorted. Throws NumericalError where one is none that forces may act
     * on. */
    void set_nodes(const std::vector<unsigned int> &nodes);

    Eigen::Index n_rows() const
    {
      return flexibility_.rows();
    }

    /** Displacements at the rows, at once, under unit forces at them [mm/N]. */
    const Eigen::MatrixXd &flexibility() const
    {
      return flexibility_;
    }

    /** Displacements of any touch @p nodes of the body (3 each, sorted, axes as of rows): of the
     * state of spin times @p spin, of modes, and at once by forces at the rows and an axial load
     * [mm]. */
    Eigen::VectorXd displace_nodes(const std::vector<unsigned int>     &nodes,
                                   double                               spin,
                                   const AxialLoad                     &axial,
                                   const std::vector<Eigen::VectorXcd> &coordinates,
                                   const Eigen::VectorXd               &forces) const;

    /** Of coordinates of all harmonics [mm]. */
    Eigen::VectorXd displace(const std::vector<Eigen::VectorXcd> &coordinates) const;
    /** Modal forces of forces at the rows. */
    std::vector<Eigen::VectorXcd> project(const Eigen::VectorXd &forces) const;

    /** In the state of spin at the body's rate [mm]. */
    const Eigen::VectorXd &spin() const
    {
      return spin_;
    }
    /** Under an axial load, less what the modes do [mm]. */
    Eigen::VectorXd under(const AxialLoad &load) const
    {
      return load.torque * torque_ + load.acceleration * euler_;
    }
    /** The same under a unit torque [1/N]. */
    const Eigen::VectorXd &torque() const
    {
      return torque_;
    }

    /** A reading of the body on a sector, without that of its spin: in modes, and at once by forces
     * at the rows and an axial load. */
    double read(unsigned int                         reading,
                unsigned int                         sector,
                const std::vector<Eigen::VectorXcd> &coordinates,
                const Eigen::VectorXd               &forces,
                const AxialLoad                     &axial) const;
    /** Its sum over all sectors. */
    double read_all(unsigned int                         reading,
                    const std::vector<Eigen::VectorXcd> &coordinates,
                    const Eigen::VectorXd               &forces,
                    const AxialLoad                     &axial) const;
    /** Its sum over the sectors k times exp(i n k alpha), 0 < n < N/2. */
    std::complex<double> read_wave(unsigned int                         reading,
                                   unsigned int                         n,
                                   const std::vector<Eigen::VectorXcd> &coordinates,
                                   const Eigen::VectorXd               &forces);

    /** Displacement [mm] and turn [rad] of a ring, along the placed axes: of the state of spin
     * times @p spin, of modes, and at once by forces at the rows and an axial load. */
    Eigen::Matrix<double, 6, 1> read_ring(unsigned int                         ring,
                                          double                               spin,
                                          const std::vector<Eigen::VectorXcd> &coordinates,
                                          const Eigen::VectorXd               &forces,
                                          const AxialLoad                     &axial) const;

    /** Turns the body frame into the axes of the rows of rings. */
    const Matrix3 &placement() const
    {
      return placement_;
    }

    /** Rows of the seats of bearings. */
    Eigen::Index n_ring_rows() const
    {
      return 6 * body_.rings.n_bearings;
    }

  private:
    /** Consecutive rows on one sector. */
    struct Run
    {
      unsigned int              sector = 0;
      Eigen::Index              first  = 0; ///< row
      std::vector<unsigned int> places;     ///< among ReducedBody::touch_nodes
    };

    /** From sector b to sector a, -N/2 < d <= N/2. */
    int                    distance(unsigned int a, unsigned int b) const;
    const Eigen::MatrixXd &find_block(int distance);
    void                   fill_flexibility();
    void                   fill_rings();
    /** Forces at the rows of rings, as loads in the body frame on all rings. */
    Eigen::VectorXd ring_loads(const Eigen::VectorXd &forces) const;
    Eigen::Index    reading_row(unsigned int reading) const;
    /** What the waves of a reading are under unit forces at the touch nodes of sector 0. */
    const Eigen::RowVectorXcd &find_wave(unsigned int reading, unsigned int n);

    const ReducedBody             &body_;
    RootsOfUnity                   phase_;
    std::vector<Eigen::MatrixXcd>  gains_;
    Matrix3                        placement_;
    Eigen::MatrixXd                to_rows_;  ///< motions of all rings to rows of bearings' seats
    std::vector<unsigned int>      place_of_; ///< of the nodes of a sector among the touch nodes
    std::map<int, Eigen::MatrixXd> blocks_;   ///< by distance, at all touch nodes of both sectors
    std::map<std::pair<unsigned int, unsigned int>, Eigen::RowVectorXcd> waves_; ///< reading, n
    std::vector<Run>                                                     runs_;
    /** Of all harmonics, a column a row: real parts, and behind them minus the imaginary ones, so
     * that a real product is what complex coordinates displace. */
    Eigen::MatrixXd shapes_;
    Eigen::MatrixXd flexibility_;
    Eigen::VectorXd spin_, torque_, euler_;
  };
} // namespace vfife

#endif
