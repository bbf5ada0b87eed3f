// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_lumped_lumped_model_h
#define vfife_lumped_lumped_model_h

#include <vfife/lumped/mesh_law.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace vfife
{
  /** One more motion of a member: a mass (or moment of inertia) on a spring. */
  struct LumpedSupport
  {
    std::string name;
    bool        tilts         = false; ///< an angle [rad] instead of a displacement [mm]
    double      lever         = 0;     ///< compression of the mesh per unit motion [rad/mm or -]
    double      inertia       = 0;     ///< [t] or [t mm^2]
    double      stiffness     = 0;     ///< [N/mm] or [N mm/rad]
    double      damping_ratio = 0;     ///< of the mass on this spring alone
  };

  /** A gear pair of few degrees of freedom. */
  struct LumpedPair
  {
    unsigned int driver_teeth = 0, driven_teeth = 0;
    bool    driver_is_free = false; ///< it turns under its torque, instead of at constant speed
    double  driver_inertia = 0;     ///< [t mm^2]; 0 where its rotation is prescribed
    double  driven_inertia = 0;     ///< [t mm^2]
    double  arm            = 0;     ///< of the normal force about the gear's axis [mm]
    double  torque         = 0;     ///< on the gear [N mm]
    MeshLaw law;
    double  damping_ratio           = 0; ///< of the mesh, for the swing of both members alone
    bool    damping_without_contact = false;
    double  speed_damping           = 0; ///< torque -speed_damping J (rate - kinematic rate) [1/s]
    std::vector<LumpedSupport> supports;

    double ratio() const
    {
      return static_cast<double>(driver_teeth) / driven_teeth;
    }
  };

  /** A natural vibration of the pair about its loaded state, mean mesh stiffness. */
  struct LumpedMode
  {
    double          frequency     = 0; ///< undamped [Hz]
    double          damping_ratio = 0; ///< of the damped motion; 0 for rigid motions
    Eigen::VectorXd shape;             ///< modal mass 1 t
  };

  /**
   * Equations of motion of a LumpedPair (doc/theory/lumped.md). Coordinates q: rotation of the gear
   * on top of the kinematic one, + in the drive direction; the same of the pinion where it is free;
   * the motions of the supports. Mesh positions are those of the nominal speed.
   */
  class LumpedModel
  {
  public:
    explicit LumpedModel(LumpedPair pair);

    const LumpedPair &pair() const
    {
      return pair_;
    }
    unsigned int n() const
    {
      return masses_.size();
    }
    const Eigen::VectorXd &masses() const
    {
      return masses_;
    }
    /** Compression of the mesh by unit motions. */
    const Eigen::VectorXd &levers() const
    {
      return levers_;
    }
    /** Of the mesh at the mean position under the torque [N mm/rad]. */
    double mesh_stiffness() const
    {
      return mesh_stiffness_;
    }
    /** Of both members for the swing against each other [t mm^2]. */
    double swing_inertia() const;
    /** Frequency of that swing [rad/s]. */
    double swing_rate() const;

    /** s of MeshLaw. */
    double compression(const Eigen::VectorXd &q, double x) const;
    /** theta_driven - ratio theta_driver [rad]. */
    double transmission_error(const Eigen::VectorXd &q) const;
    /** At rest under the torque at position @p x. */
    Eigen::VectorXd find_equilibrium(double x) const;

    /** What changes a motion, and where energy goes. */
    struct Rates
    {
      Eigen::VectorXd acceleration;
      double          mesh_torque = 0; ///< on the gear, damper included [N mm]
      double          supplied    = 0; ///< power of torques and of the positions that pass [mJ/s]
      double          dissipated  = 0; ///< [mJ/s]
    };
    /** At mesh position @p x, which grows at @p mesh_frequency [Hz]. */
    Rates compute_rates(const Eigen::VectorXd &q,
                        const Eigen::VectorXd &v,
                        double                 x,
                        double                 mesh_frequency) const;
    /** Kinetic energy of the motion on top of the kinematic one, and of all springs [mJ]. */
    double compute_energy(const Eigen::VectorXd &q, const Eigen::VectorXd &v, double x) const;

    /** Ascending. */
    std::vector<LumpedMode> find_modes() const;

  private:
    LumpedPair      pair_;
    Eigen::VectorXd masses_, levers_, stiffness_, damping_, loads_;
    double          mesh_stiffness_ = 0, mesh_damping_ = 0;
  };
} // namespace vfife

#endif
