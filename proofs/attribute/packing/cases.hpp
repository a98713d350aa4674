// Maps for the laws of packed maps: a shape, and a pattern that fills it.
#pragma once

#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

/// The pattern of a map's codes.  Smooth and flat maps pack well, noise and extremes not at all; a lone value that
/// differs shows its place.
enum class Filling : std::uint32_t { flat, ramp, waves, noise, extremes, lone };
inline constexpr std::array fillings{Filling::flat,  Filling::ramp,     Filling::waves,
                                     Filling::noise, Filling::extremes, Filling::lone};

struct PackCase {
  PackedShape shape;
  Filling filling = Filling::flat;
  std::uint64_t seed = 0, number = 0;
};

/// Case k of a level: faces and vertices by turns, each filling, up to 4 channels, 3 maps, or 17 of levels up to 2.
/// `lossy`: the errors are not all 0, and now and then one is 127.
PackCase pack_case(Level n, std::uint64_t k, std::uint64_t seed, bool lossy);

/// The maps' codes.
Bytes codes_of(const PackCase& one);

/// A case as text, "faces:channels=3,maps=1,error=0/2/0/0,waves,seed=1,number=7".  pack_case_of() throws BadCase.
std::string text_of(const PackCase& one);
PackCase pack_case_of(Level n, const std::string& text);

/// The finding for the first difference of two sequences.  Domain: they differ.
Finding differ_at(ByteView expected, ByteView got, const char* what);

/// The cases of a law with that check.
Cases<PackCase> pack_cases(bool lossy,
                           std::function<Finding(const AttributeSubject&, Level, const PackCase&)> check);

extern const Entry pack_entry, unpack_entry, reader_entry;

/// A mutant whose packer, or unpacker, `by` makes from the real one.
using Packer = std::function<Bytes(const PackedShape&, ByteView)>;
using Unpacker = std::function<std::optional<Bytes>(const PackedShape&, ByteView)>;
std::function<void(Functions&)> packing(
    std::function<Bytes(const Packer& real, const PackedShape&, ByteView)> by);
std::function<void(Functions&)> unpacking(
    std::function<std::optional<Bytes>(const Unpacker& real, const PackedShape&, ByteView)> by);

}  // namespace mmverify::proofs::attribute
