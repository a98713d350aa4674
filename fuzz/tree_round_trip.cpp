// A map through every form of the tree, compared with the map and the specification.
//
// Input: a byte of level (its remainder by 8; the rest chooses the depths of a second form), a byte whose
// lowest bit means four states and whose rest chooses the form of the map: with bit 1, flat bytes as they are;
// else runs, a byte each: its low bits the state, the rest an exponent of 2 for the length.  Missing states
// are transparent.
//
// Covers: impl/tree/*
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "impl/index/index.hpp"
#include "impl/tree/container.hpp"
#include "impl/tree/tree.hpp"
#include "spec/tree/tree.hpp"

namespace {

namespace tree = mmverify::impl::tree;
namespace spec = mmverify::spec;
using Bytes = std::vector<std::uint8_t>;

void require(bool holds, const char* what, tree::Level n, std::uint32_t b, std::uint64_t index = 0) {
  if (holds) return;
  std::fprintf(stderr, "tree_round_trip: %s, level %u, %u bits a state, index %llu\n", what, n, b,
               static_cast<unsigned long long>(index));
  std::abort();
}

std::vector<std::uint8_t> drawn(const std::uint8_t* data, std::size_t size, bool flat, std::uint64_t count,
                                std::uint32_t b) {
  const std::uint32_t mask = (1u << b) - 1;
  std::vector<std::uint8_t> states;
  for (; size > 0 && states.size() < count; ++data, --size) {
    if (flat) {
      for (std::uint32_t bit = 0; bit < 8 && states.size() < count; bit += b)
        states.push_back(static_cast<std::uint8_t>(*data >> bit & mask));
    } else {
      for (std::uint64_t left = std::uint64_t{1} << (*data >> 2 & 15); left > 0 && states.size() < count;
           --left)
        states.push_back(static_cast<std::uint8_t>(*data & mask));
    }
  }
  states.resize(count);
  return states;
}

/// The packed bytes of states.  A byte has 8 / b of them, or all.
Bytes packed(const std::vector<std::uint8_t>& states, std::uint32_t b) {
  Bytes map((states.size() * b + 7) / 8);
  auto state = states.begin();
  for (std::uint8_t& byte : map)
    for (std::uint32_t bit = 0; bit < 8 && state != states.end(); bit += b)
      byte = static_cast<std::uint8_t>(byte | *state++ << bit);
  return map;
}

/// The numbers of all micro-triangles of the greatest level, made once.
const std::vector<std::uint32_t>& numbers() {
  static const std::vector<std::uint32_t> all = [] {
    std::vector<std::uint32_t> out(std::size_t{1} << 14);
    std::iota(out.begin(), out.end(), 0u);
    return out;
  }();
  return all;
}

/// For each micro-triangle which of two forms is asked, made once.
const std::vector<std::uint32_t>& forms_asked() {
  static const std::vector<std::uint32_t> all = [] {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t k : numbers()) out.push_back(k * 5 / 8 % 2);
    return out;
  }();
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const tree::Level n = data[0] % 8;
  const std::uint32_t b = 1 + (data[1] & 1);
  const auto bits = static_cast<tree::Format>(b);
  const std::uint64_t count = std::uint64_t{1} << (2 * n);
  const std::vector<std::uint8_t> states = drawn(data + 2, size - 2, (data[1] & 2) != 0, count, b);
  const Bytes map = packed(states, b);

  // The stream is the specification's, bit for bit; the specification is slow beyond level 5.
  const tree::Stream stream = tree::encode_stream(n, bits, map);
  if (n <= 5) {
    std::vector<spec::micromap::State> exact;
    for (const std::uint8_t state : states) exact.push_back(static_cast<spec::micromap::State>(state));
    const spec::tree::Succinct expected = spec::tree::encode(exact, n);
    Bytes all = stream.tree;
    all.insert(all.end(), stream.data.begin(), stream.data.end());
    require(stream.nodes == expected.tree.size() && stream.leaves == expected.data.size(), "counts", n, b);
    require(all == spec::tree::bytes(expected, b == 1 ? spec::micromap::Format::two_state
                                                      : spec::micromap::Format::four_state),
            "the stream's bytes", n, b);
  }

  Bytes out(map.size(), 0xee);
  require(tree::decode_stream(n, bits, stream, out) && out == map, "decode_stream", n, b);
  const tree::Tree form = tree::Tree::encode(n, bits, map);
  out.assign(map.size(), 0xee);
  form.decode(out);
  require(out == map, "Tree::decode", n, b);
  const Bytes container = tree::write(n, bits, map);
  require(container.size() <= map.size() + tree::container_header, "the container's size", n, b);
  require(tree::read(container).map == map, "the container", n, b);

  // Vectors of the exact size: the sanitizer sees any step over their ends.
  const auto last_asked = static_cast<std::ptrdiff_t>(count);
  const std::vector<std::uint32_t> index(numbers().begin(), numbers().begin() + last_asked),
      which(forms_asked().begin(), forms_asked().begin() + last_asked);
  std::vector<std::uint8_t> found(count, 0xee);
  form.lookup(index, found);
  require(found == states, "Tree::lookup", n, b);
  found.assign(count, 0xee);
  const tree::Level last = std::max<tree::Level>(n, 1) - 1, block = data[0] / 8 % (last + 1);
  const tree::Tree other = tree::Tree::encode(n, bits, map, {data[1] / 4 % (block + 1), block});
  out.assign(map.size(), 0xee);
  other.decode(out);
  require(out == map, "Tree::decode of chosen depths", n, b);
  const tree::Tree* const forms[] = {&form, &other};
  tree::lookup(forms, which, index, found);
  require(found == states, "lookup in many", n, b);
  // Algorithm 3 is slow: every 1st, 2nd, 4th ... state is looked up, so that all levels cost alike.
  for (std::uint64_t k = 0; k < count; k += 1 + count / 512)
    require(tree::lookup_stream(n, bits, stream, k) == states[k] && form[k] == states[k], "a lookup", n, b,
            k);
  for (std::uint32_t k = 0; k < count; k += 1 + static_cast<std::uint32_t>(count / 64)) {
    // The middle of a micro-triangle: thirds are no floats, but far from every line.
    const auto corner = mmverify::impl::index::corners(k, n);
    const float N = static_cast<float>(1u << n) * 3;
    const float u = static_cast<float>(corner[0].i + corner[1].i + corner[2].i) / N;
    const float v = static_cast<float>(corner[0].j + corner[1].j + corner[2].j) / N;
    require(form.at(u, v) == states[k], "at a point", n, b, k);
  }
  return 0;
}
