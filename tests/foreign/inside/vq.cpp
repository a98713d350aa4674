// Topic vq: which vectors there are, table 1 as matrices, and the codes of vectors as masks.
// Source: Compressed Opacity Maps, 4.1, table 1, figure 4, 5.1 and table 2.
#include "tests/foreign/inside/vq.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::vq;
using proofs::Levels;

constexpr State T = State::T, C = State::C, O = State::O;

/// Eight states at a time: T is 0, O has bit 1; the product brings the lowest bits of eight bytes together.
template <std::size_t side>
Masks masks(const Vector<side>& v) {
  constexpr std::uint64_t ones = 0x0101010101010101, gathers = 0x0102040810204080;
  Masks m;
  for (std::size_t at = 0; at < side * side; at += 8) {
    std::uint64_t eight = ones;  // C where there are fewer
    std::memcpy(&eight, v.data() + at, std::min<std::size_t>(8, side * side));
    m.o |= static_cast<std::uint32_t>((eight >> 1 & ones) * gathers >> 56) << at;
    m.t |= static_cast<std::uint32_t>((~(eight | eight >> 1) & ones) * gathers >> 56) << at;
  }
  return m;
}
template <std::size_t side>
Vector<side> from(Masks m) {
  Vector<side> v;
  for (std::uint32_t k = 0; k < side * side; ++k)
    v[k] = (m.o >> k & 1) != 0 ? O : (m.t >> k & 1) != 0 ? T : C;
  return v;
}

/// The columns x of a mask of side x side regions.
template <std::size_t side>
constexpr std::uint32_t column(std::uint32_t x) {
  std::uint32_t mask = 0;
  for (std::uint32_t y = 0; y < side; ++y) mask |= 1u << (x + side * y);
  return mask;
}

// ---- Which vectors there are

/// O spread by one region to each side must not meet T.
template <std::size_t side>
bool valid(const Vector<side>& v, Fault how) {
  const auto [o, t] = masks<side>(v);
  constexpr std::uint32_t first = column<side>(0), last = column<side>(side - 1),
                          all = (1u << side * side) - 1;
  const std::uint32_t right = how == "no_wrap"_fault ? o << 1 & all : o << 1 & ~first & all;
  const std::uint32_t left = o >> 1 & ~last;
  std::uint32_t near = o | right | left;
  if (how == "no_diagonals"_fault)
    near |= o << side | o >> side;
  else if (how == "falling_diagonals_alone"_fault)
    near |= o << side | o >> side | left << side | right >> side;
  else
    near |= near << side | near >> side;
  if (how == "last_row_unseen"_fault) return (near & t & (all >> side)) == 0;
  if (how == "four_of_each"_fault && std::popcount(o) == 4 && std::popcount(t) == 4) return (o & t) == 0;
  return (near & t) == 0;
}

// ---- Transforms

template <std::size_t side>
Vector<side> applied(Transform t, const Vector<side>& v, Fault how) {
  Matrix m = results[t.number()];
  if (how == "clockwise"_fault && (t.number() == 1 || t.number() == 7)) m = results[8 - t.number()];
  if (how == "rotates_last"_fault && (t.number() == 3 || t.number() == 5)) m = results[8 - t.number()];
  if (how == "diagonals_exchanged"_fault && side == 4 && t.number() == 5) m = results[3];
  Vector<side> out;
  for (std::uint32_t k = 0; k < side * side; ++k) out[taken(m, side, k)] = v[k];
  if (how == "rotate_270_of_4"_fault && side == 4 && t.number() == 7) std::swap(out[5], out[10]);
  // A slip that no vector with a single mark shows.
  if (how == "two_marks"_fault && t.number() == 6 && v.front() == O && v.back() == O) out.back() = C;
  if (how == "opaque_corner"_fault && t.number() == 3 && v[1] == O) out.back() = O;
  return out;
}

Transform composed(Transform then, Transform first, Fault how) {
  if (how == "composed_backwards"_fault) std::swap(then, first);
  const Matrix &l = results[then.number()], &r = results[first.number()];
  const Matrix product{l.a * r.a + l.b * r.c, l.a * r.b + l.b * r.d, l.c * r.a + l.d * r.c,
                       l.c * r.b + l.d * r.d};
  std::uint32_t row = 0;
  while (results[row] != product) ++row;
  if (how == "one_pair_composed"_fault && then.number() == 5 && first.number() == 3) row = 4;
  return Transform::of(row);
}

// ---- Codes of vectors

/// The sets of regions that have a palette each, and where its flag is.
struct Part {
  std::uint32_t regions, flag;
};
std::vector<Part> parts_of(Code4 how, Fault wrong) {
  constexpr std::uint32_t left = 0x3333, bottom = 0x00ff, all = 0xffff;
  if (wrong == "rows_are_columns"_fault && how != Code4::simple && how != Code4::generic)
    how = how == Code4::vertical ? Code4::horizontal : Code4::vertical;
  switch (how) {
    case Code4::simple: return {{all, 16}};
    case Code4::vertical: return {{left, 16}, {all & ~left, 17}};
    case Code4::horizontal: return {{bottom, 16}, {all & ~bottom, 17}};
    case Code4::generic: break;
  }
  return {};
}

/// Region k of mini m.
std::uint32_t region_of_mini(std::uint32_t m, std::uint32_t k, Fault wrong) {
  if (wrong == "minis_columnwise_within"_fault && m == 3) k = k / 2 + 2 * (k % 2);
  return 2 * (m & 1) + (k & 1) + 4 * (2 * (m >> 1) + (k >> 1));
}

std::uint32_t mini_code(Vector<2> v, bool& fits, Fault wrong) {
  auto [o, t] = masks<2>(v);
  const bool opaque = wrong == "palette_of_the_majority"_fault ? std::popcount(o) > std::popcount(t) : o != 0;
  if (wrong == "palette_of_the_majority"_fault && std::popcount(o) != std::popcount(t)) (opaque ? t : o) = 0;
  fits = fits && (o == 0 || t == 0);
  const bool flag = opaque || (wrong == "all_checked_is_opaque"_fault && (o | t) == 0);
  return (~(o | t) & 15) | (flag ? 16u : 0u);
}

Vector<2> mini_of(std::uint32_t code) {
  const std::uint32_t clear = ~code & 15;
  return (code & 16) != 0 ? from<2>({clear, 0}) : from<2>({0, clear});
}

Vector<4> decoded(Code4 how, std::uint32_t code, Fault wrong) {
  if (wrong == "one_word"_fault && how == Code4::generic && code == 0x9d3a6) code ^= 1;
  Masks m;
  if (how == Code4::generic) {
    Vector<4> v;
    for (std::uint32_t mini = 0; mini < 4; ++mini) {
      const Vector<2> part = mini_of(code >> 5 * mini & 31);
      for (std::uint32_t k = 0; k < 4; ++k) v[region_of_mini(mini, k, wrong)] = part[k];
    }
    return v;
  }
  for (const Part& p : parts_of(how, wrong)) ((code >> p.flag & 1) != 0 ? m.o : m.t) |= ~code & p.regions;
  return from<4>(m);
}

std::optional<std::uint32_t> encoded(Code4 how, const Vector<4>& v, Fault wrong) {
  if (wrong == "windows_must_be_valid"_fault && how == Code4::generic && !valid<4>(v, Fault::none))
    return std::nullopt;
  bool fits = true;
  std::uint32_t code = 0;
  if (how == Code4::generic) {
    for (std::uint32_t mini = 0; mini < 4; ++mini) {
      Vector<2> part;
      for (std::uint32_t k = 0; k < 4; ++k) part[k] = v[region_of_mini(mini, k, wrong)];
      code |= mini_code(part, fits, wrong) << 5 * mini;
    }
  } else {
    const auto [o, t] = masks<4>(v);
    code = ~(o | t) & 0xffff;
    for (const Part& p : parts_of(how, wrong)) {
      if ((o & p.regions) != 0) code |= 1u << p.flag;
      if (wrong != "simple_takes_both"_fault || how != Code4::simple)
        fits = fits && ((o & p.regions) == 0 || (t & p.regions) == 0);
    }
  }
  return fits ? std::optional(code) : std::nullopt;
}

// ---- Rows

proofs::SubjectPtr subject(Fault f) {
  Functions parts;
  const auto fill = [&]<std::size_t side>(Vectors<side>& to) {
    to.valid = [f](const Vector<side>& v) { return valid<side>(v, f); };
    to.applied = [f](Transform t, const Vector<side>& v) { return applied<side>(t, v, f); };
  };
  fill(parts.of2);
  fill(parts.of4);
  parts.composed = [f](Transform then, Transform first) { return composed(then, first, f); };
  parts.of2.decode = [f](Code4, std::uint32_t code) {
    return f == "one_word"_fault && code == 31 ? mini_of(15 ^ 2) : mini_of(code);
  };
  parts.of2.encode = [f](Code4, const Vector<2>& v) {
    bool fits = true;
    const std::uint32_t code = mini_code(v, fits, f);
    return fits ? std::optional(code) : std::nullopt;
  };
  parts.of4.decode = [f](Code4 how, std::uint32_t code) { return decoded(how, code, f); };
  parts.of4.encode = [f](Code4 how, const Vector<4>& v) { return encoded(how, v, f); };
  return std::make_shared<VqSubject>("foreign-vectors", "vectors as masks", std::move(parts));
}

InsideFault valid_row(const char* name, const char* wrong, Levels levels) {
  return {"vq.vectors", name, wrong, subject(named(name)), levels};
}
InsideFault turn_row(const char* name, const char* wrong, Levels levels) {
  return {"vq.transforms", name, wrong, subject(named(name)), levels};
}
InsideFault code_row(const char* name, const char* wrong, Levels levels) {
  return {"vq.codes", name, wrong, subject(named(name)), levels};
}

}  // namespace

InsideRows faults_of_vectors() {
  return {
      valid_row("no_diagonals", "O and T may meet at a corner", {1, 1}),
      valid_row("falling_diagonals_alone", "O and T may meet along the rising diagonal", {1, 1}),
      valid_row("last_row_unseen", "T in the uppermost row is not looked at", {1, 1}),
      valid_row("no_wrap", "the last region of a row is beside the first of the next", {2, 2}),
      valid_row("four_of_each", "four O and four T may be anywhere", {2, 2}),
      turn_row("clockwise", "rotations by 90 and 270 are exchanged", {1, 2}),
      turn_row("rotates_last", "the rotation comes after the reflection", {1, 1}),
      turn_row("diagonals_exchanged", "4x4: Reflect X=Y is Reflect X=-Y", {2, 2}),
      turn_row("one_pair_composed", "Reflect X=Y after Reflect X=-Y is Reflect LR", {1, 1}),
      turn_row("composed_backwards", "the transforms are composed in the other order", {1, 1}),
      turn_row("rotate_270_of_4", "4x4: Rotate 270 exchanges two middle regions", {2, 2}),
      turn_row("opaque_corner", "Reflect X=-Y puts O in the last region where the second one is O", {1, 2}),
      turn_row("two_marks", "Rotate 180 loses an O where the first and the last region have it", {1, 2}),
      code_row("all_checked_is_opaque", "all C is written with the palette of O", {1, 1}),
      code_row("one_word", "one word of 20 bits, and one of 5, means another vector", {2, 2}),
      code_row("rows_are_columns", "vertical and horizontal are exchanged", {2, 2}),
      code_row("minis_columnwise_within", "the last mini's regions go up before they go right", {2, 2}),
      code_row("simple_takes_both", "O beside T is written as O", {2, 2}),
      code_row("windows_must_be_valid", "four minis are refused where O and T meet between two", {2, 2}),
      code_row("palette_of_the_majority", "three O and a T are written as O and C", {1, 2}),
  };
}

InsideRows right_vectors() {
  return {valid_row("masks", "", {1, 2}), turn_row("matrices", "", {1, 2}), code_row("masks", "", {1, 2})};
}

namespace {

InsideRows together(InsideRows a, const InsideRows& b, const InsideRows& c) {
  a.insert(a.end(), b.begin(), b.end());
  a.insert(a.end(), c.begin(), c.end());
  return a;
}

}  // namespace

InsideRows inside_faults_of_vq() {
  return together(faults_of_vectors(), faults_of_blocks(), faults_of_encoders());
}
InsideRows inside_right_of_vq() { return together(right_vectors(), right_blocks(), right_encoders()); }

}  // namespace mmverify::tests::foreign
