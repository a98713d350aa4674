#include "scene/sample/file.hpp"

#include <algorithm>

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr int unsigned_byte = 5121, unsigned_short = 5123, float_32 = 5126;
constexpr int array_buffer = 34962, element_array_buffer = 34963;

template <class T>
std::span<const unsigned char> as_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

void SampleMesh::add_quad(const std::array<Position, 4>& corners, const std::array<Uv, 4>& quad_uvs) {
  const auto first = static_cast<std::uint16_t>(positions.size());
  positions.insert(positions.end(), corners.begin(), corners.end());
  uvs.insert(uvs.end(), quad_uvs.begin(), quad_uvs.end());
  for (const int corner : {0, 1, 2, 0, 2, 3}) indices.push_back(static_cast<std::uint16_t>(first + corner));
}

std::size_t SampleFile::add(const char* array, Json element) {
  json[array].push_back(std::move(element));
  return json[array].size() - 1;
}

template <std::size_t N>
std::size_t SampleFile::add_vectors(const std::vector<std::array<float, N>>& values, bool bounds,
                                    bool of_vertices) {
  Json accessor = {{"bufferView", binary_.add_view(as_bytes(values), of_vertices ? array_buffer : 0)},
                   {"componentType", float_32},
                   {"count", values.size()},
                   {"type", "VEC" + std::to_string(N)}};
  if (bounds) {
    std::array<float, N> least = values.at(0), greatest = values.at(0);
    for (const auto& value : values)
      for (std::size_t c = 0; c < N; ++c) {
        least[c] = std::min(least[c], value[c]);
        greatest[c] = std::max(greatest[c], value[c]);
      }
    accessor["min"] = least;
    accessor["max"] = greatest;
  }
  return add("accessors", std::move(accessor));
}
template std::size_t SampleFile::add_vectors(const std::vector<std::array<float, 2>>&, bool, bool);
template std::size_t SampleFile::add_vectors(const std::vector<std::array<float, 3>>&, bool, bool);
template std::size_t SampleFile::add_vectors(const std::vector<std::array<float, 4>>&, bool, bool);

std::size_t SampleFile::add_numbers(const std::vector<float>& values, bool bounds) {
  Json accessor = {{"bufferView", binary_.add_view(as_bytes(values))},
                   {"componentType", float_32},
                   {"count", values.size()},
                   {"type", "SCALAR"}};
  if (bounds) {
    accessor["min"] = {*std::min_element(values.begin(), values.end())};
    accessor["max"] = {*std::max_element(values.begin(), values.end())};
  }
  return add("accessors", std::move(accessor));
}

Json SampleFile::primitive(const SampleMesh& mesh, std::size_t material, bool small) {
  Json primitive = {{"attributes", {{"POSITION", add_vectors(mesh.positions, true)}}},
                    {"material", material}};
  if (!mesh.uvs.empty()) primitive["attributes"]["TEXCOORD_0"] = add_vectors(mesh.uvs);
  if (mesh.indices.empty()) return primitive;
  const std::vector<std::uint8_t> bytes(mesh.indices.begin(), mesh.indices.end());
  primitive["indices"] =
      add("accessors", {{"bufferView", binary_.add_view(small ? as_bytes(bytes) : as_bytes(mesh.indices),
                                                        element_array_buffer)},
                        {"componentType", small ? unsigned_byte : unsigned_short},
                        {"count", mesh.indices.size()},
                        {"type", "SCALAR"}});
  return primitive;
}

std::size_t SampleFile::add_image(const std::string& name, std::span<const unsigned char> png) {
  return add("images", {{"bufferView", binary_.add_view(png)}, {"mimeType", "image/png"}, {"name", name}});
}

std::size_t SampleFile::place(std::size_t mesh, const char* name, const Position& at, float scale) {
  Json node = {{"mesh", mesh}, {"name", name}, {"translation", at}};
  if (scale != 1) node["scale"] = {scale, scale, scale};
  const std::size_t number = add("nodes", std::move(node));
  json["scenes"][0]["nodes"].push_back(number);
  return number;
}

}  // namespace mmverify::scene
