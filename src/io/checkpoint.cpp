#include "io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string_view>

#include "base/error.hpp"
#include "io/agree.hpp"
#include "io/file.hpp"
#include "io/reserve.hpp"
#include "io/seal.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

constexpr const char* kind = "checkpoint";

/// Whether a file name is checkpoint_<digits>.h5.
bool is_ours(std::string_view name) {
  constexpr std::string_view head = "checkpoint_", tail = ".h5";
  if (!name.starts_with(head) || !name.ends_with(tail)) return false;
  name.remove_prefix(head.size());
  name.remove_suffix(tail.size());
  return !name.empty() && name.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Bytes that a state takes in a file.
class Size final : public Archive {
 public:
  bool reading() const override { return false; }
  std::size_t bytes = 65536;  ///< with some to spare for the library's own data

 private:
  void enter(const std::string&) override {}
  void list(const std::string&, Number number, void*, std::size_t count) override {
    bytes += overhead + count * size_of(number);
  }
  std::size_t length(const std::string&, std::size_t now) override { return now; }
  void grid_values(const std::string&, Number number, void*, const GridPart& part) override {
    const auto& n = part.extent;
    bytes += overhead + n[0] * n[1] * n[2] * size_of(number);
  }
  static constexpr std::size_t overhead = 1024;
};

}  // namespace

void CheckpointLabel::state(Archive& archive) {
  archive.value("program", program);
  archive.value("case", case_text);
  archive.value("time", time);
  archive.value("step", step);
  archive.value("window begin", window_begin);
  archive.value("window end", window_end);
}

void Checkpoints::write(CheckpointLabel label, const Parallel& parallel,
                        const std::function<void(Archive&)>& save) const {
  const std::string path = fmt::format("{}/checkpoint_{:010d}.h5", folder_, label.step);
  Size size;
  save(size);
  std::error_code error;
  if (parallel.root()) fs::create_directories(folder_, error);
  reserve_file(path, size.bytes, parallel);
  StateWriter file(path + ".part", parallel.comm(), seal_size);
  reserve_file(path, size.bytes, parallel);
  file.value("label", label);
  save(file);
  std::string reason = file.close();
  if (!reason.empty()) reason = fmt::format("cannot write {}: {}", path, reason);
  if (!parallel.any(!reason.empty()) && parallel.root()) try {
      publish(path);
    } catch (const RunError& error) {
      reason = error.what();
    }
  if (parallel.root()) std::remove((path + ".part").c_str());
  agree(parallel, reason);
}

void Checkpoints::publish(const std::string& path) const {
  seal_file(path + ".part", kind, checkpoint_version);
  publish_file(path);
  int older = 0;
  for (const std::string& other : list())
    if (other > path || (other < path && ++older >= keep_)) std::remove(other.c_str());
}

std::vector<std::string> Checkpoints::list() const {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error))
    if (is_ours(entry.path().filename().string())) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end(), std::greater<>());
  return paths;
}

std::string Checkpoints::newest(std::vector<std::string>& damaged) const {
  for (const std::string& path : list()) try {
      check_checkpoint(path);
      return path;
    } catch (const InputError& error) {
      damaged.emplace_back(error.what());
    }
  std::string text = fmt::format("{}: holds no checkpoint to go on from", folder_);
  if (!damaged.empty()) text = fmt::format("{}; {}", text, fmt::join(damaged, "; "));
  throw InputError(text);
}

void check_checkpoint(const std::string& path) { check_seal(path, kind, checkpoint_version); }

CheckpointLabel read_label(const std::string& path) {
  check_checkpoint(path);
  StateReader file(path);
  CheckpointLabel label;
  file.value("label", label);
  return label;
}

}  // namespace washtub
