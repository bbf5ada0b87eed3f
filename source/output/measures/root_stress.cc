// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/column_names.h>
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/output/measures/root_stress.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    /** The corners' vectors of a facet. */
    template <typename Vectors>
    FacetCorners
    gather(const Fillet &fillet, unsigned column, unsigned row, unsigned tooth, const Vectors &of)
    {
      const auto   nodes = fillet.facet(column, row, tooth);
      FacetCorners corners;
      for (unsigned int k = 0; k < 4; ++k)
        corners.col(k) = of(nodes[k]);
      return corners;
    }

    FacetStrain undeformed(
      const Model &model, const MemberFillet &member, unsigned column, unsigned row, unsigned tooth)
    {
      const auto &X = model.bodies[member.body].node_positions();
      return FacetStrain(
        gather(member.fillet, column, row, tooth, [&X](const unsigned i) { return X[i]; }));
    }

    /** What the strains of displacements and of places share: vectors of one body. */
    using Vectors = std::function<Vector3(unsigned, unsigned)>;

    Gauge::NodeVectors of_body(const Vectors &vectors, const unsigned int body)
    {
      return [&vectors, body](const unsigned int node) { return vectors(body, node); };
    }
  } // namespace

  FilletStrains strains_of_displacements(const Model &model, Vectors u)
  {
    return {[&model, u](const MemberFillet &member, unsigned column, unsigned row, unsigned tooth) {
              return member.fillet.without_initial_strain(
                undeformed(model, member, column, row, tooth)
                  .of_displacements(
                    gather(member.fillet, column, row, tooth, of_body(u, member.body))),
                column,
                row,
                tooth);
            },
            [u](const MemberGauge &member, const unsigned tooth) {
              return member.gauge.of_displacements(of_body(u, member.body), tooth);
            }};
  }

  FilletStrains strains_of_places(const Model &model, Vectors places)
  {
    return {
      [&model, places](const MemberFillet &member, unsigned column, unsigned row, unsigned tooth) {
        return member.fillet.without_initial_strain(
          undeformed(model, member, column, row, tooth)
            .of_places(gather(member.fillet, column, row, tooth, of_body(places, member.body))),
          column,
          row,
          tooth);
      },
      [places](const MemberGauge &member, const unsigned tooth) {
        return member.gauge.of_places(of_body(places, member.body), tooth);
      }};
  }

  SampleColumns<RootStressSample> list_root_stress_columns()
  {
    using Sample = const RootStressSample &;
    SampleColumns<RootStressSample> columns;
    columns.add_text("body", [](Sample sample) { return sample.body; });
    columns.add_text(column::fillet, [](Sample sample) { return sample.fillet; });
    columns.add("tooth", "-", [](Sample sample) { return sample.tooth; });
    columns.add(column::after_mean_contact, "mesh cycles", [](Sample sample) {
      return sample.after_mesh;
    });
    const auto add = [&columns](const std::string &name, RootExtreme RootStressSample::*extreme) {
      columns.add(name, "MPa", [extreme](Sample sample) { return (sample.*extreme).stress; });
      columns.add(name + " along the face", "mm", [extreme](Sample sample) {
        return (sample.*extreme).place[0];
      });
      columns.add(name + " up the profile", "mm", [extreme](Sample sample) {
        return (sample.*extreme).place[1];
      });
    };
    add(column::tension, &RootStressSample::tension);
    add(column::compression, &RootStressSample::compression);
    return columns;
  }

  SampleColumns<GaugeSample> list_gauge_columns()
  {
    using Sample = const GaugeSample &;
    SampleColumns<GaugeSample> columns;
    columns.add_text("gauge", [](Sample sample) { return sample.gauge; });
    columns.add(column::after_mean_contact, "mesh cycles", [](Sample sample) {
      return sample.after_mesh;
    });
    columns.add("strain", "um/m", [](Sample sample) { return 1e6 * sample.strain; });
    return columns;
  }

  RootStress::RootStress(const Model &model, const FilletOptions &options)
    : model_(model)
    , teeth_(options.teeth)
  {
    const Transmission &t = *model.only_transmission();
    for (const unsigned int body : {t.driver, t.driven})
      {
        named_teeth_[body] = options.read_named_teeth(model.bodies[body].name(), count_teeth(body));
        for (const std::string &side : Fillet::list_sides(model.bodies[body]))
          {
            fillets_.push_back({body, Fillet(model.bodies[body], side)});
            const Fillet &fillet = fillets_.back().fillet;
            ranges_.emplace_back(fillet.n_columns() * (fillet.end_row() - Fillet::first_row));
            passages_.emplace_back(ranges_.back().size());
          }
      }
    for (const auto &[name, gauge] : options.gauges)
      for (const MemberFillet &member : fillets_)
        if (model.bodies[member.body].name() == gauge.body && member.fillet.side() == gauge.side)
          gauges_.push_back({name,
                             member.body,
                             gauge.tooth,
                             Gauge(model.bodies[member.body],
                                   member.fillet,
                                   gauge,
                                   std::string(FilletOptions::section) + "/Gauge " + name)});
  }

  unsigned int RootStress::count_teeth(const unsigned int body) const
  {
    return find_member(*model_.only_transmission(), body).teeth;
  }

  std::vector<unsigned int> RootStress::recorded_teeth(const unsigned int               body,
                                                       const std::vector<ToothContact> &teeth) const
  {
    const unsigned int     z = count_teeth(body);
    std::set<unsigned int> recorded;
    if (teeth_ == RecordedTeeth::named)
      recorded = named_teeth_.at(body);
    if (teeth_ == RecordedTeeth::all)
      for (unsigned int tooth = 0; tooth < z; ++tooth)
        recorded.insert(tooth);
    if (teeth_ == RecordedTeeth::in_contact)
      for (const ToothContact &contact : teeth)
        {
          const unsigned int tooth = model_.contacts[contact.contact].slave_body == body
                                       ? contact.slave_group
                                       : contact.master_group;
          for (const unsigned int step : {z - 1, 0u, 1u})
            recorded.insert((tooth + step) % z);
        }
    return {recorded.begin(), recorded.end()};
  }

  double RootStress::after_mesh(const unsigned int body,
                                const unsigned int tooth,
                                const double       meshes) const
  {
    // A tooth ahead in the sense of the body's rotation has been where tooth 0 is now.
    const MemberOfPair member = find_member(*model_.only_transmission(), body);
    const double       z = member.teeth, after = meshes + member.sense * tooth;
    return after - z * std::floor(after / z + .5);
  }

  RootStressSample RootStress::measure_tooth(const std::size_t    i,
                                             const unsigned int   tooth,
                                             const double         meshes,
                                             const FilletStrains &strains)
  {
    const MemberFillet &member = fillets_[i];
    const Fillet       &fillet = member.fillet;
    RootStressSample    sample{model_.bodies[member.body].name(),
                            fillet.side(),
                            tooth,
                            after_mesh(member.body, tooth, meshes),
                            {},
                            {}};
    auto                range   = ranges_[i].begin();
    auto                passage = passages_[i].begin();
    for (unsigned int column = 0; column < fillet.n_columns(); ++column)
      for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row, ++range, ++passage)
        {
          const PrincipalStresses stress = compute_principal_stresses(
            compute_surface_stress(strains.facet(member, column, row, tooth), fillet.material()));
          const Vector2 place = fillet.centre(column, row);
          if (stress.first > range->tension)
            {
              range->tension   = stress.first;
              passage->tension = sample.after_mesh;
            }
          if (stress.third < range->compression)
            {
              range->compression   = stress.third;
              passage->compression = sample.after_mesh;
            }
          if (stress.first > sample.tension.stress)
            sample.tension = {stress.first,
                              place,
                              strains.traction ? strains.traction(member, column, row, tooth) : 0.};
          if (stress.third < sample.compression.stress)
            sample.compression = {stress.third, place};
        }
    return sample;
  }

  std::vector<RootStressSample> RootStress::measure(const double                     meshes,
                                                    const std::vector<ToothContact> &teeth,
                                                    const FilletStrains             &strains)
  {
    std::vector<RootStressSample> samples;
    for (std::size_t i = 0; i < fillets_.size(); ++i)
      if (!fillets_[i].fillet.is_at_hub())
        for (const unsigned int tooth : recorded_teeth(fillets_[i].body, teeth))
          samples.push_back(measure_tooth(i, tooth, meshes, strains));
      else if (teeth_ != RecordedTeeth::none)
        {
          RootStressSample largest = measure_tooth(i, 0, meshes, strains);
          for (unsigned int sector = 1; sector < fillets_[i].fillet.n_teeth(); ++sector)
            if (RootStressSample here = measure_tooth(i, sector, meshes, strains);
                here.tension.stress > largest.tension.stress)
              largest = std::move(here);
          samples.push_back(std::move(largest));
        }
    return samples;
  }

  std::vector<GaugeSample> RootStress::read_gauges(const double         meshes,
                                                   const bool           copies,
                                                   const FilletStrains &strains) const
  {
    std::vector<GaugeSample> samples;
    for (const MemberGauge &gauge : gauges_)
      {
        const unsigned int z = count_teeth(gauge.body);
        for (unsigned int k = 0; k < (copies ? z : 1u); ++k)
          {
            const unsigned int tooth = (gauge.tooth + k) % z;
            samples.push_back(
              {gauge.name, after_mesh(gauge.body, tooth, meshes), strains.gauge(gauge, tooth)});
          }
      }
    return samples;
  }

  Table make_fillet_envelope_table()
  {
    Table table{{"body"}, {column::fillet}};
    for (const char *name : {"face from", "face to", "profile from", "profile to"})
      table.add_column(name, "mm");
    for (const char *name : {column::tension, column::compression, "range"})
      table.add_column(name, "MPa");
    return table;
  }

  Table RootStress::envelope() const
  {
    Table table = make_fillet_envelope_table();
    for (std::size_t i = 0; i < fillets_.size(); ++i)
      {
        const Fillet &fillet = fillets_[i].fillet;
        auto          range  = ranges_[i].begin();
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          for (unsigned int row = Fillet::first_row; row < fillet.end_row(); ++row, ++range)
            {
              const auto face = [&](const unsigned int c) {
                return .5 * (fillet.face_length(c, row) + fillet.face_length(c, row + 1));
              };
              const auto profile = [&](const unsigned int r) {
                return .5 *
                       (fillet.profile_length(column, r) + fillet.profile_length(column + 1, r));
              };
              table.add_row({model_.bodies[fillets_[i].body].name(),
                             fillet.side(),
                             face(column),
                             face(column + 1),
                             profile(row),
                             profile(row + 1),
                             range->tension,
                             range->compression,
                             range->range()});
            }
      }
    return table;
  }

  Table make_root_section_table()
  {
    Table table{{"body"}, {column::fillet}};
    for (const char *name : {"face from", "face to"})
      table.add_column(name, "mm");
    for (const std::string name : {column::tension, column::compression})
      {
        table.add_column(name, "MPa");
        table.add_column(name + " up the profile", "mm");
        table.add_column(name + " after the mean contact", "mesh cycles");
      }
    table.add_column("range", "MPa");
    return table;
  }

  Table RootStress::sections() const
  {
    Table table = make_root_section_table();
    for (std::size_t i = 0; i < fillets_.size(); ++i)
      {
        const Fillet      &fillet = fillets_[i].fillet;
        const unsigned int n      = fillet.end_row() - Fillet::first_row;
        for (unsigned int column = 0; column < fillet.n_columns(); ++column)
          {
            // Rows of the largest stresses, of one above the other.
            const auto begin   = ranges_[i].begin() + column * n;
            const auto largest = [&](const auto &value) -> unsigned int {
              return std::max_element(begin,
                                      begin + n,
                                      [&](const Range &a, const Range &b) {
                                        return value(a) < value(b);
                                      }) -
                     begin;
            };
            const unsigned int tension     = largest([](const Range &r) { return r.tension; }),
                               compression = largest([](const Range &r) { return -r.compression; }),
                               range       = largest([](const Range &r) { return r.range(); });
            const auto profile             = [&](const unsigned int row) {
              return fillet.centre(column, Fillet::first_row + row)[1];
            };
            const auto face = [&](const unsigned int c) {
              return .5 * (fillet.face_length(c, Fillet::first_row) +
                           fillet.face_length(c, fillet.end_row()));
            };
            const Passage *passages = passages_[i].data() + column * n;
            table.add_row({model_.bodies[fillets_[i].body].name(),
                           fillet.side(),
                           face(column),
                           face(column + 1),
                           begin[tension].tension,
                           profile(tension),
                           passages[tension].tension,
                           begin[compression].compression,
                           profile(compression),
                           passages[compression].compression,
                           begin[range].range()});
          }
      }
    return table;
  }

  std::vector<MemberFilletStress> RootStress::list_members() const
  {
    std::vector<MemberFilletStress> members;
    const Transmission             &t = *model_.only_transmission();
    for (const bool at_hub : {false, true})
      for (const unsigned int body : {t.driver, t.driven})
        {
          MemberFilletStress member{model_.bodies[body].name(), at_hub};
          bool               has_any = false;
          for (std::size_t i = 0; i < fillets_.size(); ++i)
            if (fillets_[i].body == body && fillets_[i].fillet.is_at_hub() == at_hub)
              for (const Range &range : ranges_[i])
                {
                  has_any            = true;
                  member.tension     = std::max(member.tension, range.tension);
                  member.compression = std::min(member.compression, range.compression);
                  member.range       = std::max(member.range, range.range());
                }
          if (has_any)
            members.push_back(member);
        }
    return members;
  }

  void RootStress::serialize(ByteStream &stream)
  {
    for (std::vector<Range> &ranges : ranges_)
      stream.pass_known(ranges);
  }

  void RootStress::serialize_passages(ByteStream &stream)
  {
    for (std::vector<Passage> &passages : passages_)
      stream.pass_known(passages);
  }
} // namespace vfife
