#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/protect.hpp"
#include "app/report.hpp"
#include "app/size.hpp"
#include "base/error.hpp"
#include "report/page.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

double seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Writes the page. Returns what there is to say about it.
std::string report(const std::string& directory, const std::string& path, std::size_t limit) {
  const double start = seconds();
  PageContent content;
  content.program = program_name;
  content.runs.push_back(read_run(directory));
  const PageSize size = write_page(path, content, limit);
  std::string text =
      fmt::format("{}: {:.1f} MB, {} frames, made in {:.1f} s", path,
                  static_cast<double>(size.bytes) / 1e6, size.frames, seconds() - start);
  for (const std::string& note : size.notes) text += "\n  " + note;
  return text;
}

std::string default_path(const std::string& directory) {
  return (fs::path(directory) / "report.html").string();
}

/// A line at the end of the run's own log, in its format.
void add_to_log(const std::string& directory, const std::string& line) {
  try {
    const auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(directory + "/log.txt");
    spdlog::logger("run", sink).info("{}", line);
  } catch (const spdlog::spdlog_ex&) {  // the line is on stderr too
  }
}

}  // namespace

int command_report(const ReportArguments& arguments) {
  const std::size_t limit = parse_size(arguments.size);
  const std::string file =
      arguments.file.empty() ? default_path(arguments.directory) : arguments.file;
  protect_page(file);
  fmt::print("{}\n", report(arguments.directory, file, limit));
  return 0;
}

bool report_run(const std::string& directory) {
  std::error_code error;
  if (!fs::exists(fs::path(directory) / "history.csv", error)) return true;
  std::string line;
  bool made = true;
  try {
    const std::size_t limit = parse_size(ReportArguments().size);
    line = report(directory, default_path(directory), limit);
  } catch (const std::exception& failure) {
    line = fmt::format("no report: {}; the results are there, make it with: washtub report {}",
                       failure.what(), directory);
    made = false;
  }
  std::fputs((line + '\n').c_str(), stderr);
  add_to_log(directory, line);
  return made;
}

}  // namespace washtub
