// Tree subjects that are broken on purpose: another one's answers, changed.
#pragma once

#include <functional>

#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// What is changed; what is empty is left alone.
struct Change {
  std::function<void(Map&)> encode = {};                ///< the map, before it is encoded
  std::function<void(const Map&, Bytes&)> decode = {};  ///< the decoded map
  std::function<void(const Map&, std::uint32_t, std::uint8_t&)> lookup = {};  ///< map, index: the state
  std::function<void(const Map&, std::span<std::uint8_t>)> batch = {};        ///< map: the states of one call
  std::function<void(const Map&, float, float, std::uint8_t&)> point = {};    ///< map, u, v: the state
  std::function<void(const Map&, Bytes&)> bytes = {};                         ///< the code's bytes
  std::function<CodePtr(Level, Format, std::span<const std::uint8_t>, CodePtr)> open = {};
  /// Level, index, true number.
  std::function<std::uint64_t(Level, std::uint64_t, std::uint64_t)> reads = {};
};

TreeSubjectPtr altered(const std::string& name, const std::string& base, Change change);

Mutant mutant(const char* name, const char* base, Levels levels, Change change);

}  // namespace mmverify::proofs::tree
