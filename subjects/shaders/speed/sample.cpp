#include "subjects/shaders/speed/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "impl/index/index.hpp"

namespace mmverify::shaders {
namespace {

/// Whether these words are the inputs of the hit at micro-triangle `number` of level 16 on the curve.
bool is_hit(const Lookup& lookup, std::uint32_t number, const std::uint32_t* in) {
  constexpr std::uint32_t deepest = 16;
  const auto point = [](const std::uint32_t* uv) {
    return impl::index::from_barycentrics(std::bit_cast<float>(uv[0]), std::bit_cast<float>(uv[1]), deepest);
  };
  // At level 0 all 32 bits go.
  const auto above = [number](std::uint32_t level) {
    return static_cast<std::uint32_t>(std::uint64_t{number} >> 2 * (deepest - level));
  };
  switch (lookup.inputs) {
    case Inputs::points: return point(in) == number;
    case Inputs::points_of_map: return in[0] == 0 && point(in + 1) == number;
    case Inputs::indices: return in[0] == above(*lookup.level);
    case Inputs::square: break;
  }
  std::uint32_t cell = 0;
  for (std::uint32_t bit = 0; bit < lookup.side; ++bit)
    cell |= (in[0] >> bit & 1u) << 2 * bit | (in[1] >> bit & 1u) << (2 * bit + 1);
  return cell == above(lookup.side) && std::max(in[0], in[1]) >> lookup.side == 0;
}

std::string name_of(const Lookup& lookup) {
  return lookup.level ? fmt::format("{} at level {}", lookup.name, *lookup.level) : lookup.name;
}

/// Compares the hits from `first` on.
void compare(OnDevice& device, const Lookup& lookup, std::uint64_t hits, Order order, std::uint64_t first,
             std::uint64_t count) {
  std::vector<std::vector<std::uint32_t>> inputs;
  for (std::uint32_t k = 0; k < lookup.words_in; ++k) inputs.push_back(device.words(k, first, count));
  const auto answers = device.words(answer_binding, first * lookup.words_out, count * lookup.words_out);
  const auto log_hits = static_cast<std::uint32_t>(std::countr_zero(hits));
  std::vector<std::uint32_t> in(lookup.words_in), right(lookup.words_out);
  for (std::uint64_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j < in.size(); ++j) in[j] = inputs[j][k];
    const std::uint32_t number = place(static_cast<std::uint32_t>(first + k), log_hits, order)
                                 << (32 - log_hits);
    if (!is_hit(lookup, number, in.data()))
      throw WrongAnswer(
          fmt::format("{}: hit {} of {}: the device made inputs {:#x} that are not micro-triangle {}",
                      name_of(lookup), first + k, hits, fmt::join(in, ", "), number));
    lookup.right(in.data(), right.data());
    const std::uint32_t* const got = &answers[k * right.size()];
    if (!std::equal(right.begin(), right.end(), got))
      throw WrongAnswer(
          fmt::format("{}: hit {} of {}, inputs {:#x}: the device answers {:#x}, the library {:#x}",
                      name_of(lookup), first + k, hits, fmt::join(in, ", "),
                      fmt::join(got, got + right.size(), ", "), fmt::join(right, ", ")));
  }
}

}  // namespace

std::uint32_t place(std::uint32_t k, std::uint32_t log_hits, Order order) {
  if (order == Order::coherent) return k;
  const std::uint32_t mask = (std::uint32_t{1} << log_hits) - 1, shift = (log_hits + 1) / 2;
  k = (k * 0x9e3779b1u) & mask;
  k ^= k >> shift;
  k = (k * 0x85ebca6bu) & mask;
  return k ^ k >> shift;
}

std::uint64_t compare_sample(OnDevice& device, const Lookup& lookup, std::uint64_t hits, Order order) {
  constexpr std::uint64_t blocks = 64, block = 1024;
  if (hits <= blocks * block) {
    compare(device, lookup, hits, order, 0, hits);
    return hits;
  }
  for (std::uint64_t k = 0; k < blocks; ++k)
    compare(device, lookup, hits, order, (hits - block) * k / (blocks - 1), block);
  return blocks * block;
}

}  // namespace mmverify::shaders
