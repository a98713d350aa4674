#include "bench/papers/measured.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "bench/papers/pieces.hpp"
#include "bench/scene/dag_maps.hpp"
#include "bench/textures/leaf_texture.hpp"
#include "impl/vq/vq.hpp"
#include "scene/attribute/atlas.hpp"
#include "scene/attribute/set_triangles.hpp"
#include "scene/bake/surface_baker.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/quad.hpp"
#include "scene/sample/scene.hpp"

namespace mmverify::bench::papers {
namespace {

namespace micromap = impl::micromap;

constexpr std::size_t generated_leaves = 60;
constexpr std::uint64_t most_map_bytes = std::uint64_t{1} << 30;
constexpr std::uint64_t most_compared_bytes = std::uint64_t{128} << 20;  ///< of 4-state maps, as in bench dag
constexpr char own_scene[] = "own scene";
constexpr double least_part = 0.03;
constexpr unsigned last_attribute_level = 5;
/// The work of a scene's attribute maps that fits a page made within minutes, in texels.
constexpr double most_attribute_work = 4.2e8;

std::vector<AlphaTexture> read_textures(const Sources& sources) {
  if (!sources.textures.empty()) return alpha_textures(sources.textures);
  std::vector<AlphaTexture> leaves;
  for (std::uint64_t seed = 1; seed <= generated_leaves; ++seed) leaves.push_back(leaf_texture(seed));
  return leaves;
}

PlannedScene planned(std::string name, const std::string& file, const scene::Bytes& bytes = {}) {
  PlannedScene one{
      .name = std::move(name), .file = file, .bytes = bytes, .scene = {}, .plan = {}, .uses = {}};
  if (file.empty()) {
    one.scene = scene::load(one.name, bytes);
    one.uses = scene::load_uses(one.name, bytes);
  } else {
    one.scene = scene::load(file);
    one.uses = scene::load_uses(file);
  }
  one.plan = scene::plan(one.scene);
  return one;
}

/// The work of a level of attribute maps, in texels: those under each distinct triangle, and the values of both kinds of
/// maps, whose cost is about that of a texel each.
double attribute_work(const scene::AttributeScene& read, unsigned level) {
  std::vector<scene::MapOfTriangle> maps;
  for (const scene::AttributePrimitive& primitive : read.primitives)
    for (const scene::AttributeUse& use : primitive.uses)
      for (const scene::Triangle& t : primitive.triangles)
        maps.push_back({use.texture, {use.uvs[t[0]], use.uvs[t[1]], use.uvs[t[2]]}});
  const std::vector<std::size_t> first = scene::first_of_same_uvs(maps);
  const auto values = static_cast<double>(scene::values_of_map(scene::MapKind::faces, level) +
                                          scene::values_of_map(scene::MapKind::vertices, level));
  double work = 0;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const scene::ColourImage& image = read.images[read.textures[maps[k].texture].image];
    if (first[k] != k || !scene::within_reach(maps[k].uvs, image)) continue;
    const double twice = scene::TexelPlane(scene::in_texels(maps[k].uvs, image.width, image.height)).area();
    work += std::abs(twice) / 2 + values;
  }
  return work;
}

/// The last level up to which all levels' work fits; at least 0.
unsigned last_level_within(const scene::AttributeScene& read) {
  double work = attribute_work(read, 0);
  unsigned last = 0;
  while (last < last_attribute_level && (work += attribute_work(read, last + 1)) <= most_attribute_work)
    ++last;
  return last;
}

/// The 4-state map of a triangle of the plan.
micromap::Bytes map_of(const PlannedScene& of, std::size_t number, unsigned level) {
  const scene::PlannedTriangle& triangle = of.plan.triangles[number];
  const impl::bake::TriangleBaker baker = surface_baker(of.scene, of.plan.surfaces[triangle.surface]);
  const auto corner = [&](std::size_t k) {
    return impl::bake::TexturePoint{triangle.uvs[k][0], triangle.uvs[k][1]};
  };
  micromap::Bytes map(micromap::packed_bytes(micromap::micro_triangles(level), micromap::Format::four_state));
  baker.bake({corner(0), corner(1), corner(2)}, level, map);
  return map;
}

std::uint32_t lost_of(VqEncoder encoder, const OpacityMaps& maps, std::uint32_t& transforms) {
  const auto taken = [&](const auto& encoded, std::size_t at) {
    transforms = (encoded.block[at] | std::uint32_t{encoded.block[at + 1]} << 8) & 511;
    return encoded.substitutions;
  };
  // The transforms stand behind the 64 indices of 3 and of 4 bits.
  constexpr std::size_t of_vq2 = 24, of_vq4 = 32;
  switch (encoder) {
    case VqEncoder::vq2_paper: return taken(impl::vq::encode_paper(maps.regions_16), of_vq2);
    case VqEncoder::vq2_optimal: return taken(impl::vq::encode_optimal(maps.regions_16), of_vq2);
    case VqEncoder::vq4_paper: return taken(impl::vq::encode_paper(maps.regions_32), of_vq4);
    case VqEncoder::vq4_balanced: break;
  }
  return taken(encode(maps.regions_32), of_vq4);
}

}  // namespace

void Measured::begins(const std::string& step) const {
  if (sources_.progress) sources_.progress(step);
  stop();
}

void Measured::stop() const {
  if (sources_.stop) sources_.stop();
}

scene::BakeOptions Measured::options() const {
  return {.threads = sources_.threads, .two_state = false, .margin = 0, .done = [this](std::uint64_t) {
            stop();
          }};
}

const std::vector<PlannedScene>& Measured::scenes() {
  if (!scenes_.empty()) return scenes_;
  if (sources_.scenes.empty()) {
    scenes_.push_back(planned(own_scene, "", scene::sample_scene()));
    scenes_.push_back(planned("Quad", "", scene::quad_scene()));
  }
  for (const std::string& file : sources_.scenes) {
    begins(file);
    try {
      scenes_.push_back(planned(std::filesystem::path(file).stem().string(), file));
    } catch (const scene::BadScene& error) {
      if (sources_.note) sources_.note(std::string("left out: ") + error.what());
    }
  }
  if (scenes_.empty()) throw std::runtime_error("no scene can be read");
  return scenes_;
}

const std::optional<scene::Sizes>& Measured::sizes(std::size_t at, unsigned level) {
  const auto known = sizes_.find({at, level});
  if (known != sizes_.end()) return known->second;
  const PlannedScene& of = scenes()[at];
  std::optional<scene::Sizes> found;
  if (scene::map_bytes_at_level(of.plan, level) <= most_map_bytes) {
    begins(of.name + ", level " + std::to_string(level));
    found = scene::sizes_at_level(of.scene, of.plan, level, options());
  }
  return sizes_.emplace(std::pair(at, level), std::move(found)).first->second;
}

const CsmFigures& Measured::common_subtrees(std::size_t at, unsigned level) {
  const auto known = common_subtrees_.find({at, level});
  if (known != common_subtrees_.end()) return known->second;
  const PlannedScene& of = scenes()[at];
  begins(of.name + ", level " + std::to_string(level) + ", common subtrees");
  const SceneMaps maps(of.scene, of.plan);
  const auto stops = [this] { stop(); };
  const MapsAtLevel in = maps.in_format(level, micromap::Format::two_state,
                                        maps.baked(level, maps.fitting(level, most_compared_bytes), stops));
  CsmFigures found;
  if (!in.maps.empty()) {
    impl::dag::Dag dag(impl::dag::Format::two_state);
    for (const auto& map : in.maps) dag.add(level, map);
    found = csm_figures({.level = level, .bits = in.bits, .maps = in.maps, .stop = stops}, dag);
  }
  return common_subtrees_.emplace(std::pair(at, level), found).first->second;
}

const Squares& Measured::squares(std::size_t at) {
  const auto known = squares_.find(at);
  if (known != squares_.end()) return known->second;
  const PlannedScene& of = scenes()[at];
  begins(of.name + ", pairs of triangles");
  Squares found;
  found.maps = square_maps(of.scene, of.plan, scene::pairs(of.scene, of.plan), options());
  const auto stops = [this] { stop(); };
  found.vq2 = vq2_footprint(found.maps, stops);
  found.vq4 = vq4_footprint(found.maps, stops);
  return squares_.emplace(at, std::move(found)).first->second;
}

const scene::AttributeFigures& Measured::attributes(std::size_t at) {
  const auto known = attributes_.find(at);
  if (known != attributes_.end()) return known->second;
  const PlannedScene& of = scenes()[at];
  begins(of.name + ", attributes");
  const scene::AttributeScene read = attributes_of(of);
  scene::AttributeOptions options;
  options.last = last_level_within(read);
  if (options.last < last_attribute_level && sources_.note)
    sources_.note(of.name + ": attribute maps of levels 0 to " + std::to_string(options.last) +
                  " alone; more would take minutes");
  options.averaging = scene::Averaging::codes;
  options.threads = sources_.threads;
  options.stop = [this] { stop(); };
  return attributes_.emplace(at, measure(read, options)).first->second;
}

const std::map<std::string, AlphaTexture>& Measured::alpha() {
  if (!alpha_.empty()) return alpha_;
  begins("textures");
  for (AlphaTexture& one : read_textures(sources_)) {
    const std::string name = one.file;
    alpha_.emplace(name, std::move(one));
  }
  return alpha_;
}

const std::vector<OpacityMaps>& Measured::textures() {
  if (!textures_.empty()) return textures_;
  for (const auto& [name, texture] : alpha())
    for (OpacityMaps& maps : opacity_maps({texture})) textures_.push_back(std::move(maps));
  if (textures_.empty())
    throw std::runtime_error(sources_.textures + ": no texture has alpha of 1/2 anywhere");
  return textures_;
}

const std::vector<OpacityMaps>& Measured::parts() {
  if (!parts_.empty()) return parts_;
  begins("parts of textures");
  for (const auto& [name, texture] : alpha()) {
    stop();
    for (OpacityMaps& maps : opacity_maps(pieces(texture, least_part))) parts_.push_back(std::move(maps));
  }
  return parts_;
}

std::optional<std::size_t> Measured::twig(std::size_t at) {
  constexpr unsigned level = 5;
  const auto known = twigs_.find(at);
  if (known != twigs_.end()) return known->second;
  const PlannedScene& of = scenes()[at];
  std::optional<std::size_t>& found = twigs_[at];
  for (std::size_t k = 0; k < of.plan.triangles.size() && !found; ++k) {
    stop();
    const micromap::StateCounts counts = micromap::count_states(
        map_of(of, k, level), micromap::Format::four_state, micromap::micro_triangles(level));
    if (counts[0] != 0 && counts[1] != 0) found = k;
  }
  return found;
}

const VqLoss& Measured::loss(VqEncoder encoder, bool of_parts) {
  const auto known = losses_.find({encoder, of_parts});
  if (known != losses_.end()) return known->second;
  const std::vector<OpacityMaps>& all = of_parts ? parts() : textures();
  begins("encoders of square maps");
  VqLoss loss;
  for (const OpacityMaps& maps : all) {
    stop();
    loss.lost.push_back(lost_of(encoder, maps, loss.transforms.emplace_back()));
  }
  return losses_.emplace(std::pair(encoder, of_parts), std::move(loss)).first->second;
}

scene::AttributeScene attributes_of(const PlannedScene& of) {
  return of.file.empty() ? scene::load_attributes(of.name, of.bytes) : scene::load_attributes(of.file);
}

std::vector<std::size_t> masked(Measured& measured) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < measured.scenes().size(); ++k)
    if (!measured.scenes()[k].plan.triangles.empty()) all.push_back(k);
  return all;
}

std::vector<double> by_scene(Measured& measured, const std::function<double(std::size_t)>& figure) {
  std::vector<double> all;
  for (const std::size_t k : masked(measured)) all.push_back(figure(k));
  return all;
}

std::optional<TriangleMap> twig_map(Measured& measured, std::size_t at, unsigned level) {
  const auto twig = measured.twig(at);
  if (!twig) return std::nullopt;
  measured.stop();
  const std::uint64_t states = micromap::micro_triangles(level);
  const micromap::Bytes four = map_of(measured.scenes()[at], *twig, level);
  TriangleMap two{micromap::Format::two_state,
                  micromap::Bytes(micromap::packed_bytes(states, micromap::Format::two_state))};
  micromap::force2(four, states, two.packed);
  return two;
}

}  // namespace mmverify::bench::papers
