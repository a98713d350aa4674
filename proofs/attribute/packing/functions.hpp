// The functions of a subject of topic attribute for packed maps.
#pragma once

#include "proofs/engine/law.hpp"
#include "spec/attribute/compress.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::MapAt;
using spec::attribute::PackedShape;
using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// Reads one value of packed maps, by map, level up to the shape's, and index: one code a channel, 0 beyond.
using ValueReader =
    std::function<std::array<std::uint8_t, 4>(std::uint32_t map, Level level, std::uint32_t index)>;

struct Compression {
  /// Codes to bytes.
  std::function<Bytes(const PackedShape&, ByteView codes)> pack = {};
  /// Bytes to codes; nothing if the bytes are refused.
  std::function<std::optional<Bytes>(const PackedShape&, ByteView bytes)> unpack = {};
  /// A reader of single values; the bytes outlive it.  Domain: unpack takes the bytes.
  std::function<ValueReader(const PackedShape&, ByteView bytes)> reader = {};
};

}  // namespace mmverify::proofs::attribute
