#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

/// `washtub movie` with a PATH that has only what a test puts there.
class Movie : public testing::Test {
 protected:
  Movie() {
    char name[] = "/tmp/washtub-movie-test-XXXXXX";
    folder = mkdtemp(name);
    fs::create_directory(folder / "tools");
  }
  ~Movie() override { fs::remove_all(folder); }

  /// Exit code of a shell command; `text` is what it wrote to both streams.
  int shell(const std::string& command) {
    FILE* pipe = popen(("cd " + folder.string() + "; " + command + " 2>&1").c_str(), "r");
    text.clear();
    std::array<char, 4096> part{};
    while (const size_t count = fread(part.data(), 1, part.size(), pipe))
      text.append(part.data(), count);
    const int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int movie(const std::string& arguments) {
    return shell("PATH=" + (folder / "tools").string() + " exec " WASHTUB_PROGRAM " movie " +
                 arguments);
  }
  /// A program that does what the shell script says.
  void install(const std::string& name, const std::string& script) const {
    const fs::path file = folder / "tools" / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(file, fs::perms::owner_all);
  }
  void install_all(const std::string& node) const {
    install("node", node);
    install("chromium", "exit 0");
    install("ffmpeg", "exit 0");
  }
  /// A run of one frame or two in the directory `run`.
  void make_run() {
    const std::string wash = fs::absolute("cases/wash-2d/case.toml").string();
    ASSERT_EQ(shell(WASHTUB_PROGRAM " run " + wash +
                    " -o run -n 1 --no-report --set domain.cells=32 --set 'time.end=0.01 s' --set "
                    "'output.window=[\"0 s\", \"0.01 s\"]' --set 'output.frames=0.01 s'"),
              0)
        << text;
  }
  bool nothing_left() const {
    return !fs::exists(folder / "run/movie.mp4") && !fs::exists(folder / "run/movie.mp4.part");
  }

  fs::path folder;
  std::string text;
};

}  // namespace

TEST_F(Movie, RefusesWrongOptions) {
  const std::string expected =
      ": expected width and height, even numbers from 64 to 4096, such as 1280x720\n";
  for (const std::string size : {"1281x720", "1280", "1280x720p", "0x0", "9999x720"}) {
    EXPECT_EQ(movie(". --size " + size), 2);
    EXPECT_EQ(text, "washtub: --size " + size + expected);
  }
  EXPECT_EQ(movie(". --from 3"), 2);
  EXPECT_EQ(text, "washtub: --from \"3\": expected time such as \"0.5 s\"\n");
  EXPECT_EQ(movie("nothing --from '3 s' --to '2 s'"), 2);
  EXPECT_EQ(text, "washtub: --from \"3 s\": is later than --to \"2 s\"\n");
  EXPECT_EQ(movie("nothing"), 2);
  EXPECT_EQ(text, "washtub: nothing: there is no such directory\n");
}

TEST_F(Movie, NamesTheMissingToolAndItsPackage) {
  EXPECT_EQ(movie("."), 1);
  EXPECT_THAT(text, HasSubstr("a movie needs node, which is not on the PATH; install the package "
                              "nodejs"));
  install("node", "exit 0");
  EXPECT_EQ(movie("."), 1);
  EXPECT_THAT(text, HasSubstr("needs chromium or chromium-browser or google-chrome"));
  install("google-chrome", "exit 0");
  EXPECT_EQ(movie("."), 1);
  EXPECT_THAT(text, HasSubstr("needs ffmpeg"));
}

TEST_F(Movie, SaysThatTheFileCannotBeWritten) {
  install_all("exit 0");
  EXPECT_EQ(movie(". -o /nowhere/a.mp4"), 2);
  EXPECT_EQ(text, "washtub: cannot write /nowhere/a.mp4: No such file or directory\n");
  EXPECT_EQ(movie(". -o tools"), 2);
  EXPECT_EQ(text, "washtub: tools: is a directory; name a file with -o\n");
  EXPECT_FALSE(fs::exists(folder / "tools.part"));
}

TEST_F(Movie, ReplacesMoviesOnly) {
  install_all("exit 0");
  std::ofstream(folder / "notes.mp4") << "kept";
  EXPECT_EQ(movie(". -o notes.mp4"), 2);
  EXPECT_EQ(text, "washtub: notes.mp4: exists and is no MP4 movie; name another file with -o\n");
  EXPECT_EQ(fs::file_size(folder / "notes.mp4"), 4U);
  make_run();
  std::ofstream(folder / "old.mp4") << std::string("\0\0\0\x20", 4) << "ftypisom";
  EXPECT_EQ(movie("run -o old.mp4"), 0) << text;
}

TEST_F(Movie, IsThereWhenAllWentWellOnly) {
  make_run();
  install_all("exit 1");
  EXPECT_EQ(movie("run"), 1) << text;
  EXPECT_TRUE(nothing_left());
  install("node", "exit 0");
  EXPECT_EQ(movie("run"), 0) << text;
  EXPECT_THAT(text, HasSubstr("run/movie.mp4"));
  EXPECT_TRUE(fs::exists(folder / "run/movie.mp4"));
  EXPECT_FALSE(fs::exists(folder / "run/movie.mp4.part"));
}

TEST_F(Movie, StopsOnRequestAndLeavesNothing) {
  make_run();
  install_all("echo begun; kill -TERM $PPID; exec /bin/sleep 30");
  EXPECT_EQ(movie("run"), 130);
  EXPECT_EQ(text, "begun\n");
  EXPECT_TRUE(nothing_left());
}
