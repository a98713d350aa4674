// How vectors, maps and blocks are written in a case.
#pragma once

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// "TTCO", a letter a region in the order of its number, and back.  Throws BadCase.
std::string letters(std::span<const State> states);
std::vector<State> states_from_letters(std::string_view text, std::size_t count);

/// `count` bytes, of a text of "NAME:" and two digits each.  Throws BadCase.
std::vector<std::uint8_t> bytes_after(std::string_view name, const std::string& text, std::size_t count);

/// "map:" and two bits a region, T 0, C 1, O 2, region k in bits 2k and 2k+1, low bits first.
template <class Format>
std::string text_of_map(const Map<Format>& map) {
  std::vector<std::uint8_t> packed(map.size() / 4);
  for (std::size_t k = 0; k < map.size(); ++k)
    packed[k / 4] = static_cast<std::uint8_t>(packed[k / 4] | static_cast<unsigned>(map[k]) << 2 * (k % 4));
  return "map:" + hex(packed);
}

template <class Format>
Map<Format> map_from_text(const std::string& text) {
  Map<Format> map;
  const auto packed = bytes_after("map", text, map.size() / 4);
  for (std::size_t k = 0; k < map.size(); ++k) {
    const unsigned state = packed[k / 4] >> 2 * (k % 4) & 3;
    if (state == 3) throw BadCase("'" + text.substr(0, 60) + "': a state is 0, 1 or 2");
    map[k] = static_cast<State>(state);
  }
  return map;
}

/// "block:" and the block's bytes.
template <class Format>
std::string text_of_block(const BlockBytes<Format>& block) {
  return "block:" + hex(block);
}

template <class Format>
BlockBytes<Format> block_from_text(const std::string& text) {
  BlockBytes<Format> block;
  const auto bytes = bytes_after("block", text, block.size());
  std::copy(bytes.begin(), bytes.end(), block.begin());
  return block;
}

}  // namespace mmverify::proofs::vq
