#include "report/page.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "io/file.hpp"
#include "report/bundle.hpp"

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

/// Bundles the runs so that each has its share of what the runs before it have left.
std::size_t bundle_all(const std::vector<RunRecord>& runs, std::size_t room, Json& index,
                       Chunks& chunks) {
  std::size_t frames = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    RunBundle one = bundle(runs[r], chunks, room / (runs.size() - r));
    room -= std::min(room, one.bytes);
    frames += one.frames;
    index.push_back(std::move(one.index));
  }
  return frames;
}

std::string assemble(const Json& index, const Chunks& chunks) {
  const auto [before, after] = frame_of_page();
  std::string page(before);
  page += "<script type=\"application/json\" id=\"washtub-data\">";
  page += page_json(index);
  page += "</script>\n";
  for (std::size_t n = 0; n < chunks.texts().size(); ++n)
    page += chunk_element(n, chunks.texts()[n]);
  page += after;
  return page;
}

}  // namespace

PageSize write_page(const std::string& path, const PageContent& content, std::size_t limit) {
  Json index = {{"version", 1}, {"program", content.program}, {"runs", Json::array()}};
  index["comparison"] = content.comparison;
  Chunks chunks;
  const std::size_t fixed = assemble(index, chunks).size();
  PageSize size;
  size.frames = bundle_all(content.runs, limit - std::min(limit, fixed), index["runs"], chunks);
  const std::string page = assemble(index, chunks);
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
