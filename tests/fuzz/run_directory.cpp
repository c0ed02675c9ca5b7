#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "input.hpp"
#include "report/facts.hpp"
#include "report/json.hpp"
#include "report/run_record.hpp"
#include "report/settings.hpp"
#include "report/warnings.hpp"

using namespace washtub;
namespace fs = std::filesystem;

namespace {

/// An empty directory in TMPDIR.
std::string make_folder() {
  std::string name = fs::temp_directory_path() / "washtub_fuzz_XXXXXX";
  if (mkdtemp(name.data()) == nullptr) std::abort();
  static const std::string path = name;
  std::atexit([] { fs::remove_all(path); });
  return path;
}

/// A line "=== NAME" begins the file NAME of a run.
void write_files(const std::string& folder, std::string_view input) {
  std::map<std::string, std::string> texts;
  std::string* text = nullptr;
  fuzz::for_lines(input, [&](std::string_view line) {
    for (const char* name : {"case.toml", "summary.json", "history.csv", "tracks.csv"})
      if (line == std::string("=== ") + name) {
        text = &texts[name];
        return;
      }
    if (text) text->append(line).append(1, '\n');
  });
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove(entry);
  for (const auto& [name, content] : texts) std::ofstream(folder + "/" + name) << content;
}

}  // namespace

/// A directory is refused as a whole or read with what is missing said: then the page can tell of
/// it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string folder = make_folder();
  write_files(folder, fuzz::text_of(data, size));
  RunRecord run;
  if (!fuzz::takes([&] { run = read_run(folder); })) return 0;
  page_json(facts(run));
  page_json(groups(run));
  page_json(warnings(run));
  differing_settings({&run, &run});
  dimension(run);
  return 0;
}
