#include "proofs/subdivision/cases.hpp"

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::subdivision {
namespace {

using spec::subdivision::cells;

/// Denominators of midpoints, of means of three and of four corners.
constexpr std::uint32_t finer = 12;

std::uint64_t points_of_cell(const Cut& c) { return c.corners * (c.corners + 1) / 2 + 1; }

/// Point `number` of a cell: a corner, a midpoint, or the last one, the mean.
Fractions point_of_cell(const Indexed& at, std::uint64_t number) {
  const Cut c = cut(at.scheme);
  const std::uint32_t N = side(at.scheme, at.level);
  const auto corners = spec::subdivision::cell<Whole>(at.scheme, at.level, at.index, N).corners;
  Fractions found{{}, finer * N};
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < c.corners && of.empty(); ++i)
    for (std::size_t j = i; j < c.corners; ++j)
      if (number-- == 0) of = {i, j};
  if (of.empty())
    for (std::size_t i = 0; i < c.corners; ++i) of.push_back(i);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Whole sum = 0;
    for (const std::size_t i : of) sum += corners[i][axis];
    found.numerators[axis] = static_cast<std::uint32_t>(sum * finer / static_cast<Whole>(of.size()));
  }
  return found;
}

const char* name_of(Scheme scheme) {
  static const auto names = [] {
    std::array<std::string, all_schemes.size()> all;
    for (const Scheme s : all_schemes) all[static_cast<std::size_t>(s)] = cut(s).name;
    return all;
  }();
  return names[static_cast<std::size_t>(scheme)].c_str();
}

SchemeLevel scheme_of_text(const std::string& name, const std::string& level) {
  for (const Scheme s : all_schemes)
    if (name == name_of(s) && std::stoul(level) <= cut(s).highest)
      return {s, static_cast<Level>(std::stoul(level))};
  throw BadCase(fmt::format("'{:.40}/{}': no such scheme at that level", name, level));
}

/// Whether a point lies in the closed unit shape.
bool inside(Scheme scheme, const Fractions& p) {
  std::uint64_t sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p.numerators[axis] > p.denominator || (axis >= cut(scheme).dimension && p.numerators[axis] != 0))
      return false;
    sum += p.numerators[axis];
  }
  return scheme == Scheme::hilbert || scheme == Scheme::morton || sum <= p.denominator;
}

}  // namespace

std::vector<SchemeLevel> scheme_levels(Level n) {
  std::vector<SchemeLevel> all;
  for (const Scheme s : all_schemes)
    for (const Level level : s == Scheme::bisection ? std::vector{2 * n, 2 * n + 1} : std::vector{n})
      if (level <= cut(s).highest) all.push_back({s, level});
  return all;
}

std::uint64_t cell_count(Level n) {
  std::uint64_t count = 0;
  for (const auto& [scheme, level] : scheme_levels(n)) count += cells(scheme, level);
  return count;
}

Indexed cell_number(Level n, std::uint64_t k) {
  for (const auto& [scheme, level] : scheme_levels(n)) {
    if (k < cells(scheme, level)) return {scheme, level, k};
    k -= cells(scheme, level);
  }
  throw std::logic_error("no such cell");
}

std::uint64_t point_count(Level n) {
  std::uint64_t count = 0;
  for (const auto& [scheme, level] : scheme_levels(n))
    count += cells(scheme, level) * points_of_cell(cut(scheme));
  return count;
}

Placed point_number(Level n, std::uint64_t k) {
  for (const auto& [scheme, level] : scheme_levels(n)) {
    const std::uint64_t each = points_of_cell(cut(scheme)), all = cells(scheme, level) * each;
    if (k < all) return {scheme, level, point_of_cell({scheme, level, k / each}, k % each)};
    k -= all;
  }
  throw std::logic_error("no such point");
}

Placed sample_point(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 911 + n, k);
  const std::vector<SchemeLevel> levels = scheme_levels(n);
  const SchemeLevel chosen = levels[random.below(levels.size())];
  const Scheme scheme = chosen.scheme;
  const Level level = chosen.level;
  // A multiple of the side has the grid's own points among its fractions.
  const std::uint32_t N = side(scheme, level), most = std::uint32_t{1} << 31;
  const bool on_grid = random.below(2) == 0;
  const auto denominator = static_cast<std::uint32_t>(on_grid ? N * (1 + random.below(std::min(most / N, 6u)))
                                                              : 1 + random.below(most));
  Placed placed{scheme, level, {{}, denominator}};
  do {
    for (std::size_t axis = 0; axis < cut(scheme).dimension; ++axis)
      placed.point.numerators[axis] =
          static_cast<std::uint32_t>(random.below(std::uint64_t{denominator} + 1));
  } while (!inside(scheme, placed.point));
  return placed;
}

std::string text_of(const Indexed& cell) {
  return fmt::format("{}/{}:k={}", name_of(cell.scheme), cell.level, cell.index);
}

std::string text_of(const Placed& point) {
  const auto& [x, y, z] = point.point.numerators;
  return fmt::format("{}/{}:{},{},{}/{}", name_of(point.scheme), point.level, x, y, z,
                     point.point.denominator);
}

Indexed cell_of_text(const std::string& text) {
  const Groups parts = groups_of(text, "([a-z0-9-]{1,20})/([0-9]{1,2}):k=([0-9]{1,10})");
  if (!parts) throw BadCase(fmt::format("'{:.60}': write SCHEME/LEVEL:k=INDEX", text));
  const auto [scheme, level] = scheme_of_text((*parts)[1], (*parts)[2]);
  const std::uint64_t index = std::stoull((*parts)[3]);
  if (index >= cells(scheme, level))
    throw BadCase(fmt::format("'{:.60}': the level has {} cells", text, cells(scheme, level)));
  return {scheme, level, index};
}

Placed point_of_text(const std::string& text) {
  const Groups parts = groups_of(
      text, "([a-z0-9-]{1,20})/([0-9]{1,2}):([0-9]{1,10}),([0-9]{1,10}),([0-9]{1,10})/([0-9]{1,10})");
  if (!parts) throw BadCase(fmt::format("'{:.60}': write SCHEME/LEVEL:X,Y,Z/DENOMINATOR", text));
  const auto [scheme, level] = scheme_of_text((*parts)[1], (*parts)[2]);
  constexpr std::uint64_t most = std::uint64_t{1} << 31;
  std::array<std::uint64_t, 4> numbers{};
  for (std::size_t k = 0; k < 4; ++k) numbers[k] = std::stoull((*parts)[3 + k]);
  const auto [x, y, z, denominator] = numbers;
  if (denominator == 0 || std::max({x, y, z, denominator}) > most)
    throw BadCase(fmt::format("'{:.60}': fractions of 1 to 2^31", text));
  const auto word = [](std::uint64_t number) { return static_cast<std::uint32_t>(number); };
  const Fractions p{{word(x), word(y), word(z)}, word(denominator)};
  if (!inside(scheme, p)) throw BadCase(fmt::format("'{:.60}': the point is outside of the shape", text));
  return {scheme, level, p};
}

InWholes in_wholes(Scheme scheme, Level n, const Fractions& p) {
  const Int128 N = side(scheme, n);
  return {{p.numerators[0] * N, p.numerators[1] * N, p.numerators[2] * N}, p.denominator * N};
}

std::uint64_t specified_index(Scheme scheme, Level n, const Fractions& p) {
  const InWholes at = in_wholes(scheme, n, p);
  return spec::subdivision::index<Int128>(scheme, n, at.point, at.unit);
}

}  // namespace mmverify::proofs::subdivision
