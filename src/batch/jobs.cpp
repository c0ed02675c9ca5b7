#include "batch/jobs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "base/error.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

constexpr double patience = 20;  ///< from SIGTERM to SIGKILL [s]

double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

struct Child {
  std::size_t job;
  pid_t process;
  double start;
};

/// Takes the place of the forked process.
[[noreturn]] void become(std::vector<char*>& words, int console) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(console, STDOUT_FILENO);
  dup2(console, STDERR_FILENO);
  execvp(words[0], words.data());
  const char* reason = std::strerror(errno);
  (void)!write(STDERR_FILENO, reason, std::strlen(reason));
  _exit(127);
}

pid_t start(const Job& job) {
  std::vector<char*> words;
  for (const std::string& word : job.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const int console = open(job.console.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (console < 0) throw RunError(cannot_write(job.console, errno));
  const pid_t process = fork();
  if (process == 0) become(words, console);
  const int reason = errno;
  close(console);
  if (process < 0) throw RunError(fmt::format("{}: {}", job.words[0], std::strerror(reason)));
  return process;
}

int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The children that run; those left when it ends are killed.
class Children {
 public:
  ~Children() {
    signal(SIGKILL);
    for (const Child& child : running_) waitpid(child.process, nullptr, 0);
  }
  std::size_t count() const { return running_.size(); }
  void add(std::size_t job, const Job& what) { running_.push_back({job, start(what), now()}); }
  void signal(int number) const {
    for (const Child& child : running_) kill(child.process, number);
  }
  /// Takes out those that have ended.
  void collect(const JobEvents& events) {
    for (std::size_t i = 0; i < running_.size();) {
      const Child child = running_[i];
      int status = 0;
      if (waitpid(child.process, &status, WNOHANG) <= 0) {
        ++i;
        continue;
      }
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      events.ended(child.job, exit_code(status), now() - child.start);
    }
  }

 private:
  std::vector<Child> running_;
};

}  // namespace

void run_jobs(const std::vector<Job>& jobs, int at_once, const JobEvents& events) {
  Children children;
  std::size_t next = 0;
  double stopped = 0;  // when the children were asked to stop
  while (children.count() > 0 || (next < jobs.size() && stopped == 0)) {
    if (stopped == 0 && events.stop()) {
      children.signal(SIGTERM);
      stopped = now();
    }
    if (stopped > 0 && now() > stopped + patience) children.signal(SIGKILL);
    while (stopped == 0 && next < jobs.size() &&
           children.count() < static_cast<std::size_t>(at_once)) {
      children.add(next, jobs[next]);
      events.started(next++);
    }
    children.collect(events);
    usleep(20000);
  }
}

}  // namespace washtub
