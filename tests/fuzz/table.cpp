#include "io/table.hpp"

#include <algorithm>

#include "input.hpp"

using namespace washtub;

/// What is sound in a table is taken, and nothing of it is lost.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  fuzz::takes([&] {
    const CsvTable table("history.csv", text);
    for (const CsvTable::Column& column : table.columns()) table.column(column.name);
    table.column("torque");
  });
  const SoundRows sound = sound_rows(text);
  if (sound.text.empty()) return 0;
  const CsvTable table("history.csv", sound.text);
  const auto lines = std::count(sound.text.begin(), sound.text.end(), '\n');
  if (static_cast<long>(table.rows()) + 1 != lines) throw std::logic_error("rows are lost");
  return 0;
}
