#include "report/json.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

std::string page_json(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

Json triple(const Vec<3>& x) { return {x.x(), x.y(), x.z()}; }

}  // namespace washtub
