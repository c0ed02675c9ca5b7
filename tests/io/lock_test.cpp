#include "io/lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>

#include "base/error.hpp"
#include "io/scratch.hpp"

namespace washtub {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

std::string refusal(const std::string& directory) {
  try {
    const DirectoryLock lock(directory);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DirectoryLock, KeepsOthersOutWhileItLives) {
  const Scratch folder;
  {
    DirectoryLock first(folder.path());
    const std::string text = refusal(folder.path());
    EXPECT_THAT(text, StartsWith(folder.path() + ": another run writes here: process " +
                                 std::to_string(getpid()) + " on "));
    EXPECT_THAT(text, HasSubstr("name another directory with -o"));
    const DirectoryLock moved = std::move(first);
    EXPECT_NE(refusal(folder.path()), "");
    EXPECT_EQ(moved.note(), "");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_EQ(refusal(folder.path()), "");
}

/// A process that takes the lock and then waits; returns when it has it.
pid_t holder_of(const std::string& directory) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    const DirectoryLock lock(directory);
    (void)!write(ends[1], "x", 1);
    pause();
    _exit(0);
  }
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 1);
  close(ends[0]);
  close(ends[1]);
  return child;
}

TEST(DirectoryLock, IsGoneWithAKilledProcess) {
  const Scratch folder;
  const pid_t child = holder_of(folder.path());
  EXPECT_THAT(refusal(folder.path()), HasSubstr("process " + std::to_string(child) + " on "));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(folder / DirectoryLock::name));
  EXPECT_EQ(refusal(folder.path()), "");
}

TEST(DirectoryLock, StaysWithAChildThatInheritedIt) {
  const Scratch folder;
  const pid_t child = [&] {
    const DirectoryLock lock(folder.path());
    const pid_t heir = fork();
    if (heir == 0) {
      pause();
      _exit(0);
    }
    // As if this process had been killed: nothing is put in order.
    fs::rename(folder / DirectoryLock::name, folder / "aside");
    return heir;
  }();
  fs::rename(folder / "aside", folder / DirectoryLock::name);
  EXPECT_NE(refusal(folder.path()), "");
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(refusal(folder.path()), "");
}

}  // namespace
}  // namespace washtub
