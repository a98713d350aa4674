// The laws on a scene's own data, a file each.
#pragma once

#include <optional>
#include <vector>

#include "proofs/scene/subject.hpp"

namespace mmverify::proofs::scene {

/// How many micro-triangles a law of baking looks at, as many of each level that occurs; none: all.
struct BakeSample {
  std::optional<std::uint64_t> size;
};

// `data` outlives the laws.
std::vector<Law> bake_laws(const Data& data, const BakeSample& sample);
std::vector<Law> array_laws(const Data& data);
std::vector<Law> tree_laws(const Data& data);
std::vector<Law> vq_laws(const Data& data);

}  // namespace mmverify::proofs::scene
