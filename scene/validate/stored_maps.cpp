#include "scene/validate/stored_maps.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "scene/validate/indices.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using Json = nlohmann::json;

/// The records, data and indices of one primitive, which keep the rules already.
using Build = micromap::Input;

template <class T>
T read(std::span<const unsigned char> bytes, std::uint64_t at) {
  T value;
  std::memcpy(&value, bytes.subspan(static_cast<std::size_t>(at), sizeof value).data(), sizeof value);
  return value;
}

micromap::Record record_of(const Build& in, std::uint64_t k) {
  const std::uint64_t at = k * in.record_stride;
  return {read<std::uint32_t>(in.records, at), read<std::uint16_t>(in.records, at + 4),
          read<std::uint16_t>(in.records, at + 6)};
}

std::uint32_t code_of(const Build& in, std::uint64_t triangle) {
  if (!in.indexed) return static_cast<std::uint32_t>(triangle);
  const std::uint64_t at = triangle * in.index_stride;
  switch (micromap::width(in.encoding)) {
    case 8: return read<std::uint8_t>(in.indices, at);
    case 16: return read<std::uint16_t>(in.indices, at);
    default: return read<std::uint32_t>(in.indices, at);
  }
}

BakedTriangle uniform(micromap::State state) {
  BakedTriangle t;
  t.uniform = state;
  ++t.states[static_cast<std::size_t>(state)];
  return t;
}

/// The records and data of a build.
StoredArray array_of(const Build& in) {
  micromap::Array array;
  for (std::uint64_t k = 0; k < in.record_count; ++k) array.records.push_back(record_of(in, k));
  array.data.assign(in.data.begin(), in.data.end());
  return std::make_shared<const micromap::Array>(std::move(array));
}

/// A collector of the stored maps of primitives.
class Collector {
 public:
  explicit Collector(const Scene& scene)
      : scene_(scene), planned_(plan(scene, finest_level, VaryingAlpha::planned, MovingTextures::planned)) {
    all_.plan.surfaces = planned_.surfaces;
  }

  /// The number of another array.
  std::size_t add(const Build& array) {
    all_.arrays.push_back(array_of(array));
    return all_.arrays.size() - 1;
  }

  void add(std::size_t primitive, const Build& in, std::size_t array) {
    const auto planned =
        std::find_if(planned_.primitives.begin(), planned_.primitives.end(),
                     [primitive](const PlannedPrimitive& p) { return p.primitive == primitive; });
    const Primitive& given = scene_.primitives.at(primitive);
    if (planned == planned_.primitives.end()) {
      const auto why =
          std::find_if(planned_.left_out.begin(), planned_.left_out.end(),
                       [primitive](const LeftOutPrimitive& p) { return p.primitive == primitive; });
      all_.not_judged.push_back({primitive, given.triangles.size(), why->why});
      return;
    }
    const std::vector<Uv>& uvs = planned_uvs(given, planned_.surfaces.at(planned->surface));
    for (std::uint64_t t = 0; t < in.triangles && t < given.triangles.size(); ++t) {
      const std::uint32_t code = code_of(in, t);
      const auto special = in.indexed ? micromap::special_state(code, in.encoding) : std::nullopt;
      all_.special += special ? 1 : 0;
      MapLink link{primitive, static_cast<std::size_t>(t), array, in.base_triangle, {}};
      if (!special) link.record = std::uint64_t{code} + in.base_triangle;
      PlannedTriangle triangle;
      triangle.surface = planned->surface;
      for (std::size_t vertex = 0; vertex < 3; ++vertex)
        triangle.uvs[vertex] = uvs.at(given.triangles[static_cast<std::size_t>(t)][vertex]);
      triangle.vertex_alpha = corner_alphas(given, given.triangles[static_cast<std::size_t>(t)]);
      add(link, triangle, special);
    }
  }

  StoredMaps taken() { return std::move(all_); }

 private:
  /// The numbers that planned triangles of equal maps have in common: of the primitive, the UVs, the order of their
  /// corners, the array, and the record or the special state.
  using Key = std::tuple<std::size_t, std::size_t, VertexOrder, std::size_t, std::uint64_t, bool>;

  void add(MapLink link, const PlannedTriangle& triangle, const std::optional<micromap::State>& special) {
    const UvDuplicates::Match same =
        uvs_.add(triangle.surface, triangle.uvs, periods(all_.plan.surfaces[triangle.surface].sampler),
                 triangle.vertex_alpha);
    const Key key{link.primitive,
                  same.number,
                  same.order,
                  link.array,
                  special ? static_cast<std::uint64_t>(*special) : *link.record,
                  special.has_value()};
    const auto [at, is_new] = planned_as_.try_emplace(key, all_.plan.triangles.size());
    link.planned = at->second;
    all_.links.push_back(link);
    if (is_new) {
      all_.first.push_back(all_.links.size() - 1);
      all_.plan.triangles.push_back(triangle);
      all_.baked.triangles.push_back(special ? uniform(*special) : map_of(link.array, *link.record));
      all_.baked.triangles.back().by_bounds = triangle.varies();
    }
    PlannedTriangle& stands = all_.plan.triangles[at->second];
    stands.placed = ++stands.unique;
  }

  /// A record's map; its states are counted once.
  const BakedTriangle& map_of(std::size_t array, std::uint64_t record) {
    const micromap::Record& r = all_.arrays[array]->records.at(static_cast<std::size_t>(record));
    const auto [at, is_new] = maps_.try_emplace({array, r.offset, r.level, r.format});
    if (is_new) at->second = stored_map(all_.arrays[array], record);
    return at->second;
  }

  const Scene& scene_;
  const Plan planned_;
  StoredMaps all_;
  UvDuplicates uvs_;
  std::map<Key, std::size_t> planned_as_;
  std::map<std::array<std::uint64_t, 4>, BakedTriangle> maps_;  ///< by array, offset, level and format
};

std::span<const unsigned char> view_of(const Buffers& buffers, const Json& micromap, const char* name) {
  return buffers.view(micromap.at(name).get<std::size_t>());
}

}  // namespace

BakedTriangle stored_map(const StoredArray& array, std::uint64_t number) {
  const micromap::Record& record = array->records.at(static_cast<std::size_t>(number));
  BakedTriangle t;
  t.level = record.level;
  t.format = static_cast<micromap::Format>(record.format);
  const std::uint64_t count = micromap::micro_triangles(t.level),
                      bytes = micromap::packed_bytes(count, t.format);
  t.map = MapBytes(array, std::span(array->data).subspan(record.offset, bytes));
  t.states = micromap::count_states(t.map, t.format, count);
  return t;
}

StoredMaps without_varying_alpha(const StoredMaps& maps) {
  StoredMaps some = maps;
  some.plan.triangles.clear();
  some.baked.triangles.clear();
  some.links.clear();
  some.first.clear();
  std::map<std::size_t, std::size_t> numbers;
  std::map<std::size_t, std::uint64_t> varying;
  for (MapLink link : maps.links) {
    if (maps.plan.triangles[link.planned].varies()) {
      ++varying[link.primitive];
      continue;
    }
    const auto [at, is_new] = numbers.try_emplace(link.planned, some.plan.triangles.size());
    if (is_new) {
      some.plan.triangles.push_back(maps.plan.triangles[link.planned]);
      some.baked.triangles.push_back(maps.baked.triangles[link.planned]);
      some.first.push_back(some.links.size());
    }
    link.planned = at->second;
    some.links.push_back(link);
  }
  for (const auto& [primitive, triangles] : varying)
    some.not_judged.push_back({primitive, triangles, LeftOut::varying_alpha});
  return some;
}

StoredMaps stored_maps(const std::string& file, const Scene& scene) {
  return stored_maps(open_document(file), scene);
}

StoredMaps stored_maps(const Document& document, const Scene& scene) {
  const Buffers buffers(document);
  Collector collector(scene);
  const auto build_of = [&](const Json& micromap) {
    Build in;
    in.records = view_of(buffers, micromap, "triangles");
    in.record_count = in.records.size() / micromap::record_bytes;
    in.data = view_of(buffers, micromap, "data");
    return in;
  };
  const Json& micromaps = member(extension(document.json, micromap_extension), "micromaps");
  for (const Json& micromap : micromaps) collector.add(build_of(micromap));
  const Json& meshes = member(document.json, "meshes");
  for (std::size_t p = 0; p < scene.primitives.size(); ++p) {
    const Json& primitive = meshes[scene.primitives[p].mesh]["primitives"][scene.primitives[p].number];
    const Json& given = extension(primitive, micromap_extension);
    if (given.empty()) continue;
    const auto array = given["micromap"].get<std::size_t>();
    Build in = build_of(micromaps[array]);
    in.triangles = scene.primitives[p].triangles.size();
    in.base_triangle = given.value("micromapBaseTriangle", std::uint32_t{0});
    MicromapIndices indices;
    if (given.contains("micromapIndices")) {
      Report report;
      indices =
          read_micromap_indices(document, buffers, given["micromapIndices"].get<std::size_t>(), "", report)
              .value();
      in.indexed = true;
      in.encoding = indices.encoding;
      in.index_stride = micromap::width(indices.encoding) / 8;
      in.indices = indices.bytes;
    }
    collector.add(p, in, array);
  }
  return collector.taken();
}

StoredMaps stored_maps(const impl::micromap::Input& input, const Scene& scene, std::size_t primitive) {
  Collector collector(scene);
  collector.add(primitive, input, collector.add(input));
  return collector.taken();
}

}  // namespace mmverify::scene
