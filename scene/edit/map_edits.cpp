#include "scene/edit/map_edits.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "scene/edit/index_codes.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using Json = nlohmann::json;

constexpr std::size_t unchanged = ~std::size_t{0};

Json& micromap_of(EditedFile& file, std::size_t number) {
  return file.json.at("extensions").at(micromap_extension).at("micromaps").at(number);
}

/// The records and data of one micromap, as they become.
struct EditedArray {
  std::vector<micromap::Record> records;
  Bytes data;

  EditedArray(EditedFile& file, std::size_t number) {
    const Json& given = micromap_of(file, number);
    const auto bytes = file.view(given.at("triangles").get<std::size_t>());
    for (std::uint64_t at = 0; at + micromap::record_bytes <= bytes.size(); at += micromap::record_bytes)
      records.push_back(micromap::record_at(bytes, at));
    const auto from = file.view(given.at("data").get<std::size_t>());
    data.assign(from.begin(), from.end());
  }

  std::span<const std::uint8_t> bytes_of(const micromap::Record& record) const {
    return std::span(data).subspan(record.offset,
                                   micromap::packed_bytes(micromap::micro_triangles(record.level),
                                                          static_cast<micromap::Format>(record.format)));
  }
  bool holds(const micromap::Record& record, const BakedTriangle& map) const {
    const auto bytes = bytes_of(record);
    return !map.uniform && record.level == map.level &&
           record.format == static_cast<std::uint16_t>(map.format) &&
           std::equal(bytes.begin(), bytes.end(), map.map.begin(), map.map.end());
  }

  micromap::Record appended(const BakedTriangle& map) {
    constexpr std::uint64_t most = std::uint64_t{1} << 32;
    if (data.size() + map.map.size() >= most)
      throw std::length_error("the micromaps' data would have 2^32 bytes or more");
    const micromap::Record record{static_cast<std::uint32_t>(data.size()),
                                  static_cast<std::uint16_t>(map.level),
                                  static_cast<std::uint16_t>(map.format)};
    data.insert(data.end(), map.map.begin(), map.map.end());
    return record;
  }

  /// Puts a map in the place of a record's.
  void put(micromap::Record& record, const BakedTriangle& map) {
    if (record.level == map.level && record.format == static_cast<std::uint16_t>(map.format))
      std::copy(map.map.begin(), map.map.end(), data.begin() + record.offset);
    else
      record = appended(map);
  }
};

class ArrayEditor {
 public:
  ArrayEditor(EditedFile& file, std::size_t number, const std::vector<BakedTriangle>& maps)
      : file_(file), number_(number), maps_(maps), array_(file, number), uses_(array_.records.size()) {}

  /// Counts the maps that a primitive's triangles are to have.  Domain: before any edit.
  void count(const LinkedPrimitive& primitive, const std::vector<std::size_t>& wanted) {
    for (std::size_t t = 0; t < wanted.size(); ++t) {
      const auto record = record_of(primitive, t);
      if (!record) continue;
      const bool stays = wanted[t] == unchanged || array_.holds(array_.records[*record], maps_[wanted[t]]);
      ++uses_[*record][stays ? unchanged : wanted[t]];
      if (!stays && !primitive.accessor) bare_.insert(*record);
    }
  }

  /// Puts maps over those of records that no triangle needs as they were; a map that another record has is left to
  /// link().
  void overwrite() {
    std::map<std::size_t, std::size_t> wanted;  // by record: the map that most of its triangles want
    for (std::size_t r = 0; r < uses_.size(); ++r) {
      if (uses_[r].empty() || uses_[r].contains(unchanged)) continue;
      const auto most = std::max_element(uses_[r].begin(), uses_[r].end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      if (!maps_[most->first].uniform) wanted[r] = most->first;
    }
    const std::set<std::size_t> linked = to_link(wanted);
    for (const auto& [r, map] : wanted)
      if (!linked.contains(r)) array_.put(array_.records[r], maps_[map]);
    by_content_.clear();
  }

  /// Gives triangles the codes of their maps; whether one changes.
  bool link(LinkedPrimitive& primitive, const std::vector<std::size_t>& wanted) {
    bool changes = false;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
      if (wanted[t] == unchanged) continue;
      const BakedTriangle& map = maps_[wanted[t]];
      const auto record = record_of(primitive, t);
      if (record && array_.holds(array_.records[*record], map)) continue;
      primitive.codes[t] = map.uniform ? special(*map.uniform) : plain_code(map, primitive);
      changes = true;
    }
    return changes;
  }

  void write() {
    const micromap::Bytes records = micromap::record_buffer(array_.records);
    put("data", array_.data);
    put("triangles", records);
    write_usage_counts(file_, number_);
  }

 private:
  std::optional<std::size_t> record_of(const LinkedPrimitive& primitive, std::size_t t) const {
    const Code code = primitive.codes[t];
    if (is_special(code)) return {};
    return static_cast<std::size_t>(code) + primitive.base;
  }

  struct Content {
    unsigned level, format;
    Bytes bytes;
    bool operator<(const Content& other) const {
      return std::tie(level, format, bytes) < std::tie(other.level, other.format, other.bytes);
    }
  };
  using Records = std::set<std::size_t>;

  /// The records with this map.
  Records& equal_to(const BakedTriangle& map) {
    if (by_content_.empty())
      for (std::size_t r = 0; r < array_.records.size(); ++r) {
        const auto bytes = array_.bytes_of(array_.records[r]);
        by_content_[{array_.records[r].level, array_.records[r].format, {bytes.begin(), bytes.end()}}].insert(
            r);
      }
    return by_content_[{map.level, static_cast<unsigned>(map.format), {map.map.begin(), map.map.end()}}];
  }

  /// The records whose wanted maps are those of other records, which keep them.
  Records to_link(const std::map<std::size_t, std::size_t>& wanted) {
    Records linked;
    for (const auto& [r, map] : wanted)
      if (!bare_.contains(r) && !equal_to(maps_[map]).empty()) linked.insert(r);
    const auto stays = [&](std::size_t r) { return !wanted.contains(r) || linked.contains(r); };
    while (std::erase_if(linked, [&](std::size_t r) {
             const Records& equal = equal_to(maps_[wanted.at(r)]);
             return std::none_of(equal.begin(), equal.end(), stays);
           }) != 0) {
    }
    return linked;
  }

  /// The code of a record with this map, a new one where there is none.
  Code plain_code(const BakedTriangle& map, const LinkedPrimitive& primitive) {
    Records& equal = equal_to(map);
    auto at = equal.lower_bound(primitive.base);
    if (at == equal.end()) {
      array_.records.push_back(array_.appended(map));
      at = equal.insert(array_.records.size() - 1).first;
    }
    return static_cast<Code>(*at - primitive.base);
  }

  void put(const char* name, std::span<const unsigned char> bytes) {
    Json& given = micromap_of(file_, number_);
    const auto view = given.at(name).get<std::size_t>();
    const auto before = file_.view(view);
    if (std::equal(before.begin(), before.end(), bytes.begin(), bytes.end())) return;
    if (file_.is_alone(view, 0, before.size()))
      file_.replace(view, bytes);
    else
      given[name] = file_.add_view(file_.buffer_of(view), bytes);
  }

  EditedFile& file_;
  const std::size_t number_;
  const std::vector<BakedTriangle>& maps_;
  EditedArray array_;
  std::vector<std::map<std::size_t, std::uint64_t>> uses_;  ///< by record: triangles by their map
  Records bare_;                                            ///< of primitives without indices
  std::map<Content, Records> by_content_;                   ///< empty: not made
};

}  // namespace

void write_usage_counts(EditedFile& file, std::size_t number) {
  Json& given = micromap_of(file, number);
  const EditedArray array(file, number);
  std::array<Json, 3> columns{Json::array(), Json::array(), Json::array()};
  for (const micromap::UsageCount& usage : micromap::usage_counts(array.records)) {
    columns[0].push_back(usage.count);
    columns[1].push_back(usage.level);
    columns[2].push_back(usage.format);
  }
  constexpr const char* names[] = {"usageCounts", "usageLevels", "usageFormats"};
  // The same counts in another order stay.
  std::map<std::pair<Json, Json>, std::uint64_t> was, is;
  for (std::size_t k = 0; k < columns[0].size(); ++k)
    is[{columns[1][k], columns[2][k]}] += columns[0][k].get<std::uint64_t>();
  const bool readable = std::all_of(std::begin(names), std::end(names), [&](const char* name) {
    const Json& column = member(given, name);
    return column.is_array() && column.size() == member(given, names[0]).size() &&
           std::all_of(column.begin(), column.end(),
                       [](const Json& value) { return value.is_number_unsigned() && value != 0; });
  });
  if (readable)
    for (std::size_t k = 0; k < given[names[0]].size(); ++k)
      if (const auto count = given[names[0]][k].get<std::uint64_t>())
        was[{given[names[1]][k], given[names[2]][k]}] += count;
  if (readable && was == is) return;
  for (std::size_t column = 0; column < 3; ++column) given[names[column]] = columns[column];
}

void write_maps(EditedFile& file, const std::vector<BakedTriangle>& maps, const std::vector<MapEdit>& edits) {
  if (edits.empty()) return;
  const Document document = file.reopened(file.written());
  const Buffers buffers(document);
  std::vector<LinkedPrimitive> primitives = linked_primitives(file, document, buffers);
  std::vector<std::vector<std::size_t>> wanted;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number_of;
  for (const LinkedPrimitive& primitive : primitives) {
    number_of[{primitive.mesh, primitive.number}] = wanted.size();
    wanted.emplace_back(primitive.codes.size(), unchanged);
  }
  std::map<std::size_t, ArrayEditor> editors;
  for (const MapEdit& edit : edits) {
    const std::size_t k = number_of.at({edit.mesh, edit.number});
    wanted[k].at(edit.triangle) = edit.map;
    editors.try_emplace(primitives[k].micromap, file, primitives[k].micromap, maps);
  }
  for (std::size_t k = 0; k < primitives.size(); ++k)
    if (const auto editor = editors.find(primitives[k].micromap); editor != editors.end())
      editor->second.count(primitives[k], wanted[k]);
  for (auto& [number, editor] : editors) editor.overwrite();
  std::vector<bool> changes(primitives.size());
  for (std::size_t k = 0; k < primitives.size(); ++k)
    if (const auto editor = editors.find(primitives[k].micromap); editor != editors.end())
      changes[k] = editor->second.link(primitives[k], wanted[k]);
  for (auto& [number, editor] : editors) editor.write();
  for (std::size_t k = 0; k < primitives.size(); ++k)
    if (changes[k]) write_codes(file, primitives[k], primitives);
}

}  // namespace mmverify::scene
