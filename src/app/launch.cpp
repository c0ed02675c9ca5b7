#include "app/launch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "base/error.hpp"
#include "record/stop.hpp"

namespace washtub {
namespace {

volatile std::sig_atomic_t launcher = 0;  ///< process id of mpirun
volatile std::sig_atomic_t ended = 0;     ///< signal that was to end the run at once

/// mpirun would kill the ranks on SIGINT, but hands SIGUSR1 on to them.
void pass_on(int signal) {
  static SignalCounter counter;
  if (counter.is_second(signal)) ended = signal;
  const int passed = ended != 0 ? SIGTERM : SIGUSR1;
  if (launcher > 0) kill(static_cast<pid_t>(launcher), passed);
}

/// Everything that names a hardware thread's core: its siblings.
std::string siblings(int cpu) {
  std::ifstream file(
      fmt::format("/sys/devices/system/cpu/cpu{}/topology/thread_siblings_list", cpu));
  std::string text;
  return std::getline(file, text) ? text : std::to_string(cpu);
}

std::vector<std::string> mpirun_command(int ranks) {
  std::vector<std::string> command = {"mpirun", "--quiet", "-n", std::to_string(ranks)};
  if (geteuid() == 0) command.emplace_back("--allow-run-as-root");
  if (ranks <= physical_cores()) {
    command.insert(command.end(), {"--bind-to", "core"});
  } else {
    command.insert(command.end(), {"--oversubscribe", "--bind-to", "none"});
  }
  command.push_back(own_program());
  return command;
}

/// Becomes mpirun in a process group of its own, which the terminal's Ctrl-C does not reach.
[[noreturn]] void become(const std::vector<std::string>& command) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::signal(SIGUSR1, SIG_IGN);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw RunError(fmt::format("mpirun: {}", std::strerror(errno)));
  if (ended != 0) return 128 + ended;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

bool inside_mpi() {
  const auto names = {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK", "PMI_SIZE"};
  return std::any_of(names.begin(), names.end(), [](const char* name) { return getenv(name); });
}

int physical_cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  std::set<std::string> cores;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
    if (CPU_ISSET(cpu, &allowed)) cores.insert(siblings(cpu));
  return std::max(1, static_cast<int>(cores.size()));
}

int launch_ranks(int ranks, const std::vector<std::string>& arguments) {
  std::vector<std::string> command = mpirun_command(ranks);
  command.insert(command.end(), arguments.begin() + 1, arguments.end());
  at_stop_signals(pass_on);
  std::signal(SIGPIPE, SIG_IGN);
  const pid_t child = fork();
  if (child < 0) throw RunError(fmt::format("mpirun: {}", std::strerror(errno)));
  if (child == 0) become(command);
  launcher = child;
  const int code = wait_for(child);
  launcher = 0;
  at_stop_signals(SIG_DFL);
  if (code == 127) throw RunError("mpirun cannot be started; install openmpi-bin or use -n 1");
  return code;
}

}  // namespace washtub
