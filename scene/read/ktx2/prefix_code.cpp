#include "scene/read/ktx2/prefix_code.hpp"

namespace mmverify::scene {

PrefixCode::PrefixCode(std::span<const std::uint8_t> lengths) {
  for (const std::uint8_t length : lengths)
    if (length != 0) ++counts_[length];
  std::uint32_t room = 1;
  for (unsigned length = 1; length <= longest; ++length) {
    room *= 2;
    if (counts_[length] > room) throw DamagedPicture("a Huffman table has more codes than its lengths allow");
    room -= counts_[length];
  }
  std::array<std::uint32_t, longest + 2> next{};
  for (unsigned length = 1; length <= longest; ++length) next[length + 1] = next[length] + counts_[length];
  symbols_.resize(next[longest + 1]);
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
    if (lengths[symbol] != 0) symbols_[next[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
}

std::uint32_t PrefixCode::take(LowBits& bits) const {
  // `code` counts from the first code of its length.
  std::uint32_t code = 0, before = 0;
  for (unsigned length = 1; length <= longest; ++length) {
    code = code << 1 | bits.take(1);
    if (code < counts_[length]) return symbols_[before + code];
    code -= counts_[length];
    before += counts_[length];
  }
  throw DamagedPicture("bits that are no Huffman code");
}

PrefixCode take_prefix_code(LowBits& bits) {
  constexpr std::uint8_t order[] = {17, 18, 19, 20, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15, 16};
  constexpr std::size_t length_symbols = std::size(order);
  // A run repeats 0 or the length before it: `least` times and as often as its bits say.
  struct Run {
    unsigned least, bits;
    bool of_zeros;
  };
  constexpr std::uint32_t first_run = 17;
  constexpr Run runs[] = {{3, 3, true}, {11, 7, true}, {3, 2, false}, {7, 7, false}};
  const std::uint32_t symbols = bits.take(14);
  if (symbols == 0) return {};
  const std::uint32_t given = bits.take(5);
  if (given == 0 || given > length_symbols)
    throw DamagedPicture("a Huffman table of " + std::to_string(given) + " lengths of lengths");
  std::uint8_t lengths_of_lengths[length_symbols] = {};
  for (std::uint32_t k = 0; k < given; ++k)
    lengths_of_lengths[order[k]] = static_cast<std::uint8_t>(bits.take(3));
  const PrefixCode code_of_lengths{lengths_of_lengths};
  std::vector<std::uint8_t> lengths;
  while (lengths.size() < symbols) {
    const std::uint32_t symbol = code_of_lengths.take(bits);
    if (symbol < first_run) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
      continue;
    }
    const Run& run = runs[symbol - first_run];
    if (!run.of_zeros && (lengths.empty() || lengths.back() == 0))
      throw DamagedPicture("a Huffman table repeats a length before the first one");
    const std::uint8_t length = run.of_zeros ? std::uint8_t{0} : lengths.back();
    lengths.insert(lengths.end(), run.least + bits.take(run.bits), length);
  }
  if (lengths.size() != symbols)
    throw DamagedPicture("a Huffman table of " + std::to_string(symbols) + " symbols has lengths for " +
                         std::to_string(lengths.size()));
  return PrefixCode(lengths);
}

}  // namespace mmverify::scene
