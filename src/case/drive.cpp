#include "case/parts.hpp"

namespace washtub {
namespace {

Table<DriveSpec> rest_table() { return Table<DriveSpec>("Does not move."); }

Table<DriveSpec> constant_table() {
  Table<DriveSpec> table("Turns at a constant speed from the start.");
  table
      .key("speed", &DriveSpec::speed, quantity(measure::angular_speed),
           "counter-clockwise seen from above")
      .required();
  return table;
}

Table<DriveSpec> sinusoid_table() {
  Table<DriveSpec> table("Agitates: omega = peak sin(2 pi frequency t), Eq. (16).");
  table
      .key("peak", &DriveSpec::peak, quantity(measure::angular_speed, above(0)),
           "largest angular speed")
      .required()
      .key("frequency", &DriveSpec::frequency, quantity(measure::frequency, above(0)),
           "full strokes, there and back, per time")
      .required();
  return table;
}

void check_table(DriveSpec& drive, const Node& node, int) {
  if (drive.times.size() < 2) throw error_at(*node.find("times"), "expected two times or more");
  if (drive.times.size() != drive.speeds.size())
    throw error_at(*node.find("speeds"),
                   fmt::format("expected {} speeds, one per time", drive.times.size()));
  if (drive.times.front() != 0) throw error_at(*node.find("times"), "expected a first time of 0 s");
  for (size_t i = 1; i < drive.times.size(); ++i)
    if (drive.times[i] <= drive.times[i - 1])
      throw error_at(*node.find("times"),
                     fmt::format("expected times that increase, but number {} is {:.6g} s after "
                                 "{:.6g} s",
                                 i + 1, drive.times[i], drive.times[i - 1]));
}

Table<DriveSpec> stroke_table_table() {
  Table<DriveSpec> table("Turns as a table of speeds says, linear in between.");
  table.key("times", &DriveSpec::times, quantities(measure::time), "increasing, from 0 s")
      .required()
      .key("speeds", &DriveSpec::speeds, quantities(measure::angular_speed), "one per time")
      .required()
      .key("repeat", &DriveSpec::repeat, boolean(),
           "start again after the last time; else keep the last speed")
      .then(check_table);
  return table;
}

}  // namespace

const Kinds<DriveSpec, Drive>& drive_kinds() {
  using Spec = const DriveSpec&;
  static const auto kinds =
      Kinds<DriveSpec, Drive>("drive")
          .kind("rest", rest_table(), [](Spec, int) { return at_rest(); })
          .kind("constant", constant_table(),
                [](Spec spec, int) { return constant_speed(spec.speed); })
          .kind("sinusoid", sinusoid_table(),
                [](Spec spec, int) { return sinusoid(spec.peak, spec.frequency); })
          .kind("table", stroke_table_table(),
                [](Spec spec, int) { return stroke_table(spec.times, spec.speeds, spec.repeat); });
  return kinds;
}

}  // namespace washtub
