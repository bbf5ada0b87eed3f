// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/number_text.h>
#include <vfife/bearing/shaft_seat.h>
#include <vfife/model/model.h>
#include <vfife/model/options/bearing_options.h>

#include <Eigen/Eigenvalues>

#include <sstream>

namespace vfife
{
  namespace
  {
    constexpr const char *matrix_form =
      "25 numbers, row by row, over displacements along x, y, z [mm] and tilts about x, y [rad]; "
      "forces in N, moments in N mm";

    /** Of the numbers in an entry. */
    Matrix5 read_matrix(const std::string &text, const std::string &entry)
    {
      std::string plain = text;
      for (char &letter : plain)
        if (letter == ',' || letter == ';')
          letter = ' ';
      std::istringstream stream(plain);
      Matrix5            matrix;
      unsigned int       n = 0;
      for (std::string word; stream >> word; ++n)
        {
          const std::optional<double> number = plain_number(word);
          if (!number)
            throw InputError(entry,
                             "expected " + std::string(matrix_form) + ", got \"" + word + "\"");
          if (n < 25)
            matrix(n / 5, n % 5) = *number;
        }
      if (n != 25)
        throw InputError(entry,
                         "expected " + std::string(matrix_form) + ", got " + std::to_string(n) +
                           " numbers");
      return matrix;
    }

    void check_matrix(const Matrix5 &matrix, const std::string &entry)
    {
      // In units of its diagonal, as forces and moments have different ones.
      Vector5 scale = matrix.diagonal().cwiseAbs().cwiseSqrt();
      for (unsigned int i = 0; i < 5; ++i)
        if (scale[i] == 0)
          scale[i] = 1;
      const Matrix5 pure =
        scale.cwiseInverse().asDiagonal() * matrix * scale.cwiseInverse().asDiagonal();
      if ((pure - pure.transpose()).cwiseAbs().maxCoeff() > 1e-6)
        throw InputError(entry, "the stiffness matrix must be symmetric");
      if (Eigen::SelfAdjointEigenSolver<Matrix5>(.5 * (pure + pure.transpose()))
            .eigenvalues()
            .minCoeff() < -1e-9)
        throw InputError(entry, "the stiffness matrix must be positive semidefinite");
    }

    Matrix5 diagonal(const double radial, const double axial, const double tilting)
    {
      Vector5 values;
      values << radial, radial, axial, tilting, tilting;
      return values.asDiagonal();
    }
  } // namespace

  void SeatOptions::declare(dealii::ParameterHandler &prm)
  {
    const Range range = Range::not_negative();
    declare_quantity(prm,
                     "radial damping",
                     radial_damping,
                     "N s/mm",
                     "Coefficient along x and y, across the axis",
                     range);
    declare_quantity(
      prm, "axial damping", axial_damping, "N s/mm", "Coefficient along the axis", range);
    declare_quantity(prm,
                     "tilting damping",
                     tilting_damping,
                     "N mm s/rad",
                     "Coefficient against tilts about x and y",
                     range);
    declare_vector(prm,
                   "x direction",
                   x_direction,
                   "-",
                   "Direction of x in the fixed frame, projected normal to the axis; 0, 0, 0: "
                   "arbitrary, sufficient for an axisymmetric bearing");
  }

  Matrix5 SeatOptions::damping() const
  {
    return diagonal(radial_damping, axial_damping, tilting_damping);
  }

  Matrix3 SeatOptions::make_axes(const Axis &axis, const std::string &section) const
  {
    if (axis.direction.cross(x_direction).norm() < 1e-6 * x_direction.norm())
      throw InputError(section + "/x direction", "must not be parallel to the axis of the body");
    return axes_along(axis.direction, x_direction);
  }

  void BearingOptions::declare(dealii::ParameterHandler &prm)
  {
    const Range range = Range::not_negative();
    declare_quantity(prm,
                     "radial stiffness",
                     radial_stiffness,
                     "N/mm",
                     "Coefficient along x and y, across the axis",
                     range);
    declare_quantity(
      prm, "axial stiffness", axial_stiffness, "N/mm", "Coefficient along the axis", range);
    declare_quantity(prm,
                     "tilting stiffness",
                     tilting_stiffness,
                     "N mm/rad",
                     "Coefficient against tilts about x and y",
                     range);
    seat.declare(prm);
    declare_text(prm,
                 "stiffness matrix",
                 stiffness_matrix,
                 std::string("Instead of the three stiffnesses: ") + matrix_form);
    declare_text(prm,
                 "damping matrix",
                 damping_matrix,
                 std::string("Instead of the three dampings: ") + matrix_form + ", per second");
    declare_vector(
      prm, "preload", preload, "N", "Force on the undisplaced shaft along x, y, z of the bearing");
  }

  void BearingOptions::check(const std::string &section) const
  {
    const bool has_numbers = radial_stiffness > 0 || axial_stiffness > 0 || tilting_stiffness > 0;
    const bool has_damping = !seat.damping().isZero(0.);
    if (!stiffness_matrix.empty() && has_numbers)
      throw InputError(
        section + "/stiffness matrix",
        "expected a stiffness matrix or radial, axial and tilting stiffness, got both");
    if (!damping_matrix.empty() && has_damping)
      throw InputError(section + "/damping matrix",
                       "expected a damping matrix or radial, axial and tilting damping, got both");
    if (stiffness_matrix.empty() && !has_numbers)
      throw InputError(section + "/radial stiffness", "at least one stiffness must be positive");
    make_law(section);
  }

  std::shared_ptr<const BearingLaw> BearingOptions::make_law(const std::string &section) const
  {
    Matrix5 stiffness = diagonal(radial_stiffness, axial_stiffness, tilting_stiffness);
    Matrix5 damping   = seat.damping();
    if (!stiffness_matrix.empty())
      {
        stiffness = read_matrix(stiffness_matrix, section + "/stiffness matrix");
        check_matrix(stiffness, section + "/stiffness matrix");
      }
    if (!damping_matrix.empty())
      {
        damping = read_matrix(damping_matrix, section + "/damping matrix");
        check_matrix(damping, section + "/damping matrix");
      }
    Vector5 load;
    load << preload, 0., 0.;
    return std::make_shared<LinearBearing>(stiffness, damping, load);
  }

  void RollingBearingOptions::declare(dealii::ParameterHandler &prm)
  {
    const Choices<RollingElement> elements = {{"ball", RollingElement::ball},
                                              {"roller", RollingElement::roller}};
    declare_choice(prm,
                   "element",
                   data.element,
                   elements,
                   "Type of rolling element: ball (deep groove; angular contact if there is a "
                   "contact angle) or roller (cylindrical; tapered if there is a contact angle)");
    declare_integer(
      prm, "number of elements", data.n, "Number of rolling elements in one row", 0, 10000);
    declare_quantity(prm,
                     "element diameter",
                     data.diameter,
                     "mm",
                     "Diameter of a ball, or mean diameter of a roller",
                     Range::not_negative());
    declare_quantity(prm,
                     "element length",
                     data.length,
                     "mm",
                     "Length of a roller's line of contact",
                     Range::not_negative());
    declare_quantity(prm,
                     "pitch diameter",
                     data.pitch_diameter,
                     "mm",
                     "Diameter of the circle through the centres of the rolling elements",
                     Range::not_negative());
    declare_quantity(prm,
                     "contact angle",
                     data.contact_angle,
                     "deg",
                     "Contact angle without load: between the line of contact and the plane normal "
                     "to the axis",
                     Range::between(0, 80));
    declare_quantity(
      prm, "clearance", data.clearance, "mm", "Diametral clearance; negative: interference");
    declare_number(prm,
                   "inner conformity",
                   data.inner_conformity,
                   "Radius of the inner groove divided by the ball diameter",
                   Range::positive());
    declare_number(prm,
                   "outer conformity",
                   data.outer_conformity,
                   "Radius of the outer groove divided by the ball diameter",
                   Range::positive());
    const Choices<double> senses = {{"+z", 1.}, {"-z", -1.}};
    declare_choice(prm,
                   "axial load direction",
                   data.sense,
                   senses,
                   "Direction of the shaft's axial force that a bearing with a contact angle "
                   "supports, along the axis z or against it");
    declare_quantity(prm,
                     "cage angle",
                     data.cage_angle,
                     "deg",
                     "Angle of the first rolling element at time zero, from x");
    const Choices<bool> cages = {{"fixed", false}, {"rolling", true}};
    declare_choice(
      prm,
      "cage",
      data.cage_rolls,
      cages,
      "fixed: the cage is at rest; rolling: the elements roll on a fixed outer ring, in "
      "runs and in loaded tooth contact analyses");
    declare_quantity(prm,
                     "preload",
                     data.preload,
                     "N",
                     "Axial force of the bearing with the undisplaced shaft",
                     Range::not_negative());
    declare_vector(prm,
                   "working load",
                   data.working_load,
                   "N",
                   "Force on the bearing along its x, y, z, at which linear studies take its "
                   "stiffness; 0, 0, 0: stiffness of the undisplaced shaft");
    seat.declare(prm);
  }

  std::shared_ptr<const BearingLaw>
  RollingBearingOptions::make_law(const std::string &section) const
  {
    try
      {
        return std::make_shared<RollingBearing>(data, seat.damping());
      }
    catch (const InputError &error)
      {
        throw InputError(section + "/" + error.entry(), error.what());
      }
  }

  void AnyBearingOptions::declare(const bool rolls, dealii::ParameterHandler &prm)
  {
    if (rolls)
      rolling.declare(prm);
    else
      linear.declare(prm);
  }

  void AnyBearingOptions::check(const bool rolls, const std::string &section) const
  {
    if (rolls)
      rolling.make_law(section);
    else
      linear.check(section);
  }

  void AnyBearingOptions::add_to(Model                    &model,
                                 const bool                rolls,
                                 const std::string        &name,
                                 const unsigned int        b,
                                 std::vector<unsigned int> nodes,
                                 const std::string        &section) const
  {
    // What holds the axis gives way: the body's rigid motion is no longer the turn alone.
    Body &body  = model.bodies[b];
    body.floats = true;
    model.bearings.push_back({name,
                              b,
                              std::move(nodes),
                              (rolls ? rolling.seat : linear.seat).make_axes(body.axis, section),
                              rolls ? rolling.make_law(section) : linear.make_law(section)});
  }

  void CouplingOptions::declare(dealii::ParameterHandler &prm)
  {
    declare_quantity(prm,
                     "torsional stiffness",
                     stiffness,
                     "N mm/rad",
                     "Torsional stiffness between the rotation at the body's speed and the mean "
                     "rotation of the nodes. The default twists by 206 arcsec per kN m and affects "
                     "torsional frequencies: enter the stiffness of the drive, or 1e12 for a rigid "
                     "one",
                     Range::positive());
    declare_quantity(prm,
                     "torsional damping",
                     damping,
                     "N mm s/rad",
                     "Torsional damping between the same rotations",
                     Range::not_negative());
  }
} // namespace vfife
