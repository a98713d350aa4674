// The measurements that the items share: each is made when an item first asks for it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/dag/csm_figures.hpp"
#include "bench/vq/maps.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/pipeline.hpp"
#include "scene/read/file.hpp"

namespace mmverify::bench::papers {

/// The sources of numbers of ours.
struct Sources {
  std::vector<std::string> scenes = {};  ///< files; none: the suite's own scene and the Quad
  std::string textures = {};             ///< a folder of alpha textures; empty: 60 generated leaves
  unsigned threads = 0;
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
  std::function<void(const std::string&)> note = {};      ///< receives what is left out, and why
  std::function<void()> stop = {};                        ///< called often, from any thread; may throw
};

/// A scene, and the plan of its maps.
struct PlannedScene {
  std::string name, file;  ///< file: empty for the suite's own and for the Quad
  scene::Bytes bytes;      ///< of these
  scene::Scene scene;
  scene::Plan plan;
  std::vector<scene::MeshUse> uses;
};

struct Squares {
  scene::SquareMaps maps;
  scene::VqFootprint vq2, vq4;
};

/// One encoder on all textures, or on all parts.
struct VqLoss {
  std::vector<std::uint32_t> lost, transforms;  ///< by map
};
enum class VqEncoder : std::uint8_t { vq2_paper, vq2_optimal, vq4_paper, vq4_balanced };

class Measured {
 public:
  explicit Measured(Sources sources) : sources_(std::move(sources)) {}

  const Sources& sources() const { return sources_; }
  void begins(const std::string& step) const;
  void stop() const;
  /// The options of a bake that stop() ends.
  scene::BakeOptions options() const;

  /// All scenes that can be read.  Errors: std::runtime_error if none can.
  const std::vector<PlannedScene>& scenes();
  /// The sizes with every triangle at one level; none beyond 1 GiB of flat maps.  Domain: a scene of masked().
  const std::optional<scene::Sizes>& sizes(std::size_t scene, unsigned level);
  /// The 2-state maps of a level in Common Subtree Merging and in our graph, a sample beyond 128 MiB; all zero
  /// without a map of two states.  Times are of one lookup, and mean nothing.  Domain: a scene of masked().
  const CsmFigures& common_subtrees(std::size_t scene, unsigned level);
  /// The square maps of a scene's pairs, and the bytes of both codecs' blocks.  Domain: a scene of masked().
  const Squares& squares(std::size_t scene);
  /// Attribute maps of levels 0 to 5, or to the last one whose work fits a page made within minutes; codes averaged.
  const scene::AttributeFigures& attributes(std::size_t scene);
  /// The alpha textures by name, and their maps.
  const std::map<std::string, AlphaTexture>& alpha();
  const std::vector<OpacityMaps>& textures();
  /// The maps of the textures' connected parts, of those with 3 % of a texture's opaque texels at least.
  const std::vector<OpacityMaps>& parts();
  /// The number of that triangle in the plan.
  std::optional<std::size_t> twig(std::size_t scene);
  const VqLoss& loss(VqEncoder encoder, bool of_parts = false);

 private:
  Sources sources_;
  std::vector<PlannedScene> scenes_;
  std::map<std::pair<std::size_t, unsigned>, std::optional<scene::Sizes>> sizes_;
  std::map<std::pair<std::size_t, unsigned>, CsmFigures> common_subtrees_;
  std::map<std::size_t, Squares> squares_;
  std::map<std::size_t, std::optional<std::size_t>> twigs_;
  std::map<std::size_t, scene::AttributeFigures> attributes_;
  std::map<std::string, AlphaTexture> alpha_;
  std::vector<OpacityMaps> textures_, parts_;
  std::map<std::pair<VqEncoder, bool>, VqLoss> losses_;
};

scene::AttributeScene attributes_of(const PlannedScene& scene);

/// The numbers of the scenes that have triangles to bake.
std::vector<std::size_t> masked(Measured& measured);
/// figure(scene's number) for each of these.
std::vector<double> by_scene(Measured& measured, const std::function<double(std::size_t)>& figure);

/// A map of a plan's triangle at a level.
struct TriangleMap {
  impl::micromap::Format format;
  impl::micromap::Bytes packed;
};
/// The 2-state map of the first triangle of a scene that has T and O in 4-state at level 5; none without one.
std::optional<TriangleMap> twig_map(Measured& measured, std::size_t scene, unsigned level);

}  // namespace mmverify::bench::papers
