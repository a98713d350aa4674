// Common parts of the laws of topic dag: the check of a scene, and the scenes that it runs on.
#pragma once

#include "proofs/dag/checks.hpp"
#include "proofs/dag/scenes.hpp"

namespace mmverify::proofs::dag {

inline constexpr char form[] =
    "docs/DAG.md; after Common Subtree Merging Compressed Opacity Micromaps (HPG 2026), abstract";

/// The law on all small scenes of levels 0..4.
Law on_small_scenes(Law law, std::vector<Entry> entries, Check check);

/// The law on a scene for each set of mixed children, levels 4 to 6, long 7.
Law on_masks(Law law, std::vector<Entry> entries, Check check);

/// The law on `count` samples of each level.
Law on_samples(Law law, std::vector<Entry> entries, CaseCount count, Check check);

/// The law on scenes of many maps.
Law on_many_maps(Law law, std::vector<Entry> entries, Check check);

/// The law of scenes with more maps than one byte, and two bytes, can count.
Law many_maps_law();
/// The law of damaged codes of any form.
Law damaged_codes_law();

using Change = std::function<void(Functions&)>;
/// A built-in subject with one deliberate error.
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// A mutant that encodes another scene.
Change encodes_another(std::function<void(Scene& scene)> spoil);
/// Mutants that change the answers of one function; `scene` is the one that was encoded.
Change decodes_wrongly(std::function<void(Scene& scene)> spoil);
Change finds_wrongly(
    std::function<void(const Scene& scene, std::uint32_t map, std::uint32_t index, std::uint8_t& state)>
        spoil);
Change writes_wrongly(std::function<void(const Scene& scene, Bytes& bytes)> spoil);

}  // namespace mmverify::proofs::dag
