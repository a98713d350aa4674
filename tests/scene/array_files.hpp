// Files of micromaps of every kind, small and good: what tests spoil.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "impl/array/container.hpp"
#include "impl/attribute/container.hpp"
#include "impl/dag/container.hpp"
#include "impl/tree/container.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/file.hpp"
#include "tests/scene/micromap_breaches.hpp"

namespace mmverify::tests {

using ByteList = std::vector<unsigned char>;

/// A file, and those beside it.
struct MadeFile {
  ByteList bytes;
  std::map<std::string, ByteList> beside = {};

  /// Judged in memory.
  scene::Judged judged(std::optional<scene::Draft> draft = {}, const scene::Target& target = {}) const {
    const auto beside_it = [this](const std::string& name) {
      const auto file = beside.find(name);
      if (file == beside.end()) throw scene::BadScene("made", name, "there is no file");
      return file->second;
    };
    return scene::validate_file("made", bytes, draft, beside_it, target);
  }
};

/// A raw array: two records (4-state of level 2, 2-state of level 1), a geometry of three triangles on records 0, 1 and 0.
struct RawArray {
  Json json = {
      {"schema", "mmverify.array/1"},
      {"apis", {"ext", "khr", "dxr", "gltf"}},
      {"records", {{"file", "records.bin"}, {"address", 512}}},
      {"data", {{"file", "data.bin"}, {"address", 256}}},
      {"usageCounts",
       {{{"count", 1}, {"level", 2}, {"format", 2}}, {{"count", 1}, {"level", 1}, {"format", 1}}}},
      {"geometries",
       {{{"triangles", 3},
         {"indices", {{"file", "indices.bin"}, {"type", "u16"}, {"address", 64}}},
         {"baseTriangle", 0},
         {"usageCounts",
          {{{"count", 2}, {"level", 2}, {"format", 2}}, {{"count", 1}, {"level", 1}, {"format", 1}}}}}}},
      {"limits",
       {{"twoStateLevel", 12}, {"fourStateLevel", 12}, {"lossyFourStateLevel", 12}, {"triangles", 100}}},
      {"lossy", false}};
  ByteList records{0, 0, 0, 0, 2, 0, 2, 0, 4, 0, 0, 0, 1, 0, 1, 0}, data{0xe4, 0x1b, 0, 0, 0x05},
      indices{0, 0, 1, 0, 0, 0};

  Json& geometry() { return json["geometries"][0]; }
  MadeFile file() const {
    return {as_bytes(json.dump()), {{"records.bin", records}, {"data.bin", data}, {"indices.bin", indices}}};
  }
};

inline ByteList array_file(std::uint32_t version) {
  impl::array::Bundle bundle;
  bundle.array = {{{0, 2, 2}, {4, 1, 1}}, {0xe4, 0x1b, 0, 0, 0x05}};
  bundle.parts.push_back(
      {impl::micromap::Encoding::u32, 0, {0, 0, 0, 0, 1, 0, 0, 0, 0xfe, 0xff, 0xff, 0xff}});
  if (version == 2) bundle.parts.push_back({impl::micromap::Encoding::i16, 1, {0, 0, 0xff, 0xff}});
  return impl::array::written(bundle, version);
}

/// Flat where its states are all over the map, a tree where they are not.
inline ByteList tree_file(bool flat) {
  ByteList map(64, 0);
  for (std::size_t k = 0; k < map.size(); ++k) map[k] = flat ? static_cast<unsigned char>(37 * k + 11) : 0x55;
  if (!flat) map[5] = 0xaa;
  return impl::tree::write(4, impl::tree::Format::four_state, map);
}

inline ByteList dag_file() {
  impl::dag::Dag dag(impl::dag::Format::two_state);
  ByteList map(128, 0);
  map[9] = 0x81;
  map[70] = 0x18;
  dag.add(5, map);
  map[100] = 1;
  dag.add(5, map);
  dag.add(1, std::vector<std::uint8_t>{0x06});
  return impl::dag::save(dag);
}

inline ByteList attribute_file() {
  impl::attribute::AttributeMaps maps;
  maps.level = 1;
  maps.components = 1;
  maps.maps = 2;
  maps.triangles = {{1, 0}, {0, 0}, {1, 0}};
  maps.codes = {1, 2, 3, 4, 5, 6, 7, 8};
  return impl::attribute::write_attributes(maps);
}

/// A good glTF file under a draft's name of the extension.
inline ByteList gltf_file(const GltfFile& file, scene::Draft draft) {
  GltfFile named = file;
  if (draft == scene::Draft::khr) {
    std::string json = file.json.dump();
    for (std::size_t at = 0; (at = json.find("EXT_mesh_opacity", at)) != std::string::npos;)
      json.replace(at, 3, "KHR");
    named.json = Json::parse(json);
  }
  return as_bytes(named.glb());
}

}  // namespace mmverify::tests
