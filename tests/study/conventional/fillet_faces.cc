// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Surface strains of fillets by the faces of finite elements of each degree, divided or not.
#include "../../ranks.h"
#include "../few_teeth.h"
#include "../gear_model.h"

#include <vfife/study/fillets/fillet_faces.h>

using namespace vfife;

/** Displacements of all points: a field at their places in the fixed frame. */
std::vector<double> displace(const FemSpace                                 &space,
                             const std::function<Vector3(const Vector3 &x)> &field)
{
  std::vector<double> u;
  for (const Vector3 &x : space.points())
    {
      const Vector3 moved = field(x);
      u.insert(u.end(), moved.data(), moved.data() + 3);
    }
  return u;
}

/** Calls @p look for each facet of the fillets of some teeth. */
template <typename Look>
void for_facets(const RootStress &stress, const Look &look)
{
  for (const MemberFillet &member : stress.fillets())
    for (const unsigned int tooth : {0u, member.fillet.n_teeth() - 1})
      for (unsigned int column = 0; column < member.fillet.n_columns(); ++column)
        for (unsigned int row = Fillet::first_row; row < member.fillet.end_row(); ++row)
          look(member, column, row, tooth);
}

int main(int argc, char **argv)
{
  const TestRanks   ranks(argc, argv);
  const std::string text = few_teeth("set body type = rim only", "set elements through rim = 2") +
                           "subsection Operation\nset speed = 20000 rpm\nset torque = 800 N m\n"
                           "set mesh cycles = 1\nset bore rotation = rigid\nend\n";
  const Model model = make_gear_model("faces.prm", text, ranks.world);
  // Both members expand by 1e-3.
  const std::string hot  = "set temperature = 1e-3/1.2e-5\nend\n";
  const Model       warm = make_gear_model("warm.prm",
                                     text + "subsection Gear pair\nsubsection Pinion\n" + hot +
                                       "subsection Gear\n" + hot + "end\n",
                                     ranks.world);
  const RootStress  stress(model, {}), warm_stress(warm, {});
  Matrix3           growth = 1e-3 * Matrix3::Identity(), any;
  Matrix3           rotation;
  rotation << 0., -5e-4, -3e-4, 5e-4, 0., -2e-4, 3e-4, 2e-4, 0.;
  growth += rotation;
  any << 1e-3, 2e-4, -3e-4, 5e-4, -4e-4, 1e-4, 2e-4, 6e-4, 7e-4;
  for (const auto &choice : fem_element_choices())
    for (const bool divided : {false, true})
      {
        FemSpaceOptions options{choice.second, FemGeometry::straight};
        if (degree_of(choice.second) > 1)
          options.geometry = FemGeometry::curved;
        if (divided)
          options.local_refinement = {"fillets 1"};
        const FemSpace    space(model, {0, 1}, options);
        const FilletFaces faces(space, stress.fillets());
        const std::string name = choice.first + (divided ? ", divided" : "");

        const auto grown  = displace(space, [&](const Vector3 &x) { return growth * x; });
        double     wrong  = 0;
        const auto strain = faces.of(grown);
        for_facets(stress, [&](const MemberFillet &member, unsigned c, unsigned r, unsigned tooth) {
          raise_to(wrong,
                   (strain.facet(member, c, r, tooth) - SurfaceTensor(1e-3, 1e-3, 0.)).norm());
        });
        check_below(name + ": growth and rotation", wrong, 1e-15);

        // Free thermal expansion has no stress.
        const FemSpace    warm_space(warm, {0, 1}, options);
        const FilletFaces warm_faces(warm_space, warm_stress.fillets());
        const auto        rest = warm_faces.of(grown);
        double            left = 0;
        for_facets(warm_stress, [&](const auto &member, unsigned c, unsigned r, unsigned tooth) {
          raise_to(left, rest.facet(member, c, r, tooth).norm());
        });
        check_below(name + ": free thermal expansion", left, 1e-15);

        if (divided || degree_of(choice.second) > 1)
          continue;
        const auto moved    = displace(space, [&](const Vector3 &x) {
          return Vector3(any * x + 1e-5 * x.cwiseProduct(x));
        });
        const auto by_faces = faces.of(moved);
        const auto by_nodes =
          strains_of_displacements(model, [&](const unsigned int body, const unsigned int node) {
            const std::size_t p = space.find_part(body)->first_point + node;
            return Vector3(model.bodies[body].placement.rotation.transpose() *
                           Eigen::Map<const Vector3>(moved.data() + 3 * p));
          });
        double apart = 0;
        for_facets(stress, [&](const MemberFillet &member, unsigned c, unsigned r, unsigned tooth) {
          raise_to(
            apart,
            (by_faces.facet(member, c, r, tooth) - by_nodes.facet(member, c, r, tooth)).norm());
        });
        check_below(name + ": as FacetStrain at the centre", apart, 1e-15);
      }
  return 0;
}
