// Any map through every encoder: only O and T become C, as many as the encoder counts; its own block loses
// nothing more; more effort is never worse.  The map's discontinuous vectors are the specification's.
//
// Input: a byte of the format (bit 0: VQ4) and of how the map is drawn (bits 1 and 2), a byte that chooses
// the encoders (VQ2, by its low two bits: 1 the optimum, 2 Algorithm 1, else both; VQ4: fast unless bit 1,
// balanced with bit 0 or 1, thorough with bits 2 and 3, Algorithm 2 with bits 4 and 5, read kindly with bit
// 6), then by how it is drawn
//   0  runs, a byte each: its low two bits the state (3 is C), the rest, plus one, the length
//   1  regions, two bits each
//   2  a byte k, k % 12 + 1 vectors of a byte each that hashes to its code words, then for each of the map's
//      vectors a byte: which of them, by its low five bits, and the transform it is turned by, the high three
//   3  a block's bytes, whose decoded map is the map
// Missing regions are T; missing bytes of the last two ways derive from the bytes before.
// Slow encoders take a share of the inputs that ask for them: Algorithm 1, and any encoder on its own map, 1/8;
// balanced and Algorithm 2, 1/32; thorough, 1/64.  An input without any of the encoders that it asks for has the
// optimum, or fast.  The laws vq2.conservative, vq4.conservative and vq4.effort judge all of them on maps of theirs.
//
// With PLANTED the harness's encoders are broken on purpose: if BR is rotated by 270, the first
// entry in use there has one C less.  A fuzzer that does not find this looks in the wrong place.
//
// Covers: impl/vq/*/encode.cpp impl/vq/*/paper.cpp impl/vq/*/search.* impl/vq/*/sets.* impl/vq/continuity.cpp
// Covers: impl/vq/transform.hpp impl/vq/vq.hpp
#include <cstddef>
#include <vector>

#include "fuzz/share.hpp"
#include "fuzz/vq_both.hpp"

namespace {

using namespace mmverify::fuzz;

/// The bytes of an input, followed by zeros, or by bytes that all of its bytes determine: a short input is
/// then a whole map, and each change to it gives another map.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool left() const { return size_ > 0; }
  std::uint8_t next_or_zero() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::uint8_t next() {
    if (size_ > 0) {
      const std::uint8_t byte = next_or_zero();
      state_ = (state_ ^ byte) * 0x100000001B3u;
      return byte;
    }
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint8_t>(state_ >> 56);
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::uint64_t state_ = 0xCBF29CE484222325u;
};

template <class Format>
slow::Vector<Format::side> vector_of(std::uint8_t seed) {
  const std::uint32_t word = (seed * 0x9E3779B1u) >> 12;  // 20 bits, each depending on the seed
  if constexpr (Format::side == 2)
    return slow::decode_mini(seed % 32);
  else
    return slow::decode_vector(seed % 2 == 0 ? slow::Code4::generic : slow::Code4::simple,
                               seed % 2 == 0 ? word : word >> 3);
}

template <class Format>
States<Format> drawn(std::uint32_t how, Bytes in) {
  constexpr std::size_t side = Format::side;
  States<Format> map;
  map.fill(fast::State::T);
  const auto state = [](std::uint32_t bits) {
    return static_cast<fast::State>(bits % 4 == 3 ? 1 : bits % 4);
  };
  if (how == 0) {
    for (std::size_t k = 0; k < map.size() && in.left();) {
      const std::uint8_t run = in.next_or_zero();
      for (std::uint32_t left = run / 4 + 1u; left > 0 && k < map.size(); --left) map[k++] = state(run);
    }
  } else if (how == 1) {
    for (std::size_t k = 0; k < map.size(); k += 4) {
      const std::uint8_t four = in.next_or_zero();
      for (std::uint32_t r = 0; r < 4; ++r) map[k + r] = state(four >> 2 * r);
    }
  } else if (how == 2) {
    std::vector<slow::Vector<side>> some;
    for (std::uint32_t left = in.next() % 12 + 1u; left > 0; --left)
      some.push_back(vector_of<Format>(in.next()));
    for (std::size_t vector = 0; vector < 64; ++vector) {
      const std::uint8_t which = in.next();
      const auto v = slow::applied<side>(slow::Transform::of(which / 32u), some[which % 32u % some.size()]);
      for (std::size_t k = 0; k < v.size(); ++k)
        map[side * (vector % 8) + k % side + 8 * side * (side * (vector / 8) + k / side)] =
            static_cast<fast::State>(v[k]);
    }
  } else {
    slow::BlockBytes<Format> block{};
    for (auto& byte : block) byte = in.next();
    map = meant<Format>(block);
  }
  return map;
}

/// Compares the counts of vectors that are not continuous.
template <class Format>
void check_continuity(const States<Format>& map) {
  constexpr std::size_t side = Format::side;
  std::uint32_t count = 0;
  for (std::size_t vector = 0; vector < 64; ++vector) {
    slow::Vector<side> v;
    for (std::size_t k = 0; k < v.size(); ++k)
      v[k] = static_cast<slow::State>(
          map[side * (vector % 8) + k % side + 8 * side * (side * (vector / 8) + k / side)]);
    count += slow::valid<side>(v) ? 0 : 1;
  }
  require(fast::discontinuous_vectors(map) == count, "discontinuous vectors", "are others", side);
}

/// The block after PLANTED has spoiled it.
template <class Format>
slow::BlockBytes<Format> planted(const slow::BlockBytes<Format>& block) {
#ifdef PLANTED
  Format fields = slow::from_bytes<Format>(block);
  if (fields.transforms[3].number() != 7) return block;
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const std::uint8_t index = fields.indices[vector];
    if (slow::quadrant_of(vector % 8, vector / 8) != slow::Quadrant::BR || index < 3) continue;
    if constexpr (Format::side == 2) {
      auto& code = index < 6 ? fields.shared[index - 3u] : fields.own[3][index - 6u];
      code = static_cast<std::uint8_t>(code & (code - 1));
    } else {
      auto& code = fields.codebook[index - 3u];
      code &= code - 1;
    }
    return slow::bytes(fields);
  }
#endif
  return block;
}

/// The promises of an encoder, for one map.
struct Promise {
  bool keeps_what_fits, block_holds_it;
  bool own_map_judged;  ///< whether the encoder encodes the map that it made once more
};

/// Judges one encoder on one map, and returns the number of substitutions.
template <class Format, class Encode>
std::uint32_t judge(const States<Format>& map, const Promise& promise, const char* who, Encode encode) {
  const auto encoded = encode(map);
  const States<Format> is = meant<Format>(planted<Format>(encoded.block));
  const std::uint32_t lost = substitutions<Format>(map, is, who);
  require(lost == encoded.substitutions, who, "counts other substitutions", Format::side);
  if (!promise.keeps_what_fits) return lost;
  require(!promise.block_holds_it || lost == 0, who, "loses what a block can hold", Format::side);
  if (!promise.block_holds_it && lost != 0 && promise.own_map_judged)
    require(encode(is).substitutions == 0, who, "loses more of its own map", Format::side);
  return lost;
}

void vq2(std::uint32_t how, std::uint8_t which, Share share, Bytes in) {
  const fast::Map2 map = drawn<slow::Vq2>(how, in);
  check_continuity<slow::Vq2>(map);
  const bool paper = (which & 3) != 1 && share.of(8), optimal = (which & 3) != 2 || !paper;
  const Promise promise{true, how == 3, share.of(8)}, no_promise{};
  std::uint32_t least = 0, greedy = 0;
  if (optimal)
    least = judge<slow::Vq2>(map, promise, "the optimum",
                             [](const fast::Map2& m) { return fast::encode_optimal(m); });
  if (paper)
    greedy = judge<slow::Vq2>(map, no_promise, "Algorithm 1",
                              [](const fast::Map2& m) { return fast::encode_paper(m); });
  if (paper)
    judge<slow::Vq2>(map, no_promise, "Algorithm 1 read the other way",
                     [](const fast::Map2& m) { return fast::encode_paper_highest_first(m); });
  if (optimal && paper) require(least <= greedy, "the optimum", "is worse than Algorithm 1", 2);
}

void vq4(std::uint32_t how, std::uint8_t which, Share share, Bytes in) {
  const fast::Map4 map = drawn<slow::Vq4>(how, in);
  check_continuity<slow::Vq4>(map);
  const bool balanced = (which & 3) != 0 && share.of(32), algorithm_2 = (which & 48) == 48 && share.of(32);
  const bool asked[] = {(which & 2) == 0 || !(balanced || algorithm_2), balanced,
                        (which & 12) == 12 && share.of(64)};
  const Promise promise{true, how == 3, share.of(8)};
  std::uint32_t before = ~0u;
  constexpr const char* names[] = {"fast", "balanced", "thorough"};
  for (std::uint32_t effort = 0; effort < 3; ++effort) {
    if (!asked[effort]) continue;
    const std::uint32_t lost = judge<slow::Vq4>(map, promise, names[effort], [=](const fast::Map4& m) {
      return fast::encode(m, static_cast<fast::Effort>(effort));
    });
    require(lost <= before, names[effort], "is worse than less effort", 4);
    before = lost;
  }
  if (algorithm_2)
    judge<slow::Vq4>(map, {}, "Algorithm 2", [=](const fast::Map4& m) {
      return (which & 64) != 0 ? fast::encode_paper_free_c(m) : fast::encode_paper(m);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Bytes rest(data + 2, size - 2);
  const Share share(data, size);
  const std::uint32_t how = data[0] / 2 % 4;
  if (data[0] % 2 == 0)
    vq2(how, data[1], share, rest);
  else
    vq4(how, data[1], share, rest);
  return 0;
}
