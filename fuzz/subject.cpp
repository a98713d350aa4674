// Someone else's codec or index function under attack: the shared library that MMVERIFY_SUBJECT names, behind
// subjects/sdk/mmverify_subject.h.  Build it with -fsanitize=fuzzer-no-link,address and the fuzzer sees its branches
// and its overruns; without the flags, it still sees its answers.
//
// Input: a byte that chooses the question, and the question's arguments.  Entry points that the library lacks
// are skipped.
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "impl/index/index.hpp"
#include "impl/micromap/micromap.hpp"
#include "impl/tree/stream.hpp"
#include "impl/vq/vq.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

namespace fast = mmverify::impl;
using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void wrong(const char* law, const char* what) {
  std::fprintf(stderr, "fuzz_subject: %s: %s\n", law, what);
  std::abort();
}

const mmverify_subject_t& subject() {
  static const mmverify_subject_t* const loaded = [] {
    const char* const path = std::getenv("MMVERIFY_SUBJECT");
    void* const library = path == nullptr ? nullptr : dlopen(path, RTLD_NOW);
    const auto entry =
        library == nullptr
            ? nullptr
            : reinterpret_cast<decltype(&mmverify_subject_v1)>(dlsym(library, "mmverify_subject_v1"));
    if (entry == nullptr) {
      std::fprintf(stderr, "fuzz_subject: %s\n",
                   path == nullptr ? "set MMVERIFY_SUBJECT to the shared library to attack" : dlerror());
      std::_Exit(4);
    }
    // A subject built against an older header is shorter; its missing members are null here.
    static mmverify_subject_t whole{};
    const mmverify_subject_t* const given = entry();
    if (given == nullptr || given->abi != MMVERIFY_SUBJECT_ABI) {
      std::fprintf(stderr, "fuzz_subject: %s: %s\n", path, given == nullptr ? "no subject" : "another ABI");
      std::_Exit(4);
    }
    std::memcpy(&whole, given, std::min<std::size_t>(given->size, sizeof whole));
    return &whole;
  }();
  return *loaded;
}

/// The rest of the input; zeros after its end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  std::uint8_t next() { return at_ == end_ ? std::uint8_t{0} : *at_++; }
  bool left() const { return at_ != end_; }
  Bytes rest() const { return {at_, end_}; }
  float next_float() {
    std::uint32_t bits = 0;
    for (int k = 0; k < 4; ++k) bits |= std::uint32_t{next()} << (8 * k);
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }
  /// A coordinate k / (4 2^level), moved by up to 4 ulps.
  float near_grid(std::uint32_t level) {
    std::uint32_t k = 0;
    for (int byte = 0; byte < 3; ++byte) k |= std::uint32_t{next()} << (8 * byte);
    float x = std::ldexp(static_cast<float>(k % ((4u << level) + 1)), -static_cast<int>(level) - 2);
    for (int moves = next() % 9 - 4; moves != 0; moves += moves < 0 ? 1 : -1)
      x = std::nextafter(x, moves < 0 ? 0.0f : 2.0f);
    return x;
  }

 private:
  const std::uint8_t *at_, *end_;
};

/// States in runs, packed: a byte each, its low bits the state, the rest an exponent of 2 for the length.
Bytes drawn_map(Input& in, std::uint32_t level, std::uint32_t bits) {
  const std::size_t count = std::size_t{1} << (2 * level);
  Bytes map((count * bits + 7) / 8);
  std::size_t k = 0;
  while (in.left() && k < count) {
    const std::uint8_t run = in.next();
    for (std::size_t left = std::size_t{1} << (run >> 2 & 15); left > 0 && k < count; --left, ++k)
      map[k * bits / 8] =
          static_cast<std::uint8_t>(map[k * bits / 8] | (run & ((1u << bits) - 1)) << (k * bits % 8));
  }
  return map;
}

/// A buffer of its own, so that a sanitizer sees one byte too many.
std::unique_ptr<std::uint8_t[]> room(std::size_t size) { return std::make_unique<std::uint8_t[]>(size); }

/// Judges the indices of several hits in one call, in buffers of exactly their length.
void indices_of_hits(Input& in) {
  const std::uint32_t how = in.next(), level = how % 17;
  // The floats are arbitrary, or lie on the level's lines and between, up to some ulps.
  const bool any = how >= 170;
  std::vector<float> u, v;
  for (const std::size_t most = 1 + in.next() % 33u; u.size() < most && (u.empty() || in.left());) {
    const float x = any ? in.next_float() : in.near_grid(level),
                y = any ? in.next_float() : in.near_grid(level);
    if (!(x >= 0 && y >= 0 && static_cast<double>(x) + static_cast<double>(y) <= 1)) return;
    u.push_back(x);
    v.push_back(y);
  }
  if (subject().index_f32 == nullptr || level > subject().max_level) return;
  const auto got = std::make_unique<std::uint32_t[]>(u.size());
  std::fill_n(got.get(), u.size(), ~0u);
  subject().index_f32(level, u.data(), v.data(), got.get(), u.size());
  for (std::size_t k = 0; k < u.size(); ++k) {
    const std::uint32_t expected = fast::index::from_barycentrics(u[k], v[k], level);
    if (got[k] == expected) continue;
    std::fprintf(stderr, "fuzz_subject: level %u u=%a v=%a: got %u, expected %u\n", level,
                 static_cast<double>(u[k]), static_cast<double>(v[k]), got[k], expected);
    wrong("index.exact_on_floats", "another micro-triangle");
  }
}

/// The code of a map.  Without an encoder it comes from Algorithm 1, if that is the subject's form; else it
/// is empty.
Bytes code_of(std::uint32_t level, std::uint32_t bits, const Bytes& map) {
  const bool stream = (subject().flags & MMVERIFY_TREE_STREAM) != 0;
  Bytes algorithm_1;
  if (stream) {
    const auto paper = fast::tree::encode_stream(level, static_cast<fast::tree::Format>(bits), map);
    algorithm_1 = paper.tree;
    algorithm_1.insert(algorithm_1.end(), paper.data.begin(), paper.data.end());
  }
  if (subject().tree_encode == nullptr) return algorithm_1;
  // The address must be valid, even if no byte fits.
  const std::size_t size = subject().tree_encode(level, bits, map.data(), room(0).get(), 0);
  if (size == 0) wrong("tree.round_trip", "a map without a code");
  const auto code = room(size);
  if (subject().tree_encode(level, bits, map.data(), code.get(), size) != size)
    wrong("tree.round_trip", "two sizes of one code");
  const Bytes written(code.get(), code.get() + size);
  if (stream && written != algorithm_1) wrong("tree.equals_spec", "not Algorithm 1's bytes");
  return written;
}

/// Looks up about 64 micro-triangles all over the map in one call, by their numbers and by a point within
/// each.
void look_up(std::uint32_t level, std::uint32_t bits, const Bytes& map, const Bytes& code) {
  std::vector<std::uint32_t> asked;
  std::vector<float> u, v;
  for (std::uint32_t k = 0, count = 1u << (2 * level); k < count; k += 1 + count / 64) {
    asked.push_back(k);
    const auto c = fast::index::corners(k, level);
    const auto within = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
      return static_cast<float>(a + b + d) / static_cast<float>(3u << level);
    };
    u.push_back(within(c[0].i, c[1].i, c[2].i));
    v.push_back(within(c[0].j, c[1].j, c[2].j));
  }
  const auto judge = [&](const char* law, auto lookup) {
    const auto state = room(asked.size());
    std::fill_n(state.get(), asked.size(), std::uint8_t{0xee});
    lookup(state.get());
    for (std::size_t n = 0; n < asked.size(); ++n)
      if (state[n] != (map[asked[n] * bits / 8] >> (asked[n] * bits % 8) & ((1u << bits) - 1)))
        wrong(law, "another state");
  };
  const mmverify_subject_t& s = subject();
  if (s.tree_lookup != nullptr)
    judge("tree.lookup_is_decode", [&](std::uint8_t* state) {
      s.tree_lookup(level, bits, code.data(), code.size(), asked.data(), state, asked.size());
    });
  if (s.tree_lookup_f32 != nullptr)
    judge("tree.point_is_index", [&](std::uint8_t* state) {
      s.tree_lookup_f32(level, bits, code.data(), code.size(), u.data(), v.data(), state, asked.size());
    });
}

/// A level whose maps take little time, and sometimes a higher one.
std::uint32_t drawn_level(Input& in) {
  const unsigned drawn = in.next();
  return drawn < 250 ? drawn % 7 : 7 + drawn % 3;
}

void tree_there_and_back(Input& in) {
  const std::uint32_t level = drawn_level(in), bits = 1 + (in.next() & 1u);
  if (level > subject().max_level) return;
  const Bytes map = drawn_map(in, level, bits), code = code_of(level, bits, map);
  if (code.empty()) return;
  if (subject().tree_decode != nullptr) {
    const auto back = room(map.size());
    if (subject().tree_decode(level, bits, code.data(), code.size(), back.get()) == 0)
      wrong("tree.round_trip", "its own code refused");
    if (!std::equal(map.begin(), map.end(), back.get())) wrong("tree.round_trip", "another map");
  }
  look_up(level, bits, map, code);
}

void tree_from_any_bytes(Input& in) {
  const std::uint32_t level = drawn_level(in), bits = 1 + (in.next() & 1u);
  if (subject().tree_decode == nullptr || level > subject().max_level) return;
  const Bytes given = in.rest();
  const auto code = room(given.size());
  std::copy(given.begin(), given.end(), code.get());
  const std::size_t bytes = ((std::size_t{1} << (2 * level)) * bits + 7) / 8;
  const auto map = room(bytes);
  if (subject().tree_decode(level, bits, code.get(), given.size(), map.get()) == 0) return;
  // An accepted code is a map's code, and a map has one code.
  const Bytes again = code_of(level, bits, {map.get(), map.get() + bytes});
  if (!again.empty() && again != given) wrong("tree.malformed", "it took a code that is no map's");
}

/// Judges a block.  law: "vq2.region_is_map" or that of vq4.
void square_block(Input& in, const char* law, auto decode, auto region, auto ours, std::size_t bytes,
                  std::uint32_t side) {
  fast::vq::Block4 padded{};
  for (std::size_t k = 0; k < bytes; ++k) padded[k] = in.next();
  const auto expected = ours(padded);
  const auto block = room(bytes);
  std::copy_n(padded.begin(), bytes, block.get());
  if (decode != nullptr) {
    const auto map = room(side * side);
    decode(block.get(), map.get());
    for (std::size_t k = 0; k < side * side; ++k)
      if (map[k] != static_cast<std::uint8_t>(expected[k])) wrong(law, "another state of a region");
  }
  if (region == nullptr) return;
  std::vector<std::uint32_t> x, y;
  for (std::uint32_t k = 0; k < side * side; k += 7) {
    x.push_back(k % side);
    y.push_back(k / side);
  }
  const auto state = room(x.size());
  std::fill_n(state.get(), x.size(), std::uint8_t{0xee});
  region(block.get(), x.data(), y.data(), state.get(), x.size());
  for (std::size_t n = 0; n < x.size(); ++n)
    if (state[n] != static_cast<std::uint8_t>(expected[x[n] + y[n] * side]))
      wrong(law, "another state than the map's");
}

/// Judges a map.  law: "vq2.conservative" or that of vq4.
void square_map(Input& in, const char* law, auto encode, auto ours, std::size_t bytes, std::uint32_t side) {
  if (encode == nullptr) return;
  const auto map = room(side * side);
  for (std::size_t k = 0; in.left() && k < side * side;) {
    const std::uint8_t run = in.next();
    for (std::size_t left = std::size_t{1} << (run >> 2 & 7); left > 0 && k < side * side; --left)
      map[k++] = static_cast<std::uint8_t>(run % 4 == 3 ? 1 : run % 4);
  }
  const auto block = room(bytes);
  encode(map.get(), block.get());
  fast::vq::Block4 padded{};
  std::copy(block.get(), block.get() + bytes, padded.begin());
  const auto left = ours(padded);
  for (std::size_t k = 0; k < side * side; ++k) {
    const auto is = static_cast<std::uint8_t>(left[k]);
    if (is != map[k] && is != 1) wrong(law, "more than T or O became C");
  }
}

/// Judges that a map decoded from a block is encoded without loss.
void held_map(Input& in, const char* law, auto encode, auto ours, std::size_t bytes, std::uint32_t side) {
  if (encode == nullptr || (subject().flags & MMVERIFY_VQ_KEEPS) == 0) return;
  fast::vq::Block4 padded{};
  for (std::size_t k = 0; k < bytes; ++k) padded[k] = in.next();
  const auto held = ours(padded);
  const auto map = room(side * side), block = room(bytes);
  for (std::size_t k = 0; k < side * side; ++k) map[k] = static_cast<std::uint8_t>(held[k]);
  encode(map.get(), block.get());
  std::copy_n(block.get(), bytes, padded.begin());
  if (ours(padded) != held) wrong(law, "a map that a block holds is not kept");
}

/// Judges substitution on a map whose padding bits are set.
void substituted(Input& in) {
  const std::uint32_t level = drawn_level(in);
  if (subject().micromap_substitute == nullptr) return;
  Bytes map = drawn_map(in, level, 2);
  const std::uint64_t count = std::uint64_t{1} << (2 * level);
  if (count < 4) map[0] |= 0xfc;
  const auto out = room(map.size());
  subject().micromap_substitute(level, map.data(), out.get());
  if (count < 4 && out[0] > 3) wrong("lossy.allowed", "bits after the last state");
  if (!fast::micromap::substitutions(map, std::span(out.get(), map.size()), count).allowed())
    wrong("lossy.allowed", "a state became T or O");
}

std::array<std::uint8_t, 32> first_half(const fast::vq::Block4& block) {
  std::array<std::uint8_t, 32> half{};
  std::copy_n(block.begin(), half.size(), half.begin());
  return half;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  subject();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const mmverify_subject_t& s = subject();
  const auto two = [](const fast::vq::Block4& b) { return fast::vq::decode(first_half(b)); };
  const auto four = [](const fast::vq::Block4& b) { return fast::vq::decode(b); };
  Input in(data, size);
  switch (in.next() % 10) {
    case 0: indices_of_hits(in); break;
    case 1: tree_there_and_back(in); break;
    case 2: tree_from_any_bytes(in); break;
    case 3: square_block(in, "vq2.region_is_map", s.vq2_decode, s.vq2_region, two, 32, 16); break;
    case 4: square_block(in, "vq4.region_is_map", s.vq4_decode, s.vq4_region, four, 64, 32); break;
    case 5: square_map(in, "vq2.conservative", s.vq2_encode, two, 32, 16); break;
    case 6: square_map(in, "vq4.conservative", s.vq4_encode, four, 64, 32); break;
    case 7: held_map(in, "vq2.lossless_when_it_fits", s.vq2_encode, two, 32, 16); break;
    case 8: held_map(in, "vq4.lossless_when_it_fits", s.vq4_encode, four, 64, 32); break;
    default: substituted(in);
  }
  return 0;
}
