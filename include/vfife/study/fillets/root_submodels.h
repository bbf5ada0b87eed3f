// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_fillets_root_submodels_h
#define vfife_study_fillets_root_submodels_h

#include <vfife/fem/submodel/sector_submodel.h>
#include <vfife/model/model.h>
#include <vfife/output/measures/root_stress.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class PairCase;
  class Log;
  struct FilletOptions;

  /** Surface strains of the fillets of a gear pair by submodels of its teeth, one of each member,
   * and of webs that have fillets at the hub. */
  class RootSubmodels
  {
  public:
    /** @p followed: the pair with the coarser mesh, which must outlive the object; @p fine: the
     * same pair with the fine mesh. @p gauges: whether strain gauges will be read. Throws as
     * FemSpace and SectorSubmodel. */
    RootSubmodels(const Model &followed, Model fine, bool gauges);
    RootSubmodels(const RootSubmodels &)            = delete;
    RootSubmodels &operator=(const RootSubmodels &) = delete;

    /** The pair whose fillets are read, for RootStress. */
    const Model &fine() const
    {
      return fine_;
    }

    /** That of the teeth, and of the web where it has fillets at the hub. */
    const std::vector<SectorSubmodel> &of_body(const unsigned int body) const
    {
      return members_[body].submodels;
    }

    /** What a body of the pair with the coarser mesh does, in its own axes. */
    struct MemberState
    {
      /** SectorSubmodel::follow(), by place in of_body(). */
      std::function<Eigen::VectorXd(std::size_t submodel, unsigned int sector)> followed;
      SectorSubmodel::ToothForces                                               forces;
      double rate = 0; ///< of its spin [rad/s]
    };

    /** By body; they are taken along. */
    FilletStrains of(std::array<MemberState, 2> states) const;

    /** Unknowns of both. */
    unsigned int n_unknowns() const;

  private:
    /** Where readings of a fillet begin. */
    struct FirstReadings
    {
      std::string  side;
      unsigned int n_columns, n_rows; ///< of facets between root land and flank
      unsigned int facets;            ///< n_points strains of each, column by column
      unsigned int n_points;
      unsigned int tractions; ///< one of each facet
      std::size_t  submodel;  ///< of which they are
    };
    struct Member
    {
      std::vector<FirstReadings>           fillets;
      std::map<unsigned int, unsigned int> nodes; ///< first of a node's displacement, by node
      std::vector<SectorSubmodel>          submodels;
    };

    const FirstReadings &readings_of(const MemberFillet &member) const;
    Member               make_member(unsigned int body, const Body &followed, bool gauges) const;
    /** Adds the submodel of a part. */
    void add_submodel(SubmodelPart    part,
                      const FemSpace &sector,
                      const Body     &followed,
                      bool            gauges,
                      Member         &member) const;

    Model                 fine_;
    std::array<Member, 2> members_;
  };

  /** Those that @p options ask for; nullptr where root stresses are not recorded, or read from the
   * model's own elements. */
  std::unique_ptr<const RootSubmodels> make_root_submodels(const PairCase      &pair_case,
                                                           const FilletOptions &options,
                                                           const Model         &model,
                                                           Log                 &log);
} // namespace vfife

#endif
