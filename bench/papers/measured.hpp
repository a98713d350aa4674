// The measurements that the items share: each is made when an item first asks for it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/vq/maps.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/pipeline.hpp"
#include "scene/read/file.hpp"

namespace mmverify::bench::papers {

/// The sources of numbers of ours.
struct Sources {
  std::vector<std::string> scenes = {};  ///< files; none: the suite's own scene
  std::string textures = {};             ///< a folder of alpha textures; empty: 60 generated leaves
  unsigned threads = 0;
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
  std::function<void(const std::string&)> note = {};      ///< receives what is left out, and why
  std::function<void()> stop = {};                        ///< called often, from any thread; may throw
};

/// A scene, and the plan of its maps.
struct PlannedScene {
  std::string name, file;  ///< file: empty for the suite's own
  scene::Scene scene;
  scene::Plan plan;
  std::vector<scene::MeshUse> uses;
};

/// One encoder on all textures.
struct VqLoss {
  std::vector<std::uint32_t> lost, transforms;  ///< by texture
};
enum class VqEncoder : std::uint8_t { vq2_paper, vq2_optimal, vq4_paper, vq4_balanced };

class Measured {
 public:
  explicit Measured(Sources sources) : sources_(std::move(sources)) {}

  const Sources& sources() const { return sources_; }
  void begins(const std::string& step) const;
  void stop() const;

  /// Scenes with triangles to bake.  Errors: scene::BadScene; std::runtime_error if no scene has one.
  const std::vector<PlannedScene>& scenes();
  /// The sizes with every triangle at one level; none beyond 1 GiB of flat maps.
  const std::optional<scene::Sizes>& sizes(std::size_t scene, unsigned level);
  /// The bytes of both codecs' blocks, and of the pairs' regions.
  const std::pair<scene::VqFootprint, scene::VqFootprint>& squares(std::size_t scene);
  /// Attribute maps of levels 0 to 5, codes averaged.
  const scene::AttributeFigures& attributes(std::size_t scene);
  const std::vector<OpacityMaps>& textures();
  const VqLoss& loss(VqEncoder encoder);

 private:
  Sources sources_;
  std::vector<PlannedScene> scenes_;
  std::map<std::pair<std::size_t, unsigned>, std::optional<scene::Sizes>> sizes_;
  std::map<std::size_t, std::pair<scene::VqFootprint, scene::VqFootprint>> squares_;
  std::map<std::size_t, scene::AttributeFigures> attributes_;
  std::vector<OpacityMaps> textures_;
  std::map<VqEncoder, VqLoss> losses_;
};

/// figure(scene's number) for each scene.
std::vector<double> by_scene(Measured& measured, const std::function<double(std::size_t)>& figure);

/// A map of a plan's triangle at a level.
struct TriangleMap {
  impl::micromap::Format format;
  impl::micromap::Bytes packed;
};
/// The map of the first triangle of a scene whose map has both states.
TriangleMap twig_map(Measured& measured, std::size_t scene, unsigned level, bool two_state);

}  // namespace mmverify::bench::papers
