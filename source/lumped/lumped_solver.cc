// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/base/types.h>
#include <vfife/lumped/lumped_solver.h>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>

namespace vfife
{
  namespace
  {
    using Scaled = std::vector<double>;

    /**
     * The motion in units of the static deflection, of the energy that it holds and of the rate of
     * the swing, so that one tolerance fits all: q, v, energy supplied, energy dissipated.
     */
    class ScaledMotion
    {
    public:
      ScaledMotion(const LumpedModel &model, const double mesh_frequency)
        : model_(model)
        , frequency_(mesh_frequency)
        , rate_(model.swing_rate())
        , lengths_(model.n())
      {
        // Lengths: the motion that alone would compress the mesh by the static s. Energy: that of s
        // under the full torque.
        const double s = model.pair().law.compression(model.pair().torque, 0.);
        energy_        = model.pair().torque * s;
        for (unsigned int i = 0; i < model.n(); ++i)
          {
            // A motion that does not move the mesh has a size of its own.
            const double lever = std::abs(model.levers()[i]);
            lengths_[i]        = lever > 0 ? s / lever : s * model.pair().arm;
          }
      }

      double rate() const
      {
        return rate_;
      }
      double position(const double scaled_time) const
      {
        return scaled_time / rate_ * frequency_;
      }
      Scaled scale(const Eigen::VectorXd &q, const Eigen::VectorXd &v) const
      {
        const unsigned int n = model_.n();
        Scaled             y(2 * n + 2, 0.);
        Eigen::Map<Eigen::VectorXd>(y.data(), n)     = q.cwiseQuotient(lengths_);
        Eigen::Map<Eigen::VectorXd>(y.data() + n, n) = v.cwiseQuotient(lengths_) / rate_;
        return y;
      }
      Eigen::VectorXd displacements(const Scaled &y) const
      {
        return lengths_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(y.data(), model_.n()));
      }
      Eigen::VectorXd velocities(const Scaled &y) const
      {
        const unsigned int n = model_.n();
        return rate_ * lengths_.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(y.data() + n, n));
      }
      /** Supplied less dissipated since the start [mJ]. */
      double received(const Scaled &y) const
      {
        return energy_ * (y[2 * model_.n()] - y[2 * model_.n() + 1]);
      }

      void operator()(const Scaled &y, Scaled &slope, const double time) const
      {
        const unsigned int       n = model_.n();
        const Eigen::VectorXd    v = velocities(y);
        const LumpedModel::Rates rates =
          model_.compute_rates(displacements(y), v, position(time), frequency_);
        // Derivatives to the scaled time rate * t.
        Eigen::Map<Eigen::VectorXd>(slope.data(), n) = v.cwiseQuotient(lengths_) / rate_;
        Eigen::Map<Eigen::VectorXd>(slope.data() + n, n) =
          rates.acceleration.cwiseQuotient(lengths_) / (rate_ * rate_);
        slope[2 * n]     = rates.supplied / (energy_ * rate_);
        slope[2 * n + 1] = rates.dissipated / (energy_ * rate_);
      }

    private:
      const LumpedModel &model_;
      double             frequency_, rate_, energy_;
      Eigen::VectorXd    lengths_;
    };

    /** Sums up samples into a LumpedResponse. */
    class Statistics
    {
    public:
      explicit Statistics(const LumpedModel &model)
        : model_(model)
      {
      }

      void add(const LumpedSolver::Sample &sample, const double energy)
      {
        // Apart: the drive flanks do not touch; a loss of contact is counted when they part. On the
        // coast flanks: the backlash is used up.
        const double s     = model_.compression(sample.q, sample.position);
        const double error = model_.transmission_error(sample.q);
        const double force = sample.mesh_torque / model_.pair().arm;
        error_.add(error);
        force_.add(force);
        const bool apart = s <= 0;
        losses_ += n_ > 0 && apart && !apart_;
        apart_ = apart;
        n_apart_ += apart;
        n_coast_ += s < -model_.pair().law.backlash;
        ++n_;
        residual_ = std::max(residual_, std::abs(sample.energy_error));
        largest_  = std::max(largest_, energy);
      }

      LumpedResponse response() const
      {
        LumpedResponse r;
        r.mean_error    = error_.mean(n_);
        r.rms_error     = error_.rms(n_);
        r.pp_error      = error_.highest - error_.lowest;
        r.mean_force    = force_.mean(n_);
        r.rms_force     = force_.rms(n_);
        r.pp_force      = force_.highest - force_.lowest;
        r.largest_force = force_.highest;
        r.losses        = losses_;
        r.time_apart    = static_cast<double>(n_apart_) / n_;
        r.time_coast    = static_cast<double>(n_coast_) / n_;
        r.energy_error  = residual_ / largest_;
        return r;
      }

    private:
      struct Sum
      {
        double first = 0, sum = 0, squares = 0, lowest = 0, highest = 0;
        bool   empty = true;

        void add(const double value)
        {
          if (empty)
            first = lowest = highest = value;
          empty = false;
          // About the first value: little is lost to a large mean.
          sum += value - first;
          squares += (value - first) * (value - first);
          lowest  = std::min(lowest, value);
          highest = std::max(highest, value);
        }
        double mean(const unsigned int n) const
        {
          return first + sum / n;
        }
        double rms(const unsigned int n) const
        {
          return std::sqrt(std::max(0., squares / n - sum / n * (sum / n)));
        }
      };

      const LumpedModel &model_;
      Sum                error_, force_;
      unsigned int       n_ = 0, n_apart_ = 0, n_coast_ = 0, losses_ = 0;
      bool               apart_    = false;
      double             residual_ = 0, largest_ = 0;
    };
  } // namespace

  void LumpedRunOptions::declare(dealii::ParameterHandler &prm)
  {
    // The product of the largest ones can still be counted.
    declare_integer(prm,
                    "settling mesh cycles",
                    settling_meshes,
                    "Mesh cycles at each speed before recording starts",
                    0,
                    100000);
    declare_integer(prm,
                    "recorded mesh cycles",
                    measured_meshes,
                    "Recorded mesh cycles at each speed",
                    1,
                    100000);
    declare_integer(prm, "samples per mesh cycle", samples, "Samples per mesh cycle", 4, 10000);
    declare_number(prm,
                   "tolerance",
                   tolerance,
                   "Error limit of one time step, relative to the static deflection",
                   Range::positive());
  }

  LumpedSolver::LumpedSolver(const LumpedModel &model, const LumpedRunOptions &options)
    : model_(model)
    , options_(options)
    , q_(model.find_equilibrium(0.))
    , v_(Eigen::VectorXd::Zero(model.n()))
  {
  }

  void LumpedSolver::set_motion(const Eigen::VectorXd &q, const Eigen::VectorXd &v)
  {
    q_ = q;
    v_ = v;
  }

  LumpedResponse LumpedSolver::run(const double mesh_frequency, const Observer &observe)
  {
    namespace odeint = boost::numeric::odeint;
    const ScaledMotion motion(model_, mesh_frequency);
    // All times here are scaled: a sample's interval, and a longest step of 1/4, a 25th of the
    // swing's period.
    const double interval = motion.rate() / (mesh_frequency * options_.samples);
    // No step passes over a short contact.
    const double     longest    = std::min(interval, 0.25);
    constexpr double least_step = 1e-9;
    auto             stepper    = odeint::make_dense_output(options_.tolerance,
                                             options_.tolerance,
                                             longest,
                                             odeint::runge_kutta_dopri5<Scaled>());
    Scaled           y          = motion.scale(q_, v_);
    stepper.initialize(y, 0., 1e-2 * longest);

    // The energy balance is kept from the start of the run, settling included.
    const double       start_energy = model_.compute_energy(q_, v_, 0.);
    const unsigned int first        = options_.settling_meshes * options_.samples;
    const unsigned int last         = first + options_.measured_meshes * options_.samples;
    Statistics         statistics(model_);
    for (unsigned int i = 0; i <= last; ++i)
      {
        const double time = i * interval;
        // Steps choose their own length; samples are interpolated within the step that passes them.
        while (stepper.current_time() < time)
          {
            stepper.do_step(std::cref(motion));
            // Below it, round-off of the motion exceeds the tolerance.
            if (stepper.current_time_step() < least_step * longest)
              throw NumericalError(sentence_of(4,
                                               "the step of the lumped model falls to ",
                                               stepper.current_time_step() / motion.rate(),
                                               " s at the mesh frequency ",
                                               mesh_frequency,
                                               " Hz. Increase the torque or Lumped/tolerance."));
          }
        if (i < first)
          continue;
        if (i > 0)
          stepper.calc_state(time, y);
        Sample sample;
        sample.time         = (i - first) / (mesh_frequency * options_.samples);
        sample.position     = motion.position(time);
        sample.q            = motion.displacements(y);
        sample.v            = motion.velocities(y);
        const double energy = model_.compute_energy(sample.q, sample.v, sample.position);
        if (!std::isfinite(energy))
          throw NumericalError(
            "the motion of the lumped model is not finite at the mesh frequency " +
            std::to_string(mesh_frequency) + " Hz");
        sample.energy_error = energy - start_energy - motion.received(y);
        // The last sample is the first of the next mesh: it only hands over the motion.
        if (i == last)
          set_motion(sample.q, sample.v);
        else
          {
            sample.mesh_torque =
              model_.compute_rates(sample.q, sample.v, sample.position, mesh_frequency).mesh_torque;
            statistics.add(sample, energy);
            if (observe)
              observe(sample);
          }
      }
    return statistics.response();
  }

  Table make_motion_table(const LumpedModel &model)
  {
    Table table{{column::time, "s"},
                {column::position, "mesh cycles"},
                {column::dte, "arcsec"},
                {"mesh force", "N"},
                {column::contact_torque_on("gear"), "N m"}};
    for (const LumpedSupport &support : model.pair().supports)
      table.add_column(support.name, support.tilts ? "arcsec" : "um");
    table.add_column(column::energy_error, "mJ");
    return table;
  }

  void add_motion(const LumpedModel &model, const LumpedSolver::Sample &sample, Table &table)
  {
    std::vector<Table::Cell> row   = {sample.time,
                                      sample.position,
                                      model.transmission_error(sample.q) / arcsecond,
                                      sample.mesh_torque / model.pair().arm,
                                      1e-3 * sample.mesh_torque};
    const std::size_t        first = model.n() - model.pair().supports.size();
    for (std::size_t j = 0; j < model.pair().supports.size(); ++j)
      row.emplace_back(sample.q[first + j] *
                       (model.pair().supports[j].tilts ? 1 / arcsecond : 1e3));
    row.emplace_back(sample.energy_error);
    table.add_row(row);
  }
} // namespace vfife
