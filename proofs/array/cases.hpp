// Cases for builders: all small arrays, samples of large ones, and the texts that name them.
#pragma once

#include "proofs/array/subject.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::array {

/// All maps of levels 0 .. n, level 0 first: 6, and at level 1 272 more.  Domain: n in 0, 1.
const std::vector<PackedMap>& all_maps(Level n);
/// The maps of all_maps(n) whose states do not descend along the curve: 6, and at level 1 40 more.
const std::vector<PackedMap>& sorted_maps(Level n);

/// All small arrays.  Domain: n in 0, 1; k below the number.
///   level 0: none to three triangles of all maps of level 0; special indices, sharing and a base triangle of 1
///            behind one record, each on and off; indices of 8, 16 and 32 bits: 259 x 8 x 3
///   level 1: maps of levels 0 and 1. One and two triangles of all 278, with special indices and sharing; one and two
///            of the 46 sorted ones with the other seven choices; three of the sorted ones with special indices and
///            sharing; each with indices of 8, 16 and 32 bits: (278 + 278^2 + 7 (46 + 46^2) + 46^3) x 3
/// Three triangles need the sorted maps only.  A third triangle changes who shares with whom, which depends on
/// whether maps are equal and not on where their states lie.  One and two triangles cover every place of a state.
std::uint64_t small_arrays(Level n);
BuildCase small_array(Level n, std::uint64_t k);

/// Every array of three triangles of all maps of levels 0 and 1, with special indices and sharing and each width:
/// 278^3 x 3.
std::uint64_t whole_small_arrays();
BuildCase whole_small_array(std::uint64_t k);

/// Up to 40 maps of levels up to n behind up to 5 records, many of them equal or nearly so, of any encoding, API,
/// base triangle and choice.  The bound of merging is at most `bound`.  Sample k of a seed is the same everywhere.
BuildCase sample_array(Level n, std::uint64_t seed, std::uint64_t k, std::uint32_t bound);

/// A map of a level up to n, of any kind that the samples of topic tree have.
PackedMap any_map(Level n, Random& random);

/// A case as text, "khr,u8,special,share,base=0,bound=0,before:2-state:1,4-state:0123,...": the choices, then the
/// maps with one digit a state.
std::string text_of(const BuildCase& c);
/// The case of a text; throws BadCase.
BuildCase case_of(const std::string& text);

/// u8, u16, u32, i16, i32.
const char* name_of(Encoding e);

/// The states of a map, and a map of states.
States states_of(const PackedMap& m);
PackedMap packed(Level level, Format format, const States& states);

/// "sample:SEED:K".  Throws BadCase.
std::string text_of_sample(std::uint64_t seed, std::uint64_t k);
std::pair<std::uint64_t, std::uint64_t> sample_of(const std::string& text);

/// The array and the geometry that the specification builds from a case.
Bundle bundle_of(const BuildCase& c);

/// Any array with any geometries.  It has up to 45 records of maps of levels up to n, or up to 600 of level 0.  Each
/// map has bytes of its own, in any order and with gaps.  None to eight geometries have any encoding and base
/// triangle, and up to 40 triangles each, with special indices and records in any order.  Sample k of a seed is the
/// same everywhere.
Bundle sample_bundle(Level n, std::uint64_t seed, std::uint64_t k);

/// The first difference of two bundles in geometries, triangles or targets, as words for `was` and for `is`.
std::optional<std::pair<std::string, std::string>> resolved_differently(const Bundle& was, const Bundle& is);

}  // namespace mmverify::proofs::array
