#include "proofs/vq/maps.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

State any_state(Random& random) { return static_cast<State>(random.below(3)); }
Transform any_transform(Random& random) { return Transform::of(static_cast<std::uint32_t>(random.below(8))); }

/// A vector that a codebook can hold.
template <class Format>
Vector<Format::side> any_entry(Random& random) {
  if constexpr (Format::side == 2) {
    return spec::vq::decode_mini(static_cast<std::uint32_t>(random.below(32)));
  } else {
    const auto how = static_cast<Code4>(random.below(4));
    return spec::vq::decode_vector(how,
                                   static_cast<std::uint32_t>(random.below(1u << spec::vq::bits_of(how))));
  }
}

/// An ellipse; a region's depth inside it (above 0) or outside counts squares of half regions.
struct Shape {
  std::int64_t x, y, r, wide, high;

  Shape(std::int64_t size, Random& random)
      : x(random.between(0, 2 * size)),
        y(random.between(0, 2 * size)),
        r(random.between(size / 2, 2 * size)),
        wide(random.between(1, 4)),
        high(random.between(1, 4)) {}
  std::int64_t inside(std::size_t at_x, std::size_t at_y) const {
    const std::int64_t dx = 2 * static_cast<std::int64_t>(at_x) + 1 - x,
                       dy = 2 * static_cast<std::int64_t>(at_y) + 1 - y;
    return r * r - wide * dx * dx - high * dy * dy;
  }
};

template <class Format>
Map<Format> shape(Random& random, std::int64_t outline) {
  constexpr std::size_t size = 8 * Format::side;
  const Shape one(size, random);
  const bool opaque = random.below(4) != 0;
  Map<Format> map;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const std::int64_t in = one.inside(k % size, k / size);
    map[k] = in > outline * one.r ? (opaque ? O : T) : in < -outline * one.r ? (opaque ? T : O) : C;
  }
  return map;
}

template <class Format>
Map<Format> wide_outline(Random& random) {
  return shape<Format>(random, random.between(3, 8));
}

template <class Format>
Map<Format> sharp(Random& random) {
  return shape<Format>(random, 0);
}

template <class Format>
Map<Format> two_shapes(Random& random) {
  constexpr std::size_t size = 8 * Format::side;
  const Shape a(size, random), b(size, random);
  Map<Format> map;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const std::int64_t in = std::max(a.inside(k % size, k / size), b.inside(k % size, k / size)),
                       outline = 4 * std::min(a.r, b.r);
    map[k] = in > outline ? O : in < -outline ? T : C;
  }
  return map;
}

template <class Format>
Map<Format> noise(Random& random) {
  Map<Format> map;
  for (State& s : map) s = any_state(random);
  return map;
}

template <class Format>
Map<Format> repeated(Random& random, std::uint64_t kinds, bool turned) {
  std::vector<Vector<Format::side>> some;
  for (std::uint64_t k = 0; k < kinds; ++k) some.push_back(any_entry<Format>(random));
  Map<Format> map;
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const auto& v = some[random.below(kinds)];
    put<Format>(map, vector, turned ? spec::vq::applied<Format::side>(any_transform(random), v) : v);
  }
  return map;
}

template <class Format>
Map<Format> few_vectors(Random& random) {
  const bool last = random.below(2) != 0;
  return repeated<Format>(random, 1 + random.below(12), last);
}

/// A map that suits the format: vectors of TL occur again in each quadrant, under the quadrant's transform.
template <class Format>
Map<Format> symmetric(Random& random) {
  const Map<Format> tl = two_shapes<Format>(random);
  std::array<Transform, 4> transforms{};
  for (std::size_t q = 1; q < 4; ++q) transforms[q] = any_transform(random);
  Map<Format> map;
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const auto q = static_cast<std::size_t>(spec::vq::quadrant_of(vector % 8, vector / 8));
    const auto from = static_cast<std::uint32_t>(random.below(4) + 8 * (4 + random.below(4)));
    put<Format>(map, vector, spec::vq::applied<Format::side>(transforms[q], vector_of<Format>(tl, from)));
  }
  return map;
}

template <class Format>
Map<Format> uniform(Random& random) {
  Map<Format> map;
  map.fill(any_state(random));
  return map;
}

template <class Format>
Map<Format> one_odd_region(Random& random) {
  Map<Format> map = uniform<Format>(random);
  map[random.below(map.size())] = any_state(random);
  return map;
}

/// One vector of any states everywhere, or two in turn.
template <class Format>
Map<Format> tiled(Random& random) {
  std::array<Vector<Format::side>, 2> tiles;
  for (auto& tile : tiles)
    for (State& s : tile) s = any_state(random);
  if (random.below(2) == 0) tiles[1] = tiles[0];
  Map<Format> map;
  for (std::uint32_t vector = 0; vector < 64; ++vector)
    put<Format>(map, vector, tiles[(vector % 8 + vector / 8) % 2]);
  return map;
}

/// Fills indices and codes.  `few`: each quadrant has two to four indices of its own choice.
template <class Format>
void fill(Format& fields, bool few, Random& random) {
  const std::uint64_t kinds = few ? 2 + random.below(3) : 1u << Format::index_bits;
  std::array<std::array<std::uint64_t, 4>, 4> kind_of{};
  for (auto& of_quadrant : kind_of)
    for (auto& kind : of_quadrant) kind = random.below(1u << Format::index_bits);
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const auto q = static_cast<std::size_t>(spec::vq::quadrant_of(vector % 8, vector / 8));
    fields.indices[vector] =
        static_cast<std::uint8_t>(few ? kind_of[q][random.below(kinds)] : random.below(kinds));
  }
  const auto code = [&](std::uint32_t bits) {
    return static_cast<std::uint32_t>(random.below(std::uint64_t{1} << bits));
  };
  if constexpr (Format::side == 2) {
    for (auto& c : fields.shared) c = static_cast<std::uint8_t>(code(5));
    for (auto& pair : fields.own)
      for (auto& c : pair) c = static_cast<std::uint8_t>(code(5));
  } else {
    for (std::uint32_t index = 3; index < 16; ++index)
      fields.codebook[index - 3] = code(spec::vq::bits_of(Vq4::code_of(index)));
  }
}

/// The indices of each quadrant run through the entries of its set, bit k for index k.
void use_in_turn(Vq2& fields, const std::array<std::uint64_t, 4>& used) {
  for (std::uint32_t q = 0; q < 4; ++q) {
    std::vector<std::uint8_t> indices;
    for (std::uint8_t index = 0; index < 8; ++index)
      if ((used[q] >> index & 1) != 0) indices.push_back(index);
    for (std::uint32_t vector = 0, next = 0; vector < 64; ++vector)
      if (static_cast<std::uint32_t>(spec::vq::quadrant_of(vector % 8, vector / 8)) == q)
        fields.indices[vector] = indices[next++ % indices.size()];
  }
}

constexpr std::uint64_t all_entries = 255;

/// Quadrants that use all their entries beside some that use few, and one entry that two quadrants own.  An encoder
/// that shares an entry because most quadrants use it lacks room for the others.
void fill_unevenly(Vq2& fields, Random& random) {
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(32)); };
  for (auto& c : fields.shared) c = code();
  for (auto& pair : fields.own)
    for (auto& c : pair) c = code();
  const std::uint64_t from = random.below(4), to = (from + random.below(4)) % 4;
  fields.own[to][random.below(2)] = fields.own[from][random.below(2)];
  std::array<std::uint64_t, 4> used;
  for (auto& of_quadrant : used) of_quadrant = random.below(2) == 0 ? all_entries : 1 + random.below(255);
  use_in_turn(fields, used);
}

/// All entries differ, none has one state only, and all are used: about half of such blocks have no second triple of
/// transforms.
void fill_full(Vq2& fields, Random& random) {
  std::vector<std::uint8_t> codes;
  for (std::uint8_t code = 0; code < 32; ++code)
    if (code % 16 != 0 && code % 16 != 15) codes.push_back(code);
  const auto next = [&] {
    const std::size_t at = random.below(codes.size());
    const std::uint8_t code = codes[at];
    codes.erase(codes.begin() + static_cast<std::ptrdiff_t>(at));
    return code;
  };
  for (auto& c : fields.shared) c = next();
  for (auto& pair : fields.own)
    for (auto& c : pair) c = next();
  use_in_turn(fields, {all_entries, all_entries, all_entries, all_entries});
}

/// One to three entries in all: the codebook has room for more, and an encoder may leave out none.
void fill_sparsely(Vq2& fields, Random& random) {
  const std::uint64_t count = 1 + random.below(3);
  std::array<std::uint64_t, 4> used;
  used.fill(7);
  for (std::uint64_t k = 0; k < count; ++k) {
    // A code with more than one state.
    const auto code = static_cast<std::uint8_t>(16 * random.below(2) + 1 + random.below(14));
    const std::uint64_t index = 3 + random.below(5), owner = random.below(4);
    if (index < 6)
      fields.shared[index - 3] = code;
    else
      fields.own[owner][index - 6] = code;
    for (std::uint64_t q = 0; q < 4; ++q)
      if (q == owner || (index < 6 && random.below(2) != 0)) used[q] |= std::uint64_t{1} << index;
  }
  use_in_turn(fields, used);
}

/// One quadrant uses all its entries.  Each other uses a shared one and two of its own, one of which all three have.
/// Sharing the entry that most quadrants use leaves too few for the quadrant that needs three.
void fill_with_a_common_own(Vq2& fields, Random& random) {
  fill_full(fields, random);
  const std::uint64_t full = random.below(4);
  std::array<std::uint64_t, 4> used{};
  std::uint64_t shared = random.below(3);
  const std::uint8_t common = fields.own[(full + 1) % 4][0];
  for (std::uint64_t q = 0; q < 4; ++q) {
    if (q != full) fields.own[q][0] = common;
    used[q] = q == full ? all_entries & ~std::uint64_t{7} : std::uint64_t{1} << (3 + shared++ % 3) | 3u << 6;
  }
  use_in_turn(fields, used);
}

/// A block's map with up to three regions changed, so that it nearly fits a block.
template <class Format>
Map<Format> near_a_block(Random& random) {
  Format fields;
  for (std::size_t q = 1; q < 4; ++q) fields.transforms[q] = any_transform(random);
  fill(fields, random.below(2) != 0, random);
  Map<Format> map = spec::vq::decode(fields);
  for (std::uint64_t odd = 1 + random.below(3); odd > 0; --odd)
    map[random.below(map.size())] = any_state(random);
  return map;
}

}  // namespace

template <class Format>
Vector<Format::side> vector_of(const Map<Format>& map, std::uint32_t vector) {
  constexpr std::size_t side = Format::side;
  Vector<side> v;
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = map[side * (vector % 8) + k % side + 8 * side * (side * (vector / 8) + k / side)];
  return v;
}

template <class Format>
void put(Map<Format>& map, std::uint32_t vector, const Vector<Format::side>& v) {
  constexpr std::size_t side = Format::side;
  for (std::size_t k = 0; k < v.size(); ++k)
    map[side * (vector % 8) + k % side + 8 * side * (side * (vector / 8) + k / side)] = v[k];
}

template <class Format>
Map<Format> sample_map(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, level_of<Format>, k);
  switch (k % 32) {
    case 31: return noise<Format>(random);
    case 14:
    case 30: return few_vectors<Format>(random);
    case 12: return uniform<Format>(random);
    case 11:
    case 28: return tiled<Format>(random);
    case 13:
    case 29: return one_odd_region<Format>(random);
    case 15:
    case 17:
    case 21:
    case 27: return near_a_block<Format>(random);
    default: break;
  }
  constexpr std::array shapes{wide_outline<Format>, sharp<Format>, two_shapes<Format>, symmetric<Format>};
  return shapes[k % shapes.size()](random);
}

template <class Format>
Format sample_block(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 16 + level_of<Format>, k);
  Format fields;
  for (std::uint32_t q = 1; q < 4; ++q)
    fields.transforms[q] = Transform::of(static_cast<std::uint32_t>(k >> 3 * (q - 1)) % 8);
  const std::uint64_t kind = k / 512 % 4;
  if constexpr (Format::side == 2) {
    if (kind >= 2)
      fill_full(fields, random);
    else if (kind == 1)
      fill_unevenly(fields, random);
    else if (k / 2048 % 4 == 3)
      fill_sparsely(fields, random);
    else if (random.below(8) == 0)
      fill_with_a_common_own(fields, random);
    else
      fill(fields, random.below(4) != 0, random);
  } else {
    fill(fields, kind % 2 == 0 && random.below(4) != 0, random);
  }
  return fields;
}

template Vector<2> vector_of<Vq2>(const Map<Vq2>&, std::uint32_t);
template Vector<4> vector_of<Vq4>(const Map<Vq4>&, std::uint32_t);
template void put<Vq2>(Map<Vq2>&, std::uint32_t, const Vector<2>&);
template void put<Vq4>(Map<Vq4>&, std::uint32_t, const Vector<4>&);
template Map<Vq2> sample_map<Vq2>(std::uint64_t, std::uint64_t);
template Map<Vq4> sample_map<Vq4>(std::uint64_t, std::uint64_t);
template Vq2 sample_block<Vq2>(std::uint64_t, std::uint64_t);
template Vq4 sample_block<Vq4>(std::uint64_t, std::uint64_t);

}  // namespace mmverify::proofs::vq
