#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

void add_case(CLI::App& command, CaseArguments& arguments) {
  command.add_option("CASE", arguments.path, "case file (TOML)")->required();
  command
      .add_option("--set", arguments.settings,
                  "override a key of the case file, as in --set cloth.count=32")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
}

void add_run(CLI::App& app, RunArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "run", "simulate a case; with --resume, CASE may be the directory of the interrupted run");
  add_case(command, arguments.input);
  command.add_option("-o", arguments.directory, "directory of the results [out/<case>]")
      ->type_name("DIR");
  command.add_option("-n", arguments.ranks, "MPI ranks [cores that are free]")->type_name("RANKS");
  command.add_flag("--force", arguments.force, "overwrite earlier results");
  command.add_flag("--resume", arguments.resume, "go on from the newest sound checkpoint");
  command
      .add_option("--from", arguments.from,
                  "start with water and cloth of another run: a checkpoint, or its directory")
      ->type_name("CHECKPOINT");
  command.add_flag("!--no-report", arguments.report, "do not make report.html at the end");
}

void add_reference(CLI::App& app, ReferenceArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "reference", "print the reference of all keys of a case file, docs/input.md");
  command.add_flag("--output", arguments.output,
                   "that of all columns, fields and entries of the results, docs/output.md");
  command.add_flag("--schema", arguments.schema, "the JSON schema of case files, for editors")
      ->excludes("--output");
}

void add_modes(CLI::App& app, ModesArguments& arguments) {
  CLI::App& command = *app.add_subcommand("modes", "natural frequencies of a case's cloth");
  add_case(command, arguments.input);
  command.add_option("--count", arguments.count, "lowest frequencies to show")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command.add_option("-o", arguments.file, "JSON file of the frequencies")->type_name("FILE");
}

void add_fabrics(CLI::App& app, std::string& name) {
  CLI::App& command =
      *app.add_subcommand("fabrics", "the kinds of cloth that a case may name, and their values");
  command.add_option("NAME", name, "one of them, with its sources [all]");
}

void add_verify(CLI::App& app, VerifyArguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("verify", "run the verification cases and judge what they compute");
  command.add_option("NAME", arguments.names, "cases [all]");
  const std::map<std::string, VerifyLevel> levels = {{"quick", VerifyLevel::quick},
                                                     {"full", VerifyLevel::full}};
  command.add_option("--level", arguments.level, "quick or full [quick]")
      ->transform(CLI::Transformer(levels))
      ->type_name("LEVEL");
  command.add_flag("--list", arguments.list, "name the cases and their runs");
  command.add_option("-o", arguments.directory, "directory of the results")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--cases", arguments.cases, "folder of the cases [the program's own]")
      ->type_name("DIR");
  command.add_option("-j", arguments.jobs, "runs at once [physical cores]")
      ->type_name("JOBS")
      ->check(CLI::Range(1, 10000));
  command.add_flag("--force", arguments.force, "repeat finished runs");
  command.add_flag("--allow-known", arguments.allow_known,
                   "exit 0 where nothing but known misses is wrong");
}

void add_report(CLI::App& app, ReportArguments& arguments) {
  CLI::App& command = *app.add_subcommand("report", "make the page to look at a run");
  command.add_option("DIR", arguments.directory, "directory of the run")->required();
  command.add_option("-o", arguments.file, "page to write [DIR/report.html]")->type_name("FILE");
  command.add_option("--max-size", arguments.size, "largest size of the page")
      ->type_name("SIZE")
      ->capture_default_str();
}

void add_bench(CLI::App& app, BenchArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "bench", "time the kernels of a step and whole steps on this machine, beside a triad");
  command.add_option("-n", arguments.ranks, "MPI ranks")->type_name("RANKS")->capture_default_str();
  command.add_option("--filter", arguments.filter, "only what matches a regular expression")
      ->type_name("REGEX");
  command.add_option("-o", arguments.file, "JSON to write the results to")->type_name("FILE");
  command.add_option("--compare", arguments.compare, "earlier results to compare with")
      ->type_name("FILE");
}

void add_check(CLI::App& app, CheckArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "check", "validate a case, show what it means, and foresee time, memory and disk of its run");
  add_case(command, arguments.input);
  command.add_option("-n", arguments.ranks, "MPI ranks of the run [cores that are free]")
      ->type_name("RANKS");
  command.add_flag("!--no-forecast", arguments.forecast,
                   "do not begin the run to foresee its time");
}

void add_compare(CLI::App& app, CompareArguments& arguments) {
  CLI::App& command =
      *app.add_subcommand("compare", "compare runs: what differs, and whether it is chance");
  command.add_option("DIR", arguments.directories, "directories of the runs, two or more");
  command.add_option("-o", arguments.file, "page to write")
      ->type_name("FILE")
      ->capture_default_str();
  command.add_option("--max-size", arguments.size, "largest size of the page")
      ->type_name("SIZE")
      ->capture_default_str();
}

void add_ensemble(CLI::App& app, EnsembleArguments& arguments) {
  CLI::App& command = *app.add_subcommand(
      "ensemble",
      "run a case from several random starts and pool what they tell; run again, it goes on with "
      "what is unfinished");
  add_case(command, arguments.input);
  command.add_option("--seeds", arguments.seeds, "how many, as in 5, or from-to, as in 6-10")
      ->type_name("SEEDS")
      ->capture_default_str();
  command.add_option("-o", arguments.directory, "directory of the members [out/<case>-ensemble]")
      ->type_name("DIR");
  command.add_option("-j", arguments.jobs, "runs at once [physical cores / RANKS]")
      ->type_name("JOBS")
      ->check(CLI::Range(1, 10000));
  command.add_option("-n", arguments.ranks, "MPI ranks of each run")
      ->type_name("RANKS")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command.add_flag("--force", arguments.force, "make all members anew");
  command.add_option("--max-size", arguments.size, "largest size of the page")
      ->type_name("SIZE")
      ->capture_default_str();
}

void add_movie(CLI::App& app, MovieArguments& arguments) {
  CLI::App& command = *app.add_subcommand("movie", "make a movie of a run's cloth and water");
  command.add_option("DIR", arguments.directory, "directory of the run")->required();
  command.add_option("-o", arguments.file, "movie to write, MP4 [DIR/movie.mp4]")
      ->type_name("FILE");
  command.add_option("--size", arguments.size, "pixels")->type_name("WxH")->capture_default_str();
  command.add_option("--fps", arguments.fps, "pictures per second")
      ->type_name("N")
      ->check(CLI::Range(1, 120))
      ->capture_default_str();
  command.add_option("--speed", arguments.speed, "seconds of the run in one of the movie")
      ->type_name("X")
      ->check(CLI::Range(0.001, 1000.0))
      ->capture_default_str();
  command.add_option("--from", arguments.from, "first time, as in \"1.5 s\"")->type_name("TIME");
  command.add_option("--to", arguments.to, "last time")->type_name("TIME");
  command.add_option("--colour", arguments.colour, "of the cloth: piece, or which stress [piece]")
      ->check(CLI::IsMember({"piece", "membrane", "bending", "total"}));
  command.add_option("--slice", arguments.slice, "planes through the water [off in 3-D]")
      ->check(CLI::IsMember({"off", "vertical", "horizontal", "both"}));
}

/// @throws InputError where a word stands in the place of the command and is none.
void check_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw InputError(fmt::format("unknown command {}; there are {}", word, fmt::join(names, ", ")));
}

/// Reads the command line and runs the command. Returns the exit code.
int command_line(int argc, char** argv) {
  CLI::App app("Washtub: how water moves clothes in a washing machine");
  app.set_version_flag("--version", program_name);
  app.require_subcommand(1);
  app.footer(exit_codes);
  RunArguments run;
  run.all.assign(argv, argv + argc);
  add_run(app, run);
  CheckArguments check;
  check.all = run.all;
  add_check(app, check);
  ModesArguments modes;
  add_modes(app, modes);
  std::string fabric;
  add_fabrics(app, fabric);
  BenchArguments bench;
  bench.all = run.all;
  add_bench(app, bench);
  VerifyArguments verify;
  add_verify(app, verify);
  ReportArguments report;
  add_report(app, report);
  CompareArguments compare;
  add_compare(app, compare);
  EnsembleArguments ensemble;
  add_ensemble(app, ensemble);
  MovieArguments movie;
  add_movie(app, movie);
  ReferenceArguments reference;
  add_reference(app, reference);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    check_command(app, argc > 1 ? argv[1] : "-");
    fmt::print(stderr, "washtub: {}\nTry washtub --help.\n", error.what());
    return exit_wrong_input;
  }
  if (app.got_subcommand("run")) return command_run(run);
  if (app.got_subcommand("modes")) return command_modes(modes);
  if (app.got_subcommand("fabrics")) return command_fabrics(fabric);
  if (app.got_subcommand("bench")) return command_bench(bench);
  if (app.got_subcommand("verify")) return command_verify(verify);
  if (app.got_subcommand("report")) return command_report(report);
  if (app.got_subcommand("ensemble")) return command_ensemble(ensemble);
  if (app.got_subcommand("compare")) return command_compare(compare);
  if (app.got_subcommand("movie")) return command_movie(movie);
  return app.got_subcommand("check") ? command_check(check) : command_reference(reference);
}

/// On stderr, whether or not anybody takes it.
void tell(const std::exception& error) {
  std::fputs(fmt::format("washtub: {}\n", error.what()).c_str(), stderr);
}

/// @throws RunError where what was printed could not be written
void flush_output() {
  if (std::fflush(stdout) != 0) throw RunError(cannot_write("standard output", errno));
}

}  // namespace
}  // namespace washtub

int main(int argc, char** argv) {
  try {
    const int code = washtub::command_line(argc, argv);
    washtub::flush_output();
    return code;
  } catch (const washtub::InputError& error) {
    washtub::tell(error);
    return washtub::exit_wrong_input;
  } catch (const std::exception& error) {
    washtub::tell(error);
    return washtub::exit_failed;
  }
}
