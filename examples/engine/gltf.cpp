// From a GLB that mmverify scene -o wrote to the structs of VK_EXT_opacity_micromap.  The buffers go to the device as they
// lie in the file; the file has the array's usage counts, and the geometry's are counted here.
#include <fstream>
#include <iterator>
#include <mmverify/mmverify.hpp>
#include <nlohmann/json.hpp>

#include "print.h"

using namespace mmverify::impl;
using Json = nlohmann::json;

/// A GLB's JSON chunk, and its BIN chunk behind that.
struct Glb {
  Json json;
  array::Bytes binary;

  explicit Glb(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::string all((std::istreambuf_iterator<char>(file)), {});
    std::uint32_t length = 0;
    if (all.size() < 20) throw std::runtime_error("no GLB");
    std::memcpy(&length, all.data() + 12, 4);
    json = Json::parse(all.substr(20, length));
    binary.assign(all.begin() + 28 + length, all.end());
  }
  std::span<const std::uint8_t> view(const Json& number, std::size_t offset = 0) const {
    const Json& v = json["bufferViews"][number.get<std::size_t>()];
    return std::span(binary).subspan(v.value("byteOffset", std::size_t{0}) + offset,
                                     v["byteLength"].get<std::size_t>() - offset);
  }
};

static array::Encoding encoding_of(int component_type) {
  if (component_type == 5123) return array::Encoding::u16;
  if (component_type == 5125) return array::Encoding::u32;
  throw std::runtime_error("VK_EXT_opacity_micromap takes unsigned indices of 16 and 32 bits");
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const Glb glb(argv[1]);
  const char* const name = "EXT_mesh_opacity_micromap";
  for (const Json& m : glb.json["extensions"][name]["micromaps"]) {
    const auto data = glb.view(m["data"]), triangles = glb.view(m["triangles"]);
    std::vector<VkMicromapUsageEXT> usage;
    for (std::size_t k = 0; k < m["usageCounts"].size(); ++k)
      usage.push_back({m["usageCounts"][k], m["usageLevels"][k], m["usageFormats"][k]});
    VkMicromapBuildInfoEXT build{};
    build.sType = VK_STRUCTURE_TYPE_MICROMAP_BUILD_INFO_EXT;
    build.type = VK_MICROMAP_TYPE_OPACITY_MICROMAP_EXT;
    build.mode = VK_BUILD_MICROMAP_MODE_BUILD_EXT;
    build.usageCountsCount = static_cast<std::uint32_t>(usage.size());
    build.pUsageCounts = usage.data();
    build.data.hostAddress = data.data();
    build.triangleArray.hostAddress = triangles.data();
    build.triangleArrayStride = sizeof(VkMicromapTriangleEXT);
    print_build(&build, static_cast<std::uint32_t>(triangles.size() / sizeof(VkMicromapTriangleEXT)),
                data.size());
  }
  for (const Json& mesh : glb.json["meshes"])
    for (const Json& primitive : mesh["primitives"]) {
      const Json& own = primitive.value("extensions", Json::object()).value(name, Json());
      if (!own.contains("micromapIndices")) continue;
      const auto triangles = glb.view(
          glb.json["extensions"][name]["micromaps"][own["micromap"].get<std::size_t>()]["triangles"]);
      std::vector<micromap::Record> records;
      for (std::size_t at = 0; at < triangles.size(); at += 8)
        records.push_back(micromap::record_at(triangles, at));
      const Json& accessor = glb.json["accessors"][own["micromapIndices"].get<std::size_t>()];
      const array::Encoding encoding = encoding_of(accessor["componentType"]);
      const std::size_t bytes = micromap::width(encoding) / 8, count = accessor["count"];
      const auto codes =
          glb.view(accessor["bufferView"], accessor.value("byteOffset", std::size_t{0})).first(count * bytes);
      const array::Part part{encoding, own.value("micromapBaseTriangle", 0u), {codes.begin(), codes.end()}};
      const auto usage = array::copied_as<VkMicromapUsageEXT>(array::geometry_counts(records, part));
      VkAccelerationStructureTrianglesOpacityMicromapEXT geometry{};
      geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_EXT;
      geometry.indexType = static_cast<VkIndexType>(array::index_type(encoding).vulkan);
      geometry.indexBuffer.hostAddress = codes.data();
      geometry.indexStride = bytes;
      geometry.baseTriangle = part.base;
      geometry.usageCountsCount = static_cast<std::uint32_t>(usage.size());
      geometry.pUsageCounts = usage.data();
      print_geometry(&geometry, static_cast<std::uint32_t>(count));
    }
}
