#include "scene/read/unique_names.hpp"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

class Names : public nlohmann::json_sax<Json> {
 public:
  std::optional<std::string> twice;

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(std::int64_t) override { return value(); }
  bool number_unsigned(std::uint64_t) override { return value(); }
  bool number_float(double, const std::string&) override { return value(); }
  bool string(std::string&) override { return value(); }
  bool binary(Json::binary_t&) override { return value(); }
  bool start_array(std::size_t) override {
    open_.push_back({.is_array = true});
    return true;
  }
  bool end_array() override { return leave(); }
  bool start_object(std::size_t) override {
    open_.push_back({.is_array = false});
    return true;
  }
  bool end_object() override { return leave(); }
  bool key(std::string& key) override {
    open_.back().name = key;
    if (!open_.back().names.insert(key).second) {
      twice.emplace();
      for (const Open& one : open_) *twice += "/" + (one.is_array ? std::to_string(one.elements) : one.name);
    }
    return !twice;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  /// An open array or object, and the element or member that the reader has reached.
  struct Open {
    bool is_array;
    std::size_t elements = 0;
    std::string name = {};
    std::set<std::string> names = {};
  };

  bool value() {
    if (!open_.empty()) ++open_.back().elements;
    return true;
  }
  bool leave() {
    open_.pop_back();
    return value();
  }

  std::vector<Open> open_;
};

}  // namespace

std::optional<std::string> twice_named(std::string_view json) {
  Names names;
  Json::sax_parse(json.begin(), json.end(), &names);
  return names.twice;
}

}  // namespace mmverify::scene
