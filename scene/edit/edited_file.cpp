#include "scene/edit/edited_file.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <stdexcept>

#include "scene/edit/base64.hpp"
#include "scene/edit/json_patch.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/resource.hpp"
#include "scene/write/container.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr std::size_t glb_header = 12, bytes_before_chunk = 8;

bool is_glb(const Bytes& bytes) { return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0; }

std::size_t to_words(std::size_t size) { return (size + 3) / 4 * 4; }

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t{bytes[at + k]} << (8 * k);
  return value;
}

void put_word(Bytes& bytes, std::size_t at, std::size_t value) {
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<unsigned char>(value >> (8 * k));
}

/// Calls `see` with every object within a value.
void each_object(const Json& value, const std::function<void(const Json&)>& see) {
  if (value.is_object()) see(value);
  if (value.is_structured())
    for (const Json& part : value) each_object(part, see);
}

/// The number of references to a view: members bufferView, and those of micromaps.
std::size_t references_to(const Json& json, std::size_t view) {
  std::size_t count = 0;
  each_object(json, [&](const Json& object) {
    if (const auto found = object.find("bufferView"); found != object.end() && *found == view) ++count;
    const auto micromaps = object.find("micromaps");
    if (micromaps == object.end() || !micromaps->is_array()) return;
    for (const Json& micromap : *micromaps)
      for (const char* name : {"data", "triangles"}) count += member(micromap, name) == Json(view) ? 1 : 0;
  });
  return count;
}

std::uint64_t offset_of(const Json& range) { return range.value("byteOffset", std::uint64_t{0}); }

/// Bytes of a buffer.
struct Range {
  std::uint64_t buffer, begin, size;

  bool overlaps(const Range& other) const {
    return buffer == other.buffer && begin < other.begin + other.size && other.begin < begin + size;
  }
};

constexpr const char* compressions[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// The object that has a compressed view's code; an empty one of a plain view.
const Json& code_of(const Json& view) {
  const Json& first = extension(view, compressions[0]);
  return first.empty() ? extension(view, compressions[1]) : first;
}

/// The range of an object with a buffer, an offset and a length: a bufferView, or one of its extensions.
Range range_of(const Json& object) {
  const auto number = [&](const char* name) {
    const Json& value = member(object, name);
    return value.is_number_unsigned() ? value.get<std::uint64_t>() : 0;
  };
  return {number("buffer"), number("byteOffset"), number("byteLength")};
}

/// The bytes from an accessor's first element to its last one.
Range range_of(const Json& accessor, const Json& view) {
  constexpr std::pair<const char*, std::uint64_t> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                             {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9}};
  std::uint64_t components = 16;
  for (const auto& [name, count] : types)
    if (accessor.at("type") == name) components = count;
  const auto type = accessor.at("componentType").get<int>();
  const std::uint64_t width = type < 5122   ? 1
                              : type < 5124 ? 2
                                            : 4,
                      stride = view.value("byteStride", components * width);
  return {view.at("buffer").get<std::uint64_t>(), offset_of(view) + offset_of(accessor),
          accessor.at("count").get<std::uint64_t>() * stride};
}

/// The number of readers of a bufferView's bytes within a range.
std::size_t readers_of(const Json& json, std::size_t view, const Range& range) {
  std::size_t accessors = 0, within = 0;
  for (const Json& accessor : member(json, "accessors")) {
    if (member(accessor, "bufferView") != Json(view)) continue;
    ++accessors;
    within += range.overlaps(range_of(accessor, json.at("bufferViews")[view])) ? 1 : 0;
  }
  return references_to(json, view) - accessors + within;
}

/// A chunk's header and content, to_words.
void put_chunk(Bytes& out, const Bytes& header_of, std::size_t at, std::span<const unsigned char> content,
               unsigned char padding) {
  const std::size_t begin = out.size();
  out.insert(out.end(), header_of.begin() + static_cast<std::ptrdiff_t>(at),
             header_of.begin() + static_cast<std::ptrdiff_t>(at + bytes_before_chunk));
  out.insert(out.end(), content.begin(), content.end());
  out.resize(begin + bytes_before_chunk + to_words(content.size()), padding);
  put_word(out, begin, to_words(content.size()));
}

}  // namespace

EditedFile::EditedFile(const std::string& file)
    : file_(file), original_(read_file(file, file, "")), document_(parse(split(original_, file), file)) {
  json = document_.json;
  const Buffers buffers(document_);
  for (std::size_t k = 0; k < buffers.all().size(); ++k) buffers_.push_back(buffers.all()[k]);
}

std::span<const unsigned char> EditedFile::view(std::size_t number) const {
  const Json& view = json.at("bufferViews").at(number);
  if (is_compressed(number)) {
    if (!decoded_.contains(number)) {
      const Buffers buffers(document_);
      const auto bytes = buffers.view(number);
      decoded_[number].assign(bytes.begin(), bytes.end());
    }
    return decoded_[number];
  }
  const Bytes& buffer = buffers_.at(view.at("buffer").get<std::size_t>());
  const auto offset = offset_of(view), size = view.at("byteLength").get<std::uint64_t>();
  if (offset > buffer.size() || size > buffer.size() - offset)
    throw BadScene(file_, place("bufferView", number), "it reaches beyond its buffer; truncated file?");
  return std::span(buffer).subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

bool EditedFile::is_compressed(std::size_t view) const {
  return !code_of(json.at("bufferViews").at(view)).empty();
}

std::size_t EditedFile::buffer_of(std::size_t view) const {
  const Json& given = json.at("bufferViews").at(view);
  const Json& code = code_of(given);
  return (code.empty() ? given : code).at("buffer").get<std::size_t>();
}

bool EditedFile::is_alone(std::size_t number, std::uint64_t offset, std::uint64_t size) const {
  const Json& views = json.at("bufferViews");
  const Range range{range_of(views.at(number)).buffer, offset_of(views.at(number)) + offset, size};
  std::size_t readers = 0;
  for (std::size_t v = 0; v < views.size(); ++v)
    if (range.overlaps(range_of(views[v]))) readers += readers_of(json, v, range);
  each_object(json, [&](const Json& object) {
    const bool is_view =
        std::greater_equal<>()(&object, &views.front()) && std::less_equal<>()(&object, &views.back());
    if (!is_view && object.contains("buffer") && object.contains("byteLength"))
      readers += range.overlaps(range_of(object)) ? 1 : 0;
  });
  return readers <= 1;
}

void EditedFile::overwrite(std::size_t number, std::uint64_t offset, std::span<const unsigned char> bytes) {
  if (const auto all = view(number); offset > all.size() || bytes.size() > all.size() - offset)
    throw BadScene(file_, place("bufferView", number), "the bytes to be rewritten reach beyond it");
  const Json& view = json.at("bufferViews").at(number);
  if (is_compressed(number)) {
    Bytes all = decoded_.at(number);
    std::copy(bytes.begin(), bytes.end(), all.begin() + static_cast<std::ptrdiff_t>(offset));
    return all == decoded_.at(number) ? void() : store_plain(number, all);
  }
  const std::size_t buffer = buffer_of(number);
  const auto at = buffers_[buffer].begin() + static_cast<std::ptrdiff_t>(offset_of(view) + offset);
  if (std::equal(bytes.begin(), bytes.end(), at)) return;
  std::copy(bytes.begin(), bytes.end(), at);
  changed_.insert(buffer);
}

std::uint64_t EditedFile::append(std::size_t number, std::span<const unsigned char> bytes) {
  Bytes& buffer = buffers_.at(number);
  buffer.resize(to_words(buffer.size()));
  const std::size_t at = buffer.size();
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  json["buffers"][number]["byteLength"] = buffer.size();
  changed_.insert(number);
  return at;
}

void EditedFile::store_plain(std::size_t number, std::span<const unsigned char> bytes) {
  const std::size_t buffer = buffer_of(number);
  Json& view = json.at("bufferViews").at(number);
  view["buffer"] = buffer;
  view["byteOffset"] = append(buffer, bytes);
  view["byteLength"] = bytes.size();
  for (const char* name : compressions) view["extensions"].erase(name);
  if (view["extensions"].empty()) view.erase("extensions");  // glTF has no empty objects
}

void EditedFile::replace(std::size_t number, std::span<const unsigned char> bytes) {
  Json& view = json.at("bufferViews").at(number);
  if (is_compressed(number)) return store_plain(number, bytes);
  const auto size = view.at("byteLength").get<std::size_t>();
  if (size == bytes.size()) return overwrite(number, 0, bytes);
  if (Bytes& buffer = buffers_.at(buffer_of(number)); offset_of(view) + size == buffer.size()) {
    buffer.resize(buffer.size() - size + bytes.size());
    json["buffers"][buffer_of(number)]["byteLength"] = buffer.size();
    view["byteLength"] = bytes.size();
    return overwrite(number, 0, bytes);
  }
  view["byteOffset"] = append(buffer_of(number), bytes);
  view["byteLength"] = bytes.size();
}

std::size_t EditedFile::add_view(std::size_t buffer, std::span<const unsigned char> bytes) {
  Json view = {{"buffer", buffer}, {"byteLength", bytes.size()}};
  view["byteOffset"] = append(buffer, bytes);
  Json& views = json["bufferViews"];
  views.push_back(std::move(view));
  return views.size() - 1;
}

std::vector<std::size_t> EditedFile::unread_views() const {
  std::vector<std::size_t> unread;
  for (std::size_t v = 0; v < member(json, "bufferViews").size(); ++v)
    if (references_to(json, v) == 0) unread.push_back(v);
  return unread;
}

bool EditedFile::is_changed() const { return !changed_.empty() || json != document_.json; }

std::set<std::string> EditedFile::uris() const {
  std::set<std::string> all;
  for (const char* list : {"buffers", "images"})
    for (const Json& one : member(json, list))
      if (const std::string uri = one.value("uri", std::string()); !uri.empty() && !is_data_uri(uri))
        all.insert(uri);
  return all;
}

std::string EditedFile::json_text(const Json& changed) const {
  std::string text = split(original_, file_).json;
  if (changed == document_.json) return text;
  if (is_glb(original_)) text.erase(text.find_last_not_of(' ') + 1);  // the padding
  const std::string patched = patched_json(text, document_.json, changed);
  if (Json::parse(patched) != changed) throw std::logic_error(file_ + ": the JSON was patched wrongly");
  return patched;
}

WrittenFile EditedFile::written() const {
  WrittenFile all;
  Json changed = json;
  bool in_chunk = false;
  for (const std::size_t k : changed_) {
    const auto uri = changed["buffers"][k].find("uri");
    if (uri == changed["buffers"][k].end())
      in_chunk = true;
    else if (const std::string text = uri->get<std::string>(); is_data_uri(text))
      *uri = text.substr(0, text.find(',') + 1) + base64(buffers_[k]);
    else
      all.buffers[text] = buffers_[k];
  }
  const std::string text = json_text(changed);
  if (!is_glb(original_)) {
    all.bytes.assign(text.begin(), text.end());
    return all;
  }
  const std::size_t behind_json = glb_header + bytes_before_chunk + to_words(word(original_, glb_header));
  all.bytes.assign(original_.begin(), original_.begin() + glb_header);
  put_chunk(all.bytes, original_, glb_header,
            std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()), ' ');
  std::size_t rest = std::min(behind_json, original_.size());
  if (in_chunk) {
    // The chunk may have more bytes than the buffer, since it is to_words.
    const std::size_t size = word(original_, rest);
    Bytes content(original_.begin() + static_cast<std::ptrdiff_t>(rest + bytes_before_chunk),
                  original_.begin() + static_cast<std::ptrdiff_t>(rest + bytes_before_chunk + size));
    content.resize(std::max(content.size(), buffers_[0].size()));
    std::copy(buffers_[0].begin(), buffers_[0].end(), content.begin());
    glb_size(text.size(), content.size());
    put_chunk(all.bytes, original_, rest, content, 0);
    rest = std::min(original_.size(), rest + bytes_before_chunk + to_words(size));
  }
  all.bytes.insert(all.bytes.end(), original_.begin() + static_cast<std::ptrdiff_t>(rest), original_.end());
  put_word(all.bytes, 8, all.bytes.size());
  return all;
}

Document EditedFile::reopened(const WrittenFile& written) const {
  Document document = parse(split(written.bytes, file_), file_);
  document.files = written.buffers;
  return document;
}

}  // namespace mmverify::scene
