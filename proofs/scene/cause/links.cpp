#include "proofs/scene/cause/links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::Array;
using mmverify::scene::BakedTriangle;
using mmverify::scene::MapLink;
using mmverify::scene::StoredArray;
using mmverify::scene::StoredMaps;

/// The place of a map: an array's record.
struct RecordPlace {
  std::size_t array;
  std::uint64_t record;
};
using RecordRule = std::function<std::optional<RecordPlace>(const MapLink&)>;
using TriangleRule = std::function<std::optional<std::size_t>(const MapLink&)>;

/// The most places by which a base triangle is tried to be off.
constexpr std::int64_t most_shift = 1024;

class Links {
 public:
  explicit Links(const Judged& judged) : judged_(judged), maps_(judged.maps) {
    for (std::size_t k = 0; k < maps_.links.size(); ++k) {
      auto& of = by_primitive_[maps_.links[k].primitive];
      of.resize(std::max(of.size(), maps_.links[k].triangle + 1), none);
      of[maps_.links[k].triangle] = k;
    }
  }

  std::vector<LinkChange> all() {
    equal_offsets();
    equal_indices();
    other_arrays();
    other_primitives();
    other_bases();
    add_triangles("triangles_reversed", "the triangles' maps lie in reverse", [this](const MapLink& link) {
      return planned_of(link.primitive, by_primitive_.at(link.primitive).size() - 1 - link.triangle);
    });
    return std::move(all_);
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  /// The planned triangle of a primitive's.
  std::optional<std::size_t> planned_of(std::size_t primitive, std::size_t triangle) const {
    const auto of = by_primitive_.find(primitive);
    if (of == by_primitive_.end() || triangle >= of->second.size() || of->second[triangle] == none) return {};
    return maps_.links[of->second[triangle]].planned;
  }

  /// A reading by which a triangle with a record has another record; special indices stay.
  void add_records(std::string code, std::string says, RecordRule rule) {
    all_.push_back({std::move(code), std::move(says),
                    [&maps = maps_, rule = std::move(rule)](std::size_t k) -> std::optional<BakedTriangle> {
                      if (!maps.link(k).record) return {};
                      const std::optional<RecordPlace> place = rule(maps.link(k));
                      if (!place || place->record >= maps.arrays[place->array]->records.size()) return {};
                      return mmverify::scene::stored_map(maps.arrays[place->array], place->record);
                    }});
  }

  /// A reading by which a triangle has the map, or the special index, of another triangle.
  void add_triangles(std::string code, std::string says, TriangleRule rule) {
    all_.push_back({std::move(code), std::move(says),
                    [&maps = maps_, rule = std::move(rule)](std::size_t k) -> std::optional<BakedTriangle> {
                      const std::optional<std::size_t> other = rule(maps.link(k));
                      if (!other) return {};
                      return maps.baked.triangles[*other];
                    }});
  }

  /// Records that all point to one place, read as if their maps lay one after another.
  void equal_offsets() {
    std::vector<StoredArray> arrays = maps_.arrays;
    bool changes = false;
    for (StoredArray& stored : arrays) {
      const auto& records = stored->records;
      const auto same = [&](const auto& record) { return record.offset == records[0].offset; };
      if (records.size() < 2 || !std::all_of(records.begin(), records.end(), same)) continue;
      Array array = *stored;
      std::uint64_t end = array.records[0].offset;
      for (auto& record : array.records) {
        const std::uint64_t bytes =
            impl::micromap::packed_bytes(impl::micromap::micro_triangles(record.level),
                                         static_cast<impl::micromap::Format>(record.format));
        if (end + bytes > array.data.size()) return;
        record.offset = static_cast<std::uint32_t>(end);
        end += bytes;
      }
      stored = std::make_shared<const Array>(std::move(array));
      changes = true;
    }
    if (!changes) return;
    all_.push_back(
        {"offsets_equal", "the offsets of all records are equal; their maps lie one after another",
         [&maps = maps_, arrays = std::move(arrays)](std::size_t k) -> std::optional<BakedTriangle> {
           const MapLink& link = maps.link(k);
           if (!link.record) return {};
           return mmverify::scene::stored_map(arrays[link.array], *link.record);
         }});
  }

  void equal_indices() {
    std::map<std::size_t, std::set<std::uint64_t>> records;
    for (const MapLink& link : maps_.links)
      if (link.record) records[link.primitive].insert(*link.record);
    const bool equal = std::all_of(records.begin(), records.end(), [&](const auto& of) {
      return of.second.size() == 1 && by_primitive_.at(of.first).size() > 1;
    });
    if (!records.empty() && equal)
      add_records("indices_equal", "the indices of all triangles are equal; map k is triangle k's",
                  [](const MapLink& link) {
                    return RecordPlace{link.array, link.base + link.triangle};
                  });
  }

  void other_bases() {
    std::int64_t most = 0;
    for (const StoredArray& array : maps_.arrays)
      most = std::max(most, static_cast<std::int64_t>(array->records.size()));
    most = std::min(most - 1, most_shift);
    for (std::int64_t by = -most; by <= most; ++by) {
      if (by == 0) continue;
      add_records("base_triangle",
                  fmt::format("each triangle has the map of the record {} {} its own", by < 0 ? -by : by,
                              by < 0 ? "behind" : "before"),
                  [by](const MapLink& link) -> std::optional<RecordPlace> {
                    if (by < 0 && *link.record < static_cast<std::uint64_t>(-by)) return {};
                    return RecordPlace{link.array, *link.record + static_cast<std::uint64_t>(by)};
                  });
    }
  }

  void other_arrays() {
    for (std::size_t array = 0; array < maps_.arrays.size(); ++array)
      add_records("other_micromap", fmt::format("the maps of micromap {} fit", array),
                  [array](const MapLink& link) {
                    return RecordPlace{array, *link.record};
                  });
    if (maps_.arrays.size() == 2)
      add_records("micromaps_exchanged", "the two micromaps are exchanged", [](const MapLink& link) {
        return RecordPlace{1 - link.array, *link.record};
      });
  }

  void other_primitives() {
    for (const auto& [other, triangles] : by_primitive_)
      add_triangles("other_primitive",
                    fmt::format("the maps of mesh {} primitive {} fit", judged_.scene.primitives[other].mesh,
                                judged_.scene.primitives[other].number),
                    [this, other = other](const MapLink& link) { return planned_of(other, link.triangle); });
    if (by_primitive_.size() != 2) return;
    const std::size_t one = by_primitive_.begin()->first, two = by_primitive_.rbegin()->first;
    add_triangles("primitives_exchanged", "the two primitives have each other's maps",
                  [=, this](const MapLink& link) {
                    return planned_of(link.primitive == one ? two : one, link.triangle);
                  });
  }

  const Judged& judged_;
  const StoredMaps& maps_;
  std::map<std::size_t, std::vector<std::size_t>>
      by_primitive_;  ///< triangles of the plan by that of the primitive
  std::vector<LinkChange> all_;
};

}  // namespace

std::vector<LinkChange> link_changes(const Judged& judged) {
  const auto links = std::make_shared<Links>(judged);
  std::vector<LinkChange> all = links->all();
  // The rules read the links.
  for (LinkChange& change : all)
    change.map = [links, map = std::move(change.map)](std::size_t triangle) { return map(triangle); };
  return all;
}

}  // namespace mmverify::proofs::scene
