#include "impl/scene/nodes.hpp"

#include <algorithm>

#include "impl/scene/bad_scene.hpp"

namespace mmverify::impl::scene {
namespace {

void check_trees(const Document& document) {
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
  // With one parent each, a node that no root reaches is on a circle, or below one.
  std::vector<std::size_t> reached;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (parent[k] == none) reached.push_back(k);
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const int child : nodes[reached[k]].children) reached.push_back(static_cast<std::size_t>(child));
  if (reached.size() == nodes.size()) return;
  std::sort(reached.begin(), reached.end());
  std::size_t first = 0;
  while (first < reached.size() && reached[first] == first) ++first;
  throw BadScene(document.file, place("node", first), "its ancestors form a circle");
}

}  // namespace

std::vector<std::uint64_t> mesh_uses(const Document& document) {
  check_trees(document);
  std::vector<std::uint64_t> uses(document.model.meshes.size(), 0);
  for (std::size_t k = 0; k < document.model.nodes.size(); ++k) {
    const int mesh = document.model.nodes[k].mesh;
    if (mesh < 0) continue;
    const nlohmann::json& instancing = extension(document.json["nodes"][k], "EXT_mesh_gpu_instancing");
    std::uint64_t instances = 1;
    if (const nlohmann::json& attributes = member(instancing, "attributes"); !attributes.empty())
      instances = document.model.accessors[attributes.begin()->get<std::size_t>()].count;
    uses[static_cast<std::size_t>(mesh)] += instances;
  }
  return uses;
}

}  // namespace mmverify::impl::scene
