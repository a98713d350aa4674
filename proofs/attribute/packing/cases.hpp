// Maps that the laws of packed maps are asked about: a shape, and a pattern that fills it.
#pragma once

#include <string>

#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

/// How maps are filled: smooth and flat ones pack well, noise and extremes not at all, and one value that differs shows
/// each place.
enum class Filling : std::uint32_t { flat, ramp, waves, noise, extremes, lone };
inline constexpr std::array fillings{Filling::flat,  Filling::ramp,     Filling::waves,
                                     Filling::noise, Filling::extremes, Filling::lone};

struct PackCase {
  PackedShape shape;
  Filling filling = Filling::flat;
  std::uint64_t seed = 0, number = 0;
};

/// Case k of a level: faces and vertices by turns, each filling, up to 4 channels, 3 maps or 17 of levels up to 2.
/// `lossy`: with errors, one of them 127 now and then; else all 0.
PackCase pack_case(Level n, std::uint64_t k, std::uint64_t seed, bool lossy);

/// The maps' codes.
Bytes codes_of(const PackCase& one);

/// "faces:channels=3,maps=1,error=0/2/0/0,waves,seed=1,number=7", and back; throws BadCase.
std::string text_of(const PackCase& one);
PackCase pack_case_of(Level n, const std::string& text);

/// Where the first of two sequences differs, in words; both are not equal.
Finding differ_at(ByteView expected, ByteView got, const char* what);

/// Cases of a law whose checks are such.
Cases<PackCase> pack_cases(bool lossy,
                           std::function<Finding(const AttributeSubject&, Level, const PackCase&)> check);

extern const Entry pack_entry, unpack_entry, reader_entry;

/// A subject that packs, unpacks otherwise: given the real function's.
using Packer = std::function<Bytes(const PackedShape&, ByteView)>;
using Unpacker = std::function<std::optional<Bytes>(const PackedShape&, ByteView)>;
std::function<void(Functions&)> packing(
    std::function<Bytes(const Packer& real, const PackedShape&, ByteView)> by);
std::function<void(Functions&)> unpacking(
    std::function<std::optional<Bytes>(const Unpacker& real, const PackedShape&, ByteView)> by);

}  // namespace mmverify::proofs::attribute
