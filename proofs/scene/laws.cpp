#include "proofs/scene/laws.hpp"

#include <variant>

#include "proofs/scene/exact_surface.hpp"
#include "proofs/scene/law_parts.hpp"
#include "spec/bake/whole/state.hpp"

namespace mmverify::proofs::scene {
namespace {

constexpr Level finest = 12;

/// Levels as text, "levels 0..3, 7".
std::string levels_text(const std::vector<Level>& levels) {
  std::string text = levels.size() == 1 ? "level " : "levels ";
  for (std::size_t k = 0; k < levels.size();) {
    std::size_t last = k;
    while (last + 1 < levels.size() && levels[last + 1] == levels[last] + 1) ++last;
    if (k != 0) text += ", ";
    text += last == k ? fmt::format("{}", levels[k]) : fmt::format("{}..{}", levels[k], levels[last]);
    k = last + 1;
  }
  return text;
}

void append_all(std::vector<Law>& all, std::vector<Law> some) {
  for (Law& law : some) all.push_back(std::move(law));
}

void add_formats(SceneLaws& all, const Data& data) {
  bool two = false, four = false;
  for (const auto& record : data.arrays.array.records) (record.format == 1 ? two : four) = true;
  if (!two)
    all.left_out.push_back({"2-state", "not tested: every map that is stored has unknown micro-triangles"});
  if (!four)
    all.left_out.push_back({"4-state", "not tested: no map that is stored has unknown micro-triangles"});
}

/// A fingerprint of the scene and of all its maps: whatever the laws read.
std::string fingerprint_of(const Data& data) {
  Hash hash;
  hash.numbers(data.arrays.array.data);
  for (const auto& record : data.arrays.array.records)
    hash.number(record.offset), hash.number(record.level), hash.number(record.format);
  for (const auto& primitive : data.arrays.primitives) hash.numbers(primitive.geometry.indices);
  for (const auto& image : data.scene.images) {
    hash.number(image.width), hash.number(image.height);
    std::visit([&hash](const auto& alpha) { hash.numbers(alpha); }, image.alpha);
  }
  for (const auto& s : data.plan.surfaces) {
    hash.number(std::uint64_t{s.image});
    hash.number(s.mode), hash.number(s.cutoff), hash.number(s.base_color_alpha), hash.number(s.vertex_alpha);
    hash.number(s.sampler.wrap_u), hash.number(s.sampler.wrap_v), hash.number(filter_of(s.sampler));
  }
  for (std::size_t k = 0; k < data.plan.triangles.size(); ++k) {
    hash.number(data.plan.triangles[k].surface), hash.number(data.baked.triangles[k].level);
    hash.numbers(data.baked.triangles[k].states);
    for (const auto& uv : data.plan.triangles[k].uvs) hash.numbers(uv);
    if (data.plan.triangles[k].varies()) hash.numbers(data.plan.triangles[k].vertex_alpha);
  }
  for (const auto& pair : data.pairs.distinct)
    for (const auto& use : {pair.lower, pair.upper}) hash.number(use.triangle), hash.numbers(use.order);
  for (const auto& map : data.squares.vq2) hash.numbers(map);
  for (const auto& map : data.squares.vq4) hash.numbers(map);
  return fmt::format("{} {:016x} margin {}{}", data.scene.file, hash.value(), data.margin,
                     data.two_state ? " 2-state" : "");
}

}  // namespace

/// The fingerprint takes a second, so it is computed once.
std::string SceneSubject::fingerprint() const {
  std::call_once(asked_, [this] { fingerprint_ = fingerprint_of(data_); });
  return fingerprint_;
}

SceneLaws scene_laws(const Data& data, const BakeSample& sample, const std::string& command) {
  SceneLaws all;
  all.exact = std::make_shared<const ExactSurfaces>(data.scene, data.plan, data.margin);
  append_all(all.laws, bake_laws(data, all.exact, sample));
  append_all(all.laws, array_laws(data));
  append_all(all.laws, tree_laws(data));
  append_all(all.laws, vq_laws(data, all.exact));
  std::map<std::string, SubjectPtr> subjects;
  for (Law& law : all.laws) {
    law.replayed_by = fmt::format("{} --replay {}", command, law.id);
    SubjectPtr& subject = subjects[law.topic];
    if (!subject) subject = std::make_shared<const SceneSubject>(data, law.topic);
    std::vector<Level> absent;
    for (Level n = 0; n <= finest; ++n)
      if (law.unfit(*subject, n))
        absent.push_back(n);
      else
        all.jobs.push_back({&law, subject, {n, n}, {}});
    if (absent.size() == finest + 1)
      all.left_out.push_back({law.id, *law.unfit(*subject, law.topic == "vq" ? 4 : 0)});
    else if (law.topic == "bake" || law.topic == "tree")
      all.left_out.push_back({fmt::format("{}, {}", law.id, levels_text(absent)),
                              "not tested: the scene has no map of these levels"});
  }
  add_formats(all, data);
  return all;
}

std::optional<std::string> rationals_text(const SceneLaws& laws) {
  const std::uint64_t count = laws.exact ? laws.exact->in_rationals() : 0;
  if (count == 0) return std::nullopt;
  return fmt::format(
      "{} of the exact states took rationals: numbers of too many bits, or micro-triangles over "
      "more than {} rows and columns of texels",
      count, spec::bake::whole::most_squares);
}

SceneLaws map_laws(const Data& data, const BakeSample& sample, const std::string& name,
                   const std::string& command) {
  SceneLaws all;
  all.exact = std::make_shared<const ExactSurfaces>(data.scene, data.plan, data.margin);
  all.laws = bake_laws(data, all.exact, sample);
  const auto subject = std::make_shared<const SceneSubject>(data, "bake", name);
  for (Law& law : all.laws) {
    law.replayed_by = fmt::format("{} --replay {}", command, law.id);
    for (Level n = 0; n <= finest; ++n)
      if (!law.unfit(*subject, n)) all.jobs.push_back({&law, subject, {n, n}, {}});
  }
  return all;
}

}  // namespace mmverify::proofs::scene
