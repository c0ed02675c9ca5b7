#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

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
  }
  /// Adds a run that takes `room` bytes at most, if it can. Returns how many it takes.
  std::size_t add(const RunRecord& run, std::size_t room) {
    RunBundle one = bundle(run, chunks, room);
    size.frames += one.frames;
    size.thinned.insert(size.thinned.end(), one.thinned.begin(), one.thinned.end());
    index["runs"].push_back(std::move(one.index));
    return one.bytes + 1;
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

/// Every run gets what it needs at least, and its share of what is left over by those before it.
/// The smallest page where that is not enough.
std::pair<std::string, PageSize> compose(const PageContent& content, std::size_t limit) {
  const auto& runs = content.runs;
  Draft draft(content), smallest(content);
  const std::size_t fixed = assemble(draft).size();
  std::vector<std::size_t> least(runs.size(), 0);
  for (std::size_t r = 0; r < runs.size() && runs.size() > 1; ++r)
    least[r] = smallest.add(runs[r], 0);
  const std::size_t needed = std::accumulate(least.begin(), least.end(), fixed);
  if (needed > limit) return {assemble(smallest), smallest.size};
  std::size_t rest = limit - needed;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::size_t room = least[r] + rest / (runs.size() - r);
    const std::size_t taken = draft.add(runs[r], room - std::min<std::size_t>(room, 1));
    rest -= std::min(rest, taken - std::min(taken, least[r]));
  }
  std::string page = assemble(draft);
  if (page.size() > limit && runs.size() > 1) return {assemble(smallest), smallest.size};
  return {std::move(page), draft.size};
}

}  // namespace

PageSize write_page(const std::string& path, const PageContent& content, std::size_t limit) {
  auto [page, size] = compose(content, limit);
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
