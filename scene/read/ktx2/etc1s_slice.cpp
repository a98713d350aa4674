#include <algorithm>

#include "scene/read/damaged_picture.hpp"
#include "scene/read/ktx2/etc1s.hpp"

namespace mmverify::scene {
namespace {

/// A number in groups of bits, the lowest first; the highest bit of a group says that another one follows.
std::uint32_t take_groups(LowBits& bits, unsigned group) {
  std::uint64_t value = 0;
  for (unsigned at = 0; at < 32; at += group) {
    const std::uint32_t taken = bits.take(group + 1);
    value |= std::uint64_t{taken & ((1u << group) - 1)} << at;
    if (taken >> group == 0) return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, 0xffffffff));
  }
  throw DamagedPicture("a length of more than 32 bits");
}

/// Selectors that were used lately: new ones replace those of the back half, used ones move forward.
class SelectorHistory {
 public:
  explicit SelectorHistory(std::size_t size) : all_(size), next_(size / 2) {}

  void add(std::uint32_t selectors) {
    if (all_.empty()) return;
    all_[next_] = selectors;
    if (++next_ == all_.size()) next_ = all_.size() / 2;
  }

  std::uint32_t use(std::size_t k) {
    if (k >= all_.size()) throw DamagedPicture("a selector beyond the history");
    const std::uint32_t selectors = all_[k];
    std::swap(all_[k], all_[k / 2]);
    return selectors;
  }

 private:
  std::vector<std::uint32_t> all_;
  std::size_t next_;
};

/// The state of a slice between its blocks, which come row by row.
class SliceReader {
 public:
  SliceReader(const Etc1sCodebooks& books, Ktx2Bytes slice, std::size_t across)
      : books_(books), bits_(slice), below_((across + 1) / 2), above_(across), history_(books.history) {}

  /// Precondition: the blocks before it were read.
  Etc1sBlock next(std::size_t x, std::size_t y) {
    if (x % 2 == 0) begin_square(x / 2, y);
    const std::uint32_t prediction = square_ & 3;
    square_ >>= 2;
    const std::uint32_t end = end_of(prediction, x, y), selectors = next_selectors();
    if (end >= books_.ends.size() || selectors >= books_.selectors.size())
      throw DamagedPicture("a block of endpoint " + std::to_string(end) + " and selector " +
                           std::to_string(selectors) + ", the codebooks have " +
                           std::to_string(books_.ends.size()) + " and " +
                           std::to_string(books_.selectors.size()));
    above_left_ = above_[x];
    above_[x] = left_ = end;
    return {static_cast<std::uint16_t>(end), static_cast<std::uint16_t>(selectors)};
  }

 private:
  /// Predictions of 2 x 2 blocks, 2 bits each: the even row reads them, the odd row has the upper half.
  void begin_square(std::size_t column, std::size_t y) {
    constexpr std::uint32_t repeat = 256, least_repeats = 3;
    if (y % 2 == 1) {
      square_ = below_[column];
      return;
    }
    if (repeats_ > 0) {
      --repeats_;
    } else {
      const std::uint32_t symbol = books_.predictions.take(bits_);
      if (symbol > repeat) throw DamagedPicture("a prediction of " + std::to_string(symbol));
      if (symbol == repeat)
        repeats_ = std::uint64_t{take_groups(bits_, 4)} + least_repeats - 1;
      else
        last_square_ = symbol;
    }
    square_ = last_square_;
    below_[column] = static_cast<std::uint8_t>(square_ >> 4);
  }

  std::uint32_t end_of(std::uint32_t prediction, std::size_t x, std::size_t y) {
    constexpr std::uint32_t from_left = 0, from_above = 1, from_above_left = 2;
    if ((x == 0 && (prediction == from_left || prediction == from_above_left)) ||
        (y == 0 && (prediction == from_above || prediction == from_above_left)))
      throw DamagedPicture("a block that is predicted from outside the picture");
    if (prediction == from_left) return left_;
    if (prediction == from_above) return above_[x];
    if (prediction == from_above_left) return above_left_;
    const std::uint64_t end = std::uint64_t{left_} + books_.end_steps.take(bits_), count = books_.ends.size();
    return static_cast<std::uint32_t>(end >= count ? end - count : end);
  }

  std::uint32_t next_selectors() {
    constexpr std::uint32_t long_run = 63, least_run = 3;
    const std::size_t count = books_.selectors.size(), run = count + books_.history;
    if (run_ > 0) {
      --run_;
      return history_.use(0);
    }
    const std::uint32_t symbol = books_.selector_symbols.take(bits_);
    if (symbol < count) {
      history_.add(symbol);
      return symbol;
    }
    if (symbol != run) return history_.use(symbol - count);
    const std::uint32_t length = books_.run_lengths.take(bits_);
    run_ = std::uint64_t{length == long_run ? take_groups(bits_, 7) : length} + least_run - 1;
    return history_.use(0);
  }

  const Etc1sCodebooks& books_;
  LowBits bits_;
  std::uint32_t square_ = 0, last_square_ = 0, left_ = 0, above_left_ = 0;
  std::uint64_t repeats_ = 0, run_ = 0;
  std::vector<std::uint8_t> below_;
  std::vector<std::uint32_t> above_;
  SelectorHistory history_;
};

}  // namespace

std::vector<Etc1sBlock> etc1s_blocks(const Etc1sCodebooks& books, Ktx2Bytes slice, std::uint32_t width,
                                     std::uint32_t height) {
  const std::size_t across = (std::size_t{width} + 3) / 4, down = (std::size_t{height} + 3) / 4;
  SliceReader reader(books, slice, across);
  std::vector<Etc1sBlock> blocks;
  for (std::size_t y = 0; y < down; ++y)
    for (std::size_t x = 0; x < across; ++x) blocks.push_back(reader.next(x, y));
  return blocks;
}

RgbaTexels texels_of_etc1s(const Etc1sEnd& end, const Etc1sSelectors& selectors) {
  constexpr int modifiers[8][2] = {{2, 8},   {5, 17},  {9, 29},   {13, 42},
                                   {18, 60}, {24, 80}, {33, 106}, {47, 183}};
  const auto& [a, b] = modifiers[end.table];
  const int steps[] = {-b, -a, a, b};
  RgbaTexels texels;
  for (std::size_t t = 0; t < 16; ++t) {
    const int step = steps[selectors[t / 4] >> (2 * (t % 4)) & 3];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int base = end.colour[channel] << 3 | end.colour[channel] >> 2;
      texels[t][channel] = static_cast<std::uint8_t>(std::clamp(base + step, 0, 255));
    }
    texels[t][3] = 255;
  }
  return texels;
}

}  // namespace mmverify::scene
