#include "scene/edit/json_patch.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

class Patch {
 public:
  explicit Patch(const std::string& text) : text_(text) {}

  std::string patched(const Json& was, const Json& is) {
    if (text_.starts_with("\xef\xbb\xbf")) keep(3);  // the mark of UTF-8
    value(was, is);
    keep(text_.size());
    return std::move(out_);
  }

 private:
  char here() const {
    if (at_ >= text_.size()) throw std::invalid_argument("patched_json: the text ends early");
    return text_[at_];
  }

  /// Appends the text up to a place.
  void keep(std::size_t end) {
    out_.append(text_, at_, end - at_);
    at_ = end;
  }

  void keep_space() { keep(behind_space(at_)); }

  std::size_t behind_space(std::size_t at) const {
    while (at < text_.size() && std::isspace(static_cast<unsigned char>(text_[at])) != 0) ++at;
    return at;
  }

  std::size_t behind_string(std::size_t at) const {
    for (++at; at < text_.size() && text_[at] != '"'; ++at)
      if (text_[at] == '\\') ++at;
    return at + 1;
  }

  /// The place behind the value that begins at a place.
  std::size_t behind_value(std::size_t at) const {
    int depth = 0;
    while (at < text_.size()) {
      const char c = text_[at];
      if (c == '"') {
        at = behind_string(at);
        if (depth == 0) return at;
        continue;
      }
      if (c == '[' || c == '{') ++depth;
      if (depth == 0 &&
          (c == ',' || c == ']' || c == '}' || std::isspace(static_cast<unsigned char>(c)) != 0))
        return at;
      ++at;
      if ((c == ']' || c == '}') && --depth == 0) return at;
    }
    return std::min(at, text_.size());
  }

  void value(const Json& was, const Json& is) {
    keep_space();
    if (was == is) return keep(behind_value(at_));
    if (was.is_object() && is.is_object()) return object(was, is);
    if (was.is_array() && is.is_array()) return array(was, is);
    at_ = behind_value(at_);
    out_ += is.dump();
  }

  /// A member or element of the text: the space before it, its name where it has one, its value's begin and end.
  struct Item {
    std::size_t begin, name, value, end;
    std::string key;
  };

  /// The items of the object or array at the current place; afterwards the place is that of its closing bracket.
  std::vector<Item> items(bool named) {
    std::vector<Item> all;
    std::size_t at = at_ + 1;
    for (;;) {
      Item item{at, behind_space(at), 0, 0, {}};
      at = item.name;
      if (at >= text_.size()) throw std::invalid_argument("patched_json: the text ends early");
      if (text_[at] == ']' || text_[at] == '}') break;
      if (named) {
        const std::size_t end = behind_string(at);
        item.key = Json::parse(text_.substr(at, end - at)).get<std::string>();
        at = behind_space(behind_space(end) + 1);  // behind the colon
      }
      item.value = at;
      item.end = behind_value(at);
      all.push_back(item);
      at = behind_space(item.end);
      if (at < text_.size() && text_[at] == ',') ++at;
    }
    close_ = at;
    return all;
  }

  /// Writes the space, name and patched value of an item.
  void item(const Item& one, const Json& was, const Json& is) {
    out_.append(text_, one.begin, one.value - one.begin);
    at_ = one.value;
    value(was, is);
  }

  /// Writes what stands between the last item and the closing bracket, and the bracket.
  void close(const std::vector<Item>& all, std::size_t end) {
    at_ = all.empty() ? end : all.back().end;
    keep(end + 1);
  }

  /// The space before a new item: that of the last one.
  std::string space_of(const std::vector<Item>& all) const {
    return all.empty() ? std::string() : text_.substr(all.back().begin, all.back().name - all.back().begin);
  }

  void object(const Json& was, const Json& is) {
    const std::vector<Item> all = items(true);
    const std::size_t end = close_;
    out_ += '{';
    const char* comma = "";
    for (const Item& one : all) {
      const auto kept = is.find(one.key);
      if (kept == is.end()) continue;
      out_ += comma;
      comma = ",";
      item(one, was.at(one.key), *kept);
    }
    for (const auto& [key, added] : is.items()) {
      if (was.contains(key)) continue;
      out_ += comma + space_of(all) + Json(key).dump() + ":" + added.dump();
      comma = ",";
    }
    close(all, end);
  }

  void array(const Json& was, const Json& is) {
    const std::vector<Item> all = items(false);
    const std::size_t end = close_;
    if (all.size() != was.size()) throw std::invalid_argument("patched_json: the text is another value's");
    // Elements that are equal from the end on belong to each other, where elements before them are gone.
    std::size_t tail = 0;
    if (was.size() > is.size())
      while (tail < is.size() && was[was.size() - 1 - tail] == is[is.size() - 1 - tail]) ++tail;
    out_ += '[';
    for (std::size_t k = 0; k < is.size(); ++k) {
      if (k != 0) out_ += ',';
      const std::size_t from = k + tail >= is.size() ? was.size() - is.size() + k : k;
      if (from < was.size())
        item(all[from], was[from], is[k]);
      else
        out_ += space_of(all) + is[k].dump();
    }
    close(all, end);
  }

  const std::string& text_;
  std::size_t at_ = 0, close_ = 0;
  std::string out_;
};

}  // namespace

std::string patched_json(const std::string& text, const Json& was, const Json& is) {
  return Patch(text).patched(was, is);
}

}  // namespace mmverify::scene
