// Topic vq: encoders and what they promise, each with one thing wrong.
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "tests/foreign/inside/encode.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;

using Encode2 = std::function<Encoded<Vq2>(const Map<Vq2>&)>;
using Encode4 = std::function<Encoded<Vq4>(const Map<Vq4>&)>;
using Count2 = std::function<std::uint32_t(const Map<Vq2>&)>;
using Count4 = std::function<std::uint32_t(const Map<Vq4>&)>;

Encode2 by(const Search2& search) {
  return [search](const Map<Vq2>& map) {
    const Solved2 s = solved(map, search);
    return Encoded<Vq2>{written(s.block), s.lost};
  };
}
Encode4 by(const Search4& search) {
  return [search](const Map<Vq4>& map) {
    const Solved4 s = solved(map, search);
    return Encoded<Vq4>{written(s.block), s.lost};
  };
}
Count2 lost_by(const Search2& search) {
  return [search](const Map<Vq2>& map) { return solved(map, search).lost; };
}
Count4 lost_by(const Search4& search) {
  return [search](const Map<Vq4>& map) { return solved(map, search).lost; };
}

constexpr Search2 all2{};
constexpr Search4 all4{}, plain4{.identity_alone = true};

/// Codes uniform vectors only; every other vector becomes C throughout.
template <class Format>
Encoded<Format> uniform_alone(const Map<Format>& map) {
  Format block{};
  std::uint32_t gone = 0;
  constexpr std::uint32_t side = Format::side, row = 8 * side;
  for (std::uint32_t v = 0; v < 64; ++v) {
    std::uint32_t of[3] = {};
    for (std::uint32_t k = 0; k < side * side; ++k)
      ++of[static_cast<std::size_t>(map[v % 8 * side + k % side + row * (v / 8 * side + k / side)])];
    const bool o = of[2] == side * side, t = of[0] == side * side;
    block.indices[v] = o ? 2 : t ? 0 : 1;
    if (!o && !t) gone += of[0] + of[2];
  }
  return {written(block), gone};
}

// ---- 16x16

InsideFault optimum(const char* name, const char* wrong, Encode2 encode) {
  Functions parts;
  parts.vq2 = {.encode = std::move(encode), .fewest = true};
  return {"vq2.optimum",
          name,
          wrong,
          std::make_shared<VqSubject>("foreign-optimal", "all triples", std::move(parts)),
          {level_of<Vq2>, level_of<Vq2>}};
}
InsideFault effort2(const char* name, const char* wrong, Encode2 encode, Count2 promised) {
  Functions parts;
  parts.vq2 = {.encode = std::move(encode), .at_most = std::move(promised)};
  return {"vq2.effort",
          name,
          wrong,
          std::make_shared<VqSubject>("foreign-effort", "all triples", std::move(parts)),
          {level_of<Vq2>, level_of<Vq2>}};
}

/// Each vector that the search left as C throughout becomes O throughout, or T where it has more T than O.  Its C
/// regions are then guesses, so no promise is kept, and none of its O and T count as lost.
template <class Format, class Search>
Encoded<Format> guessed(const Map<Format>& map, const Search& search) {
  auto s = solved(map, search);
  if (s.lost == 0) return {written(s.block), s.lost};
  constexpr std::uint32_t side = Format::side, row = 8 * side;
  std::uint32_t gone = 0;
  for (std::uint32_t v = 0; v < 64; ++v) {
    if (s.block.indices[v] != 1) continue;
    std::uint32_t of[3] = {};
    for (std::uint32_t k = 0; k < side * side; ++k)
      ++of[static_cast<std::size_t>(map[v % 8 * side + k % side + row * (v / 8 * side + k / side)])];
    if (of[1] == side * side) continue;
    s.block.indices[v] = of[2] >= of[0] ? 2 : 0;
    gone += of[0] + of[2];
  }
  return {written(s.block), s.lost - std::min(s.lost, gone)};
}

// ---- 32x32

InsideFault effort4(const char* name, const char* wrong, Encode4 encode, Count4 promised) {
  Functions parts;
  parts.vq4 = {.encode = std::move(encode), .at_most = std::move(promised)};
  return {"vq4.effort",
          name,
          wrong,
          std::make_shared<VqSubject>("foreign-effort", "entries in turn", std::move(parts)),
          {level_of<Vq4>, level_of<Vq4>}};
}
InsideFault bound(const char* name, const char* wrong, Encode4 encode, Count4 at_least,
                  Count4 at_most = lost_by(plain4)) {
  Functions parts;
  parts.vq4 = {.encode = std::move(encode), .at_most = std::move(at_most), .at_least = std::move(at_least)};
  return {"vq4.bound",
          name,
          wrong,
          std::make_shared<VqSubject>("foreign-bound", "O beside T in a mini", std::move(parts)),
          {level_of<Vq4>, level_of<Vq4>}};
}

/// The numbers of O and of T in the 2x2 regions whose first corner is (x, y).
std::pair<std::uint32_t, std::uint32_t> both(const Map<Vq4>& map, std::uint32_t x, std::uint32_t y) {
  std::uint32_t o = 0, t = 0;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const State s = map[x + k % 2 + 32 * (y + k / 2)];
    o += s == State::O;
    t += s == State::T;
  }
  return {o, t};
}
/// A lower bound on the loss: a 2x2 that holds O and T has one palette, so it loses the fewer of the two.  Faults take
/// the more, or windows that are not aligned (step 1).
std::uint32_t minis(const Map<Vq4>& map, bool the_more, std::uint32_t step) {
  std::uint32_t sum = 0;
  for (std::uint32_t y = 0; y < 31; y += step)
    for (std::uint32_t x = 0; x < 31; x += step) {
      const auto [o, t] = both(map, x, y);
      sum += the_more && o * t != 0 ? std::max(o, t) : std::min(o, t);
    }
  return sum;
}
std::uint32_t minis(const Map<Vq4>& map) { return minis(map, false, 2); }

/// The number of different vectors that are not uniform, without regard to transforms.
std::uint32_t kinds(const Map<Vq4>& map) {
  std::vector<std::array<State, 16>> seen;
  for (std::uint32_t v = 0; v < 64; ++v) {
    std::array<State, 16> a;
    for (std::uint32_t k = 0; k < 16; ++k) a[k] = map[v % 8 * 4 + k % 4 + 32 * (v / 8 * 4 + k / 4)];
    if (std::count(a.begin(), a.end(), a[0]) != 16 && std::find(seen.begin(), seen.end(), a) == seen.end())
      seen.push_back(a);
  }
  return static_cast<std::uint32_t>(seen.size());
}

}  // namespace

InsideRows faults_of_encoders() {
  const Search2 no_half_turn{.quadrant = 3, .untried = 6};
  const Search4 no_270{.quadrant = 3, .untried = 7};
  return {
      optimum("uniform_alone", "everything but uniform vectors is C", uniform_alone<Vq2>),
      optimum("identity_alone", "no transform is tried", by(Search2{.identity_alone = true})),
      optimum("no_half_turn_in_br", "Rotate 180 is not tried in BR", by(no_half_turn)),
      optimum("shared_in_turn", "shared entries are chosen one after the other",
              by(Search2{.shared_in_turn = true})),
      optimum("own_in_turn", "a quadrant's second entry is the best beside the best",
              by(Search2{.own_in_turn = true})),
      optimum("whole_vectors", "entries are whole vectors of the map", by(Search2{.whole_vectors = true})),
      optimum("mirrored", "the search takes Reflect X=Y for Reflect X=-Y", by(Search2{.mirrored = true})),
      optimum("guesses", "a vector that no entry fits is O or T throughout",
              [](const Map<Vq2>& m) { return guessed<Vq2>(m, all2); }),
      effort2("uniform_alone", "everything but uniform vectors is C", uniform_alone<Vq2>,
              lost_by(Search2{.identity_alone = true})),
      effort2("no_half_turn_in_br", "Rotate 180 is not tried in BR, where more is promised", by(no_half_turn),
              lost_by(all2)),
      effort2("own_in_turn", "a quadrant's second entry is the best beside the best, where more is promised",
              by(Search2{.own_in_turn = true}), lost_by(all2)),
      effort2(
          "guesses", "a vector that no entry fits is O or T throughout",
          [](const Map<Vq2>& m) { return guessed<Vq2>(m, Search2{.identity_alone = true}); }, lost_by(all2)),
      effort2("promises_itself", "everything but uniform vectors is C, which is all that is promised",
              uniform_alone<Vq2>, [](const Map<Vq2>& m) { return *uniform_alone<Vq2>(m).substitutions; }),
      effort4("promises_itself", "everything but uniform vectors is C, which is all that is promised",
              uniform_alone<Vq4>, [](const Map<Vq4>& m) { return *uniform_alone<Vq4>(m).substitutions; }),
      effort4("uniform_alone", "everything but uniform vectors is C", uniform_alone<Vq4>, lost_by(plain4)),
      effort4("no_270_in_br", "Rotate 270 is not tried in BR, where more is promised", by(no_270),
              lost_by(all4)),
      effort4("no_vertical_in_tr", "no vector of TR takes the vertical entry, where more is promised",
              by(Search4{.unused_in = 1, .unused = 6}), lost_by(all4)),
      effort4(
          "guesses", "a vector that no entry fits is O or T throughout",
          [](const Map<Vq4>& m) { return guessed<Vq4>(m, plain4); }, lost_by(all4)),
      bound("the_more_of_a_mini", "of O and T in a mini the more is lost", by(all4),
            [](const Map<Vq4>& m) { return minis(m, true, 2); }),
      bound("every_window", "minis that are not aligned count too", by(all4),
            [](const Map<Vq4>& m) { return minis(m, false, 1); }),
      bound("a_kind_an_entry", "the fourteenth kind of vector must lose something", by(all4),
            [](const Map<Vq4>& m) { return minis(m) + (kinds(m) > 13 ? 1 : 0); }),
      bound("its_own_is_the_least", "the bound is what its own block loses", by(plain4), lost_by(plain4)),
      bound(
          "promises_itself", "everything but uniform vectors is C, which is all that is promised",
          uniform_alone<Vq4>, [](const Map<Vq4>& m) { return minis(m); },
          [](const Map<Vq4>& m) { return *uniform_alone<Vq4>(m).substitutions; }),
      bound("uniform_alone", "everything but uniform vectors is C", uniform_alone<Vq4>,
            [](const Map<Vq4>& m) { return minis(m); }),
      bound("no_vertical_in_tr", "no vector of TR takes the vertical entry",
            by(Search4{.identity_alone = true, .unused_in = 1, .unused = 6}),
            [](const Map<Vq4>& m) { return minis(m); }),
  };
}

InsideRows right_encoders() {
  return {
      optimum("optimal", "", by(all2)),
      effort2("optimal", "", by(all2),
              lost_by(Search2{.identity_alone = true, .shared_in_turn = true, .own_in_turn = true})),
      effort4("turned", "", by(all4), lost_by(plain4)),
      bound("minis", "", by(all4), [](const Map<Vq4>& m) { return minis(m); }),
  };
}

}  // namespace mmverify::tests::foreign
