#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/commands.hpp"
#include "app/movie_tools.hpp"
#include "app/protect.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "base/units.hpp"
#include "io/file.hpp"
#include "record/stop.hpp"
#include "report/page.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

constexpr int cannot_start = 127;
constexpr std::size_t page_limit = 200'000'000;  ///< [bytes], so that little is thinned

/// A folder for the page, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_((fs::temp_directory_path() / "washtub-movie-XXXXXX").string()) {
    if (!mkdtemp(path_.data())) throw RunError(cannot_write(path_, errno));
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const char* name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};

/// The movie while it is made, beside its place; removed at the end unless it was put there.
class PartialFile {
 public:
  explicit PartialFile(const std::string& target) : target_(target), path_(target + ".part") {
    const int file = open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) throw InputError(cannot_write(target, errno));
    close(file);
  }
  ~PartialFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  const std::string& path() const { return path_; }
  void keep() const {
    if (std::rename(path_.c_str(), target_.c_str()) != 0)
      throw RunError(cannot_write(target_, errno));
  }

 private:
  std::string target_, path_;
};

/// @throws InputError unless the text is two even numbers of pixels such as "1280x720"
std::pair<int, int> pixels(const std::string& text) {
  int width = 0, height = 0, end = 0;
  const int found = std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end);
  const auto allowed = [](int n) { return n >= 64 && n <= 4096 && n % 2 == 0; };
  if (found == 2 && end == static_cast<int>(text.size()) && allowed(width) && allowed(height))
    return {width, height};
  throw InputError(fmt::format(
      "--size {}: expected width and height, even numbers from 64 to 4096, such as 1280x720",
      text));
}

/// Seconds, or null where nothing was said.
nlohmann::json seconds(const char* option, const std::string& text) {
  if (text.empty()) return nullptr;
  try {
    return parse_quantity(text, measure::time);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} \"{}\": {}", option, text, error.what()));
  }
}

/// What viewer/movie.mjs is asked for, but for the files.
nlohmann::json wishes(const MovieArguments& arguments) {
  const auto [width, height] = pixels(arguments.size);
  const auto from = seconds("--from", arguments.from), to = seconds("--to", arguments.to);
  if (from.is_number() && to.is_number() && from.get<double>() > to.get<double>())
    throw InputError(
        fmt::format("--from \"{}\": is later than --to \"{}\"", arguments.from, arguments.to));
  return {{"width", width},
          {"height", height},
          {"fps", arguments.fps},
          {"speed", arguments.speed},
          {"from", from},
          {"to", to},
          {"colour", arguments.colour},
          {"slice", arguments.slice}};
}

void make_page(const std::string& directory, const std::string& file) {
  PageContent content;
  content.program = program_name;
  content.runs.push_back(read_run(directory));
  const PageSize page = write_page(file, content, page_limit);
  if (page.frames == 0)
    throw InputError(fmt::format(
        "{}: has no frames to show; a run writes them where output.frames is set", directory));
  for (const std::string& sentence : page.notes) fmt::print(stderr, "{}\n", sentence);
}

/// Becomes Node.js with the script; the terminal's Ctrl-C reaches only the command, which tells it.
[[noreturn]] void become(const MovieTools& tools, std::string options) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::string program = tools.node, script = tools.script;
  char* const words[] = {program.data(), script.data(), options.data(), nullptr};
  execv(words[0], words);
  fmt::print(stderr, "washtub: {} cannot be started: {}\n", program, std::strerror(errno));
  _exit(cannot_start);
}

/// Runs the script until it ends or this process is asked to stop. Returns the exit code.
int run_script(const MovieTools& tools, const std::string& options) {
  const pid_t child = fork();
  if (child == 0) become(tools, options);
  if (child < 0) throw RunError(fmt::format("{}: {}", tools.node, std::strerror(errno)));
  int status = 0;
  bool told = false;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (stop_requested() && !told) told = kill(child, SIGTERM) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (told) return exit_stopped;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : exit_failed;
  return code == cannot_start ? exit_failed : code;
}

}  // namespace

int command_movie(const MovieArguments& arguments) {
  nlohmann::json options = wishes(arguments);
  if (!fs::is_directory(arguments.directory))
    throw InputError(fmt::format("{}: there is no such directory", arguments.directory));
  const MovieTools tools = find_movie_tools();
  const std::string target = arguments.file.empty()
                                 ? (fs::path(arguments.directory) / "movie.mp4").string()
                                 : arguments.file;
  protect_movie(target);
  install_stop_handlers();
  const PartialFile movie(target);
  const TemporaryFolder folder;
  make_page(arguments.directory, folder.file("report.html"));
  if (stop_requested()) return exit_stopped;
  options.update({{"page", folder.file("report.html")},
                  {"output", movie.path()},
                  {"browser", tools.browser},
                  {"encoder", tools.encoder}});
  const int code = run_script(tools, options.dump());
  if (code != 0) return code;
  movie.keep();
  fmt::print("{}: {:.1f} kB\n", target, 1e-3 * static_cast<double>(fs::file_size(target)));
  return 0;
}

}  // namespace washtub
