// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/process/wall_clock.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/stress/fillet_options.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/fillets/face_strains.h>
#include <vfife/study/fillets/facet_readings.h>
#include <vfife/study/fillets/root_submodels.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** The point of a node of tooth 0, which may be the next sector's. */
    unsigned int point_of(const FemSpace &sector, const Body &body, const unsigned int node)
    {
      const unsigned int first =
        sector.parts().front().first_point + body.structure().first_copy(node);
      if (body.structure().sector_of(node) == 0)
        return first;
      return std::find_if(sector.images().begin(),
                          sector.images().end(),
                          [first](const auto &image) { return image.second == first; })
        ->first;
    }
  } // namespace

  RootSubmodels::RootSubmodels(const Model &followed, Model fine, const bool gauges)
    : fine_(std::move(fine))
  {
    for (unsigned int body = 0; body < members_.size(); ++body)
      members_[body] = make_member(body, followed.bodies[body], gauges);
  }

  RootSubmodels::Member
  RootSubmodels::make_member(const unsigned int body, const Body &followed, const bool gauges) const
  {
    const FemSpace sector =
      FemSpace::sector_of(fine_, body, {FemElement::quadratic, FemGeometry::curved});
    Member member;
    add_submodel(SubmodelPart::teeth, sector, followed, gauges, member);
    const auto sides = Fillet::list_sides(fine_.bodies[body]);
    if (std::any_of(sides.begin(), sides.end(), [](const std::string &side) {
          return Fillet::is_at_hub(side);
        }))
      add_submodel(SubmodelPart::web, sector, followed, false, member);
    return member;
  }

  void RootSubmodels::add_submodel(const SubmodelPart part,
                                   const FemSpace    &sector,
                                   const Body        &followed,
                                   const bool         gauges,
                                   Member            &member) const
  {
    const Body               &fine = fine_.bodies[sector.parts().front().body];
    std::vector<PointReading> readings;
    for (const std::string &side : Fillet::list_sides(fine))
      {
        if (Fillet::is_at_hub(side) != (part == SubmodelPart::web))
          continue;
        const Fillet       fillet(fine, side);
        const unsigned int first = readings.size(), n_rows = fillet.end_row() - Fillet::first_row;
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row)
            for (PointReading &reading : read_facet(sector, fillet.facet(column, row, 0)))
              readings.push_back(std::move(reading));
        const unsigned int n_points = (readings.size() - first) / (3 * fillet.n_columns() * n_rows);
        member.fillets.push_back({side,
                                  fillet.n_columns(),
                                  n_rows,
                                  first,
                                  n_points,
                                  static_cast<unsigned int>(readings.size()),
                                  member.submodels.size()});
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row)
            readings.push_back(read_traction(sector, fillet.facet(column, row, 0)));
        for (unsigned int column = 0; gauges && column <= fillet.n_columns(); ++column)
          for (unsigned int row = 0; row <= fillet.n_rows(); ++row)
            {
              const unsigned int node = fillet.node(column, row, 0);
              if (!member.nodes.emplace(node, readings.size()).second)
                continue;
              for (unsigned int c = 0; c < 3; ++c)
                readings.push_back({{point_of(sector, fine, node), Vector3::Unit(c)}});
            }
      }
    member.submodels.emplace_back(part, sector, followed, readings);
  }

  const RootSubmodels::FirstReadings &RootSubmodels::readings_of(const MemberFillet &member) const
  {
    const std::vector<FirstReadings> &fillets = members_[member.body].fillets;
    return *std::find_if(fillets.begin(), fillets.end(), [&member](const FirstReadings &one) {
      return one.side == member.fillet.side();
    });
  }

  FilletStrains RootSubmodels::of(std::array<MemberState, 2> states) const
  {
    // Each sector that is looked at is read once.
    using Values = std::map<std::array<std::size_t, 3>, Eigen::VectorXd>;
    const auto read =
      [this,
       states = std::make_shared<const std::array<MemberState, 2>>(std::move(states)),
       known  = std::make_shared<Values>()](const unsigned int body,
                                           const std::size_t  submodel,
                                           const unsigned int tooth) -> const Eigen::VectorXd & {
      const auto [place, is_new] = known->try_emplace({{body, submodel, tooth}});
      if (is_new)
        {
          const MemberState &state = (*states)[body];
          place->second            = state.followed(submodel, tooth) +
                          members_[body].submodels[submodel].load(tooth, state.forces, state.rate);
        }
      return place->second;
    };
    FilletStrains strains;
    strains.facet = [this, read](const MemberFillet &member,
                                 const unsigned int  column,
                                 const unsigned int  row,
                                 const unsigned int  tooth) {
      const FirstReadings   &fillet = readings_of(member);
      const Eigen::VectorXd &values = read(member.body, fillet.submodel, tooth);
      const unsigned int     facet  = column * fillet.n_rows + row - Fillet::first_row;
      WorstStrain            worst(member.fillet.material());
      for (unsigned int i = 0; i < fillet.n_points; ++i)
        worst.add(member.fillet.without_initial_strain(
          values.segment<3>(fillet.facets + 3 * (facet * fillet.n_points + i)),
          column,
          row,
          tooth));
      return worst.strain();
    };
    strains.traction = [this, read](const MemberFillet &member,
                                    const unsigned int  column,
                                    const unsigned int  row,
                                    const unsigned int  tooth) {
      const FirstReadings &fillet   = readings_of(member);
      const Material      &material = member.fillet.material();
      return read(member.body,
                  fillet.submodel,
                  tooth)[fillet.tractions + column * fillet.n_rows + row - Fillet::first_row] -
             (3. * material.lambda() + 2. * material.mu()) *
               member.fillet.initial_strain(column, row, tooth);
    };
    strains.gauge = [this, read](const MemberGauge &gauge, const unsigned int tooth) {
      const Eigen::VectorXd &values    = read(gauge.body, 0, tooth);
      const BodyStructure   &structure = fine_.bodies[gauge.body].structure();
      const Matrix3          turned    = structure.turn(static_cast<int>(tooth));
      return gauge.gauge.of_displacements(
        [&](const unsigned int node) -> Vector3 {
          const unsigned int of_tooth_0 = structure.copy(node, -static_cast<int>(tooth));
          return turned * values.segment<3>(members_[gauge.body].nodes.at(of_tooth_0));
        },
        tooth);
    };
    return strains;
  }

  unsigned int RootSubmodels::n_unknowns() const
  {
    unsigned int n = 0;
    for (const Member &member : members_)
      for (const SectorSubmodel &submodel : member.submodels)
        n += submodel.n_unknowns();
    return n;
  }

  std::unique_ptr<const RootSubmodels> make_root_submodels(const PairCase      &pair_case,
                                                           const FilletOptions &options,
                                                           const Model         &model,
                                                           Log                 &log)
  {
    if (!options.follows_submodels())
      return nullptr;
    const auto           start = WallClock::now();
    std::optional<Model> fine  = pair_case.make_submodel_mesh(options.submodel_elements);
    if (!fine)
      return nullptr;
    auto submodels =
      std::make_unique<const RootSubmodels>(model, std::move(*fine), !options.gauges.empty());
    log.line("submodels of teeth and webs: ",
             submodels->n_unknowns(),
             " unknowns, found in ",
             seconds_since(start),
             " s");
    for (const Body &body : model.bodies)
      if (body.has_node_set(node_set::web_front) && !body.has_node_set(node_set::hub_fillet_front))
        log.line(body.name(),
                 ": no stress of the web at the hub, because a sharp corner has no finite one; set "
                 "hub fillet radius");
    return submodels;
  }
} // namespace vfife
