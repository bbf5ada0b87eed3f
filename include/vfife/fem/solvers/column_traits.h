// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_solvers_column_traits_h
#define vfife_fem_solvers_column_traits_h

// How Anasazi's eigenvalue solvers see Columns and ColumnOperator; names are Anasazi's. For sources
// that call Anasazi.
#include <vfife/base/process/communicator.h>
#include <vfife/fem/solvers/columns.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <AnasaziConfigDefs.hpp>
#include <AnasaziMultiVecTraits.hpp>
#include <AnasaziOperatorTraits.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>
#include <ostream>

template <>
class Anasazi::MultiVecTraits<double, vfife::Columns>
{
  using Columns = vfife::Columns;
  using Index   = std::vector<int>; // of vectors
  using Pointer = Teuchos::RCP<Columns>;
  using Small   = Teuchos::SerialDenseMatrix<int, double>;

public:
  static Pointer Clone(const Columns &x, const int n)
  {
    return Teuchos::rcp(new Columns(x.communicator(), x.n_rows(), n));
  }
  static Pointer CloneCopy(const Columns &x)
  {
    const Pointer copy = Clone(x, x.n());
    Assign(x, *copy);
    return copy;
  }
  static Pointer CloneCopy(const Columns &x, const Index &index)
  {
    return CloneCopy(x.view(index));
  }
  static Pointer CloneViewNonConst(Columns &x, const Index &index)
  {
    return Teuchos::rcp(new Columns(x.view(index)));
  }
  static Teuchos::RCP<const Columns> CloneView(const Columns &x, const Index &index)
  {
    return Teuchos::rcp(new Columns(x.view(index)));
  }

  static std::ptrdiff_t GetGlobalLength(const Columns &x)
  {
    return x.communicator().sum(static_cast<unsigned int>(x.n_rows()));
  }
  static int GetNumberVecs(const Columns &x)
  {
    return x.n();
  }

  /** y = alpha x b + beta y; x and y may share memory. */
  static void MvTimesMatAddMv(
    const double alpha, const Columns &x, const Small &b, const double beta, Columns &y)
  {
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> small(
      b.values(), b.numRows(), b.numCols(), Eigen::OuterStride<>(b.stride()));
    Eigen::MatrixXd       copy;
    const Eigen::MatrixXd product = x.matrix(copy) * (alpha * small);
    for (std::size_t k = 0; k < y.n(); ++k)
      if (beta == 0)
        y[k] = product.col(k);
      else
        y[k] = product.col(k) + beta * y[k];
  }
  static void
  MvAddMv(const double alpha, const Columns &x, const double beta, const Columns &y, Columns &sum)
  {
    for (std::size_t k = 0; k < sum.n(); ++k)
      sum[k] = alpha * x[k] + beta * y[k];
  }
  /** b = alpha x^T y; b may be larger. */
  static void MvTransMv(const double alpha, const Columns &x, const Columns &y, Small &b)
  {
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(
      b.values(), x.n(), y.n(), Eigen::OuterStride<>(b.stride())) = alpha * x.products(y);
  }
  /** @p dots may be longer than the number of vectors. */
  static void MvDot(const Columns &x, const Columns &y, std::vector<double> &dots)
  {
    const std::vector<double> found = x.dot(y);
    std::copy(found.begin(), found.end(), dots.begin());
  }
  static void MvNorm(const Columns &x, std::vector<double> &norms)
  {
    const std::vector<double> squares = x.dot(x);
    std::transform(squares.begin(), squares.end(), norms.begin(), [](const double square) {
      return std::sqrt(square);
    });
  }

  static void SetBlock(const Columns &x, const Index &index, Columns &y)
  {
    for (std::size_t k = 0; k < index.size(); ++k)
      y[index[k]] = x[k];
  }
  static void Assign(const Columns &x, Columns &y)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      y[k] = x[k];
  }
  static void MvScale(Columns &x, const double factor)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      x[k] *= factor;
  }
  static void MvScale(Columns &x, const std::vector<double> &factors)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      x[k] *= factors[k];
  }
  /** Numbers in [-1, 1], other ones at each call. */
  static void MvRandom(Columns &x)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      x[k].setRandom();
  }
  static void MvInit(Columns &x, const double value = 0.)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      x[k].setConstant(value);
  }
  static void MvPrint(const Columns &x, std::ostream &out)
  {
    for (std::size_t k = 0; k < x.n(); ++k)
      out << x[k].transpose() << '\n';
  }
};

template <>
class Anasazi::OperatorTraits<double, vfife::Columns, vfife::ColumnOperator>
{
public:
  static void Apply(const vfife::ColumnOperator &A, const vfife::Columns &x, vfife::Columns &y)
  {
    A.apply(x, y);
  }
};

#endif
