#include "cli/output/json_text.hpp"

#include <nlohmann/json.hpp>

namespace mmverify::cli {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string as_utf8(const std::string& text) { return Json::parse(json_text(text)).get<std::string>(); }

}  // namespace mmverify::cli
