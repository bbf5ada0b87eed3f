// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/contact/search/broad_search.h>
#include <vfife/contact/surface/facet_integrals.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>
#include <vfife/model/options/bodies_at_start.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace vfife
{
  namespace
  {
    /** Which places lie inside the elements of a body. */
    class Interior
    {
    public:
      explicit Interior(const Body &body)
        : body_(body)
        , tree_(boxes_of(body))
      {
      }

      /** @p x in the body frame; places on the boundary are not inside, those between elements are.
       */
      bool contains(const Vector3 &x) const
      {
        std::vector<unsigned int> near;
        tree_.find({x, x}, near);
        if (near.empty())
          return false;
        double size = std::numeric_limits<double>::infinity();
        for (const unsigned int e : near)
          size = std::min(size, std::cbrt(compute_volume(body_.element_nodes(e))));
        // All around it there is an element.
        for (unsigned int v = 0; v < 8; ++v)
          if (!is_in_element(x + 1e-5 * size * reference_corner(v)))
            return false;
        return true;
      }

    private:
      static std::vector<Box> boxes_of(const Body &body)
      {
        std::vector<Box> boxes;
        for (const auto &nodes : body.elements())
          {
            std::vector<Vector3> corners;
            for (const std::uint32_t node : nodes)
              corners.push_back(body.node_positions()[node]);
            boxes.push_back(Box::around(corners, 0.));
          }
        return boxes;
      }

      bool is_in_element(const Vector3 &x) const
      {
        std::vector<unsigned int> near;
        tree_.find({x, x}, near);
        return std::any_of(near.begin(), near.end(), [&](const unsigned int e) {
          return is_in(body_.element_nodes(e), x);
        });
      }

      static bool is_in(const HexahedronNodes &nodes, const Vector3 &x)
      {
        // Newton's method for the reference coordinates; they leave the cube for places outside.
        Vector3 xi = Vector3::Zero();
        for (unsigned int k = 0; k < 20; ++k)
          {
            const Vector3 change =
              compute_jacobian(nodes, xi).inverse() * (x - nodes * shape_functions(xi));
            xi += change;
            if (!(xi.cwiseAbs().maxCoeff() < 3.))
              return false;
            if (change.norm() < 1e-10)
              break;
          }
        return xi.cwiseAbs().maxCoeff() < 1.;
      }

      const Body &body_;
      BoxTree     tree_;
    };

    /** From @p x to a bilinear facet, or a little more where that is skew [mm]. */
    double distance_to(const std::array<Vector3, 4> &y, const Vector3 &x)
    {
      double xi = .5, eta = .5, least = std::numeric_limits<double>::infinity();
      for (unsigned int k = 0; k < 8; ++k)
        {
          const auto    N    = bilinear_weights(xi, eta);
          const Vector3 rest = x - N[0] * y[0] - N[1] * y[1] - N[2] * y[2] - N[3] * y[3];
          least              = std::min(least, rest.norm());
          Eigen::Matrix<double, 3, 2> slopes;
          slopes.col(0) = (1. - eta) * (y[1] - y[0]) + eta * (y[2] - y[3]);
          slopes.col(1) = (1. - xi) * (y[3] - y[0]) + xi * (y[2] - y[1]);
          const Vector2 step =
            (slopes.transpose() * slopes).inverse() * (slopes.transpose() * rest);
          xi  = std::min(1., std::max(0., xi + step[0]));
          eta = std::min(1., std::max(0., eta + step[1]));
        }
      return least;
    }

    std::array<Vector3, 4> corners_of(const FacetSurface &surface, const unsigned int facet)
    {
      const auto &k = surface.facets[facet];
      return {{surface.positions[k[0]],
               surface.positions[k[1]],
               surface.positions[k[2]],
               surface.positions[k[3]]}};
    }

    double mean_facet_size(const FacetSurface &surface)
    {
      double area = 0;
      for (unsigned int f = 0; f < surface.facets.size(); ++f)
        for (const double part : integrate_areas(corners_of(surface, f)))
          area += part;
      return std::sqrt(area / surface.facets.size());
    }

    /** A body and its surface in a contact. */
    struct Side
    {
      const Body         &body;
      const FacetSurface &surface;

      Side(const Model &model, const unsigned int number, const std::string &name)
        : body(model.bodies[number])
        , surface(body.mesh().surfaces.at(name))
      {
      }

      Box box() const
      {
        std::vector<Vector3> places;
        for (const Vector3 &x : body.node_positions())
          places.push_back(body.placement(x));
        return Box::around(places, 0.);
      }
    };

    struct Overlap
    {
      double  depth = 0; ///< [mm]
      Vector3 place = Vector3::Zero();
    };

    /** The deepest one of places of one body (its frame) that lie inside the other, below the
     * other's surface. */
    Overlap find_overlap(const std::vector<Vector3> &places, const Side &from, const Side &other)
    {
      const Interior interior(other.body);
      const Matrix3  back = other.body.placement.rotation.transpose();
      Overlap        deepest;
      for (const Vector3 &X : places)
        {
          const Vector3 place = from.body.placement(X);
          const Vector3 x     = back * (place - other.body.placement.translation);
          if (!interior.contains(x))
            continue;
          double depth = std::numeric_limits<double>::infinity();
          for (unsigned int f = 0; f < other.surface.facets.size(); ++f)
            depth = std::min(depth, distance_to(corners_of(other.surface, f), x));
          if (depth > deepest.depth)
            deepest = {depth, place};
        }
      return deepest;
    }

    std::string describe(const Overlap &overlap, const Side &from, const Side &other)
    {
      std::ostringstream text;
      text << "body \"" << from.body.name() << "\" at (" << overlap.place[0] << ", "
           << overlap.place[1] << ", " << overlap.place[2] << ") mm, " << overlap.depth
           << " mm inside body \"" << other.body.name() << '"';
      return text.str();
    }

    void check_pair(const Model &model, const ContactPair &pair, Log &log)
    {
      if (pair.slave_body == pair.master_body)
        return;
      const Side slave(model, pair.slave_body, pair.slave_surface),
        master(model, pair.master_body, pair.master_surface);
      const Box one = slave.box(), two = master.box();
      if ((one.low.array() > two.high.array()).any() || (two.low.array() > one.high.array()).any())
        return;
      const double limit =
        pair.options.depth_limit > 0
          ? pair.options.depth_limit
          : .5 * std::min(mean_facet_size(slave.surface), mean_facet_size(master.surface));
      for (const bool of_slave : {true, false})
        {
          const Side          &from = of_slave ? slave : master, &other = of_slave ? master : slave;
          std::vector<Vector3> facets, elements;
          for (unsigned int f = 0; f < from.surface.facets.size(); ++f)
            {
              const auto x = corners_of(from.surface, f);
              facets.push_back(.25 * (x[0] + x[1] + x[2] + x[3]));
            }
          if (const Overlap overlap = find_overlap(facets, from, other); overlap.depth > limit)
            {
              std::ostringstream text;
              text << "expected a penetration of at most " << limit
                   << " mm at the start (contact depth limit), got "
                   << describe(overlap, from, other)
                   << ". Move one body (position), or choose the surfaces in contact";
              throw InputError("Model/Contact " + pair.side, text.str());
            }
          for (unsigned int e = 0; e < from.body.n_elements(); ++e)
            elements.push_back(from.body.element_nodes(e).rowwise().mean());
          if (const Overlap overlap = find_overlap(elements, from, other); overlap.depth > limit)
            {
              log.warning("contact ",
                          pair.side,
                          " at the start: ",
                          describe(overlap, from, other),
                          ", away from the contact surfaces, where contact does not detect it");
              return;
            }
        }
    }

    void check_wall(const Model &model, const RigidWall &wall, Log &log)
    {
      const Body &body     = model.bodies[wall.body];
      const auto  depth_of = [&](const unsigned int node) {
        return -wall.normal.dot(body.placement(body.node_positions()[node]) - wall.point);
      };
      double least = std::numeric_limits<double>::infinity(), most = -least, deepest = -least;
      for (unsigned int node = 0; node < body.n_nodes(); ++node)
        {
          least = std::min(least, depth_of(node));
          most  = std::max(most, depth_of(node));
        }
      // Touching counts as behind, but for the round-off of places.
      if (least > -1e-9 * (most - least))
        {
          std::ostringstream text;
          text << "expected a body in front of the wall, got body \"" << body.name()
               << "\" completely behind it, from " << std::max(0., least) << " to " << most
               << " mm. Move the body or the wall point, or reverse the wall normal, which points "
                  "out of the wall";
          throw InputError("Model/Contact " + wall.name + "/wall normal", text.str());
        }
      double area = 0;
      for (const double part : compute_nodal_areas(body, wall.nodes, wall.faces))
        area = std::max(area, part);
      for (const unsigned int node : wall.nodes)
        deepest = std::max(deepest, depth_of(node));
      const bool given = !wall.penalty.is_open();
      if (given && deepest > .5 * std::sqrt(area))
        log.warning("contact ",
                    wall.name,
                    ": body ",
                    body.name(),
                    " begins ",
                    deepest,
                    " mm behind the wall, more than half a facet");
    }
  } // namespace

  void check_start(const Model &model, Log &log)
  {
    for (const ContactPair &pair : model.contacts)
      check_pair(model, pair, log);
    for (const RigidWall &wall : model.walls)
      check_wall(model, wall, log);
  }
} // namespace vfife
