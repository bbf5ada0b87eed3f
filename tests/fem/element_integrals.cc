// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Points, faces and masses of finite elements of each degree on a cell with warped faces.
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/element/hexahedron.h>
#include <vfife/fem/system/fem_space.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/model/load_shares.h>

using namespace vfife;

Model make_warped_cell()
{
  auto mesh = make_block(Vector3(2., 3., 1.5), {{1, 1, 1}});
  for (const auto &cell : mesh->triangulation.active_cell_iterators())
    for (unsigned int v = 0; v < 8; ++v)
      for (unsigned int c = 0; c < 3; ++c)
        cell->vertex(v)[c] += .3 * std::sin(12.9898 * (v + 1) + 78.233 * c);
  return model_of(Body("cell", std::move(mesh), Material()));
}

int main(int argc, char **argv)
{
  MpiSession                      session(argc, argv);
  const Model                     model  = make_warped_cell();
  const Body                     &body   = model.bodies[0];
  const std::vector<unsigned int> nodes  = {0, 1, 2, 3, 4, 5, 6, 7};
  const double                    volume = compute_volume(body.element_nodes(0));
  for (const auto &choice : fem_element_choices())
    {
      const FemSpace     space(model, {0}, choice.second);
      const ElementNodes X = space.element_nodes(0);
      // The divergence of x is 3, that of a constant and of a rotation is nothing.
      double  outflow = 0;
      Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
      for (const BoundaryFace &face : find_boundary_faces(body, nodes))
        {
          const auto   points = space.face_points(face.element, face.number);
          ElementNodes of_face(3, points.size());
          for (std::size_t i = 0; i < points.size(); ++i)
            of_face.col(i) = space.points()[points[i]];
          for (unsigned int k = 0; k < 2; ++k)
            check_below(
              choice.first + ": corners of a face are those of its element",
              (of_face.col(k * space.degree()) - body.node_positions()[face.nodes[k]]).norm(),
              1e-15);
          for (const FacePoint &at : compute_face_points(of_face))
            for (std::size_t i = 0; i < points.size(); ++i)
              {
                const Vector3 pressure = at.N[i] * at.normal;
                outflow += of_face.col(i).dot(pressure);
                force += pressure;
                moment += Vector3(of_face.col(i)).cross(pressure);
              }
        }
      check_ratio(choice.first + ": outflow of x over three volumes",
                  outflow / (3. * volume),
                  1e-13);
      check_below(choice.first + ": even pressure leaves no force [mm^2]", force.norm(), 1e-13);
      check_below(choice.first + ": and no moment [mm^3]", moment.norm(), 1e-13);
      for (const MassKind kind : {MassKind::consistent, MassKind::lumped})
        {
          const Eigen::MatrixXd m = compute_mass_coefficients(X, 2., kind);
          check_ratio(choice.first + ": mass", m.sum() / (2. * volume), 1e-13);
          check(choice.first + ": masses of points are positive", m.diagonal().minCoeff() > 0);
          const auto points = compute_element_points(X);
          Vector3    centre = Vector3::Zero();
          for (const ElementPoint &point : points)
            centre += 2. * point.weight * (X * point.N);
          check_below(choice.first + ": centre of mass",
                      (X * m.rowwise().sum() - centre).norm() / centre.norm(),
                      1e-14);
        }
      // All points of the boundary: all but those inside of the cell.
      const unsigned int n = space.degree() + 1;
      check(choice.first + ": points of the boundary",
            space.points_of(space.parts()[0], nodes).size() ==
              n * n * n - (n - 2) * (n - 2) * (n - 2));
    }
  return 0;
}
