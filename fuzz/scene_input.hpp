// A glTF file made from a fuzzer's bytes.
//
// Input: 'r', then a file as it is; or anything else, then JSON up to a zero byte, then the BIN chunk, which
// are put into a GLB here, since few inputs would get past a container's lengths.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace mmverify::fuzz::scene {

using Bytes = std::vector<unsigned char>;

inline constexpr const char* name = "input.glb";

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "scene: %s\n", what.c_str());
  std::abort();
}

inline Bytes as_file(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return {};
  if (*data == 'r') return {data + 1, data + size};
  const std::uint8_t* const json_end = std::find(data + 1, data + size, std::uint8_t{0});
  const std::uint8_t* const binary = std::min(json_end + 1, data + size);
  Bytes file{'g', 'l', 'T', 'F'};
  const auto put_word = [&](std::size_t word) {
    for (int k = 0; k < 4; ++k) file.push_back(static_cast<unsigned char>(word >> (8 * k)));
  };
  const auto put_chunk = [&](std::size_t type, const std::uint8_t* first, const std::uint8_t* last,
                             unsigned char padding) {
    const auto length = static_cast<std::size_t>(last - first);
    put_word((length + 3) / 4 * 4);
    put_word(type);
    file.insert(file.end(), first, last);
    file.resize((file.size() + 3) / 4 * 4, padding);
  };
  put_word(2);
  put_word(0);
  put_chunk(0x4E4F534A, data + 1, json_end, ' ');
  put_chunk(0x004E4942, binary, data + size, 0);
  for (std::size_t k = 0; k < 4; ++k) file[8 + k] = static_cast<unsigned char>(file.size() >> (8 * k));
  return file;
}

}  // namespace mmverify::fuzz::scene
