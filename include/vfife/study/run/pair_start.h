// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_run_pair_start_h
#define vfife_study_run_pair_start_h

#include <vfife/dynamics/equilibrium/relaxation.h>
#include <vfife/fem/pair/pair_equilibrium.h>
#include <vfife/output/files/figures.h>

#include <functional>
#include <memory>
#include <string>

namespace vfife
{
  class PairCase;

  /** What settle_penalties() leaves besides the penalties. */
  struct SettledPenalties
  {
    /** Of the pair; nullptr where no penalty was open. */
    std::shared_ptr<Compliance> compliance;
    /** The mean transmission error of quadratic elements, where they were asked. */
    NamedFigures figures;
  };

  /** Finds the penalties that a case leaves open (calibrate_penalty()) for bodies of the elements
   * @p fem. Collective. */
  SettledPenalties settle_penalties(const PairCase     &the_case,
                                    const FemOptions   &fem,
                                    const Communicator &communicator,
                                    Log                &log,
                                    Model              &model);

  /**
   * Equilibrium of a gear pair in the frames that turn with its bodies, found in a few rounds: the
   * forces out of balance are those of the VFIFE operator and its contact, and what the bodies do
   * under them is told by the factors of the conventional stiffness matrix
   * (doc/theory/equilibrium.md, The preloaded start). The result is the operator's own equilibrium,
   * up to the tolerance of the relaxation, which also does the rest where the rounds do not get
   * there.
   */
  class PairStart
  {
  public:
    /** @p compliance: of the model with make_fem_options(), in spin where Model::any_body_turns();
     * nullptr: is factorized here. Throws as Compliance and PairEquilibrium. */
    PairStart(const Model                &model,
              const DynamicsOptions      &options,
              Relaxation                 &relaxation,
              std::shared_ptr<Compliance> compliance,
              const Communicator         &communicator,
              Log                        &log);

    /** Moves the positions of @p state into equilibrium and says in words how that went. Throws
     * NumericalError as Relaxation and PairEquilibrium. */
    std::string solve(State &state, const Relaxation::Loads &loads);

    /** find_static_errors(); empty unless the start is `steady torsional vibration`, and for pairs
     * on shafts. */
    const std::vector<double> &static_errors() const
    {
      return static_errors_;
    }

  private:
    using NodeVector = std::function<Vector3(unsigned int body, std::uint32_t local)>;

    /** Among the points of the space, of a local node. */
    std::size_t point_of(const State &state, const FemSpace::Part &part, std::uint32_t local) const;
    Matrix3     rotation(unsigned int body) const;
    std::vector<double> gather(const State &state, const NodeVector &vector) const;
    std::vector<double> displacements(const State &state) const;
    std::vector<double> turned_back(const State &state, const NodeField &forces) const;
    double              moment(const State &state, const NodeField &forces) const;
    void                place(const std::vector<double> &u, State &state) const;

    const Model                     &model_;
    Relaxation                      &relaxation_;
    const Communicator              &communicator_;
    std::shared_ptr<Compliance>      compliance_;
    std::vector<double>              static_errors_;
    std::unique_ptr<PairEquilibrium> pair_;
    double                           turn_ = 0; ///< of the driven body about its axis [rad]
  };
} // namespace vfife

#endif
