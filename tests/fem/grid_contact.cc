// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Pressures on their own grid between bodies of coarse elements, against Hertz: whatever elements
// are as wide as, where the contact lies among them, and which forces have bent them before.
#include "../tests.h"

#include <vfife/base/facet_surface.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/contact/half_space/cell_flexibility.h>
#include <vfife/contact/law/hertz.h>
#include <vfife/contact/surface/facet_quadrature.h>
#include <vfife/fem/pressure/grid_contact.h>
#include <vfife/fem/statics/compliance.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <iomanip>
#include <map>
#include <memory>

using namespace vfife;

/** z = curvature_x (x - x0)^2/2 + curvature_y (y - y0)^2/2 into a block, which lies above
 * (into = 1) or below (-1). */
struct Curved
{
  Vector2 curvatures, apex;
  double  into;

  double height(const Vector2 &x) const
  {
    return into * .5 * curvatures.dot((x - apex).cwiseAbs2());
  }
  Vector3 normal(const Vector2 &x) const
  {
    const Vector2 slope = into * curvatures.cwiseProduct(x - apex);
    return into * Vector3(slope[0], slope[1], -1.).normalized();
  }
  /** How far the true surface lies beyond @p y along the unit vector @p n. */
  double offset(const Vector3 &y, const Vector3 &n) const
  {
    double delta = 0.;
    for (unsigned int i = 0; i < 30; ++i)
      {
        const Vector3 at     = y + delta * n;
        const Vector3 out    = normal(at.head<2>());
        const double  beyond = (height(at.head<2>()) - at[2]) * out[2];
        delta += beyond / out.dot(n);
      }
    return delta;
  }
};

/** A block of n x n x layers cells of the size h, its surface "flank" curved. */
std::unique_ptr<BodyMesh>
make_curved_block(const Curved &shape, const unsigned int n, const unsigned int layers, double h)
{
  auto                   mesh = std::make_unique<BodyMesh>();
  std::vector<Vector3>   nodes;
  std::vector<CellNodes> cells;
  const auto             number = [n](unsigned int i, unsigned int j, unsigned int k) {
    return (k * (n + 1) + j) * (n + 1) + i;
  };
  FacetSurface &flank = mesh->surfaces["flank"];
  flank.name          = "flank";
  for (unsigned int k = 0; k <= layers; ++k)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const Vector2 x(h * (i - .5 * n), h * (j - .5 * n));
          const double  part = double(k) / layers;
          nodes.emplace_back(x[0],
                             x[1],
                             shape.into * part * layers * h + (1. - part) * shape.height(x));
          if (k == 0)
            {
              flank.nodes.push_back(number(i, j, 0));
              flank.positions.push_back(nodes.back());
              flank.normals.push_back(shape.normal(x));
            }
          else if (k == layers)
            mesh->node_sets["far"].push_back(number(i, j, k));
        }
  for (unsigned int k = 0; k < layers; ++k)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          CellNodes cell;
          for (unsigned int a = 0; a < 8; ++a)
            cell[a] =
              number(i + a % 2, j + (a / 2) % 2, (a / 4 == 1) == (shape.into > 0.) ? k + 1 : k);
          cells.push_back(cell);
          if (k > 0)
            continue;
          std::array<unsigned int, 4> facet{
            {number(i, j, 0), number(i + 1, j, 0), number(i + 1, j + 1, 0), number(i, j + 1, 0)}};
          if (shape.into > 0.)
            std::swap(facet[1], facet[3]);
          flank.facets.push_back(facet);
          flank.group.push_back(0);
        }
  create_triangulation(*mesh, nodes, cells);
  find_neighbours(flank);
  flank.offset_points = 5;
  const auto points   = gauss_lobatto_points(5);
  for (unsigned int f = 0; f < flank.facets.size(); ++f)
    {
      flank.offset_row.push_back(f);
      for (const double eta : points)
        for (const double xi : points)
          {
            const auto N = bilinear_weights(xi, eta);
            Vector3    y = Vector3::Zero(), m = Vector3::Zero();
            for (unsigned int k = 0; k < 4; ++k)
              {
                y += N[k] * flank.positions[flank.facets[f][k]];
                m += N[k] * flank.normals[flank.facets[f][k]];
              }
            flank.offsets.push_back(shape.offset(y, m.normalized()));
          }
    }
  return mesh;
}

bool verbose = false; // says the numbers

const ElasticLayer steel{206000., 0.29, {}}, bronze{110000., 0.34, {}};

/** Two blocks, the upper one of steel, the slave. */
struct Blocks
{
  Model                                           model;
  std::unique_ptr<Compliance>                     compliance;
  std::array<std::unique_ptr<SurfaceGeometry>, 2> surfaces;
  std::array<std::vector<double>, 2>              positions;
  std::array<NearLayer, 2>                        near;
  ElasticContact                                  contact;

  Blocks(const std::array<Curved, 2>       &shapes,
         const std::array<unsigned int, 2> &cells,
         const double                       width,
         const double                       depth,
         const Communicator                &communicator)
  {
    for (unsigned int b = 0; b < 2; ++b)
      {
        Material material;
        material.youngs_modulus = b == 0 ? steel.youngs_modulus : bronze.youngs_modulus;
        material.poissons_ratio = b == 0 ? steel.poissons_ratio : bronze.poissons_ratio;
        const double h          = width / cells[b];
        model.add_body(Body(b == 0 ? "upper" : "lower",
                            make_curved_block(shapes[b], cells[b], cells[b] * 3 / 4, h),
                            material));
        model.constraints.push_back(
          {"far", ConstraintKind::held, b, model.bodies[b].node_set("far")});
      }
    compliance = std::make_unique<Compliance>(model, FemOptions(), false, communicator);
    const FemSpace           &d = compliance->space();
    std::vector<unsigned int> points;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const FacetSurface       &flank = model.bodies[b].mesh().surfaces.at("flank");
        ElasticFlank             &side  = contact.flanks[b];
        std::vector<unsigned int> patch;
        for (const unsigned int node : flank.nodes)
          {
            side.places.push_back(points.size());
            patch.push_back(d.find_part(b)->first_point + node);
            points.push_back(patch.back());
            positions[b].insert(positions[b].end(),
                                model.bodies[b].node_positions()[node].data(),
                                model.bodies[b].node_positions()[node].data() + 3);
          }
        std::vector<PointWeights> means;
        for (const unsigned int point : patch)
          means.push_back({{point, 1.}});
        for (const auto &facet : flank.facets)
          {
            FlankPart part{unit_square, {}, facet, {}};
            part.bulges.fill(Vector3::Zero());
            for (unsigned int k = 0; k < 4; ++k)
              part.places[k] = side.places[facet[k]];
            side.parts.push_back({part});
          }
        PointPairs edges;
        for (unsigned int f = 0; f < flank.facets.size(); ++f)
          for (unsigned int k = 0; k < 4; ++k)
            if (edge_number(flank, f, k) != 0)
              edges.push_back({{patch[flank.facets[f][k]], patch[flank.facets[f][(k + 1) % 4]]}});
        near[b]             = find_near_layer(d, patch, means, {}, depth, edges);
        side.near           = &near[b];
        side.youngs_modulus = model.bodies[b].materials().front().youngs_modulus;
        side.poissons_ratio = model.bodies[b].materials().front().poissons_ratio;
        surfaces[b] = std::make_unique<SurfaceGeometry>(flank, ContactSurfaceKind::true_flank);
      }
    compliance->watch(points);
    contact.surfaces = {surfaces[0].get(), surfaces[1].get(), 0, 0, 1.};
  }

  Eigen::MatrixXd flexibility(const std::vector<unsigned int> &rows)
  {
    return compliance->flexibility(rows);
  }

  /** Pressed by @p force, the bodies bent before by @p known forces along z at the slave's node
   * nearest to @p at, and the opposite ones at the master's. */
  GridPressure press(const double       force,
                     const unsigned int cells_across,
                     const double       known = 0.,
                     const Vector2     &at    = Vector2::Zero())
  {
    ContactLoad load;
    load.flexibility = [this](const std::vector<unsigned int> &rows) { return flexibility(rows); };
    load.forces      = Eigen::VectorXd::Zero(3 * compliance->watched().size());
    load.arm         = [](const Vector3 &, const Vector3 &) { return 1.; };
    load.load        = force;
    for (unsigned int b = 0; b < 2; ++b)
      {
        const FacetSurface &flank   = model.bodies[b].mesh().surfaces.at("flank");
        std::size_t         nearest = 0;
        for (std::size_t i = 0; i < flank.nodes.size(); ++i)
          if ((flank.positions[i].head<2>() - at).norm() <
              (flank.positions[nearest].head<2>() - at).norm())
            nearest = i;
        load.forces[3 * contact.flanks[b].places[nearest] + 2] = b == 0 ? known : -known;
      }
    std::vector<unsigned int> rows;
    for (Eigen::Index k = 0; k < load.forces.size(); ++k)
      if (load.forces[k] != 0.)
        rows.push_back(k);
    compliance->prepare(rows);
    std::array<std::vector<double>, 2> bent = positions;
    for (const unsigned int row : rows)
      for (unsigned int b = 0; b < 2; ++b)
        for (std::size_t i = 0; i < contact.flanks[b].places.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            bent[b][3 * i + c] +=
              load.forces[row] * compliance->column(row)[3 * contact.flanks[b].places[i] + c];
    for (unsigned int b = 0; b < 2; ++b)
      surfaces[b]->bind({bent[b].data(), nullptr, {}});
    return find_grid_pressures({contact}, load, cells_across).front();
  }
};

/** Largest pressure, half axes (by second moments; one over the square root of five of an axis on
 * an ellipse) over Hertz's. */
struct Compared
{
  double  pressure;
  Vector2 axes;
};
Compared compare(const GridPressure &found, const HertzContact &hertz, const double force)
{
  Vector3 centre = Vector3::Zero();
  double  sum    = 0.;
  for (std::size_t i = 0; i < found.cells.size(); ++i)
    {
      centre += found.pressures[i] * found.cells[i].position;
      sum += found.pressures[i];
    }
  centre /= sum;
  Vector2 moments = Vector2::Zero();
  for (std::size_t i = 0; i < found.cells.size(); ++i)
    {
      const Vector3 d = found.cells[i].position - centre;
      moments +=
        found.pressures[i] / sum *
        Vector2(std::pow(d.dot(found.plane.along), 2), std::pow(d.dot(found.plane.across), 2));
    }
  return {found.pressures[found.largest()] / hertz.largest_pressure(force),
          Vector2((5. * moments).cwiseSqrt().cwiseQuotient(hertz.semi_axes(force)))};
}

double modulus()
{
  return contact_modulus(steel.youngs_modulus,
                         steel.poissons_ratio,
                         bronze.youngs_modulus,
                         bronze.poissons_ratio);
}

void check_hertz(const std::string  &name,
                 const GridPressure &found,
                 const HertzContact &hertz,
                 const double        force)
{
  const Compared over = compare(found, hertz, force);
  check_ratio(name + ", force", found.force / force, 1e-10);
  check_ratio(name + ", largest pressure", over.pressure, 0.015);
  check_ratio(name + ", longer half axis", over.axes[0], 0.015);
  check_ratio(name + ", shorter half axis", over.axes[1], 0.015);
  if (verbose)
    std::cerr << name << ": " << std::fixed << std::setprecision(4) << over.pressure << " "
              << over.axes.transpose() << ", closing " << found.closing / hertz.approach(force)
              << ", " << found.cells.size() << " cells" << std::endl;
}

/** Elements over the width of two blocks, which is so many half axes, and depth of the layers in
 * half axes. */
struct Elements
{
  std::array<unsigned int, 2> cells;
  double                      width, depth;
};

const double force = 3000.;

void check_pair(const std::string           &name,
                const std::array<Curved, 2> &shapes,
                const Vector2               &curvatures,
                const std::vector<Elements> &meshes,
                const Communicator          &communicator)
{
  const HertzContact hertz(curvatures, modulus());
  const double       a = hertz.semi_axes(force)[1];
  for (const Elements &mesh : meshes)
    {
      std::ostringstream text;
      text << name << ", elements of " << mesh.width / mesh.cells[0] << " a and "
           << mesh.width / mesh.cells[1] << " a, " << mesh.depth << " a deep";
      Blocks blocks(shapes, mesh.cells, mesh.width * a, mesh.depth * a, communicator);
      check_hertz(text.str(), blocks.press(force, 16), hertz, force);
    }
}

/** Spheres @p distance half axes from an edge of both blocks, or from both edges at a corner:
 * pressure and approach over Hertz's, whatever the depth of the layers. Layers that end there, or
 * that go on in closed form alone, give another one for each depth. */
void check_edge(const double        distance,
                const bool          at_corner,
                const double        closing,
                const double        most_pressure,
                const Communicator &communicator)
{
  const HertzContact          hertz(Vector2(.03, .03), modulus());
  const double                a = hertz.semi_axes(force)[0], width = 12. * a;
  const double                x = .5 * width - distance * a;
  const Vector2               at(x, at_corner ? x : -.17);
  const std::array<Curved, 2> spheres{{{Vector2(.01, .01), at, 1.}, {Vector2(.02, .02), at, -1.}}};
  for (const double depth : {0., 3.})
    {
      Blocks             blocks(spheres, {{8, 8}}, width, depth * a, communicator);
      const GridPressure found = blocks.press(force, 16);
      const double       over  = found.pressures[found.largest()] / hertz.largest_pressure(force);
      std::ostringstream name;
      name << distance << " a from " << (at_corner ? "both edges at a corner" : "an edge")
           << ", layers " << depth << " a deep or more, ";
      if (verbose)
        std::cerr << name.str() << "closing " << found.closing / hertz.approach(force)
                  << ", largest pressure " << over << std::endl;
      check_close(name.str() + "closing",
                  found.closing / hertz.approach(force),
                  closing,
                  .018 * closing);
      check_below(name.str() + "largest pressure", over, most_pressure);
    }
}

/** Blocks whose nearest places lie beyond a corner of both: it touches under the least force, on an
 * area that is some thousandths of a facet wide. The grid has no cells on the rest of the flank. */
void check_touching_corner(const Communicator &communicator)
{
  const double                width = 6.;
  const Vector2               beyond(width, width);
  const std::array<Curved, 2> shapes{
    {{Vector2(.01, .01), beyond, 1.}, {Vector2(.02, .02), beyond, -1.}}};
  Blocks             blocks(shapes, {{4, 4}}, width, 0., communicator);
  const GridPressure found = blocks.press(1e-4, 16);
  check_ratio("touching corner, force", found.force / 1e-4, 1e-10);
  check_below("touching corner, width [mm]", found.width, 1e-2);
  check("touching corner, cells", found.cells.size() < 1000);
  check("touching corner, at an edge", found.at_edge[found.largest()]);
  if (verbose)
    std::cerr << "touching corner: " << found.cells.size() << " cells, width " << found.width
              << std::endl;
}

/** Beyond two edges of a plate that meet at a corner the quarter between them is filled, once. */
void check_corner_layer()
{
  constexpr unsigned int    n = 3, rows = 2;
  LayerElements             layer;
  std::vector<unsigned int> patch;
  PointPairs                edges;
  const auto                number = [](unsigned int i, unsigned int j, unsigned int k) {
    return (k * (n + 1) + j) * (n + 1) + i;
  };
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          if (k == 0)
            patch.push_back(layer.points.size());
          layer.points.emplace_back(i, j, k);
          layer.held.push_back(k == 1);
        }
  for (unsigned int j = 0; j < n; ++j)
    {
      edges.push_back({{number(n, j, 0), number(n, j + 1, 0)}});
      edges.push_back({{number(j, n, 0), number(j + 1, n, 0)}});
      for (unsigned int i = 0; i < n; ++i)
        {
          layer.elements.emplace_back();
          for (unsigned int a = 0; a < 8; ++a)
            layer.elements.back().push_back(number(i + a % 2, j + a / 2 % 2, a / 4));
        }
    }
  layer.continue_beyond(edges, patch, rows);
  // By their middles: one in each square.
  std::map<std::array<int, 2>, unsigned int> squares;
  for (const auto &element : layer.elements)
    {
      Vector3 middle = Vector3::Zero();
      for (const unsigned int point : element)
        middle += layer.points[point] / 8.;
      ++squares[{{int(std::floor(middle[0])), int(std::floor(middle[1]))}}];
    }
  check("layer beyond both edges of a corner: one element in each square",
        squares.size() == (n + rows) * (n + rows) &&
          layer.elements.size() == (n + rows) * (n + rows) &&
          squares.count({{n + rows - 1, n + rows - 1}}) == 1);
}

/** Beyond a chamfer, whose sides are those of another element than that under the surface, the
 * layer goes on along the surface. */
void check_chamfer_layer()
{
  //        0    1   1.4  x
  //   z 0  *----*            patch, edge, chamfer
  //     .6 |    | *
  //     1  *----*-*          held
  LayerElements layer;
  for (const auto &[x, z] : {std::pair(0., 0.),
                             std::pair(1., 0.),
                             std::pair(1.4, .6),
                             std::pair(0., 1.),
                             {1., 1.},
                             {1.4, 1.}})
    for (const double y : {0., 1.})
      {
        layer.points.emplace_back(x, y, z);
        layer.held.push_back(z == 1.);
      }
  layer.elements = {{0, 2, 1, 3, 6, 8, 7, 9}, {2, 4, 3, 5, 8, 10, 9, 11}};
  layer.continue_beyond({{{2, 3}}}, {0, 1, 2, 3}, 3.);
  const auto volume = [&](const std::vector<unsigned int> &element) {
    return compute_volume(HexahedronNodes(layer.nodes_of(element)));
  };
  double sum = 0.;
  for (const auto &element : layer.elements)
    sum += volume(element);
  check("layer beyond a chamfer: no element is folded", !layer.is_folded(0));
  // Three rows as wide as the element under the surface, below the chamfer and the end beside it.
  check_close("layer beyond a chamfer: volume",
              sum - volume(layer.elements[0]) - volume(layer.elements[1]),
              3.,
              1e-12);
  double wrong = 0.;
  for (std::size_t p = 12; p < layer.points.size(); ++p)
    raise_to(wrong,
             std::min(std::abs(std::remainder(layer.points[p][0], 1.)),
                      std::abs(std::remainder(layer.points[p][0] - .4, 1.))));
  check_below("layer beyond a chamfer: steps along the surface", wrong, 1e-12);
}

/** Beyond the end of a wedge, whose lines meet within the length, all points go on alike. */
void check_converging_layer()
{
  LayerElements layer;
  for (const double z : {0., 1.})
    for (const double y : {-1., 1.})
      for (const double x : {0., 1.})
        {
          layer.points.emplace_back(x, y * (1. - .4 * x), z);
          layer.held.push_back(z == 1.);
        }
  layer.elements = {{0, 1, 2, 3, 4, 5, 6, 7}};
  layer.continue_beyond({{{1, 3}}}, {0, 1, 2, 3}, 3.);
  check("layer beyond a wedge: three rows, none of them folded",
        layer.elements.size() == 4 && !layer.is_folded(0));
  check_close("layer beyond a wedge: width",
              (layer.points.back() - layer.points[layer.points.size() - 2]).norm(),
              1.2,
              1e-12);
}

/** The cells converge; forces that have bent the bodies before, as springs of a contact by
 * penalties would, leave no trace. */
void check_one_pair(const std::array<Curved, 2> &shapes, const Communicator &communicator)
{
  const HertzContact  hertz(Vector2(.03, .03), modulus());
  const double        a = hertz.semi_axes(force)[0];
  Blocks              blocks(shapes, {{8, 8}}, 24. * a, 3. * a, communicator);
  std::vector<double> pressures;
  for (const unsigned int n : {8u, 16u, 32u})
    {
      const GridPressure found = blocks.press(force, n);
      pressures.push_back(found.pressures[found.largest()]);
    }
  check("pressures converge with the cells",
        std::abs(pressures[2] - pressures[1]) < .6 * std::abs(pressures[1] - pressures[0]));
  const GridPressure plain = blocks.press(force, 16);
  for (const Vector2 &at : {Vector2(0., 0.), Vector2(3. * a, 0.)})
    {
      const GridPressure bent = blocks.press(force, 16, force, at);
      check_ratio("bent before, largest pressure",
                  bent.pressures[bent.largest()] / plain.pressures[plain.largest()],
                  2e-3);
      check_ratio("bent before, closing", bent.closing / plain.closing, 2e-3);
    }
}

int main(int argc, char **argv)
{
  MpiSession          session(argc, argv);
  const Communicator &world = session.world();
  verbose                   = argc > 1;

  // Away from nodes and middles of elements.
  const Vector2               off(.23, -.17);
  const std::array<Curved, 2> spheres{
    {{Vector2(.01, .01), off, 1.}, {Vector2(.02, .02), off, -1.}}};
  std::vector<Elements> meshes = {{{{4, 4}}, 24., 0.}, {{{8, 8}}, 24., 0.}, {{{12, 8}}, 24., 3.}};
  check_pair("spheres", spheres, Vector2(.03, .03), meshes, world);
  check_one_pair(spheres, world);
  // What blocks of finer elements come to, 0.75 half axes wide: 1.423 and 1.227.
  check_edge(.5, false, 1.423, 1.1, world);
  check_edge(1., false, 1.227, 1.1, world);
  // The same of those at a corner.
  check_edge(.5, true, 2.076, 1.2, world);
  check_edge(1., true, 1.593, 1.2, world);
  check_touching_corner(world);
  check_corner_layer();
  check_chamfer_layer();
  check_converging_layer();
  meshes.push_back({{{12, 12}}, 12., 3.});
  check_pair("crossed cylinders",
             {{{Vector2(.01, 0.), off, 1.}, {Vector2(0., .04), off, -1.}}},
             Vector2(.01, .04),
             meshes,
             world);
  return 0;
}
