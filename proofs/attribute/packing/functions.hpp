// What a subject of topic attribute may have of packed maps.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "proofs/engine/law.hpp"
#include "spec/attribute/compress.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::MapAt;
using spec::attribute::PackedShape;
using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// One value of packed maps, a code a channel and 0 beyond: of a map, a level up to the shape's, an index.
using ValueReader =
    std::function<std::array<std::uint8_t, 4>(std::uint32_t map, Level level, std::uint32_t index)>;

struct Compression {
  /// Codes to bytes.
  std::function<Bytes(const PackedShape&, ByteView codes)> pack = {};
  /// Bytes to codes; nothing where they are refused.
  std::function<std::optional<Bytes>(const PackedShape&, ByteView bytes)> unpack = {};
  /// Single values of bytes that unpack takes, which outlive the reader.
  std::function<ValueReader(const PackedShape&, ByteView bytes)> reader = {};
};

}  // namespace mmverify::proofs::attribute
