#include <algorithm>

#include "impl/subdivision/rules.hpp"
#include "impl/subdivision/subdivision.hpp"

namespace mmverify::impl::subdivision {
namespace detail {
namespace {

/// Corners on a grid, and a path's state.
struct Shape {
  std::array<Offset, 4> corners;
  unsigned state;
  friend bool operator==(const Shape&, const Shape&) = default;
};

Shape unit_shape(Scheme scheme) {
  switch (scheme) {
    case Scheme::hilbert:
    case Scheme::morton: return {{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}, 0};
    case Scheme::tetrahedron: return {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, first_path};
    case Scheme::bisection: return {{{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}}, 0};
    default: return {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0};
  }
}

/// The children of a shape on a grid that is finer by the factor `parts`.
std::vector<Shape> children_of(Scheme scheme, const Shape& parent) {
  const auto s = static_cast<std::size_t>(scheme);
  std::vector<Shape> all;
  for (unsigned digit = 0; digit < children[s]; ++digit) {
    const Listed child = listed(scheme, parent.state, digit);
    Shape shape{{}, child.state};
    const char* names = child.corners;
    for (std::size_t k = 0; k < corner_count[s]; ++k, names += parts[s] + 1)
      for (std::size_t part = 0; part < parts[s]; ++part)
        for (std::size_t axis = 0; axis < 3; ++axis)
          shape.corners[k][axis] += parent.corners[static_cast<std::size_t>(names[part] - '0')][axis];
    all.push_back(shape);
  }
  return all;
}

/// Halves the grid of the children if all their corners lie on every other line; returns the grid's scale.
std::uint32_t coarsened(std::uint32_t scale, std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes)
    for (const Offset& corner : shape.corners)
      for (const std::int32_t x : corner)
        if (x % static_cast<std::int32_t>(scale) != 0) return scale;
  for (Shape& shape : shapes)
    for (Offset& corner : shape.corners)
      for (std::int32_t& x : corner) x /= static_cast<std::int32_t>(scale);
  return 1;
}

/// The shape moved so that its first corner is the origin.
Shape at_origin(Shape shape, std::size_t count) {
  const Offset first = shape.corners[0];
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) shape.corners[k][axis] -= first[axis];
  return shape;
}

std::vector<Orientation> closure(Scheme scheme) {
  const auto s = static_cast<std::size_t>(scheme);
  std::vector<Shape> known{at_origin(unit_shape(scheme), corner_count[s])};
  std::vector<Orientation> all;
  for (std::size_t k = 0; k < known.size(); ++k) {
    std::vector<Shape> shapes = children_of(scheme, known[k]);
    Orientation one{known[k].corners, coarsened(parts[s], shapes), {}, {}};
    for (std::size_t digit = 0; digit < shapes.size(); ++digit) {
      one.shift[digit] = shapes[digit].corners[0];
      const Shape child = at_origin(shapes[digit], corner_count[s]);
      auto found = std::find(known.begin(), known.end(), child);
      if (found == known.end()) found = known.insert(found, child);
      one.next[digit] = static_cast<std::uint8_t>(found - known.begin());
    }
    all.push_back(one);
  }
  return all;
}

}  // namespace

const std::vector<Orientation>& orientations(Scheme scheme) {
  static const std::array<std::vector<Orientation>, 6> all{
      closure(Scheme::triangle_4), closure(Scheme::triangle_9),  closure(Scheme::hilbert),
      closure(Scheme::morton),     closure(Scheme::tetrahedron), closure(Scheme::bisection)};
  return all[static_cast<std::size_t>(scheme)];
}

}  // namespace detail

std::uint32_t side(Scheme scheme, Level level) noexcept {
  level = std::min(level, highest_level(scheme));
  if (scheme == Scheme::bisection) level = (level + 1) / 2;
  std::uint32_t N = 1;
  for (Level depth = 0; depth < level; ++depth) N *= detail::parts[static_cast<std::size_t>(scheme)];
  return N;
}

namespace {

/// The cell with an index in base b, for corners of `count`, whose first one lies at `first` at level 0.
template <unsigned b>
Corners walked(const std::vector<detail::Orientation>& all, std::size_t count, Vertex first, Level level,
               std::uint32_t index) noexcept {
  std::array<std::uint8_t, 31> digits{};
  for (Level depth = level; depth-- > 0; index /= b) digits[depth] = static_cast<std::uint8_t>(index % b);
  const detail::Orientation* at = all.data();
  // Words wrap: a corner is not negative, but the way to it may be.
  for (Level depth = 0; depth < level; ++depth) {
    const unsigned digit = digits[depth];
    for (std::size_t axis = 0; axis < 3; ++axis)
      first[axis] = first[axis] * at->scale + static_cast<std::uint32_t>(at->shift[digit][axis]);
    at = all.data() + at->next[digit];
  }
  Corners found{};
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      found[k][axis] = first[axis] + static_cast<std::uint32_t>(at->corners[k][axis]);
  return found;
}

}  // namespace

Corners corners(Scheme scheme, Level level, std::uint32_t index) noexcept {
  level = std::min(level, highest_level(scheme));
  const std::vector<detail::Orientation>& all = detail::orientations(scheme);
  switch (scheme) {
    case Scheme::triangle_4: return walked<4>(all, 3, {}, level, index);
    case Scheme::triangle_9: return walked<9>(all, 3, {}, level, index);
    case Scheme::tetrahedron: return walked<8>(all, 4, {}, level, index);
    case Scheme::bisection: return walked<2>(all, 3, {1, 0, 0}, level, index);
    default: return walked<4>(all, 4, {}, level, index);
  }
}

}  // namespace mmverify::impl::subdivision
