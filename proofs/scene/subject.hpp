// A scene's own data as a subject: its baked maps, and the arrays and codes built from them.
#pragma once

#include "impl/tree/tree.hpp"
#include "proofs/engine/law.hpp"
#include "scene/bake/arrays.hpp"
#include "scene/bake/square_maps.hpp"

namespace mmverify::proofs::scene {

/// The codecs of the maps: this project's, or in a test a wrong one, which the laws must refute.
struct Codecs {
  using Map = std::span<const std::uint8_t>;
  std::function<impl::tree::Stream(Level, impl::micromap::Format, Map)> stream =
      [](Level n, impl::micromap::Format f, Map map) { return impl::tree::encode_stream(n, f, map); };
  std::function<impl::tree::Tree(Level, impl::micromap::Format, Map)> tree =
      [](Level n, impl::micromap::Format f, Map map) { return impl::tree::Tree::encode(n, f, map); };
  std::function<impl::vq::Encoded2(const impl::vq::Map2&)> vq2 = impl::vq::encode_optimal;
  std::function<impl::vq::Encoded4(const impl::vq::Map4&)> vq4 = [](const impl::vq::Map4& map) {
    return impl::vq::encode(map);
  };
};

/// All data that the scene's laws read.  Nothing is owned: the scene outlives its laws.
struct Data {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::Plan& plan;
  const mmverify::scene::Baked& baked;
  const mmverify::scene::SceneArrays& arrays;
  const mmverify::scene::Pairs& pairs;
  const mmverify::scene::SquareMaps& squares;
  float margin = 0;        ///< the margin of the bake
  bool two_state = false;  ///< whether the maps were forced to 2-state
  Codecs codecs = {};
  /// The name of a planned triangle in the file; empty: it has none.
  std::function<std::string(std::size_t triangle)> name_of = {};
};

class SceneSubject : public Subject {
 public:
  SceneSubject(const Data& data, const std::string& topic)
      : Subject(topic, "impl", "what this project bakes, packs and codes of a scene"), data_(data) {}
  /// A subject of maps that another program has made.
  SceneSubject(const Data& data, const std::string& topic, const std::string& name)
      : Subject(topic, name, "maps that a file has"), data_(data) {}
  bool exact() const override { return true; }
  std::string fingerprint() const override;

 private:
  Data data_;
  mutable std::once_flag asked_;
  mutable std::string fingerprint_;
};

}  // namespace mmverify::proofs::scene
