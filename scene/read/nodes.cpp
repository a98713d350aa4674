#include "scene/read/nodes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/read/accessor.hpp"
#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

/// Node numbers, parents before children.
std::vector<std::size_t> checked_trees(const Document& document) {
  constexpr std::size_t none = SIZE_MAX;
  const auto& nodes = document.model.nodes;
  std::vector<std::size_t> parent(nodes.size(), none);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (const int child : nodes[k].children) {
      std::size_t& its = parent[static_cast<std::size_t>(child)];
      if (its != none)
        throw BadScene(document.file, place("node", static_cast<std::size_t>(child)),
                       "a child of node " + std::to_string(its) + " and of node " + std::to_string(k));
      its = k;
    }
  // Each node has at most one parent, so a node that no root reaches is on a circle, or below one.
  std::vector<std::size_t> reached;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (parent[k] == none) reached.push_back(k);
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const int child : nodes[reached[k]].children) reached.push_back(static_cast<std::size_t>(child));
  if (reached.size() == nodes.size()) return reached;
  std::sort(reached.begin(), reached.end());
  std::size_t first = 0;
  while (first < reached.size() && reached[first] == first) ++first;
  throw BadScene(document.file, place("node", first), "its ancestors form a circle");
}

constexpr Placement identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

Placement product(const Placement& a, const Placement& b) {
  Placement c{};
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t k = 0; k < 3; ++k) c[row + 3 * column] += a[row + 3 * k] * b[k + 3 * column];
  return c;
}

/// The linear part of a node: rotation times scale, or the matrix.  Source: glTF 2.0, 3.5.3.
Placement linear_part(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    Placement m{};
    for (std::size_t k = 0; k < 9; ++k) m[k] = node.matrix[4 * (k / 3) + k % 3];
    return m;
  }
  Placement m = identity;
  if (node.rotation.size() == 4) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    m = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (x * z - y * w),
         2 * (x * y - z * w),     1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
         2 * (x * z + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y)};
  }
  if (node.scale.size() == 3)
    for (std::size_t k = 0; k < 9; ++k) m[k] *= node.scale[k / 3];
  return m;
}

/// The squared scale of a transform that keeps all angles, to within a millionth; or -1.
double similar_scale(const Placement& m) {
  const auto dot = [&m](std::size_t a, std::size_t b) {
    return m[3 * a] * m[3 * b] + m[3 * a + 1] * m[3 * b + 1] + m[3 * a + 2] * m[3 * b + 2];
  };
  const double scale = (dot(0, 0) + dot(1, 1) + dot(2, 2)) / 3, slack = 1e-6 * scale;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      if (!(std::abs(dot(a, b) - (a == b ? scale : 0)) <= slack)) return -1;
  return scale;
}

void place_once(Mesh& mesh, const Placement& m, double times = 1) {
  if (const double scale = similar_scale(m); scale >= 0)
    mesh.placements.similar += times * scale;
  else
    mesh.placements.others.push_back({m, times});
}

/// Places the instances of EXT_mesh_gpu_instancing, each by its rotation times scale under the node.
void place_instances(const Document& document, const Buffers& buffers, const nlohmann::json& attributes,
                     const std::string& at, const Placement& m, Mesh& mesh) {
  const auto instances = document.model.accessors[attributes.begin()->get<std::size_t>()].count;
  for (const auto& [name, accessor] : attributes.items())
    if (document.model.accessors[accessor.get<std::size_t>()].count != instances)
      throw BadScene(document.file, at,
                     "EXT_mesh_gpu_instancing: " + name + " and others have different counts");
  mesh.uses += instances;
  const auto read = [&](const char* name, int components, Integers integers) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::vector<float>();
    return read_floats(document, buffers, found->get<std::size_t>(), components, integers, at + " " + name);
  };
  const std::vector<float> rotation = read("ROTATION", 4, Integers::any),
                           scale = read("SCALE", 3, Integers::none);
  // A rotation alone changes no area, nor does a rotation under a node that keeps angles.
  if (scale.empty() && (rotation.empty() || similar_scale(m) >= 0))
    return place_once(mesh, m, static_cast<double>(instances));
  for (std::size_t k = 0; k < instances; ++k) {
    tinygltf::Node node;
    if (!rotation.empty())
      node.rotation.assign(rotation.begin() + 4 * static_cast<std::ptrdiff_t>(k),
                           rotation.begin() + 4 * static_cast<std::ptrdiff_t>(k) + 4);
    if (!scale.empty())
      node.scale.assign(scale.begin() + 3 * static_cast<std::ptrdiff_t>(k),
                        scale.begin() + 3 * static_cast<std::ptrdiff_t>(k) + 3);
    place_once(mesh, product(m, linear_part(node)));
  }
}

// ---- The places of uses

Transform product(const Transform& a, const Transform& b) {
  Transform c{product(a.linear, b.linear), a.translation};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) c.translation[row] += a.linear[row + 3 * k] * b.translation[k];
  return c;
}

Transform transform_of(const tinygltf::Node& node) {
  Transform t{linear_part(node), {0, 0, 0}};
  if (node.matrix.size() == 16)
    t.translation = {node.matrix[12], node.matrix[13], node.matrix[14]};
  else if (node.translation.size() == 3)
    t.translation = {node.translation[0], node.translation[1], node.translation[2]};
  return t;
}

/// Adds the instances of EXT_mesh_gpu_instancing; read_meshes() has checked their counts.
void list_instances(const Document& document, const Buffers& buffers, const nlohmann::json& attributes,
                    std::size_t number, const Transform& node_at, std::size_t mesh,
                    std::vector<MeshUse>& uses) {
  const std::string at = place("node", number);
  const auto read = [&](const char* name, int components, Integers integers) {
    const auto found = attributes.find(name);
    if (found == attributes.end()) return std::vector<float>();
    return read_floats(document, buffers, found->get<std::size_t>(), components, integers, at + " " + name);
  };
  const std::vector<float> translation = read("TRANSLATION", 3, Integers::none),
                           rotation = read("ROTATION", 4, Integers::any),
                           scale = read("SCALE", 3, Integers::none);
  const auto part = [](const std::vector<float>& all, std::size_t k, std::size_t size) {
    return all.empty() ? std::vector<double>()
                       : std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(k * size),
                                             all.begin() + static_cast<std::ptrdiff_t>(k * size + size));
  };
  const std::size_t instances = document.model.accessors[attributes.begin()->get<std::size_t>()].count;
  for (std::size_t k = 0; k < instances; ++k) {
    tinygltf::Node node;
    node.translation = part(translation, k, 3);
    node.rotation = part(rotation, k, 4);
    node.scale = part(scale, k, 3);
    uses.push_back({mesh, product(node_at, transform_of(node)), number});
  }
}

}  // namespace

std::vector<MeshUse> read_uses(const Document& document, const Buffers& buffers) {
  const auto& nodes = document.model.nodes;
  constexpr Transform still{identity, {0, 0, 0}};
  std::vector<Transform> at(nodes.size(), still);
  std::vector<MeshUse> uses;
  for (const std::size_t k : checked_trees(document)) {
    at[k] = product(at[k], transform_of(nodes[k]));
    for (const int child : nodes[k].children) at[static_cast<std::size_t>(child)] = at[k];
    if (nodes[k].mesh < 0) continue;
    const auto mesh = static_cast<std::size_t>(nodes[k].mesh);
    const nlohmann::json& instancing = extension(document.json["nodes"][k], "EXT_mesh_gpu_instancing");
    if (const nlohmann::json& attributes = member(instancing, "attributes"); !attributes.empty())
      list_instances(document, buffers, attributes, k, at[k], mesh, uses);
    else
      uses.push_back({mesh, at[k], k});
  }
  if (uses.empty())
    for (std::size_t mesh = 0; mesh < document.model.meshes.size(); ++mesh) uses.push_back({mesh, still});
  return uses;
}

std::vector<Mesh> read_meshes(const Document& document, const Buffers& buffers) {
  const std::vector<std::size_t> order = checked_trees(document);
  const auto& nodes = document.model.nodes;
  std::vector<Placement> placements(nodes.size(), identity);
  std::vector<Mesh> meshes;
  for (const tinygltf::Mesh& mesh : document.model.meshes) meshes.push_back({mesh.name, 0, {}});
  for (const std::size_t k : order) {
    // Until here, placements[k] is the parent's.
    placements[k] = product(placements[k], linear_part(nodes[k]));
    for (const int child : nodes[k].children) placements[static_cast<std::size_t>(child)] = placements[k];
    if (nodes[k].mesh < 0) continue;
    Mesh& mesh = meshes[static_cast<std::size_t>(nodes[k].mesh)];
    const nlohmann::json& instancing = extension(document.json["nodes"][k], "EXT_mesh_gpu_instancing");
    if (const nlohmann::json& attributes = member(instancing, "attributes"); !attributes.empty()) {
      place_instances(document, buffers, attributes, place("node", k), placements[k], mesh);
    } else {
      ++mesh.uses;
      place_once(mesh, placements[k]);
    }
  }
  return meshes;
}

}  // namespace mmverify::scene
