// A good file with EXT_mesh_opacity_micromap, and a breach by hand of each rule that it can break alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/read/meshopt.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/write/glb.hpp"
#include "tests/scene/gltf_file.hpp"

namespace mmverify::tests::micromap_file {

using namespace mmverify::scene;
using mmverify::impl::micromap::Array;
using mmverify::impl::micromap::Encoding;

inline const char* const name = "EXT_mesh_opacity_micromap";

/// Two primitives: two triangles with 16-bit signed indices, record 1 and opaque; one triangle without, on
/// record 0 + 1.
inline GltfFile good() {
  GltfFile source = square();
  source.json["meshes"][0]["primitives"].push_back(source.primitive());
  source.json["meshes"][0]["primitives"][1].erase("indices");
  source.set_buffer_length();
  const Array array{{{0, 2, 2}, {4, 1, 1}}, {0xe4, 0x1b, 0, 0, 0xf5}};
  const std::vector<std::int16_t> codes{1, -2};
  const std::string bytes = bytes_of(codes);
  const std::vector<unsigned char> indices = as_bytes(bytes);
  const PrimitiveMicromaps primitives[] = {{0, 0, 0, Encoding::i16, indices, 0},
                                           {0, 1, 0, Encoding::u32, {}, 1}};
  return taken_apart(
      to_glb("good.glb", as_bytes(source.glb()), {std::span(&array, 1), std::span(primitives)}));
}

struct Subject {
  GltfFile file = good();

  Json& root() { return file.json["extensions"][name]; }
  Json& micromap() { return root()["micromaps"][0]; }
  Json& extension(std::size_t primitive = 0) {
    return file.json["meshes"][0]["primitives"][primitive]["extensions"][name];
  }
  Json& view_of(const Json& number) { return file.json["bufferViews"][number.get<std::size_t>()]; }
  Json& data_view() { return view_of(micromap()["data"]); }
  Json& records_view() { return view_of(micromap()["triangles"]); }
  Json& accessor() { return file.json["accessors"][extension()["micromapIndices"].get<std::size_t>()]; }
  Json& indices_view() { return view_of(accessor()["bufferView"]); }
  char& byte_of(Json& view, std::size_t at) { return file.bytes[view["byteOffset"].get<std::size_t>() + at]; }

  std::vector<FileViolation> found() const { return validate_micromaps("f.glb", as_bytes(file.glb())); }
};

inline std::string lines(const std::vector<FileViolation>& found) {
  std::string all;
  for (const FileViolation& violation : found) all += "\n  " + describe(violation);
  return all;
}

/// A breach of one rule, which shows at one place, and breaks no other.
struct Breach {
  std::string rule, pointer;
  std::function<void(Subject&)> plant;
};

inline const std::string root_at = std::string("/extensions/") + name, micromap_at = root_at + "/micromaps/0",
                         primitive_at = "/meshes/0/primitives/0" + root_at,
                         indices_at = primitive_at + "/micromapIndices", accessor_at = "/accessors/3";

/// Declares a view compressed: its bytes stand in no buffer, and `code` in buffer 0.
inline void compress(GltfFile& file, Json& view, const std::string& code) {
  const std::size_t at = file.bytes.size();
  file.bytes += code;
  file.set_buffer_length();
  file.json["buffers"].push_back(
      {{"byteLength", 64}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  view = {{"buffer", file.json["buffers"].size() - 1},
          {"byteLength", 8},
          {"extensions",
           {{"EXT_meshopt_compression",
             {{"buffer", 0},
              {"byteOffset", at},
              {"byteLength", code.size()},
              {"byteStride", 4},
              {"count", 2},
              {"mode", "ATTRIBUTES"}}}}}};
}

inline Json sparse_of(Subject& s, const std::string& where, const std::string& what) {
  const auto indices = s.file.add_view(where), values = s.file.add_view(what);
  s.file.set_buffer_length();
  return {{"count", where.size()},
          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
          {"values", {{"bufferView", values}}}};
}

inline const std::vector<Breach> all_breaches{
    {"file.readable", "", [](Subject& s) { s.file.json["asset"]["version"] = 2; }},
    {"used.listed", "/extensionsUsed", [](Subject& s) { s.file.json.erase("extensionsUsed"); }},
    {"required.unlisted", "/extensionsRequired",
     [](Subject& s) { s.file.json["extensionsRequired"] = {name}; }},
    {"root.micromaps", root_at + "/micromaps",
     [](Subject& s) {
       s.root()["micromaps"] = Json::array();
       for (Json& primitive : s.file.json["meshes"][0]["primitives"]) primitive.erase("extensions");
     }},
    {"root.object", root_at,
     [](Subject& s) {
       s.root() = 7;
       for (Json& primitive : s.file.json["meshes"][0]["primitives"]) primitive.erase("extensions");
     }},
    {"micromap.object", micromap_at, [](Subject& s) { s.micromap() = Json::array(); }},
    {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("usageLevels"); }},
    {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("data"); }},
    {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("triangles"); }},
    {"micromap.name", micromap_at + "/name", [](Subject& s) { s.micromap()["name"] = 1; }},
    {"micromap.view", micromap_at + "/data", [](Subject& s) { s.micromap()["data"] = 99; }},
    {"micromap.view", micromap_at + "/triangles", [](Subject& s) { s.micromap()["triangles"] = -1; }},
    {"view.stride", micromap_at + "/triangles", [](Subject& s) { s.records_view()["byteStride"] = 8; }},
    {"view.stride", micromap_at + "/data", [](Subject& s) { s.data_view()["byteStride"] = 4; }},
    {"view.stride", indices_at, [](Subject& s) { s.indices_view()["byteStride"] = 4; }},
    {"view.inside", micromap_at + "/data", [](Subject& s) { s.data_view()["byteLength"] = 100000; }},
    {"usage.array", micromap_at + "/usageFormats", [](Subject& s) { s.micromap()["usageFormats"] = 1; }},
    {"usage.integer", micromap_at + "/usageLevels/0",
     [](Subject& s) { s.micromap()["usageLevels"][0] = 1.5; }},
    {"usage.integer", micromap_at + "/usageCounts/1",
     [](Subject& s) { s.micromap()["usageCounts"][1] = -1; }},
    {"usage.integer", micromap_at + "/usageCounts/1",
     [](Subject& s) { s.micromap()["usageCounts"][1] = 4294967297; }},
    {"usage.length", micromap_at + "/usageLevels", [](Subject& s) { s.micromap()["usageLevels"] = {1}; }},
    {"counts.zero", micromap_at + "/usageCounts/2",
     [](Subject& s) {
       s.micromap()["usageCounts"].push_back(0);
       s.micromap()["usageLevels"].push_back(1);
       s.micromap()["usageFormats"].push_back(1);
     }},
    // A count of what no record can be breaks counts.array as well; so these come with a record of it.
    {"counts.level_12", micromap_at + "/usageLevels/0", {}},
    {"counts.format", micromap_at + "/usageFormats/0", {}},
    {"counts.array", micromap_at + "/usageCounts",
     [](Subject& s) {
       s.micromap()["usageCounts"] = {2, 1};
     }},
    {"records.whole", micromap_at + "/triangles", [](Subject& s) { s.records_view()["byteLength"] = 17; }},
    {"record.region", micromap_at + "/triangles", [](Subject& s) { s.data_view()["byteLength"] = 4; }},
    {"record.overlap", micromap_at + "/triangles", [](Subject& s) { s.byte_of(s.records_view(), 8) = 3; }},
    {"record.level_12", micromap_at + "/triangles", {}},
    {"record.format", micromap_at + "/triangles", {}},
    {"primitive.object", primitive_at, [](Subject& s) { s.extension() = "0"; }},
    {"primitive.micromap", primitive_at + "/micromap", [](Subject& s) { s.extension()["micromap"] = 1; }},
    {"primitive.micromap", primitive_at + "/micromap", [](Subject& s) { s.extension().erase("micromap"); }},
    {"primitive.base", primitive_at + "/micromapBaseTriangle",
     [](Subject& s) { s.extension()["micromapBaseTriangle"] = -1; }},
    {"primitive.mode", "/meshes/0/primitives/1/mode",
     [](Subject& s) { s.file.json["meshes"][0]["primitives"][1]["mode"] = 5; }},
    {"indices.accessor", indices_at, [](Subject& s) { s.extension()["micromapIndices"] = 4; }},
    {"indices.type", accessor_at + "/type", [](Subject& s) { s.accessor()["type"] = "VEC2"; }},
    {"indices.component", accessor_at + "/componentType",
     [](Subject& s) { s.accessor()["componentType"] = 5126; }},
    {"indices.component", accessor_at + "/componentType",
     [](Subject& s) { s.accessor()["componentType"] = 5120; }},
    {"indices.normalized", accessor_at + "/normalized",
     [](Subject& s) { s.accessor()["normalized"] = true; }},
    {"indices.count", indices_at, [](Subject& s) { s.accessor()["count"] = 1; }},
    {"indices.inside", indices_at, [](Subject& s) { s.accessor()["byteOffset"] = 2; }},
    {"indices.sparse", accessor_at + "/sparse/indices",
     [](Subject& s) { s.accessor()["sparse"] = sparse_of(s, "\2", std::string("\0\0", 2)); }},
    {"indices.sparse", accessor_at + "/sparse/indices",
     [](Subject& s) { s.accessor()["sparse"] = sparse_of(s, std::string("\1\0", 2), std::string(4, '\0')); }},
    {"indices.sparse", accessor_at + "/sparse/values",
     [](Subject& s) { s.accessor()["sparse"] = sparse_of(s, std::string("\0\1", 2), std::string(3, '\0')); }},
    {"align.index", indices_at,
     [](Subject& s) {
       s.indices_view()["byteOffset"] = s.indices_view()["byteOffset"].get<int>() - 1;
       s.byte_of(s.indices_view(), 0) = s.byte_of(s.indices_view(), 1) = 0;
       s.byte_of(s.indices_view(), 2) = s.byte_of(s.indices_view(), 3) = 0;
     }},
    {"index.special", indices_at, [](Subject& s) { s.byte_of(s.indices_view(), 2) = '\xfb'; }},
    {"index.range", indices_at, [](Subject& s) { s.byte_of(s.indices_view(), 0) = 2; }},
    {"index.range", "/meshes/0/primitives/1" + root_at,
     [](Subject& s) { s.extension(1)["micromapBaseTriangle"] = 2; }},
    {"index.range", "/meshes/0/primitives/1" + root_at,
     [](Subject& s) { s.extension(1)["micromapBaseTriangle"] = 4294967295; }},
    {"file.version", "/asset", [](Subject& s) { s.file.json["asset"]["minVersion"] = "2.1"; }},
    {"file.newer", "/asset/version", [](Subject& s) { s.file.json["asset"]["version"] = "2.1"; }},
    {"view.shared", micromap_at + "/data",
     [](Subject& s) {
       s.file.add(
           "accessors",
           {{"bufferView", s.micromap()["data"]}, {"componentType", 5121}, {"count", 5}, {"type", "SCALAR"}});
     }},
    {"view.shared", indices_at,
     [](Subject& s) {
       s.file.json["meshes"][0]["primitives"][1]["attributes"]["_ID"] = s.extension()["micromapIndices"];
     }},
    {"limits.extension", micromap_at + "/data",
     [](Subject& s) {
       s.data_view()["extensions"]["ACME_zip"] = Json::object();
       s.file.json["extensionsRequired"] = {"ACME_zip"};
     }},
    // A build without the decoder cannot tell damage from what it does not read.
    {"view.compressed", micromap_at + "/data", {}},
    {has_meshopt() ? "view.compressed" : "limits.extension", micromap_at + "/data",
     [](Subject& s) { compress(s.file, s.data_view(), std::string("\xa0?????", 6)); }},
    {"limits.indices", accessor_at + "/count",
     [](Subject& s) {
       s.accessor().erase("bufferView");
       s.accessor()["count"] = 4194305;
     }},
};

inline const std::vector<Breach>& breaches() { return all_breaches; }

}  // namespace mmverify::tests::micromap_file
