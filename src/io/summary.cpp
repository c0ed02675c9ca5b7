#include "io/summary.hpp"

#include "io/file.hpp"

namespace washtub {

void write_summary(const std::string& path, const nlohmann::ordered_json& summary) {
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  replace_file(path, summary.dump(2, ' ', false, replace) + '\n');
}

}  // namespace washtub
