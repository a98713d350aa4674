#include "proofs/bake/mesh/mesh_baker.hpp"

#include <cstring>

#include "proofs/array/answers.hpp"
#include "proofs/bake/cases/header_case.hpp"
#include "subjects/dock/codec.hpp"

namespace mmverify::proofs::bake {

std::optional<array::Answer> mesh_array(const char* builder, const MeshCase& mesh,
                                        const StatesOfTriangle& states_of,
                                        const array::BuildOptions& options) {
  array::BuildCase c{{}, {}, options};
  c.options.api = mesh.api;
  c.options.encoding = mesh.encoding;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto states = states_of(mesh, t);
    if (!states) return std::nullopt;
    c.maps.push_back(array::packed(mesh.level_of(t), mesh.format, *states));
  }
  return array::built_in(builder)->functions.build(c);
}

StatesOfTriangle own_states(const Functions& functions) {
  return [bake = functions.bake](const MeshCase& mesh,
                                 std::size_t triangle) -> std::optional<std::vector<State>> {
    auto baked = bake(on_triangle(mesh, triangle), mesh.level_of(triangle), static_cast<Format>(mesh.format));
    if (!baked) return std::nullopt;
    return std::move(baked->states);
  };
}

MeshBaker mesh_baker_of(const Functions& functions, const char* builder) {
  return [states = own_states(functions), builder](const MeshCase& mesh) {
    return mesh_array(builder, mesh, states);
  };
}

namespace {

template <class Numbers>
void put_numbers(std::vector<std::uint8_t>& blob, const Numbers& numbers) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(numbers.data());
  blob.insert(blob.end(), bytes, bytes + numbers.size() * sizeof(numbers[0]));
}

/// The case in the C header's form; behind it its surface, numbers and texels, as subjects/dock/desk/arguments.hpp reads
/// them.
std::vector<std::uint8_t> mesh_blob(const MeshCase& mesh) {
  Case surface = mesh.surface;
  surface.uv = {};
  const std::array of_surface{header_case(surface, mesh.level, static_cast<std::uint32_t>(mesh.format))};
  std::array<mmverify_mesh_case_t, 1> of_mesh{};
  mmverify_mesh_case_t& what = of_mesh.front();
  what.size = sizeof what;
  what.api = static_cast<std::uint32_t>(mesh.api);
  what.index_type = static_cast<std::uint32_t>(mesh.encoding);
  what.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  what.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  // The worker sets all addresses; this one says that there are levels.
  static constexpr std::uint32_t some_level = 0;
  if (!mesh.levels.empty()) what.levels = &some_level;
  std::vector<std::uint8_t> blob;
  put_numbers(blob, of_mesh);
  put_numbers(blob, of_surface);
  put_numbers(blob, mesh.triangles);
  put_numbers(blob, mesh.vertices);
  put_numbers(blob, mesh.levels);
  put_numbers(blob, header_texels(mesh.surface));
  return blob;
}

}  // namespace

MeshBaker mesh_baker_of(const dock::LibraryPtr& library) {
  return [library](const MeshCase& mesh) -> std::optional<array::Answer> {
    constexpr std::uint64_t room = 4096;
    const std::vector<std::uint8_t> blob = mesh_blob(mesh);
    const dock::Answer answer = dock::ask(
        *library, {dock::Call::bake_mesh, mesh.level, static_cast<std::uint32_t>(mesh.format), blob, room},
        [&] { return "baking the mesh " + text_of(mesh); });
    if (!answer.taken) return std::nullopt;
    return array::read_answer(answer.bytes);
  };
}

}  // namespace mmverify::proofs::bake
