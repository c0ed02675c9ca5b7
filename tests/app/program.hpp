#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace washtub::testing {

namespace fs = std::filesystem;

struct Outcome {
  int code;
  std::string text;  ///< of both output streams
};

/// Runs the built program as a user does, from an empty folder of its own.
class Program : public ::testing::Test {
 protected:
  Program() {
    char name[] = "/tmp/washtub-test-XXXXXX";
    folder = mkdtemp(name);
  }
  ~Program() override { fs::remove_all(folder); }

  /// `before`: commands of the shell that come first; `launcher`: such as mpirun.
  Outcome run(const std::string& arguments, const std::string& before = "",
              const std::string& launcher = "") const {
    const std::string command = "cd " + folder.string() + " && " + before + "env" +
                                without_launcher() + " " + launcher + WASHTUB_PROGRAM " " +
                                arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    Outcome outcome;
    std::array<char, 4096> part{};
    while (const size_t count = fread(part.data(), 1, part.size(), pipe))
      outcome.text.append(part.data(), count);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  /// Starts the program and does not wait for it; what it prints goes to console.txt.
  pid_t start(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd " + folder.string() + " && " + before + "exec env" +
                                without_launcher() + " " WASHTUB_PROGRAM " " + arguments +
                                " > console.txt 2>&1";
    const pid_t child = fork();
    if (child == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    return child;
  }
  /// The command fails as wrong input, says so in one line, and writes nothing.
  void refuses(const std::string& arguments, const std::string& message) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_EQ(outcome.text, "washtub: " + message + "\n");
    EXPECT_TRUE(fs::is_empty(folder)) << arguments;
  }

  fs::path folder;

 private:
  /// Options of env that hide that this test runs under MPI itself.
  static std::string without_launcher() {
    std::string options;
    for (char** entry = environ; *entry; ++entry) {
      const std::string text = *entry;
      for (const char* prefix : {"OMPI_", "PMIX_", "PMI_"})
        if (text.starts_with(prefix)) options += " -u " + text.substr(0, text.find('='));
    }
    return options;
  }
};

}  // namespace washtub::testing
