// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Root stresses and strain gauges of a loaded tooth contact analysis of a coarse pair.
#include "../../model_sections.h"
#include "../../refusal.h"
#include "../quick_pair.h"

#include <vfife/base/process/mpi_session.h>
#include <vfife/output/files/run_figures.h>

#include <filesystem>
#include <set>

using namespace vfife;

void write_file(const std::string &more)
{
  std::ofstream("root_stress.prm")
    << quick_pair("set body type = rim only", "set elements through rim = 2", "1e-5")
    << model_text::loaded_contact(2) << more;
}

struct Extremes
{
  double tension = 0, compression = 0;
  double tension_after = 0; ///< where the tension is
};

Extremes find_extremes(const Table       &table,
                       const std::string &body,
                       const char        *after = "position after the mean contact")
{
  Extremes extremes;
  for (std::size_t i = 0; i < table.n_rows(); ++i)
    if (table.column("body").texts[i] == body)
      {
        if (table.numbers("tension")[i] > extremes.tension)
          {
            extremes.tension       = table.numbers("tension")[i];
            extremes.tension_after = table.numbers(after)[i];
          }
        extremes.compression = std::min(extremes.compression, table.numbers("compression")[i]);
      }
  return extremes;
}

/** All tables tell the same. */
void check_tables()
{
  const std::string folder = "root_stress_results/";
  const Table       stress = read_result_table(folder + "root_stress.csv"),
              envelope     = read_result_table(folder + "fillet_envelope.csv");
  check("a row a position, tooth and side", stress.n_rows() == 2 * 2 * (27 + 79));
  check("a row a facet", envelope.n_rows() == 2 * 2 * (2 * 2));
  for (const char *body : {"pinion", "gear"})
    {
      const Extremes    rows    = find_extremes(stress, body);
      const std::string name    = body;
      double            tension = 0, compression = 0, range = 0;
      for (std::size_t i = 0; i < envelope.n_rows(); ++i)
        if (envelope.column("body").texts[i] == body)
          {
            raise_to(tension, envelope.numbers("tension")[i]);
            compression = -largest_of(-compression, -envelope.numbers("compression")[i]);
            raise_to(range, envelope.numbers("range")[i]);
          }
      check(name + ": envelope as rows",
            tension == rows.tension && compression == rows.compression);
      const auto figure = [&](const std::string &what) {
        return read_figure(folder + "figures.json", "/" + name + " root " + what);
      };
      check(name + ": figures as envelope",
            figure("tension") == tension && figure("compression") == compression &&
              figure("stress range") == range);
      check(name + ": range of one facet",
            range < tension - compression && range > .8 * std::max(tension, -compression));
      check(name + ": largest while the tooth is in mesh", std::abs(rows.tension_after) <= 1.5);
    }
  // The side that carries is in tension on the loaded flank's side: the pinion drives by its
  // concave flanks.
  const Table      &t = stress;
  const std::size_t first =
    std::max_element(t.numbers("tension").begin(), t.numbers("tension").end()) -
    t.numbers("tension").begin();
  const std::string &body   = t.column("body").texts[first],
                    &fillet = t.column("fillet").texts[first];
  check("tension beside the flank that carries",
        fillet == (body == "pinion" ? "concave" : "convex"));
}

/** Sections along the face have the largest of the facets one above the other. */
void check_sections()
{
  const std::string folder = "root_stress_results/";
  const Table       stress = read_result_table(folder + "root_stress.csv"),
              sections     = read_result_table(folder + "root_sections.csv"),
              envelope     = read_result_table(folder + "fillet_envelope.csv");
  check("a row a section of two facets", 2 * sections.n_rows() == envelope.n_rows());
  bool as_facets = true, ends = true;
  for (std::size_t i = 0; i < sections.n_rows(); ++i)
    {
      const auto largest = [&](const char *name, const double sign) {
        const auto &of_facets = envelope.numbers(name);
        return sign * std::max(sign * of_facets[2 * i], sign * of_facets[2 * i + 1]);
      };
      as_facets = as_facets &&
                  sections.column("fillet").texts[i] == envelope.column("fillet").texts[2 * i] &&
                  sections.numbers("tension")[i] == largest("tension", 1.) &&
                  sections.numbers("compression")[i] == largest("compression", -1.) &&
                  sections.numbers("range")[i] == largest("range", 1.);
      ends = ends && sections.numbers("face to")[i] > sections.numbers("face from")[i] + 12. &&
             sections.numbers("tension up the profile")[i] > 0. &&
             sections.numbers("tension up the profile")[i] < 2.;
    }
  check("sections as facets", as_facets);
  check("two sections are the face of 30 mm", ends);
  for (const char *body : {"pinion", "gear"})
    {
      const Extremes of_sections = find_extremes(sections, body, "tension after the mean contact");
      check(std::string(body) + ": the largest of sections, and when, as rows",
            of_sections.tension == find_extremes(stress, body).tension &&
              of_sections.tension_after == find_extremes(stress, body).tension_after);
    }
}

void check_gauge()
{
  const Table gauges = read_result_table("root_stress_results/gauges.csv");
  check("gauge: a row a position and tooth", gauges.n_rows() == 2 * 79);
  std::set<double> places;
  for (const double after : gauges.numbers("position after the mean contact"))
    places.insert(std::round(1e6 * after));
  check("gauge: each place once, over a whole turn",
        places.size() == 2 * 79 && *places.begin() >= -39.5e6 && *places.rbegin() < 39.5e6);
  // Facets show their centres; along one that is half the face width the strain changes by some
  // tenths.
  const Extremes gear =
    find_extremes(read_result_table("root_stress_results/root_stress.csv"), "gear");
  const double largest =
    *std::max_element(gauges.numbers("strain").begin(), gauges.numbers("strain").end());
  check("gauge: of the size of the largest stress over E",
        largest > .5e6 * gear.tension / 206000. && largest < 1.2e6 * gear.tension / 206000.);
}

/** Those in mesh have the same rows; none have none. */
void check_choices(Communicator &world)
{
  run_pair("root_stress.prm", "root_stress_in_mesh", world, {"Fillets/teeth=in contact"});
  const Table all = read_result_table("root_stress_results/root_stress.csv"),
              few = read_result_table("root_stress_in_mesh/root_stress.csv");
  std::set<std::string> rows;
  for (std::size_t i = 0; i < all.n_rows(); ++i)
    rows.insert(all.csv_row(i));
  bool known = few.n_rows() > 0 && few.n_rows() < all.n_rows() / 4;
  for (std::size_t i = 0; i < few.n_rows(); ++i)
    known = known && rows.count(few.csv_row(i)) == 1;
  check("teeth in mesh: some of the rows", known);
  check_close("teeth in mesh: the largest tension",
              find_extremes(few, "pinion").tension,
              find_extremes(all, "pinion").tension,
              0.);
  run_pair("root_stress.prm",
           "root_stress_named",
           world,
           {"Fillets/teeth=named", "Fillets/named teeth=pinion 3, gear 78"});
  const Table named = read_result_table("root_stress_named/root_stress.csv");
  known             = named.n_rows() == 2 * 2 * 2;
  for (std::size_t i = 0; i < named.n_rows(); ++i)
    known = known && rows.count(named.csv_row(i)) == 1 &&
            named.numbers("tooth")[i] == (named.column("body").texts[i] == "gear" ? 78 : 3);
  check("named teeth: their rows", known);
  run_pair("root_stress.prm", "root_stress_none", world, {"Fillets/teeth=none"});
  check("none: gauges alone",
        !std::ifstream("root_stress_none/root_stress.csv") &&
          bool(std::ifstream("root_stress_none/gauges.csv")));
}

/** A run starts from the equilibrium that the analysis finds at its first position, its strains
 * those of large rotations or, of reduced bodies, readings. */
void check_run(const std::vector<std::string> &entries, Communicator &world)
{
  std::filesystem::remove_all("root_stress_run");
  run_pair("root_stress.prm", "root_stress_run", world, entries);
  const Table still       = read_result_table("root_stress_in_mesh/root_stress.csv"),
              run         = read_result_table("root_stress_run/root_stress.csv");
  double       difference = 0, largest = 0;
  unsigned int n = 0;
  for (; n < run.n_rows() && run.numbers("time")[n] == 0; ++n)
    {
      check("run: same tooth",
            run.numbers("tooth")[n] == still.numbers("tooth")[n] &&
              run.column("fillet").texts[n] == still.column("fillet").texts[n]);
      for (const char *stress : {"tension", "compression"})
        {
          raise_to(largest, std::abs(still.numbers(stress)[n]));
          raise_to(difference, std::abs(run.numbers(stress)[n] - still.numbers(stress)[n]));
        }
    }
  // Linear statics against large displacements: squares of the strains and the turn of the rim.
  check_below("run: stresses at the start", difference, .01 * largest);
  check("run: both sides of three teeth and more of both members", n >= 12);
  check_ratio("run: gauge at the start",
              read_result_table("root_stress_run/gauges.csv").numbers("strain")[0] /
                read_result_table("root_stress_results/gauges.csv").numbers("strain")[0],
              .02);
  // What the envelope has is the largest of the rows.
  check_close("run: figure of the summary",
              read_figure("root_stress_run/summary.json", "/figures/gear root tension"),
              find_extremes(run, "gear").tension,
              0.);
}

/** Reduced pairs of a sweep: its table has their root stresses. */
void check_sweep(Communicator &world)
{
  std::filesystem::remove_all("root_stress_sweep");
  std::ofstream("root_stress_sweep.prm")
    << "subsection Study\n set kind = sweep\nend\n"
       "subsection Sweep\n set base = root_stress.prm\n set report = no\n"
       " set parameters = torque\n"
       " set entries = Study/kind = reduced; Fillets/teeth = in contact; Output/samples per mesh "
       "cycle = 50\n"
       " subsection Parameter torque\n  set entry = Operation/torque\n"
       "  set values = 800 N m\n end\nend\n";
  run_case("root_stress_sweep.prm", "root_stress_sweep", world);
  const Table table = read_result_table("root_stress_sweep/sweep.csv");
  for (const char *figure : {"pinion root tension", "gear root stress range"})
    check_close(std::string("sweep: ") + figure,
                table.numbers(figure)[0],
                read_figure("root_stress_sweep/run_01/summary.json",
                            std::string("/figures/") + figure),
                0.);
}

void check_refusals(Communicator &world)
{
  for (const char *entry : {"Fillets/Gauge G/length=50 mm",
                            "Fillets/Gauge G/tooth=79",
                            "Fillets/Gauge G/height=1.2",
                            "Fillets/Gauge H/length=1 mm",
                            "Fillets/named teeth=gear 3"})
    print_refusal([&] { run_pair("root_stress.prm", "root_stress_refused", world, {entry}); });
  for (const char *teeth : {"", "pinion 27", "gaer 0", "gear", "pinion 1.5"})
    print_refusal([&] {
      run_pair("root_stress.prm",
               "root_stress_refused",
               world,
               {"Fillets/teeth=named", std::string("Fillets/named teeth=") + teeth});
    });
}

int main(int argc, char **argv)
{
  MpiSession session(argc, argv);
  write_file(gauge_of_gear);
  run_pair("root_stress.prm", "root_stress_results", session.world());
  check_tables();
  check_sections();
  check_gauge();
  check_choices(session.world());
  check_run({"Study/kind=run", "Fillets/teeth=in contact", "Output/field output interval=0"},
            session.world());
  check_run({"Study/kind=reduced", "Fillets/teeth=in contact", "Output/samples per mesh cycle=50"},
            session.world());
  check_sweep(session.world());
  check_refusals(session.world());
  return 0;
}
