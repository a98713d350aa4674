#include "scene/read/json_fault.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

/// Keeps the place of the first fault.
class FirstFault : public nlohmann::json_sax<Json> {
 public:
  std::size_t read = 0;  ///< bytes up to the fault, the faulty one too
  bool number = false;   ///< the fault is a number that binary64 cannot hold

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(std::string&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;  // nlohmann/json, out_of_range.406
    read = position;
    number = error.id == number_overflow;
    return false;
  }
};

}  // namespace

std::string json_fault(std::string_view text) {
  FirstFault fault;
  if (Json::sax_parse(text.begin(), text.end(), &fault)) return "";
  if (fault.read > text.size())
    return "the JSON ends at byte " + std::to_string(text.size()) + ", within a value; truncated file?";
  const std::string_view before = text.substr(0, std::max<std::size_t>(fault.read, 1) - 1);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = before.size() - (newline == before.npos ? 0 : newline + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column) + ": " +
         (fault.number ? "the number that ends here is too large" : "no JSON from here on");
}

}  // namespace mmverify::scene
