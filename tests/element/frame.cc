// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Frames: rigid motions, balance of forces and moments, force as derivative of energy, numbering,
// series.
#include "../internal_force.h"
#include "../refusal.h"
#include "../tests.h"
#include "samples.h"

#include <vfife/element/frame.h>

#include <Eigen/LU>

using namespace vfife;

constexpr StiffnessKind kind = StiffnessKind::incompatible_modes;

/** What the kernel of the best instruction set gives for one element (in lane 3). */
struct KernelElement
{
  KernelElement(const HexahedronNodes &X, const FrameKind frame)
    : kernels(select_kernels(frame, best_instruction_set()))
  {
    packs.resize(1, 9);
    packs.nodes.assign(packs.nodes.size(), 8);
    packs.set_constants(0, 3, compute_reduced_stiffness(X, Material(), kind), Material());
    for (unsigned int a = 0; a < 8; ++a)
      packs.set_node(0, 3, a, a);
  }

  HexahedronNodes forces(const HexahedronNodes &x)
  {
    for (unsigned int a = 0; a < 8; ++a)
      packs.set_position(a, x.col(a));
    std::vector<double> records(36, 0.), energies(8, 0.), jacobians(8, 0.);
    kernels.measure_internal_forces(packs.view(),
                                    0,
                                    1,
                                    packs.positions.data(),
                                    records.data(),
                                    energies.data(),
                                    jacobians.data());
    energy = energies[3];
    HexahedronNodes f;
    for (unsigned int a = 0; a < 8; ++a)
      f.col(a) = SamplePacks::at(records, a);
    return f;
  }

  SamplePacks           packs;
  const ElementKernels &kernels;
  double                energy = 0.; ///< of the last call
};

double moment_defect(const HexahedronNodes &x, const HexahedronNodes &f)
{
  Vector3 moment = Vector3::Zero();
  for (unsigned int a = 0; a < 8; ++a)
    moment += (x.col(a) - x.col(0)).cross(f.col(a));
  return moment.norm() / (f.cwiseAbs().maxCoeff() * (x.col(7) - x.col(0)).norm());
}

/** Largest difference between the kernel's force and the derivative of its energy, relative. */
double derivative_defect(KernelElement &element, const HexahedronNodes &x)
{
  const HexahedronNodes f      = element.forces(x);
  const double          h      = 1e-4;
  double                defect = 0.;
  for (unsigned int a = 0; a < 8; ++a)
    for (unsigned int i = 0; i < 3; ++i)
      {
        double energy[4];
        int    at = 0;
        for (const double step : {-2. * h, -h, h, 2. * h})
          {
            HexahedronNodes moved = x;
            moved(i, a) += step;
            element.forces(moved);
            energy[at++] = element.energy;
          }
        const double derivative =
          (energy[0] - 8. * energy[1] + 8. * energy[2] - energy[3]) / (12. * h);
        raise_to(defect, std::abs(derivative + f(i, a)));
      }
  return defect / f.cwiseAbs().maxCoeff();
}

void check_frame(const FrameKind frame, const bool verbose)
{
  const std::string name = word_of(frame, frame_choices()) + ": ";
  Samples           samples;
  double            rigid = 0., rotation_error = 0., force_sum = 0., objectivity = 0.;
  double            moment[2] = {0., 0.}, derivative[2] = {0., 0.};
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      const HexahedronNodes X = samples.hexahedron({1., 2., 3.}, 0.15, {60., 50., 40.});
      const Matrix24        K = compute_stiffness(X, Material(), kind);
      KernelElement         element(X, frame);
      const double          scale = K.cwiseAbs().maxCoeff() * 100.;

      const Matrix3         Q     = samples.rotation();
      const HexahedronNodes moved = (Q * X).colwise() + 10. * samples.vector();
      raise_to(rotation_error, (compute_frame(frame, X, moved) - Q).cwiseAbs().maxCoeff());
      rigid =
        largest_of({rigid,
                    element.forces(moved).cwiseAbs().maxCoeff() / scale,
                    compute_internal_forces(K, X, moved, frame).cwiseAbs().maxCoeff() / scale});
      unsigned int order = 0;
      for (const double strain : {1e-3, 1e-2})
        {
          const HexahedronNodes x =
            (Q * (X + samples.displacement(0.5 * strain))).colwise() - Q * X.col(0);
          const HexahedronNodes f = element.forces(x);
          raise_to(force_sum, f.rowwise().sum().cwiseAbs().maxCoeff() / f.cwiseAbs().maxCoeff());
          const Matrix3 turn = samples.rotation();
          raise_to(objectivity,
                   (element.forces(turn * x) - turn * f).cwiseAbs().maxCoeff() /
                     f.cwiseAbs().maxCoeff());
          raise_to(moment[order], moment_defect(x, f));
          raise_to(derivative[order], derivative_defect(element, x));
          ++order;
        }
    }
  if (verbose)
    std::cout << name << rotation_error << ' ' << rigid << ' ' << force_sum << ' ' << objectivity
              << " moment " << moment[0] << ' ' << moment[1] << " derivative " << derivative[0]
              << ' ' << derivative[1] << std::endl;
  check_below(name + "a rigid rotation is found", rotation_error, 1e-12);
  // Coordinates of 100 mm carry 1e-14 mm.
  check_below(name + "a rigid motion gives no force", rigid, 1e-15);
  check_below(name + "forces sum to zero", force_sum, 1e-14);
  check_below(name + "forces turn with the element", objectivity, 1e-10);
  if (frame == FrameKind::polar)
    {
      check_below(name + "moments sum to zero", largest_of(moment[0], moment[1]), 1e-10);
      // Round-off of the energy over the step of the difference formula.
      check_below(name + "force is the derivative of the energy",
                  largest_of(derivative[0], derivative[1]),
                  1e-8);
    }
  else
    {
      // Published form: both are defects of the order of the strain, and not less.
      for (const auto &defect : {moment, derivative})
        {
          const std::string what = defect == moment ? "moment" : "energy derivative";
          check_below(name + what + " defect at strain 1e-3", defect[0], 1e-2);
          check(name + what + " defect grows with the strain",
                defect[1] > 5. * defect[0] && defect[1] < 20. * defect[0]);
        }
    }
}

/** Same element, nodes numbered from another corner (turned by 90 degrees about zeta). */
void check_numbering(const bool verbose)
{
  const unsigned int renumbered[8] = {1, 3, 0, 2, 5, 7, 4, 6};
  Samples            samples;
  double             difference[n_frame_kinds] = {0., 0.}, between_frames = 0.;
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      const HexahedronNodes X = samples.hexahedron({1., 2., 3.}, 0.15);
      const HexahedronNodes x = X + samples.displacement(0.5e-3);
      HexahedronNodes       X_other, x_other;
      for (unsigned int a = 0; a < 8; ++a)
        {
          X_other.col(a) = X.col(renumbered[a]);
          x_other.col(a) = x.col(renumbered[a]);
        }
      HexahedronNodes by_frame[n_frame_kinds];
      for (const FrameKind frame : {FrameKind::polar, FrameKind::three_nodes})
        {
          HexahedronNodes f     = KernelElement(X, frame).forces(x);
          HexahedronNodes other = KernelElement(X_other, frame).forces(x_other);
          const auto      row   = static_cast<unsigned int>(frame);
          by_frame[row]         = f;
          for (unsigned int a = 0; a < 8; ++a)
            raise_to(difference[row],
                     (other.col(a) - f.col(renumbered[a])).cwiseAbs().maxCoeff() /
                       f.cwiseAbs().maxCoeff());
        }
      raise_to(between_frames,
               (by_frame[0] - by_frame[1]).cwiseAbs().maxCoeff() /
                 by_frame[0].cwiseAbs().maxCoeff());
    }
  if (verbose)
    std::cout << "numbering " << difference[0] << ' ' << difference[1] << " between frames "
              << between_frames << std::endl;
  check_below("polar: numbering does not matter", difference[0], 1e-11);
  check("three nodes: numbering matters by the order of the strain",
        difference[1] > 1e-5 && difference[1] < 1e-2);
  check("the frames differ by the order of the strain",
        between_frames > 1e-5 && between_frames < 1e-2);
}

/** The polar kernel, series and exact rotation, against the exact reference, over strain. */
void check_series(const bool verbose)
{
  for (const double strain : {1e-3, 1e-2, 2e-2, 5e-2, 1e-1, 2e-1, 5e-1})
    {
      Samples samples;
      double  error = 0.;
      for (unsigned int sample = 0; sample < 50; ++sample)
        {
          const HexahedronNodes X = samples.hexahedron({1., 1., 1.}, 0.1);
          Matrix3               gradient;
          gradient << samples.vector(), samples.vector(), samples.vector();
          // Stretches of 1 + strain at most, and some hourglass motion.
          const Matrix3 stretch = 0.5 * (gradient + gradient.transpose()) /
                                  (0.5 * (gradient + gradient.transpose())).norm() * strain;
          const HexahedronNodes x =
            samples.rotation() * (X + stretch * X + samples.displacement(0.1 * strain));
          const Matrix24        K        = compute_stiffness(X, Material(), kind);
          const HexahedronNodes expected = compute_internal_forces(K, X, x, FrameKind::polar);
          raise_to(error,
                   (KernelElement(X, FrameKind::polar).forces(x) - expected).cwiseAbs().maxCoeff() /
                     expected.cwiseAbs().maxCoeff());
        }
      if (verbose)
        std::cout << "series " << strain << ' ' << error << std::endl;
      // Round-off over the strain, and up to |E| = 1/50 the first term that the series leaves
      // out, 95 E^9, over the strain; beyond, the rotation is not a series any more.
      const double left_out = strain <= .02 ? 95. * std::pow(strain, 8) : 0.;
      check_below("rotation of the polar kernel at strain " + std::to_string(strain).substr(0, 5),
                  error,
                  2e-14 / strain + left_out);
    }
}

int main(int argc, char **)
{
  const bool verbose = argc > 1;
  for (const auto &choice : frame_choices())
    check_frame(choice.second, verbose);
  check_numbering(verbose);
  check_series(verbose);

  Samples               samples;
  const HexahedronNodes X       = samples.hexahedron({1., 1., 1.}, 0.);
  unsigned int          refused = 0;
  for (const FrameKind frame : {FrameKind::polar, FrameKind::three_nodes})
    refused += refuses<NumericalError>([&] { compute_frame(frame, X, HexahedronNodes::Zero()); });
  check("an element shrunk to a point has no frame", refused == 2);
  return 0;
}
