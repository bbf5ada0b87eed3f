// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/communicator.h>
#include <vfife/fem/system/fem_system.h>

#include <algorithm>

namespace vfife
{
  FemSystem::FemSystem(const FemSpace                &space,
                       const FemConstraints::Options &options,
                       const Communicator            &communicator,
                       Links                          links,
                       const HousingLaw               housing)
    : space_(space)
    , communicator_(communicator)
    , constraints_(space, options, communicator.size())
    , first_(constraints_.first(communicator.rank()))
    , last_(constraints_.first(communicator.rank() + 1))
    , links_(std::move(links))
    // Rings join all sectors: an open one has none, as in harmonics beyond 1.
    , rings_(space, housing, options.open ? 2 : options.harmonic)
  {
    // Every rank knows all points and numbers all unknowns alike; it sums only the
    // rows that it owns. So no matrix entries are sent: elements at the border
    // between ranks are computed on both.
    find_elements();
    make_pattern();
  }

  void FemSystem::find_elements()
  {
    const unsigned int n_local = space_.points_per_element();
    const std::size_t  copy    = 3 * static_cast<std::size_t>(space_.n_points());
    for (unsigned int e = 0; e < space_.n_elements(); ++e)
      {
        // Every rank that owns an unknown of the element's points, in any copy of them, computes
        // it.
        bool mine = false;
        for (unsigned int a = 0; a < n_local && !mine; ++a)
          for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
            {
              const std::size_t row = k * copy + 3 * std::size_t(space_.element_points(e)[a]);
              for (unsigned int c = 0; c < 3; ++c)
                for (const auto &term : constraints_.line(row + c))
                  mine = mine || is_mine(term.first);
            }
        if (mine)
          elements_.push_back(e);
      }
  }

  void FemSystem::make_pattern()
  {
    const unsigned int n_local = space_.points_per_element();
    const std::size_t  copy    = 3 * static_cast<std::size_t>(space_.n_points());
    // First the columns of each own row in a list of their own, then all lists behind each other.
    std::vector<std::vector<int>> rows(last_ - first_);
    std::vector<std::size_t>      compressed(rows.size(), 0);
    const auto                    compress = [](std::vector<int> &row) {
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
    };
    // An element makes a full block: every unknown that its points depend on meets every other one.
    // So does a link, points that something else joins, such as those of a contact spring.
    const auto touched_by =
      [&](const std::size_t offset, const unsigned int *points, const unsigned int n) {
        // All unknowns that the three components of these points depend on.
        std::vector<int> touched;
        for (unsigned int a = 0; a < n; ++a)
          {
            const std::size_t row = offset + 3 * std::size_t(points[a]);
            for (unsigned int c = 0; c < 3; ++c)
              for (const auto &term : constraints_.line(row + c))
                touched.push_back(term.first);
          }
        compress(touched);
        return touched;
      };
    const auto meet = [&](const std::vector<int> &own, const std::vector<int> &others) {
      for (const int i : own)
        if (is_mine(i))
          {
            auto &row = rows[i - first_];
            row.insert(row.end(), others.begin(), others.end());
            // Each column comes from several elements: rows are kept short on the way.
            if (row.size() > 2 * compressed[i - first_] + 200)
              {
                compress(row);
                compressed[i - first_] = row.size();
              }
          }
    };
    const auto couple = [&](const unsigned int *points, const unsigned int n) {
      for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
        {
          const std::vector<int> touched = touched_by(k * copy, points, n);
          meet(touched, touched);
        }
    };
    for (const unsigned int e : elements_)
      couple(space_.element_points(e), n_local);
    for (const std::vector<unsigned int> &link : links_)
      couple(link.data(), link.size());
    std::vector<std::vector<int>> of_rings;
    for (const BearingRing &ring : rings_.list())
      of_rings.push_back(touched_by(0, ring.points.data(), ring.points.size()));
    for (std::size_t i = 0; i < of_rings.size(); ++i)
      for (std::size_t j = 0; j < of_rings.size(); ++j)
        if (rings_.joins(i, j))
          meet(of_rings[i], of_rings[j]);
    // Compressed rows: row i has the columns from begin[i] to begin[i + 1]. A list is given back as
    // soon as it is copied: the pattern is not twice in memory.
    SparsePattern pattern;
    pattern.communicator = &communicator_;
    pattern.n            = constraints_.n();
    pattern.first_row    = first_;
    pattern.begin.push_back(0);
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        rows[i].push_back(first_ + i); // padding has a diagonal only
        compress(rows[i]);
        pattern.columns.insert(pattern.columns.end(), rows[i].begin(), rows[i].end());
        pattern.begin.push_back(pattern.columns.size());
        std::vector<int>().swap(rows[i]);
      }
    pattern_ = std::make_shared<const SparsePattern>(std::move(pattern));
  }

  void FemSystem::add(const std::size_t      row_offset,
                      const unsigned int    *row_points,
                      const unsigned int    *column_points,
                      const Eigen::MatrixXd &A,
                      FemMatrix             &sum) const
  {
    // (T^T A T)_st = sum_ij T_is A_ij T_jt; rows of T are the lines of the displacements.
    const auto line_of = [&](const unsigned int *points,
                             const int           i) -> const FemConstraints::Line & {
      return constraints_.line(row_offset + 3 * static_cast<std::size_t>(points[i / 3]) + i % 3);
    };
    std::vector<const FemConstraints::Line *> columns(A.cols());
    for (int j = 0; j < A.cols(); ++j)
      columns[j] = &line_of(column_points, j);
    for (int i = 0; i < A.rows(); ++i)
      for (const auto &[row, of_row] : line_of(row_points, i))
        {
          if (!is_mine(row))
            continue;
          for (int j = 0; j < A.cols(); ++j)
            // Consistent masses and all that is "times identity" are two thirds zeros.
            if (A(i, j) != 0)
              for (const auto &[column, of_column] : *columns[j])
                sum.at(row, column) += of_row * of_column * A(i, j);
        }
  }

  FemMatrix FemSystem::matrix(const ElementMatrix &element) const
  {
    FemMatrix         sum(pattern_);
    const std::size_t copy = 3 * static_cast<std::size_t>(space_.n_points());
    for (const unsigned int e : elements_)
      {
        const Eigen::MatrixXd A = element(e);
        for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
          add(k * copy, space_.element_points(e), space_.element_points(e), A, sum);
      }
    return sum;
  }

  FemMatrix
  FemSystem::point_matrix(const std::vector<std::pair<unsigned int, Matrix3>> &points) const
  {
    FemMatrix         sum(pattern_);
    const std::size_t copy = 3 * static_cast<std::size_t>(space_.n_points());
    for (const auto &point : points)
      for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
        {
          const unsigned int index = point.first;
          add(k * copy, &index, &index, point.second, sum);
        }
    return sum;
  }

  FemMatrix
  FemSystem::link_matrix(const std::function<Eigen::MatrixXd(unsigned int link)> &link) const
  {
    FemMatrix         sum(pattern_);
    const std::size_t copy = 3 * static_cast<std::size_t>(space_.n_points());
    for (unsigned int l = 0; l < links_.size(); ++l)
      for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
        add(k * copy, links_[l].data(), links_[l].data(), link(l), sum);
    return sum;
  }

  FemMatrix FemSystem::ring_matrix(const Eigen::MatrixXd &stiffness) const
  {
    FemMatrix sum(pattern_);
    // Points of a ring count through all copies.
    const std::vector<BearingRing> &rings = rings_.list();
    for (std::size_t i = 0; i < rings.size(); ++i)
      for (std::size_t j = 0; j < rings.size(); ++j)
        if (rings_.joins(i, j))
          add(0,
              rings[i].points.data(),
              rings[j].points.data(),
              rings[i].motion.transpose() * stiffness.block<6, 6>(6 * i, 6 * j) * rings[j].motion,
              sum);
    return sum;
  }

  OwnedVector FemSystem::vector(const ElementVector &element) const
  {
    OwnedVector       values(last_ - first_, 0.);
    const std::size_t copy = 3 * static_cast<std::size_t>(space_.n_points());
    for (const unsigned int e : elements_)
      {
        const Eigen::VectorXd f      = element(e);
        const unsigned int   *points = space_.element_points(e);
        for (unsigned int k = 0; k < constraints_.n_copies(); ++k)
          for (int i = 0; i < f.size(); ++i)
            {
              const std::size_t row =
                k * copy + 3 * static_cast<std::size_t>(points[i / 3]) + i % 3;
              for (const auto &[unknown, coefficient] : constraints_.line(row))
                if (is_mine(unknown))
                  values[unknown - first_] += coefficient * f[i];
            }
      }
    return values;
  }

  OwnedVector FemSystem::restrict_forces(const std::vector<double> &forces) const
  {
    OwnedVector values(last_ - first_, 0.);
    for (std::size_t row = 0; row < forces.size(); ++row)
      for (const auto &[unknown, coefficient] : constraints_.line(row))
        if (is_mine(unknown))
          values[unknown - first_] += coefficient * forces[row];
    return values;
  }

  void FemSystem::set_padding(FemMatrix &A, const double value) const
  {
    for (unsigned int i = first_; i < last_; ++i)
      if (constraints_.is_padding(i))
        A.at(i, i) = value;
  }

  std::vector<double> FemSystem::expand(const OwnedVector &q) const
  {
    return constraints_.expand(communicator_.all_gather(q));
  }

  OwnedVector FemSystem::restrict_field(const std::vector<double> &u) const
  {
    const std::vector<double> q = constraints_.restrict_field(u);
    return OwnedVector(q.begin() + first_, q.begin() + last_);
  }

  double FemSystem::mean_diagonal(const FemMatrix &A) const
  {
    double       sum = 0;
    unsigned int n   = 0;
    // Padding has zero there and does not count.
    for (const double d : A.diagonal())
      if (d > 0)
        {
          sum += d;
          ++n;
        }
    return communicator_.sum(sum) / communicator_.sum(n);
  }

  double FemSystem::dot(const OwnedVector &a, const OwnedVector &b) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return communicator_.sum(sum);
  }
} // namespace vfife
