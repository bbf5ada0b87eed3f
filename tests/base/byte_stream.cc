// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Values of all kinds come back from bytes; too few bytes are refused.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/table.h>

#include <cstring>

using namespace vfife;

struct Values
{
  double                                      number = 0;
  bool                                        answer = false;
  std::string                                 text;
  Vector3                                     vector = Vector3::Zero();
  RigidMotion                                 motion;
  std::vector<std::vector<Vector3>>           lists;
  std::vector<std::pair<std::string, double>> pairs;

  void serialize(ByteStream &stream)
  {
    stream.pass(number, answer, text, vector, motion, lists, pairs);
  }
};

template <typename Function>
void refuse(const Function &function)
{
  print_refusal([&] { function(); });
}
struct Record
{
  double one = 1, two = 2;
};
/** The same in a later version. */
struct LongerRecord
{
  double one = 10, two = 20, three = 30;
};

/** Bytes between members are no values. */
void padding()
{
  struct Padded
  {
    bool   answer;
    double number;
  };
  const auto bytes_of = [](const int filling) {
    Padded padded;
    std::memset(&padded, filling, sizeof(padded));
    padded.answer = true;
    padded.number = 1;
    std::vector<Padded> several(2, padded), records = several;
    Padded              record = padded;
    ByteStream          out;
    out.pass(padded, several);
    out.pass_record(record);
    out.pass_records(records);
    return out.bytes();
  };
  check("equal values: equal bytes", bytes_of(0) == bytes_of(0xff));
}

/** Parts are found by their names, in any order; what is not there says so. */
void parts()
{
  double     a = 1, b = 2;
  ByteStream out;
  out.pass_part("a", [&](ByteStream &part) { part.pass(a); });
  out.pass_part("nobody asks", [&](ByteStream &part) { part.pass(a, b); });
  out.pass_part("b", [&](ByteStream &part) { part.pass(b); });
  a = b        = 0;
  double     c = 3;
  ByteStream in(out.bytes());
  const bool found_b = in.pass_part("b", [&](ByteStream &part) { part.pass(b); });
  const bool found_c = in.pass_part("c", [&](ByteStream &part) { part.pass(c); });
  in.pass_required_part("a", [&](ByteStream &part) { part.pass(a); });
  check("parts", found_b && !found_c && a == 1 && b == 2 && c == 3);
  refuse([&] { in.pass_required_part("c", [&](ByteStream &part) { part.pass(c); }); });

  Record     record{5, 6};
  ByteStream short_one;
  short_one.pass_record(record);
  LongerRecord longer;
  ByteStream   from_short(short_one.bytes());
  from_short.pass_record(longer);
  check("a record of before", longer.one == 5 && longer.two == 6 && longer.three == 30);
  std::vector<Record>       records(2, record);
  std::vector<LongerRecord> longer_ones;
  ByteStream                several;
  several.pass_records(records);
  ByteStream from_several(several.bytes());
  from_several.pass_records(longer_ones);
  from_several.finish();
  check("records of before",
        longer_ones.size() == 2 && longer_ones[1].one == 5 && longer_ones[1].two == 6 &&
          longer_ones[1].three == 30);
  ByteStream longer_several;
  longer_several.pass_records(longer_ones);
  refuse([&] {
    ByteStream from_longer(longer_several.bytes());
    from_longer.pass_records(records);
  });
  ByteStream long_one;
  long_one.pass_record(longer);
  refuse([&] {
    ByteStream from_long(long_one.bytes());
    from_long.pass_record(record);
  });
}

int main()
{
  Values values;
  values.number                = 1. / 3;
  values.answer                = true;
  values.text                  = std::string("a\0b", 3);
  values.vector                = Vector3(1, 2, 3);
  values.motion.rotation       = rotation_about(Vector3::UnitX(), 1);
  values.motion.translation[1] = 7;
  values.lists                 = {{}, {Vector3(4, 5, 6), Vector3(7, 8, 9)}};
  values.pairs                 = {{"x", 1}, {"", 2}};
  ByteStream written;
  values.serialize(written);
  ByteStream stored(written.bytes());
  Values     again;
  again.serialize(stored);
  check("directions", !written.reads() && stored.reads());
  check("numbers and texts",
        again.number == values.number && again.answer && again.text == values.text);
  check("vectors and motions",
        again.vector == values.vector && again.motion.rotation == values.motion.rotation &&
          again.motion.translation == values.motion.translation);
  check("lists", again.lists == values.lists && again.pairs == values.pairs);

  Table table;
  table.add_column("length", "mm");
  table.add_text_column("name");
  Table read_back = table;
  table.add_row({1.5, "one"});
  table.add_row({2.5, "two"});
  ByteStream rows;
  table.serialize_rows(rows);
  ByteStream stored_rows(rows.bytes());
  read_back.serialize_rows(stored_rows);
  check("rows of a table", read_back.n_rows() == 2 && read_back.csv_row(1) == table.csv_row(1));

  // A column that a later version adds has no cells for the rows of before.
  Table wider;
  wider.add_column("length", "mm");
  wider.add_column("force", "N");
  wider.add_text_column("name");
  ByteStream rows_again(rows.bytes());
  wider.serialize_rows(rows_again);
  wider.add_row({3.5, 7., "three"});
  check("rows with a younger column",
        wider.n_rows() == 3 && wider.numbers("length")[1] == 2.5 &&
          std::isnan(wider.numbers("force")[1]) && wider.column("name").texts[1] == "two");

  padding();
  parts();
  refuse([&] {
    ByteStream part(written.bytes().substr(0, written.bytes().size() - 1));
    again.serialize(part);
  });
  // What the reader knows is compared before it is used.
  ByteStream          three;
  std::vector<double> numbers = {1, 2, 3};
  three.pass_known(numbers);
  ByteStream stored_three(three.bytes());
  numbers.assign(3, 0);
  stored_three.pass_known(numbers);
  stored_three.finish();
  check("as many as are known", numbers == std::vector<double>({1, 2, 3}));
  refuse([&] {
    ByteStream from(three.bytes(), "the data in \"file\"");
    numbers.resize(2);
    from.pass_known(numbers);
  });
  refuse([&] {
    ByteStream from(three.bytes() + "x");
    numbers.resize(3);
    from.pass_known(numbers);
    from.finish();
  });
  refuse([&] {
    ByteStream from(std::string("\2"));
    bool       answer = false;
    from.pass(answer);
  });
  refuse([&] {
    Table other;
    other.add_column("length", "m");
    ByteStream from(rows.bytes());
    other.serialize_rows(from);
  });
  return 0;
}
