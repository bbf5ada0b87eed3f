// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_rows.h"

#include <vfife/base/errors.h>
#include <vfife/contact/half_space/cell_flexibility.h>
#include <vfife/contact/half_space/cell_forces.h>
#include <vfife/fem/pressure/grid_contact.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vfife
{
  /** The grid of one contact. */
  struct GridOfContact
  {
    const ElasticContact                     *contact;
    ContactPlane                              plane;
    std::vector<ContactCell>                  cells;   ///< all there are, those taken first
    std::map<std::array<int, 2>, std::size_t> numbers; ///< of the cells by their places
    std::size_t     n_taken = 0; ///< of the cells that may carry, the first ones
    Eigen::MatrixXd flexibility; ///< of the layers near the surfaces, in these [mm/N]

    /** Takes @p n of the cells. */
    GridOfContact(const ElasticContact &contact, const ContactPlane &plane, std::size_t n);

    /** Takes cells that lie beside one that carries, too; returns whether there were such. */
    bool extend(const Eigen::VectorXd &forces);

    GridPressure evaluate(const Eigen::VectorXd &forces, const ContactLoad &load) const;

    /** The plane along what carries, with @p n cells over its width. */
    ContactPlane refine(const GridPressure &found, unsigned int n) const;

  private:
    /** Takes the first @p n cells. Throws NumericalError where there are too many. */
    void take(std::size_t n);
  };

  namespace
  {
    /** Grids that are tried until the contacts have the cells that are asked for. */
    constexpr unsigned int most_grids = 8;
    /** A contact that carries less of the load keeps its first grid. */
    constexpr double least_part = 0.02;
    /** Cells of a contact that are looked at, the nearest ones: on its first grid, and at most. */
    constexpr std::size_t first_cells = 150, most_cells = 6000;
    /** The same over the cells that carry by the grid before: the nearest cells are not quite the
     * ones that carry. */
    constexpr double taken_per_loaded = 1.5;
    /** Cells on each side of one that carries which are looked at, too. */
    constexpr int beside = 1;
    /** A long contact has three times as many cells along as across, and these are at most so many
     * times as long as they are wide. */
    constexpr double most_stretch = 8.;
    /** Of a finer grid: it reaches so many extents of what carries to each side. */
    constexpr double reached = 3.;
    /** A corner that touches has no width: cells have at least this part of a facet. */
    constexpr double least_side = 1e-3;
  } // namespace

  std::size_t GridPressure::largest() const
  {
    return std::max_element(pressures.begin(), pressures.end()) - pressures.begin();
  }

  double GridPressure::force_of(const std::size_t cell) const
  {
    // The surface is inclined against the plane: the cell's area on it is larger.
    return pressures[cell] * plane.sides.prod() / cells[cell].normal.dot(plane.normal);
  }

  GridOfContact::GridOfContact(const ElasticContact &contact_,
                               const ContactPlane   &plane_,
                               const std::size_t     n)
    : contact(&contact_)
    , plane(plane_)
    , cells(find_contact_cells(contact_.surfaces, plane_))
  {
    for (ContactCell &cell : cells)
      cell.gap += cell.normal.dot(contact->flanks[0].find(cell.feet[0]).bulge() -
                                  contact->flanks[1].find(cell.feet[1]).bulge());
    std::stable_sort(cells.begin(), cells.end(), [](const ContactCell &a, const ContactCell &b) {
      return a.gap < b.gap;
    });
    for (std::size_t i = 0; i < cells.size(); ++i)
      numbers[cells[i].place] = i;
    take(n);
  }

  void GridOfContact::take(const std::size_t n)
  {
    if (n > most_cells)
      throw NumericalError("the contact's own grid exceeds " + std::to_string(most_cells) +
                           " cells");
    n_taken = std::min(n, cells.size());
    std::vector<std::array<int, 2>> places;
    std::array<ElasticLayer, 2>     bodies;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const ElasticFlank &flank   = contact->flanks[side];
        bodies[side].youngs_modulus = flank.youngs_modulus;
        bodies[side].poissons_ratio = flank.poissons_ratio;
        bodies[side].held           = flank.held;
        for (std::size_t i = 0; i < n_taken; ++i)
          {
            const FlankFoot foot  = flank.find(cells[i].feet[side]);
            double          depth = 0;
            for (unsigned int k = 0; k < 4; ++k)
              depth += foot.weights[k] * flank.near->depths[foot.part->near_places[k]];
            bodies[side].depths.push_back(depth);
          }
      }
    for (std::size_t i = 0; i < n_taken; ++i)
      places.push_back(cells[i].place);
    flexibility = compute_cell_flexibility(places, plane.sides, bodies);
  }

  bool GridOfContact::extend(const Eigen::VectorXd &forces)
  {
    const std::size_t before = n_taken;
    std::size_t       n      = n_taken;
    for (std::size_t i = 0; i < before; ++i)
      if (forces[i] > 0)
        for (int u = -beside; u <= beside; ++u)
          for (int v = -beside; v <= beside; ++v)
            {
              const auto other = numbers.find({{cells[i].place[0] + u, cells[i].place[1] + v}});
              if (other == numbers.end() || other->second < n)
                continue;
              const std::size_t from = other->second;
              std::swap(cells[from], cells[n]);
              numbers[cells[from].place] = from;
              numbers[cells[n].place]    = n;
              ++n;
            }
    if (n > before)
      take(n);
    return n > before;
  }

  GridPressure GridOfContact::evaluate(const Eigen::VectorXd &forces, const ContactLoad &load) const
  {
    GridPressure                      found;
    std::map<int, std::array<int, 2>> ends; // across, by the place along
    found.plane       = plane;
    const double area = plane.sides.prod();
    for (std::size_t i = 0; i < n_taken; ++i)
      {
        if (!(forces[i] > 0))
          continue;
        const ContactCell &cell = cells[i];
        // The surface is inclined against the plane: the cell's area on it is larger.
        const double cosine = cell.normal.dot(plane.normal);
        found.cells.push_back(cell);
        found.pressures.push_back(forces[i] * cosine / area);
        found.force += forces[i];
        found.moment += forces[i] * load.arm(cell.position, cell.normal);
        found.area += area / cosine;
        bool at_edge = false;
        for (const auto &step : {std::array<int, 2>{{1, 0}}, {{-1, 0}}, {{0, 1}}, {{0, -1}}})
          {
            const std::array<int, 2> place{{cell.place[0] + step[0], cell.place[1] + step[1]}};
            at_edge =
              at_edge || (numbers.count(place) == 0 && std::abs(place[0]) <= plane.reach[0] &&
                          std::abs(place[1]) <= plane.reach[1]);
          }
        found.at_edge.push_back(at_edge);
        auto &across =
          ends.try_emplace(cell.place[0], std::array<int, 2>{{cell.place[1], cell.place[1]}})
            .first->second;
        across = {{std::min(across[0], cell.place[1]), std::max(across[1], cell.place[1])}};
      }
    if (ends.empty())
      return found;
    found.length = plane.sides[0] * (ends.rbegin()->first - ends.begin()->first + 1);
    for (const auto &row : ends)
      found.width = std::max(found.width, plane.sides[1] * (row.second[1] - row.second[0] + 1));
    return found;
  }

  ContactPlane GridOfContact::refine(const GridPressure &found, const unsigned int n) const
  {
    // Along the longer way of what carries; for its curvature the plane is where the most is.
    ContactPlane finer  = plane;
    Vector2      mean   = Vector2::Zero();
    double       sum    = 0;
    Vector3      normal = Vector3::Zero();
    for (std::size_t i = 0; i < found.cells.size(); ++i)
      {
        mean += found.pressures[i] * Vector2(found.cells[i].place[0] * plane.sides[0],
                                             found.cells[i].place[1] * plane.sides[1]);
        normal += found.pressures[i] * found.cells[i].normal;
        sum += found.pressures[i];
      }
    mean /= sum;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < found.cells.size(); ++i)
      {
        const Vector2 d = Vector2(found.cells[i].place[0] * plane.sides[0],
                                  found.cells[i].place[1] * plane.sides[1]) -
                          mean;
        spread += found.pressures[i] / sum * d * d.transpose();
      }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> ways(spread);
    const Vector2                                        longer = ways.eigenvectors().col(1);
    const Vector3 along = longer[0] * plane.along + longer[1] * plane.across;
    finer.origin += mean[0] * plane.along + mean[1] * plane.across;
    finer.normal         = normal.normalized();
    finer.along          = (along - finer.normal * finer.normal.dot(along)).normalized();
    finer.across         = finer.normal.cross(finer.along);
    const double stretch = std::min(std::max(found.length / (3. * found.width), 1.), most_stretch);
    const double across =
      std::max(found.width / n, least_side * contact->surfaces.slave->mean_facet_size());
    finer.sides = Vector2(stretch, 1.) * across;
    finer.reach =
      reached * std::max(found.length, found.width) * finer.sides.cwiseInverse() + Vector2(2., 2.);
    return finer;
  }

  namespace
  {
    /** Contacts on their grids, joined by the bodies. */
    class JoinedGrids
    {
    public:
      JoinedGrids(std::vector<GridOfContact> &grids, const ContactLoad &load)
        : grids_(grids)
        , load_(load)
      {
        collect_rows();
        find_far_flexibility();
      }

      CellForces solve() const;

    private:
      void collect_rows();
      void find_far_flexibility();

      std::vector<GridOfContact>                  &grids_;
      const ContactLoad                           &load_;
      std::vector<unsigned int>                    rows_;
      Eigen::SparseMatrix<double, Eigen::RowMajor> gap_of_; ///< changes of gaps by displacements
      Eigen::MatrixXd                              far_;    ///< flexibility less what is near
      Eigen::VectorXd                              gaps_, arms_;
    };

    void JoinedGrids::collect_rows()
    {
      ContactRows  rows(load_);
      Eigen::Index n = 0;
      for (const GridOfContact &grid : grids_)
        {
          for (std::size_t i = 0; i < grid.n_taken; ++i)
            rows.add(*grid.contact, grid.cells[i], ContactRows::At::points);
          n += grid.n_taken;
        }
      rows_ = rows.number();

      gaps_.resize(n);
      arms_.resize(n);
      ContactRows::Entries entries;
      Eigen::Index         row = 0;
      for (const GridOfContact &grid : grids_)
        for (std::size_t i = 0; i < grid.n_taken; ++i, ++row)
          {
            const ContactCell &cell = grid.cells[i];
            gaps_[row]              = cell.gap;
            arms_[row]              = load_.arm(cell.position, cell.normal);
            rows.append_gap(*grid.contact, cell, ContactRows::At::points, row, entries);
          }
      gap_of_.resize(n, rows_.size());
      gap_of_.setFromTriplets(entries.begin(), entries.end());
    }

    void JoinedGrids::find_far_flexibility()
    {
      far_ = load_.flexibility(rows_);
      Eigen::VectorXd known(rows_.size());
      for (std::size_t k = 0; k < rows_.size(); ++k)
        known[k] = load_.forces[rows_[k]];
      // Without the forces that brought them there; those on the grids take their place.
      gaps_ -= gap_of_ * (far_ * known);
      std::map<unsigned int, unsigned int> first;
      for (std::size_t k = 0; k < rows_.size(); k += 3)
        first[rows_[k] / 3] = k;
      std::set<const NearLayer *> taken;
      for (const GridOfContact &grid : grids_)
        for (const ElasticFlank &flank : grid.contact->flanks)
          {
            if (!taken.insert(flank.near).second)
              continue;
            // Rows here and there of the points that are in both.
            std::map<Eigen::Index, Eigen::Index> both;
            for (const std::vector<FlankPart> &of_facet : flank.parts)
              for (const FlankPart &part : of_facet)
                for (unsigned int k = 0; k < 4; ++k)
                  if (const auto found = first.find(part.places[k]); found != first.end())
                    both[found->second] = 3 * Eigen::Index(part.near_places[k]);
            for (const auto &[row, near_row] : both)
              for (const auto &[column, near_column] : both)
                far_.block<3, 3>(row, column) -=
                  flank.near->flexibility.block<3, 3>(near_row, near_column);
          }
      far_ = .5 * (far_ + far_.transpose()).eval();
    }

    CellForces JoinedGrids::solve() const
    {
      return find_cell_forces(
        [this](const Eigen::VectorXd &f) -> Eigen::VectorXd {
          Eigen::VectorXd gaps  = gap_of_ * (far_ * (gap_of_.transpose() * f));
          Eigen::Index    first = 0;
          for (const GridOfContact &grid : grids_)
            {
              const Eigen::Index n = grid.n_taken;
              gaps.segment(first, n) +=
                grid.flexibility.selfadjointView<Eigen::Lower>() * f.segment(first, n);
              first += n;
            }
          return gaps;
        },
        gaps_,
        arms_,
        load_.load);
    }

    /** On these grids, with as many of their cells as carry or lie beside those. */
    std::vector<GridPressure> solve_on(std::vector<GridOfContact> &grids, const ContactLoad &load)
    {
      for (;;)
        {
          const CellForces          result = JoinedGrids(grids, load).solve();
          std::vector<GridPressure> found;
          Eigen::Index              first  = 0;
          bool                      enough = true;
          for (GridOfContact &grid : grids)
            {
              const Eigen::VectorXd forces = result.forces.segment(first, grid.n_taken);
              first += grid.n_taken;
              found.push_back(grid.evaluate(forces, load));
              found.back().closing = result.closing;
              enough               = !grid.extend(forces) && enough;
            }
          if (enough)
            return found;
        }
    }
  } // namespace

  std::vector<GridPressure> find_grid_pressures(const std::vector<ElasticContact> &contacts,
                                                const ContactLoad                 &load,
                                                const unsigned int                 cells_across)
  {
    std::vector<ContactPlane> planes;
    std::vector<std::size_t>  n_cells(contacts.size(), first_cells);
    for (const ElasticContact &contact : contacts)
      planes.push_back(place_contact_plane(contact.surfaces, cells_across));
    for (unsigned int i = 0;; ++i)
      {
        std::vector<GridOfContact> grids;
        for (std::size_t k = 0; k < contacts.size(); ++k)
          grids.emplace_back(contacts[k], planes[k], n_cells[k]);
        std::vector<GridPressure> found = solve_on(grids, load);
        bool                      fine  = i > 0;
        for (std::size_t k = 0; k < contacts.size(); ++k)
          if (found[k].moment > least_part * load.load)
            {
              planes[k]  = grids[k].refine(found[k], cells_across);
              n_cells[k] = std::min(most_cells,
                                    std::max(first_cells,
                                             std::size_t(taken_per_loaded * found[k].area /
                                                         planes[k].sides.prod())));
              // Cells of the same number, but for one at each side that may carry or not.
              fine = fine && std::abs(found[k].width / found[k].plane.sides[1] - cells_across) <=
                               std::max(2., .15 * cells_across);
            }
        if (fine || i + 1 == most_grids)
          return found;
      }
  }
} // namespace vfife
