// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_source_fem_distributed_distributed_loads_h
#define vfife_source_fem_distributed_distributed_loads_h

#include "distributed_space.h"

#include <vfife/model/load_shares.h>

namespace vfife
{
  /** Adds loads and torques of the model to forces of a distributed body: what add_load_forces()
   * and add_torque_forces() do on a space. All functions are collective. */
  class DistributedLoads
  {
  public:
    /** Both must outlive this. */
    DistributedLoads(const Model &model, const DistributedSpace &space);

    /** Throws InputError for a load that its nodes cannot carry. */
    void add_load(const Load &load, double factor);
    /** @p value [N mm]. */
    void add_torque(const Torque &torque, double value);

    /** [N]; what hangs has passed its force on. May be called once. */
    const DistributedVector &finish();

  private:
    /** A point and its part of a sum. */
    struct Share
    {
      PointDofs dofs;
      double    weight;
      double    place[3];
    };

    Vector3            place_of(const Share &share) const;
    bool               integrates() const;
    void               add(const PointDofs &dofs, const Vector3 &force);
    void               add_pressure(const Load &load, double factor);
    void               add_acceleration(const Load &load, double factor);
    std::vector<Share> list_nodes(const std::vector<unsigned int> &nodes,
                                  const std::vector<double>       &weights) const;
    /** Areas [mm^2] of the points of faces of the body, of all ranks. */
    std::vector<Share> find_areas(const std::vector<BoundaryFace> &faces) const;
    /** Shares of one by area. */
    std::vector<Share> find_shares(const Load &load) const;

    /** A face of a cell. */
    struct Face
    {
      std::vector<PointDofs> points;
      ElementNodes           places;
    };
    /** Those of this rank's cells on faces of the body. */
    void for_faces(const std::vector<BoundaryFace>         &faces,
                   const std::function<void(const Face &)> &act) const;

    const Model            &model_;
    const DistributedSpace &space_;
    DistributedVector       forces_;
  };
} // namespace vfife

#endif
