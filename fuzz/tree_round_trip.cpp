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

#include "fuzz/share.hpp"
#include "impl/index/index.hpp"
#include "impl/tree/container.hpp"
#include "impl/tree/tree.hpp"
#include "spec/tree/tree.hpp"

namespace {

namespace tree = mmverify::impl::tree;
namespace spec = mmverify::spec;
using Bytes = std::vector<std::uint8_t>;

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

struct Case {
  tree::Level n;
  std::uint32_t b;
  std::vector<std::uint8_t> states;
  Bytes map;

  tree::Format format() const { return static_cast<tree::Format>(b); }
  void require(bool holds, const char* what, std::uint64_t index = 0) const {
    if (holds) return;
    std::fprintf(stderr, "tree_round_trip: %s, level %u, %u bits a state, index %llu\n", what, n, b,
                 static_cast<unsigned long long>(index));
    std::abort();
  }
};

/// Compares the stream with the specification's, bit for bit.
void check_stream(const Case& c, const tree::Stream& stream) {
  std::vector<spec::micromap::State> exact;
  for (const std::uint8_t state : c.states) exact.push_back(static_cast<spec::micromap::State>(state));
  const spec::tree::Succinct expected = spec::tree::encode(exact, c.n);
  Bytes all = stream.tree;
  all.insert(all.end(), stream.data.begin(), stream.data.end());
  c.require(stream.nodes == expected.tree.size() && stream.leaves == expected.data.size(), "counts");
  c.require(all == spec::tree::bytes(expected, c.b == 1 ? spec::micromap::Format::two_state
                                                        : spec::micromap::Format::four_state),
            "the stream's bytes");
}

/// Looks up all states in batches, of one form and of two.
void check_batches(const Case& c, const tree::Tree& form, const tree::Tree& other) {
  // Vectors of the exact size: the sanitizer sees any step over their ends.
  const auto count = static_cast<std::ptrdiff_t>(c.states.size());
  const std::vector<std::uint32_t> index(numbers().begin(), numbers().begin() + count),
      which(forms_asked().begin(), forms_asked().begin() + count);
  std::vector<std::uint8_t> found(c.states.size(), 0xee);
  form.lookup(index, found);
  c.require(found == c.states, "Tree::lookup");
  found.assign(c.states.size(), 0xee);
  const tree::Tree* const forms[] = {&form, &other};
  tree::lookup(forms, which, index, found);
  c.require(found == c.states, "lookup in many");
}

/// Looks up one state in the stream and in the tree, by its number and by a point.
void check_one(const Case& c, const tree::Stream& stream, const tree::Tree& form, std::uint32_t k) {
  c.require(tree::lookup_stream(c.n, c.format(), stream, k) == c.states[k] && form[k] == c.states[k],
            "a lookup", k);
  // The middle of a micro-triangle: thirds are no floats, but far from every line.
  const auto corner = mmverify::impl::index::corners(k, c.n);
  const float N = static_cast<float>(1u << c.n) * 3;
  const float u = static_cast<float>(corner[0].i + corner[1].i + corner[2].i) / N;
  const float v = static_cast<float>(corner[0].j + corner[1].j + corner[2].j) / N;
  c.require(form.at(u, v) == c.states[k], "at a point", k);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  Case c{data[0] % 8u, 1 + (data[1] & 1u), {}, {}};
  const auto count = static_cast<std::uint32_t>(1u << 2 * c.n);
  c.states = drawn(data + 2, size - 2, (data[1] & 2) != 0, count, c.b);
  c.map = packed(c.states, c.b);

  const tree::Stream stream = tree::encode_stream(c.n, c.format(), c.map);
  // The specification is slow beyond level 5.
  if (c.n <= 5) check_stream(c, stream);
  Bytes out(c.map.size(), 0xee);
  c.require(tree::decode_stream(c.n, c.format(), stream, out) && out == c.map, "decode_stream");
  const tree::Tree form = tree::Tree::encode(c.n, c.format(), c.map);
  out.assign(c.map.size(), 0xee);
  form.decode(out);
  c.require(out == c.map, "Tree::decode");
  const Bytes container = tree::write(c.n, c.format(), c.map);
  c.require(container.size() <= c.map.size() + tree::container_header, "the container's size");
  c.require(tree::read(container).map == c.map, "the container");
  const tree::Level last = std::max<tree::Level>(c.n, 1) - 1, block = data[0] / 8 % (last + 1);
  const tree::Tree other = tree::Tree::encode(c.n, c.format(), c.map, {data[1] / 4 % (block + 1), block});
  out.assign(c.map.size(), 0xee);
  other.decode(out);
  c.require(out == c.map, "Tree::decode of chosen depths");
  check_batches(c, form, other);
  // Algorithm 3 is slow: above level 3 it finds 64 states, from one on that all bytes of the input choose.
  const std::uint32_t step = c.n < 4 ? 1 : count / 64;
  for (std::uint32_t k = mmverify::fuzz::Share(data, size).below(step); k < count; k += step)
    check_one(c, stream, form, k);
  return 0;
}
