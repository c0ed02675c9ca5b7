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
      throw error_at(*node.find("times"), "expected times that increase");
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

const Kinds<DriveSpec>& drive_kinds() {
  static const Kinds<DriveSpec> kinds = Kinds<DriveSpec>()
                                            .kind("rest", rest_table())
                                            .kind("constant", constant_table())
                                            .kind("sinusoid", sinusoid_table())
                                            .kind("table", stroke_table_table());
  return kinds;
}

Drive make_drive(const DriveSpec& spec) {
  if (spec.kind == "constant") return constant_speed(spec.speed);
  if (spec.kind == "sinusoid") return sinusoid(spec.peak, spec.frequency);
  if (spec.kind == "table") return stroke_table(spec.times, spec.speeds, spec.repeat);
  return at_rest();
}

}  // namespace washtub
