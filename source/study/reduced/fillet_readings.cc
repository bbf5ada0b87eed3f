// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/reduced/reduced_pair.h>
#include <vfife/study/fillets/root_submodels.h>
#include <vfife/study/reduced/fillet_readings.h>

#include <map>
#include <string>

namespace vfife
{
  namespace
  {
    /** Of the first component; those of 22 and 12 follow. */
    std::string
    name_of_facet(const MemberFillet &member, const unsigned int column, const unsigned int row)
    {
      return "strain " + member.fillet.side() + " fillet " + std::to_string(column) + " " +
             std::to_string(row);
    }

    std::string name_of_submodel_reading(const std::size_t submodel, const Eigen::Index row)
    {
      return "submodel " + std::to_string(submodel) + " reading " + std::to_string(row);
    }

    std::string name_of_gauge(const MemberGauge &gauge)
    {
      return "gauge " + gauge.name;
    }

    using Strains = std::function<Eigen::VectorXd(const FilletStrains &)>;

    /** The strains under unit displacements of each node, by node. */
    std::map<unsigned int, Eigen::MatrixXd> differentiate(const Model                     &model,
                                                          const std::vector<unsigned int> &nodes,
                                                          const Strains                   &strains)
    {
      std::map<unsigned int, Eigen::MatrixXd> derivatives;
      for (const unsigned int node : nodes)
        {
          Eigen::MatrixXd derivative;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Eigen::VectorXd column =
                strains(strains_of_displacements(model, [&](unsigned int, const unsigned int i) {
                  return Vector3(double(i == node) * Vector3::Unit(c));
                }));
              derivative.conservativeResize(column.size(), 3);
              derivative.col(c) = column;
            }
          derivatives[node] = derivative;
        }
      return derivatives;
    }

    void add_readings(const std::string                             &name,
                      const std::map<unsigned int, Eigen::MatrixXd> &derivatives,
                      std::vector<SectorReading>                    &readings)
    {
      const unsigned int n = derivatives.begin()->second.rows();
      for (unsigned int k = 0; k < n; ++k)
        {
          SectorReading reading{k == 0 ? name : name + " component " + std::to_string(k), {}};
          for (const auto &[node, derivative] : derivatives)
            if (!derivative.row(k).isZero(0.))
              reading.weights.emplace_back(node, derivative.row(k).transpose());
          readings.push_back(std::move(reading));
        }
    }
  } // namespace

  std::vector<SectorReading>
  list_fillet_readings(const Model &model, const RootStress &stress, const unsigned int body)
  {
    std::vector<SectorReading> readings;
    for (const MemberFillet &member : stress.fillets())
      {
        if (member.body != body)
          continue;
        const Fillet             &fillet = member.fillet;
        std::vector<unsigned int> all;
        for (unsigned int column = 0; column <= fillet.n_columns(); ++column)
          for (unsigned int row = 0; row <= fillet.n_rows(); ++row)
            all.push_back(fillet.node(column, row, 0));
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row)
            {
              const auto corners = fillet.facet(column, row, 0);
              add_readings(name_of_facet(member, column, row),
                           differentiate(model,
                                         {corners.begin(), corners.end()},
                                         [&](const FilletStrains &strains) -> Eigen::VectorXd {
                                           return strains.facet(member, column, row, 0);
                                         }),
                           readings);
            }
        for (const MemberGauge &gauge : stress.gauges())
          if (gauge.body == body && &gauge.gauge.fillet() == &fillet)
            add_readings(name_of_gauge(gauge),
                         differentiate(model,
                                       all,
                                       [&](const FilletStrains &strains) -> Eigen::VectorXd {
                                         return Eigen::VectorXd::Constant(1,
                                                                          strains.gauge(gauge, 0));
                                       }),
                         readings);
      }
    return readings;
  }

  FilletMeasure measure_fillet_readings(const ReducedPair &pair)
  {
    return [&pair](const State &) -> FilletStrains {
      // The state of the pair's members once for all readings.
      std::vector<PairReader::Reading> read;
      for (unsigned int b = 0; b < 2; ++b)
        read.push_back(pair.reader().reading_of(b));
      return {
        [&pair, read](const MemberFillet &member,
                      const unsigned int  column,
                      const unsigned int  row,
                      const unsigned int  tooth) {
          const unsigned int first =
            pair.body(member.body).find_reading(name_of_facet(member, column, row));
          const auto &body = read[member.body];
          return SurfaceTensor(body(first, tooth), body(first + 1, tooth), body(first + 2, tooth));
        },
        [&pair, read](const MemberGauge &gauge, const unsigned int tooth) {
          return read[gauge.body](pair.body(gauge.body).find_reading(name_of_gauge(gauge)), tooth);
        }};
    };
  }

  std::vector<SectorReading> list_submodel_readings(const std::vector<SectorSubmodel> &submodels)
  {
    std::vector<SectorReading> readings;
    for (std::size_t k = 0; k < submodels.size(); ++k)
      {
        const std::vector<unsigned int> &nodes   = submodels[k].followed_nodes();
        const Eigen::MatrixXd           &weights = submodels[k].of_displacements();
        for (Eigen::Index row = 0; row < weights.rows(); ++row)
          {
            readings.push_back({name_of_submodel_reading(k, row), {}});
            for (std::size_t i = 0; i < nodes.size(); ++i)
              readings.back().weights.emplace_back(nodes[i],
                                                   weights.block<1, 3>(row, 3 * i).transpose());
          }
      }
    return readings;
  }

  FilletMeasure measure_submodel_readings(const Model         &model,
                                          const RootSubmodels &submodels,
                                          const ReducedPair   &pair)
  {
    std::array<std::vector<unsigned int>, 2> flanks;
    std::array<std::vector<unsigned int>, 2> firsts; ///< by submodel
    for (unsigned int b = 0; b < flanks.size(); ++b)
      {
        flanks[b] = submodels.of_body(b).front().list_flank_nodes();
        for (std::size_t k = 0; k < submodels.of_body(b).size(); ++k)
          firsts[b].push_back(pair.body(b).find_reading(name_of_submodel_reading(k, 0)));
      }
    return [&model, &submodels, &pair, flanks, firsts](const State &state) {
      std::array<RootSubmodels::MemberState, 2> states;
      for (unsigned int b = 0; b < states.size(); ++b)
        {
          const auto &parts  = submodels.of_body(b);
          states[b].rate     = pair.body(b).rate;
          states[b].followed = [&parts, first = firsts[b], read = pair.reader().reading_of(b)](
                                 const std::size_t k, const unsigned int sector) {
            Eigen::VectorXd values(parts[k].of_displacements().rows());
            for (Eigen::Index row = 0; row < values.size(); ++row)
              values[row] = read(first[k] + row, sector);
            return values;
          };
          // Forces act in the fixed frame, on the body as it has turned.
          const Matrix3 to_body = pair.body_motion(b).rotation.transpose();
          for (const unsigned int node : flanks[b])
            {
              const Vector3 force = state.contact_force.value(model.bodies[b].first_node + node);
              if (!force.isZero(0.))
                parts.front().add_nodal_force(node, to_body * force, states[b].forces);
            }
        }
      return submodels.of(std::move(states));
    };
  }
} // namespace vfife
