// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Energy ledger, damping audit and contact losses of made-up steps, by hand; and interrupted at any
// of them, written and read again: the same.
#include "../made_state.h"
#include "../model_parts.h"
#include "../parts.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/motion/mean_speed.h>
#include <vfife/dynamics/watch/contact_watch.h>
#include <vfife/dynamics/watch/damping_watch.h>
#include <vfife/dynamics/watch/energy_book.h>
#include <vfife/dynamics/watch/motion_sums.h>
#include <vfife/mesh/primitives/primitives.h>

#include <sstream>

using namespace vfife;

/** What is done to an object, one after the other. */
template <typename Object>
using Events = std::vector<std::function<void(Object &)>>;

template <typename Object>
using Make = std::function<std::unique_ptr<Object>()>;

/** Whether @p describe says the same of an object that has seen all events, and of two of which
 * the second, by @p make_later, goes on from the bytes of the first, wherever the first ends. */
template <typename Object>
bool survives_breaks(const Make<Object>                               &make,
                     const Make<Object>                               &make_later,
                     const Events<Object>                             &events,
                     const std::function<std::string(const Object &)> &describe)
{
  const auto whole = make();
  for (const auto &event : events)
    event(*whole);
  bool same = true;
  for (std::size_t end = 0; end <= events.size(); ++end)
    {
      const auto first = make(), second = make_later();
      for (std::size_t i = 0; i < end; ++i)
        events[i](*first);
      ByteStream written;
      first->serialize(written);
      ByteStream read(written.bytes());
      second->serialize(read);
      for (std::size_t i = end; i < events.size(); ++i)
        events[i](*second);
      if (describe(*second) == describe(*whole))
        continue;
      same = false;
      std::cout << "after " << end << " events: " << describe(*second) << "instead of "
                << describe(*whole);
    }
  return same;
}

std::string describe(const EnergyLedger &l)
{
  std::ostringstream text;
  text.precision(17);
  for (const double number : {l.kinetic,
                              l.kinetic_relative,
                              l.strain,
                              l.contact,
                              l.drive_work,
                              l.torque_work,
                              l.damping_loss,
                              l.mesh_damping_uptake,
                              l.contact_loss,
                              l.start,
                              l.scale,
                              l.friction_loss,
                              l.swing_loss})
    text << number << ' ';
  text << '\n';
  return text.str();
}

/** A ring in bearings. */
Model turning_ring(const double rate)
{
  Model model;
  Body  ring("ring", make_ring(20, 30, 4, {{2, 24, 1}}), Material());
  ring.turns_on_axis = true;
  ring.rate          = rate;
  model.add_body(std::move(ring));
  return model;
}

/** Sums of a body in bearings with all of its kinetic energy and that of its spin [mJ]. */
std::vector<BodySums> spin_sums(const double kinetic, const double of_spin)
{
  BodySums sums;
  sums.update.kinetic        = kinetic;
  sums.update.axial_inertia  = 0.02;
  sums.update.axial_momentum = std::sqrt(2 * 0.02 * of_spin);
  return {sums};
}

/** A sample of bodies whose rigid motion stays as it is. */
void take_sample(EnergyBook                  &book,
                 const Model                 &model,
                 const std::vector<BodySums> &sums,
                 const double                 strain,
                 const double                 contact)
{
  std::vector<RigidVelocity> same;
  for (unsigned int b = 0; b < model.bodies.size(); ++b)
    same.push_back(compute_momentum_rate(UpdateAxis::of(model.bodies[b]),
                                         model.bodies[b].mass(),
                                         sums[b].update));
  book.take_sample(same, sums, strain, contact, 0);
}

void ledger_of_turning_ring()
{
  const Model model = turning_ring(500);
  EnergyBook  book(model);
  // 1. The first sample: nothing has been exchanged, a ten thousand millionth of the spin counts.
  take_sample(book, model, spin_sums(5000, 4990), 7, 1);
  const EnergyLedger &now = book.ledger();
  check_close("ring: relative kinetic energy [mJ]", now.kinetic_relative, 10, 1e-9);
  check_close("ring: energy at the start [mJ]", now.start, 5008, 1e-12);
  check_close("ring: scale of the first sample [mJ]", now.scale, 5e-7, 1e-18);
  check("ring: no error yet", now.error() == 0);

  // 2. Work and losses, half a step at a time.
  StepPowers powers;
  powers.drive   = 300;
  powers.torque  = -100;
  powers.damping = 40;
  powers.mesh    = 20;
  powers.swing   = 5;
  powers.contact = 10;
  book.add_work(powers, 0.06);
  book.add_work(powers, 0.04);
  book.add_friction_loss(0.5);
  check_close("ring: work of the drive [mJ]", now.drive_work, 30, 1e-12);
  check_close("ring: work of the torque [mJ]", now.torque_work, -10, 1e-12);
  check_close("ring: damping loss [mJ]", now.damping_loss, 4, 1e-12);
  check_close("ring: taken by the driven speed damping [mJ]", now.mesh_damping_uptake, 2, 1e-12);
  check_close("ring: of that from the swing [mJ]", now.swing_loss, 0.5, 1e-12);
  check_close("ring: contact loss, that of friction with it [mJ]", now.contact_loss, 1.5, 1e-12);
  check_close("ring: friction loss [mJ]", now.friction_loss, 0.5, 1e-12);

  // 3. Strain 7 -> 9, contact 1 -> 4, relative 10 -> 6, lost 7.5: 16.5 within, beside work of 20
  // and 3 of spin and all. Stored 5003 + 9 + 4 of 5008 + 20 - 7.5.
  take_sample(book, model, spin_sums(5003, 4997), 9, 4);
  check_close("ring: scale by work [mJ]", now.scale, 20, 1e-9);
  check_close("ring: residual [mJ]", now.residual(), 5016 - 5020.5, 1e-9);
  check_close("ring: error", now.error(), -4.5 / 20, 1e-9);
  // 4. Strain 7 -> 12, contact 1 -> 3, relative 10 -> 2, lost 7.5: 22.5 within.
  take_sample(book, model, spin_sums(5000, 4998), 12, 3);
  check_close("ring: scale by what is exchanged within [mJ]", now.scale, 22.5, 1e-9);
  check_close("ring: residual then [mJ]", now.residual(), 5015 - 5020.5, 1e-9);
  // 5. The ring slows down by 40 mJ; later all comes back, the scale stays.
  take_sample(book, model, spin_sums(4960, 4950), 7, 1);
  check_close("ring: scale by kinetic energy [mJ]", now.scale, 40, 1e-9);
  take_sample(book, model, spin_sums(5000, 4990), 7, 1);
  check_close("ring: largest scale so far [mJ]", now.scale, 40, 1e-9);
  check_close("ring: error by it", now.error(), (5008 - 5020.5) / 40, 1e-9);
  book.reset();
  check("ring: a new run has nothing in its book",
        describe(book.ledger()) == describe(EnergyLedger()));

  // 6. Nothing moves: round-off is measured by that of the steps so far.
  book.set_round_off(1e-15);
  book.take_sample({RigidVelocity()}, spin_sums(0, 0), 1e-18, 0, 0);
  book.take_sample({RigidVelocity()}, spin_sums(1e-18, 0), 3e-18, 0, 99);
  check_close("at rest: scale [mJ]", book.ledger().scale, 1e-13, 1e-20);
  check_close("at rest: error", book.ledger().error(), 3e-5, 1e-10);
}

/** Two blocks that fly and may touch. */
Model flying_blocks()
{
  Model model = model_of(Body("small", make_block(Vector3(4, 2, 2), {{2, 1, 1}}), Material()));
  model.add_body(Body("large", make_block(Vector3(6, 4, 2), {{3, 2, 1}}), Material()));
  model.contacts.push_back(contact_of("", {0, ""}, {1, ""}));
  return model;
}

/** Sums of the undeformed bodies of a model with these velocities of their centres [mm/s] and
 * rates [rad/s]. */
std::vector<BodySums> flight_sums(const Model                                    &model,
                                  const std::vector<std::pair<Vector3, Vector3>> &motions)
{
  std::vector<BodySums> sums(model.bodies.size());
  for (std::size_t b = 0; b < sums.size(); ++b)
    {
      const Body &body   = model.bodies[b];
      Vector3     centre = Vector3::Zero();
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        centre += body.node_masses()[i] * body.node_positions()[i] / body.mass();
      for (unsigned int i = 0; i < body.n_nodes(); ++i)
        {
          const Vector3 &x = body.node_positions()[i];
          const Vector3  v = motions[b].first + motions[b].second.cross(x - centre);
          add_node_moments({}, body.node_masses()[i], x, v, sums[b].update);
          sums[b].update.kinetic += 0.5 * body.node_masses()[i] * v.squaredNorm();
        }
    }
  return sums;
}

/** Rigid motions that an update changes: energies are products of those before and after it. */
void ledger_of_changing_rates()
{
  // A ring that nothing but its spin moves, faster by a hundredth after the update.
  const Model           ring = turning_ring(500);
  EnergyBook            book(ring);
  std::vector<BodySums> sums(1);
  sums[0].update.axial_inertia  = 0.02;
  sums[0].update.axial_momentum = 0.02 * 505;
  sums[0].update.kinetic        = 0.5 * 0.02 * 500 * 505;
  book.take_sample({{Vector3::Zero(), 500 * Vector3::UnitZ()}}, sums, 0, 0, 0);
  check_below("accelerated ring: no motion relative to its spin [mJ]",
              std::abs(book.ledger().kinetic_relative),
              1e-9);

  // Blocks that an update pushes and turns: sum m v- . v+/2 node by node.
  const Model         model = flying_blocks();
  EnergyBook          flight(model);
  const Vector3       none   = Vector3::Zero(), v(300, -20, 5), omega(3, 400, 900);
  const auto          pushed = flight_sums(model, {{v, omega}, {none, none}});
  const Body         &body   = model.bodies[0];
  const UpdateSums    after  = pushed[0].update;
  const RigidVelocity rate   = compute_momentum_rate({}, body.mass(), after);
  auto                slower = pushed;
  slower[0].update.kinetic *= 0.9;
  flight.take_sample({{0.9 * rate.velocity, 0.9 * rate.omega}, {none, none}}, slower, 0, 0, 0);
  check_below("accelerated flight: no motion relative to it, of the whole energy",
              std::abs(flight.ledger().kinetic_relative) / after.kinetic,
              1e-12);
}

void energy_of_approach()
{
  Model         model = flying_blocks();
  const double  m = model.bodies[0].mass(), M = model.bodies[1].mass();
  const Vector3 v(3000, -1000, 500), V(-2000, 0, 100), none = Vector3::Zero();
  const auto    fly     = flight_sums(model, {{v, none}, {V, none}});
  const double  reduced = m * M / (m + M), approach = 0.5 * reduced * (v - V).squaredNorm();
  check_ratio("approach of two blocks over mu |v - V|^2/2",
              ApproachEnergy(model).compute(fly) / approach,
              1e-12);
  // The spin of the small one about z, m (a^2 + b^2)/4 of masses in its corners and middle: the
  // kinetic energy says it.
  const auto   turn = flight_sums(model, {{v, Vector3(0, 0, 900)}, {V, none}});
  const double spin = turn[0].update.kinetic - fly[0].update.kinetic;
  check_ratio("approach with spin", ApproachEnergy(model).compute(turn) / (approach + spin), 1e-10);
  check("spin counts", spin > 0.01 * approach);

  // Before the first touch it is nobody's measure.
  EnergyBook book(model);
  take_sample(book, model, fly, 0, 0);
  check("approach does not count before a touch", book.ledger().scale < 1e-6 * approach);
  book.observe_contact(true);
  take_sample(book, model, flight_sums(model, {{none, none}, {none, none}}), 0, 0);
  check("approach counts after one, though it is gone", book.ledger().scale >= 0.999 * approach);

  // The large one is held: all of the small one's energy.
  Constraint hold;
  hold.body = 1;
  model.constraints.push_back(hold);
  check_ratio("approach to a body that is held over m v^2/2",
              ApproachEnergy(model).compute(fly) / (0.5 * m * v.squaredNorm()),
              1e-12);
  // Against a wall alone.
  Model     bound = flying_blocks();
  RigidWall wall;
  wall.body = 1;
  bound.walls.push_back(wall);
  bound.contacts.clear();
  check_ratio("approach to a wall over M V^2/2",
              ApproachEnergy(bound).compute(fly) / (0.5 * M * V.squaredNorm()),
              1e-12);
}

/** The book with what its log and its failure say. */
struct LoggedBook
{
  std::ostringstream text;
  Log                log;
  EnergyBook         book;
  std::string        trace, failure;

  explicit LoggedBook(const Model &model)
    : log(text, true, Verbosity::quiet)
    , book(model)
  {
  }

  void serialize(ByteStream &stream)
  {
    book.serialize(stream);
    stream.pass(trace, failure);
    // A run keeps its warnings with its log.
    unsigned int n = log.warnings().size();
    stream.pass(n);
    warned_before = stream.reads() ? n : 0;
  }

  void check(const double limit)
  {
    failure += message_of<NumericalError>([&] { book.check(limit, "then", log); });
  }

  unsigned int warned_before = 0;
};

/** Energy out of nowhere, @p residuals [mJ] at samples one after the other, beside 100 mJ of
 * work: after which of them the book fails a limit of 0.05, and after which it has warned; 0:
 * none. */
std::pair<std::size_t, std::size_t> find_failure(const std::vector<double> &residuals)
{
  const Model model = turning_ring(500);
  LoggedBook  one(model);
  take_sample(one.book, model, spin_sums(5000, 5000), 0, 0);
  StepPowers powers;
  powers.drive = 1000;
  one.book.add_work(powers, 0.1);
  std::pair<std::size_t, std::size_t> places(0, 0);
  for (std::size_t i = 0; i < residuals.size(); ++i)
    {
      take_sample(one.book, model, spin_sums(5100 + residuals[i], 5100 + residuals[i]), 0, 0);
      one.check(0.05);
      if (places.first == 0 && !one.failure.empty())
        places.first = i + 1;
      if (places.second == 0 && !one.log.warnings().empty())
        places.second = i + 1;
    }
  return places;
}

void lasting_errors()
{
  using Places = std::pair<std::size_t, std::size_t>;
  // Errors of 0.057, 0.074, 0.091: kinetic energy changes by work and residual.
  check("an error that lasts and grows fails", find_failure({6, 8, 10}) == Places(3, 3));
  check("two samples are not enough", find_failure({6, 10}) == Places(0, 0));
  check("one that has not grown by half goes on", find_failure({6, 7, 8.5}) == Places(0, 0));
  check("a sample below the limit breaks it", find_failure({6, 8, 4, 10, 12}) == Places(0, 4));
  check("from two fifths of the limit on a warning", find_failure({2.5, 3, 4}) == Places(0, 3));
  check("below it none", find_failure({1., 1.5, 2.}) == Places(0, 0));
}

void books_go_on()
{
  const Model   model  = flying_blocks();
  const Vector3 none   = Vector3::Zero();
  const auto    sample = [&](const double speed, const double strain, const double contact) {
    const auto sums = flight_sums(model, {{Vector3(speed, 0, 0), none}, {none, none}});
    return [=, &model](LoggedBook &one) {
      take_sample(one.book, model, sums, strain, contact);
      one.trace += describe(one.book.ledger());
    };
  };
  const auto work = [](const double power) {
    return [=](LoggedBook &one) {
      one.book.add_work({power, 2 * power, 3 * power, 4 * power, 5 * power}, 0.1);
    };
  };
  const auto check_now = [](LoggedBook &one) { one.check(0.05); };
  // The fastest approach is seen before the touch; a touch between samples; losses; strain that
  // sets the scale, and then strain out of nowhere, beyond two fifths of the limit at all five
  // samples and beyond it at three: a warning and a failure.
  Events<LoggedBook> events = {sample(4000, 0, 0),
                               sample(6000, 0, 0),
                               work(0.1),
                               sample(3000, 1, 0),
                               [](LoggedBook &one) { one.book.observe_contact(true); },
                               sample(2000, 1, 0),
                               [](LoggedBook &one) { one.book.add_friction_loss(0.7); },
                               sample(5000, 0, 3),
                               sample(5000, 1000, 3)};
  for (unsigned int i = 1; i < 6; ++i)
    {
      events.push_back(sample(5000, 10. * std::pow(1.7, i), 3));
      events.push_back(check_now);
      events.push_back(work(0.01));
    }
  const auto make = [&] { return std::make_unique<LoggedBook>(model); };
  const auto tell = [](const LoggedBook &one) {
    return one.trace + describe(one.book.ledger()) +
           std::to_string(one.warned_before + one.log.warnings().size()) + " warnings " +
           one.failure + "\n";
  };
  check("energy book goes on from any step", survives_breaks<LoggedBook>(make, make, events, tell));
  LoggedBook whole(model);
  for (const auto &event : events)
    event(whole);
  check("of a run that has warned once and failed",
        whole.log.warnings().size() == 1 && !whole.failure.empty());
}

void losses_of_contact()
{
  std::ostringstream text;
  Log                log(text, true, Verbosity::quiet);
  // One step in a millisecond. A run begins apart; it touches, and lets go at 3 and at 7 ms.
  const std::vector<bool> touching = {false, true, true, false, false, true, true, false, true};
  Events<ContactWatch>    events;
  for (std::size_t i = 0; i < touching.size(); ++i)
    events.push_back([=](ContactWatch &watch) { watch.observe(1e-3 * i, 1e-3, touching[i]); });
  ContactWatch watch(log);
  for (const auto &event : events)
    event(watch);
  check("two losses of contact", watch.losses().count == 2);
  check_close("the first at [s]", watch.losses().first, 3e-3, 1e-15);
  check_close("without contact, but for the time before the first touch [s]",
              watch.losses().duration,
              3e-3,
              1e-15);
  const auto tell = [](const ContactWatch &one) {
    return std::to_string(one.losses().count) + " " + std::to_string(1e6 * one.losses().first) +
           " " + std::to_string(1e6 * one.losses().duration) + "\n";
  };
  const auto make = [&] { return std::make_unique<ContactWatch>(log); };
  check("contact watch goes on from any step",
        survives_breaks<ContactWatch>(make, make, events, tell));
}

void damping_audit()
{
  for (const double rate : {300., -300.})
    {
      const std::string name  = rate > 0 ? "audit, rate +: " : "audit, rate -: ";
      const Model       model = turning_ring(rate);
      const Body       &ring  = model.bodies[0];
      Communicator      self(MPI_COMM_SELF);
      // Rigid spin, and a drift along the axis: a mean speed sqrt(rate^2 + w^2/r^2).
      const double w = 8000;
      State        state =
        made_state(model, [](const Body &, unsigned int, const Vector3 &start) { return start; });
      double mean = 0;
      for (unsigned int i = 0; i < ring.n_nodes(); ++i)
        {
          const Vector3 &x = ring.node_positions()[i];
          state.velocity.set(i, Vector3(-rate * x[1], rate * x[0], w));
          mean += ring.node_masses()[i] / ring.mass() * std::hypot(rate, w / x.head<2>().norm());
        }
      const double sense = rate > 0 ? 1. : -1.;
      check_close(name + "mean speed rate, in the sense of the body's [rad/s]",
                  compute_mean_speed_rate(ring, state, 0, self).omega[2],
                  sense * mean,
                  1e-9);
      const auto rates = [](const double omega) {
        RigidVelocity one;
        one.omega[2] = omega;
        return std::vector<RigidVelocity>{one};
      };
      const auto step = [](const double torque, const double power) {
        return [=](DampingWatch &watch) {
          BodySums sums;
          sums.update.damping_torque = torque;
          sums.update.damping_power  = power;
          watch.observe_step({sums});
        };
      };
      NodalMotion motion;
      for (unsigned int i = 0; i < ring.n_nodes(); ++i)
        motion.add(UpdateAxis::of(ring),
                   ring.node_masses()[i],
                   state.node_position(i),
                   state.node_velocity(i),
                   state.node_velocity(i));
      const std::vector<double> mean_speeds = sum_motion(model, {motion}, self).mean_speeds;
      const auto                sample      = [&](const double omega) {
        return [&, omega](DampingWatch &watch) { watch.observe_sample(mean_speeds, rates(omega)); };
      };
      const auto make = [&] {
        auto watch = std::make_unique<DampingWatch>(model);
        watch->reset(rates(rate));
        return watch;
      };
      const Events<DampingWatch> events = {
        sample(rate), step(1, 20), step(-4, 60), sample(0.9 * rate), step(9, 10), step(0, 30)};
      const auto watch = make();
      for (const auto &event : events)
        event(*watch);
      const DampingAudit audit = watch->compute_audit(rates(rate + 7)).at(0);
      check_close(name + "mean torque of four steps [N mm]", audit.net_torque, 1.5, 1e-12);
      check_close(name + "mean power [mJ/s]", audit.power, 30, 1e-12);
      check_close(name + "drift of the spin [rad/s]", audit.spin_drift, 7, 1e-12);
      check_close(name + "mean of two samples of the mean speed less the momentum rate [rad/s]",
                  audit.rate_difference,
                  mean - 0.95 * std::abs(rate),
                  1e-9);
      const auto tell = [&](const DampingWatch &one) {
        const DampingAudit now = one.compute_audit(rates(rate + 7)).at(0);
        std::ostringstream text;
        text.precision(17);
        text << now.net_torque << ' ' << now.power << ' ' << now.spin_drift << ' '
             << now.rate_difference << '\n';
        return text.str();
      };
      // What goes on was set up by a run that begins elsewhere.
      const auto other = [&] {
        auto one = make();
        one->reset(rates(0.));
        return one;
      };
      check(name + "goes on from any step",
            survives_breaks<DampingWatch>(make, other, events, tell));
    }
}

int main(int argc, char **argv)
{
  return run_parts(argc,
                   argv,
                   {ledger_of_turning_ring,
                    ledger_of_changing_rates,
                    energy_of_approach,
                    lasting_errors,
                    books_go_on,
                    losses_of_contact,
                    damping_audit});
}
