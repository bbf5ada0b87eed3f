// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_dynamics_operator_vfife_operator_h
#define vfife_dynamics_operator_vfife_operator_h

#include <vfife/dynamics/operator/halo_exchange.h>
#include <vfife/dynamics/operator/pack_layout.h>
#include <vfife/element/frame_kind.h>
#include <vfife/element/kernels/kernels.h>
#include <vfife/element/stiffness.h>

#include <map>
#include <string>
#include <vector>

namespace vfife
{
  class Communicator;
  struct Model;

  /** The element that decides the time step. */
  struct LimitingElement
  {
    double      frequency = 0; ///< largest circular frequency of the free element [rad/s]
    std::string body;
    unsigned    element  = 0;               ///< of the body
    Vector3     centroid = Vector3::Zero(); ///< body frame [mm]

    double stable_step() const
    {
      return 2. / frequency;
    }
  };

  /** How the elements are stored and computed; nothing here changes results but by round-off,
   * except single precision and mass scaling. */
  struct OperatorLayout
  {
    bool share_constants = true; ///< of congruent elements; else each element has its own
    /** Hourglass blocks H of elements with constants of their own are stored in single precision
     * (computed with in double): relative error 6e-8 of H alone, mean strains stay exact. */
    bool single_hourglass = false;
    /** Elements have at least this stable step by added mass, see scale_masses() [s]; 0: none. */
    double         mass_scaling_step = 0;
    InstructionSet instruction_set   = best_instruction_set();
  };

  /** What a pass over the elements measures beside their forces. */
  struct ElementMeasures
  {
    double strain_energy  = 0; ///< of all ranks [mJ]
    double least_jacobian = 0; ///< det(dx/dxi) at a corner on this rank [mm^3]; <= 0: inverted
    std::uint32_t least_element = 0; ///< of the model, where that is
  };

  /**
   * The internal forces of massless hexahedra between mass points (VFIFE): partition over ranks,
   * packed layout, congruence classes, kernels of the best instruction set. Built once for a model.
   *
   * Index of a node: fields are ordered by the local nodes of partition(). Vertex v of body b's
   * deal.II triangulation is node n = model.bodies[b].first_node + v of the model, and local node
   * partition().local_node[n], Partition::absent where another rank has it.
   *
   * Sign of a force: it acts on the node and restores the shape, minus the derivative of the strain
   * energy. Mass times acceleration is internal force plus load; the residual of an assembled
   * finite element method (K u) has the other sign.
   */
  class VfifeOperator
  {
  public:
    VfifeOperator(const Model        &model,
                  FrameKind           frame,
                  StiffnessKind       stiffness,
                  const Communicator &communicator,
                  OperatorLayout      layout = {});

    VfifeOperator(const VfifeOperator &)            = delete;
    VfifeOperator &operator=(const VfifeOperator &) = delete;

    const Partition &partition() const;
    FrameKind        frame() const;
    StiffnessKind    stiffness() const;

    /** Goes on with other kernels: what is stored is the same for all. */
    void use_kernels(FrameKind frame, InstructionSet instruction_set);

    /** Zeros at the local nodes and at one more, which unused lanes write to: the fields that this
     * class works on have its size. */
    NodeField make_field() const;

    /** Sets @p forces [N] (on all copies of a node) to the internal forces at the present
     * @p positions [mm] (not displacements). Collective. */
    void compute_internal_forces(const NodeField &positions, NodeField &forces);

    /** The same, and what the elements show besides. */
    ElementMeasures measure_internal_forces(const NodeField &positions, NodeField &forces);

    /** The worst element over all ranks. */
    const LimitingElement &limiting_element() const;

    /** Stable step of the elements if the @p n worst ones were not there [s]. Collective. */
    double stable_step_without(unsigned int n) const;

    /** Lumped masses of the local nodes [t]. */
    const std::vector<double> &masses() const;

    /**
     * Nodal masses for a relaxation with pseudo time step 1: every element's share is scaled such
     * that its largest frequency is 2 @p fraction. Summed over ranks. Collective.
     */
    std::vector<double> compute_relaxation_masses(double fraction);

    /** Elements of the model on this rank that a local node belongs to (searched: for a few nodes
     * at observations). */
    const std::vector<std::uint32_t> &elements_at(std::uint32_t local_node) const;

    std::size_t n_local_elements() const;
    std::size_t n_congruence_classes() const;
    const char *instruction_set() const;

    /** Number of elements with their own constants, on this rank. */
    std::size_t n_own_elements() const;
    /** What one element with its own constants reads of them [bytes]. */
    unsigned int own_bytes() const;

    /** Sums the vectors of a field over ranks, see HaloExchange. */
    void add_over_ranks(NodeField &values);

  private:
    struct Group
    {
      std::vector<std::uint32_t> nodes;
      std::vector<double>        constants;
      std::vector<float>         hourglass;
      std::vector<std::uint32_t> constants_row;
      std::vector<std::uint32_t> element; ///< of the model, or absent
      ElementPacks               packs;
      std::size_t                n_at_border = 0; ///< packs, the first ones
    };

    /**
     * Sets @p forces to zero, calls @p add(group, first, last) for all packs, those that touch
     * nodes of other ranks first, and sums over the ranks while the others are computed.
     */
    template <typename Add>
    void for_all_packs(NodeField &forces, const Add &add);

    void add_group(const Model &model, unsigned int body, bool shared);
    void copy_own_constants(const std::vector<double> &class_constants,
                            const BodyPacks           &packs,
                            Group                     &group) const;
    void compute_class_data(const Model &model);
    void find_limiting_element(const Model &model);

    const Communicator        &communicator_;
    FrameKind                  frame_;
    StiffnessKind              stiffness_;
    OperatorLayout             layout_;
    std::vector<std::uint32_t> rank_of_element_;
    std::vector<BodyPacks>     body_packs_;
    Partition                  partition_;
    HaloExchange               halo_;
    const ElementKernels      *kernels_;
    std::vector<Group>         groups_;
    std::vector<double>        masses_;
    LimitingElement            limiting_element_;
    std::vector<double>        element_energies_, element_jacobians_;

    /** Per body and class: constants of the kernel, lumped masses of the element's nodes, largest
     * frequency. */
    struct ClassData
    {
      std::vector<double>                constants;
      std::vector<std::array<double, 8>> masses;
      std::vector<double>                frequency;
    };
    std::vector<ClassData>                                      class_data_;
    std::vector<std::uint32_t>                                  first_element_; ///< per body
    mutable std::map<std::uint32_t, std::vector<std::uint32_t>> elements_at_;   ///< found so far
    std::vector<std::vector<std::array<std::uint32_t, 8>>>
      local_elements_; ///< local nodes of each row of BodyPacks::elements
  };
} // namespace vfife

#endif
