// What the laws of topic dag are put together from: a check of one scene, and the scenes that it is run on.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/dag/checks.hpp"
#include "proofs/dag/scenes.hpp"

namespace mmverify::proofs::dag {

inline constexpr char form[] =
    "docs/DAG.md; after Common Subtree Merging Compressed Opacity Micromaps (HPG 2026), abstract";

/// The law, on all small scenes of levels 0..4.
Law on_small_scenes(Law law, std::vector<Entry> entries, Check check);

/// The law, on a scene for each set of mixed children, levels 4 to 6, long 7.
Law on_masks(Law law, std::vector<Entry> entries, Check check);

/// The law, on so many samples of each level.
Law on_samples(Law law, std::vector<Entry> entries, std::function<std::uint64_t(Level)> count, Check check);

/// The law, on scenes of many maps.
Law on_many_maps(Law law, std::vector<Entry> entries, Check check);

/// Numbers of maps beyond one byte and two.
Law many_maps_law();
/// Codes of any form, damaged.
Law damaged_codes_law();

/// A built-in subject with one thing broken on purpose.
using Change = std::function<void(Functions&)>;
Mutant mutant(const char* name, const char* base, Levels levels, const Change& change);

/// Another scene is encoded.
Change encodes_another(std::function<void(Scene& scene)> spoil);
/// One function's answers, changed; `scene` is the one that the code is of.
Change decodes_wrongly(std::function<void(Scene& scene)> spoil);
Change finds_wrongly(
    std::function<void(const Scene& scene, std::uint32_t map, std::uint32_t index, std::uint8_t& state)>
        spoil);
Change writes_wrongly(std::function<void(const Scene& scene, Bytes& bytes)> spoil);

}  // namespace mmverify::proofs::dag
