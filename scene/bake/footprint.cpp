#include "scene/bake/footprint.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <set>

#include "impl/dag/dag.hpp"
#include "impl/tree/tree.hpp"

namespace mmverify::scene {
namespace {

using namespace impl::micromap;

ModeFootprint of_map(Level level, Format format, std::span<const std::uint8_t> map) {
  ModeFootprint size;
  if (uniform(map, format, micro_triangles(level))) return size;
  const impl::tree::Stream stream = impl::tree::encode_stream(level, format, map);
  size.records = 1;
  size.data = map.size();
  size.tree = stream.tree.size() + stream.data.size();
  size.our_tree = (impl::tree::Tree::encode(level, format, map).bits() + 7) / 8;
  return size;
}

/// A record's map in one mode.
Bytes map_in(Format mode, const Array& array, const Record& record) {
  const auto format = static_cast<Format>(record.format);
  const std::uint64_t count = micro_triangles(record.level);
  const auto map = std::span(array.data).subspan(record.offset, packed_bytes(count, format));
  Bytes as_mode(packed_bytes(count, mode));
  if (format == mode)
    as_mode.assign(map.begin(), map.end());
  else if (mode == Format::four_state)
    widen(map, count, as_mode);
  else
    force2(map, count, as_mode);
  return as_mode;
}

constexpr std::array modes{Format::two_state, Format::four_state};

std::array<ModeFootprint, 2> of_record(const Array& array, const Record& record) {
  return {of_map(record.level, modes[0], map_in(modes[0], array, record)),
          of_map(record.level, modes[1], map_in(modes[1], array, record))};
}

/// The size of one graph with all maps, in the records' order.
std::uint64_t graph_bytes(const Array& array, Format mode) {
  impl::dag::Dag graph(impl::dag::Format{bits(mode)});
  for (const Record& record : array.records) {
    const Bytes map = map_in(mode, array, record);
    if (!uniform(map, mode, micro_triangles(record.level))) graph.add(record.level, map);
  }
  return graph.bits() / 8;
}

void add(ModeFootprint& sum, const ModeFootprint& one) {
  sum.records += one.records;
  sum.data += one.data;
  sum.tree += one.tree;
  sum.our_tree += one.our_tree;
}

}  // namespace

Footprint footprint(const Scene& scene, const Plan& plan, const SceneArrays& arrays, unsigned threads) {
  Footprint size;
  size.records = arrays.array.records.size();
  size.special = arrays.special;
  size.record_bytes = record_bytes * size.records;
  size.array_data = arrays.array.data.size();
  for (const PrimitiveIndices& primitive : arrays.primitives)
    size.index_bytes += primitive.geometry.indices.size();

  std::vector<std::array<ModeFootprint, 2>> each(arrays.array.records.size());
  oneapi::tbb::task_arena arena(threads == 0 ? oneapi::tbb::task_arena::automatic
                                             : static_cast<int>(threads));
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, each.size(), [&](std::size_t k) {
      each[k] = of_record(arrays.array, arrays.array.records[k]);
    });
    oneapi::tbb::parallel_for(std::size_t{0}, modes.size(), [&](std::size_t k) {
      size.mode[k].graph = graph_bytes(arrays.array, modes[k]);
    });
  });
  for (const auto& [two, four] : each) {
    add(size.mode[0], two);
    add(size.mode[1], four);
  }

  std::set<std::size_t> images;
  for (const Surface& surface : plan.surfaces) images.insert(surface.image);
  for (const std::size_t k : images) {
    const Image& image = scene.images[k];
    const std::uint64_t texels = std::uint64_t{image.width} * image.height;
    size.mode[0].bitmask += (texels + 7) / 8;
    size.mode[1].bitmask += (2 * texels + 7) / 8;
    size.texture += texels * static_cast<unsigned>(image.bits()) / 8;
  }
  for (const PlannedPrimitive& primitive : plan.primitives) {
    size.vertex_data += 12 * std::uint64_t{primitive.triangles.size()};
    size.vertex_data += 8 * std::uint64_t{scene.primitives[primitive.primitive].uvs.size()};
  }
  return size;
}

}  // namespace mmverify::scene
