#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "base/error.hpp"
#include "io/file.hpp"
#include "report/bundle.hpp"
#include "report/json.hpp"

extern "C" const char washtub_template[];
extern "C" const char washtub_template_end[];

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view mark = "<!--washtub-data-->";

/// The page without its data, in two parts: before and after them.
std::array<std::string_view, 2> frame_of_page() {
  const std::string_view whole(washtub_template, washtub_template_end);
  const auto at = whole.find(mark);
  if (at == std::string_view::npos) throw RunError("the page's template has no place for data");
  return {whole.substr(0, at), whole.substr(at + mark.size())};
}

/// A page that is being made.
struct Draft {
  Json index;
  Chunks chunks;
  PageSize size;  ///< without its bytes

  explicit Draft(const PageContent& content)
      : index{{"version", 1}, {"program", content.program}, {"runs", Json::array()}} {
    index["comparison"] = content.comparison;
    index["ensemble"] = content.ensemble;
  }
  /// Adds a run that takes `room` bytes at most, if it can. Returns how many it takes.
  std::size_t add(const RunRecord& run, std::size_t room) {
    RunBundle one = bundle(run, chunks, room);
    size.frames += one.frames;
    size.notes.insert(size.notes.end(), one.notes.begin(), one.notes.end());
    index["runs"].push_back(std::move(one.index));
    return one.bytes;
  }
};

std::string assemble(const Draft& draft) {
  const auto [before, after] = frame_of_page();
  std::string page(before);
  page += "<script type=\"application/json\" id=\"washtub-data\">";
  page += page_json(draft.index);
  page += "</script>\n";
  for (std::size_t n = 0; n < draft.chunks.texts().size(); ++n)
    page += chunk_element(n, draft.chunks.texts()[n]);
  page += after;
  return page;
}

/// What the runs need at least; `smallest` becomes the page of that.
std::vector<std::size_t> least_sizes(const std::vector<RunRecord>& runs, Draft& smallest) {
  std::vector<std::size_t> least;
  for (const RunRecord& run : runs) least.push_back(smallest.add(run, 0) + 1);  // with its comma
  return least;
}

/// The page of one run, as near to the limit as it can be.
Draft compose_one(const PageContent& content, std::size_t limit) {
  Draft draft(content);
  const std::size_t fixed = assemble(draft).size();
  draft.add(content.runs[0], limit - std::min(limit, fixed));
  return draft;
}

/// Every run gets what it needs at least, and its share of what is left over by those before it.
/// The smallest page where that is not enough.
Draft compose(const PageContent& content, std::size_t limit) {
  const auto& runs = content.runs;
  if (runs.size() == 1) return compose_one(content, limit);
  Draft draft(content), smallest(content);
  const std::vector<std::size_t> least = least_sizes(runs, smallest);
  const std::size_t needed = std::accumulate(least.begin(), least.end(), assemble(draft).size());
  if (needed > limit) return smallest;
  std::size_t rest = limit - needed;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t taken = draft.add(runs[r], least[r] - 1 + rest / (runs.size() - r)) + 1;
    rest -= std::min(rest, taken - std::min(taken, least[r]));
  }
  return assemble(draft).size() > limit ? smallest : draft;
}

}  // namespace

PageSize write_page(const std::string& path, const PageContent& content, std::size_t limit) {
  const Draft draft = compose(content, limit);
  const std::string page = assemble(draft);
  PageSize size = draft.size;
  size.bytes = page.size();
  if (size.bytes > limit)
    throw InputError(
        fmt::format("{}: does not fit into {:.3g} MB; the smallest possible page has "
                    "{:.3g} MB",
                    path, static_cast<double>(limit) / 1e6,
                    std::ceil(static_cast<double>(size.bytes) / 1e4) / 1e2));
  replace_file(path, page);
  return size;
}

}  // namespace washtub
