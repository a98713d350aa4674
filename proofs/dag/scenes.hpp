// The scenes that the laws range over, and the text that names one on the command line.
#pragma once

#include "proofs/dag/subject.hpp"

namespace mmverify::proofs::dag {

/// Small scenes of a level, all of them:
///   0, 1  all ordered pairs of maps, 2-state and 4-state
///   2     all 2-state maps, one each
///   3     all ordered pairs of T, O, UO (4-state alone) and two tiles that are not of one state
///   4     all ordered pairs of maps of four tiles, each T or one of two that are not of one state; and each such map of T
///         and four others: those with three of them or more are laid flat
/// Domain: n in 0..4.
std::uint64_t small_scenes(Level n);
/// Domain: k < small_scenes(n).
Scene small_scene(Level n, std::uint64_t k);
std::string about_small_scenes(Level n);

/// Maps of which each set of children is mixed: scene k has one map of level n, 2-state for even k, and child c of the root
/// is mixed where bit c of k / 2 is set.  No two mixed ones are the same; the others have one state each.
/// Domain: n in 4..7.
constexpr std::uint64_t mask_scenes(Level n) { return std::uint64_t{2} << spec::dag::children(n); }
Scene mask_scene(Level n, std::uint64_t k);

/// Up to five maps of levels up to n, the last of level n: noise, few states among many, tiles and larger subtrees that
/// repeat, maps that were there already, and such with one state changed.  Both formats.  Sample k of a seed is the same
/// everywhere.
Scene sample_scene(Level n, std::uint64_t seed, std::uint64_t k);

/// Some hundred maps of levels up to n, at level 0 of some samples more than 2^16: numbers of maps of two and of three bytes.
/// Each state is drawn on its own.  Sample k of a seed is the same everywhere.
Scene many_maps(Level n, std::uint64_t seed, std::uint64_t k);

/// "k=17", and "sample:SEED:K".
std::string text_of_number(std::uint64_t k);
std::string text_of_sample(std::uint64_t seed, std::uint64_t k);
/// Throw BadCase, saying what is wrong with the text.
std::uint64_t number_from_text(const std::string& text, std::uint64_t limit);
std::pair<std::uint64_t, std::uint64_t> sample_from_text(const std::string& text);

}  // namespace mmverify::proofs::dag
