#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "app/commands.hpp"
#include "app/launch.hpp"
#include "app/mpi.hpp"
#include "app/protect.hpp"
#include "base/error.hpp"
#include "io/file.hpp"
#include "record/build_facts.hpp"
#include "speed/suite.hpp"

namespace washtub {
namespace {

std::regex filter_of(const BenchArguments& arguments) try {
  return std::regex(arguments.filter);
} catch (const std::regex_error&) {
  throw InputError(fmt::format("--filter {}: expected a regular expression such as \"step|triad\"",
                               arguments.filter));
}

/// The part of a rank.
int measure(const BenchArguments& arguments) {
  const Mpi mpi;
  const Parallel parallel;
  std::optional<Speeds> before;
  if (!arguments.compare.empty()) before = read_speeds(arguments.compare);
  const Speeds now{build_facts().commit, processor(), parallel.size(),
                   measure_speeds(parallel, filter_of(arguments))};
  if (now.results.empty()) throw InputError("--filter: nothing has such a name");
  if (!parallel.root()) return 0;
  fmt::print("commit {}, {}, {} {}\n", now.commit, now.processor, now.ranks,
             now.ranks == 1 ? "rank" : "ranks");
  if (before)
    fmt::print("against commit {}, {}, {} {}\n", before->commit, before->processor, before->ranks,
               before->ranks == 1 ? "rank" : "ranks");
  fmt::print("{}", speed_table(now, before ? &*before : nullptr));
  if (!arguments.file.empty()) replace_file(arguments.file, to_json(now).dump(2) + "\n");
  return 0;
}

}  // namespace

int command_bench(const BenchArguments& arguments) {
  if (arguments.ranks < 1)
    throw InputError(fmt::format("-n {}: allowed: 1 or more ranks", arguments.ranks));
  filter_of(arguments);
  if (!arguments.compare.empty()) read_speeds(arguments.compare);
  if (!arguments.file.empty()) protect_speeds(arguments.file);
  if (inside_mpi() || arguments.ranks == 1) return measure(arguments);
  return launch_ranks(arguments.ranks, arguments.all);
}

}  // namespace washtub
