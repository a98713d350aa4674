#include "proofs/bake/domains/family.hpp"

#include <fmt/format.h>

#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace bake = spec::bake;
// The coordinates of the triangles have few bits.
using Q = Rational64;

/// Marks of a part: some point of it is not opaque, some point is not transparent, its one point is rather opaque.
using Marks = std::uint8_t;
constexpr Marks not_opaque = 1, not_transparent = 2, rather_opaque = 4, known = 8;
constexpr Marks mixed_cells = not_opaque | not_transparent;

std::uint64_t power(std::uint64_t base, std::uint32_t exponent) {
  std::uint64_t result = 1;
  while (exponent-- > 0) result *= base;
  return result;
}

/// The part of a polygon in one cell, or in one texel with nearest filtering, and its marks for each combination of
/// texel values.
struct Part {
  std::int64_t i, j;
  bake::Polygon<Q> local;                         ///< in the cell's coordinates; empty with nearest filtering
  mutable std::vector<std::atomic<Marks>> marks;  ///< by threshold and texel values

  Part(std::int64_t column, std::int64_t row, bake::Polygon<Q> polygon, std::size_t kinds)
      : i(column), j(row), local(std::move(polygon)), marks(3 * kinds) {}
};

struct Micro {
  std::vector<Part> parts;
  std::vector<Part> centroid;  ///< the part at the centroid, exactly one
};
using Micros = std::vector<Micro>;

}  // namespace

/// The true states of a level, a byte each, kept for later laws and their mutants.
struct Enumerated::CaseCache {
  static constexpr Level levels = 4;
  static constexpr std::uint64_t most = 100'000;  ///< the most cases that are kept: some 5 MB a family
  struct OfLevel {
    std::vector<std::uint8_t> states;
    std::vector<std::atomic<bool>> known;
  };
  std::array<std::once_flag, levels> once;
  std::array<OfLevel, levels> of_level;

  /// The kept states of a level; null if there are too many.
  OfLevel* of(Level n, std::uint64_t cases) {
    if (n >= levels || cases > most) return nullptr;
    std::call_once(once[n], [&] {
      of_level[n].states.resize(cases << 2 * n);
      of_level[n].known = std::vector<std::atomic<bool>>(cases);
    });
    return &of_level[n];
  }
};

struct Enumerated::Geometry {
  static constexpr Level levels = 13;
  struct Slot {
    std::once_flag once;
    Micros micros;
    std::int64_t first_i = 0, first_j = 0, last_i = 0, last_j = 0;  ///< the texels that the parts name
  };
  std::vector<Slot> slots;

  explicit Geometry(std::size_t triangles) : slots(triangles * levels) {}

  static std::vector<Part> parts_of(const Family& f, const bake::Polygon<Q>& polygon) {
    std::vector<Part> parts;
    const bool nearest = f.filter == Filter::nearest,
               open = f.rules.contact == bake::Contact::open && bake::has_area(polygon);
    const std::size_t kinds = power(f.alphabet.size(), nearest ? 1 : 4);
    bake::for_each_square(polygon, nearest ? Q(0) : bake::fraction<Q>(1, 2),
                          [&](std::int64_t i, std::int64_t j, bake::Polygon<Q> part) {
                            if (open && !bake::has_area(part)) return;
                            for (auto& p : part)
                              p = {p.x - bake::Cell<Q>::along(i), p.y - bake::Cell<Q>::along(j)};
                            if (nearest) part.clear();
                            parts.emplace_back(i, j, std::move(part), kinds);
                          });
    return parts;
  }

  const Slot& of(const Family& f, std::size_t triangle, Level n) {
    Slot& slot = slots[triangle * levels + n];
    std::call_once(slot.once, [&] {
      Case one;
      one.uv = f.triangles[triangle];
      const auto uv = base_triangle<Q>(one);
      for (std::uint32_t index = 0; index < std::uint32_t{1} << 2 * n; ++index) {
        const auto polygon = bake::micro_triangle(uv, n, index, f.side, f.side);
        slot.micros.push_back({parts_of(f, polygon), parts_of(f, {bake::centroid(polygon)})});
      }
      find_texels(slot);
    });
    return slot;
  }

  static void find_texels(Slot& slot) {
    const Part& any = slot.micros.front().parts.front();
    slot.first_i = slot.last_i = any.i;
    slot.first_j = slot.last_j = any.j;
    for (const Micro& micro : slot.micros)
      for (const auto* parts : {&micro.parts, &micro.centroid})
        for (const Part& part : *parts) {
          slot.first_i = std::min(slot.first_i, part.i);
          slot.first_j = std::min(slot.first_j, part.j);
          slot.last_i = std::max(slot.last_i, part.i + 1);  // bilinear filtering takes the next one, too
          slot.last_j = std::max(slot.last_j, part.j + 1);
        }
  }

  /// Domain: values of the cell's texels in the order (0,0), (1,0), (0,1), (1,1); one value with nearest filtering.
  static Marks marks(const Family& f, const Part& part, const std::array<std::uint8_t, 4>& values,
                     Threshold threshold) {
    const std::size_t base = f.alphabet.size();
    const std::size_t of_values =
        f.filter == Filter::nearest ? values[0]
                                    : values[0] + base * (values[1] + base * (values[2] + base * values[3]));
    const std::size_t key = of_values + part.marks.size() / 3 * static_cast<std::size_t>(threshold);
    Marks found = part.marks[key].load(std::memory_order_relaxed);
    if (found != 0) return found;
    Case four;
    four.width = four.height = 2;
    four.texel = f.texel;
    four.alpha.clear();
    for (const std::uint8_t value : values)
      four.alpha.push_back(converted(Texel::unorm8, f.texel, f.alphabet[value]));
    const auto range = with_textures(four, [&](const auto& mips) {
      return f.filter == Filter::nearest ? bake::Range<Q>(bake::texel<Q>(mips.front(), 0, 0))
                                         : bake::range(bake::Cell<Q>(mips.front(), 0, 0), part.local);
    });
    // A part with an area may leave out its boundary with open contact; a part without an area is closed.
    const bool varies =
        f.rules.contact == bake::Contact::open && range.least < range.greatest && bake::has_area(part.local);
    found = with_mode<Q>(f.blend, f.cutoff, f.rules, threshold, [&](const auto& mode) {
      const bool opaque = mode.opaque(range.least) || (varies && mode.opaque_above(range.least)),
                 transparent =
                     mode.transparent(range.greatest) || (varies && mode.transparent_below(range.greatest));
      return static_cast<Marks>(known | (opaque ? 0 : not_opaque) | (transparent ? 0 : not_transparent) |
                                (mode.rather_opaque(range.greatest) ? rather_opaque : 0));
    });
    part.marks[key].store(found, std::memory_order_relaxed);
    return found;
  }
};

std::vector<Spot> Family::all_spots() const {
  if (!spots.empty()) return spots;
  std::vector<Spot> all;
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
    for (const auto& [u, v] : wraps) all.push_back({u, v, triangle});
  return all;
}

Enumerated::Enumerated(Family family)
    : family_(std::move(family)),
      spots_(family_.all_spots()),
      textures_(power(family_.alphabet.size(), family_.varied() * family_.varied())),
      geometry_(std::make_unique<Geometry>(family_.triangles.size())),
      kept_{std::make_unique<CaseCache>(), std::make_unique<CaseCache>(), std::make_unique<CaseCache>()} {}
Enumerated::~Enumerated() = default;
Enumerated::Enumerated(Enumerated&&) noexcept = default;

std::uint64_t Enumerated::count() const { return textures_ * spots_.size(); }

std::vector<std::uint8_t> Enumerated::values(std::uint64_t texture) const {
  const std::uint32_t side = family_.side, varied = family_.varied();
  std::vector<std::uint8_t> places(side * side);
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      std::uint8_t& place = places[i + side * j];
      if (i >= varied || j >= varied) {
        place = places[std::min(i, varied - 1) + side * std::min(j, varied - 1)];
        continue;
      }
      place = static_cast<std::uint8_t>(texture % family_.alphabet.size());
      texture /= family_.alphabet.size();
    }
  return places;
}

Case Enumerated::at(std::uint64_t k) const {
  const Spot& spot = spots_.at(k / textures_);
  Case one;
  one.width = one.height = family_.side;
  one.alpha.clear();
  for (const std::uint8_t place : values(k % textures_))
    one.alpha.push_back(converted(Texel::unorm8, family_.texel, family_.alphabet[place]));
  one.texel = family_.texel;
  one.filter = family_.filter;
  one.wrap_u = spot.u;
  one.wrap_v = spot.v;
  one.border = converted(Texel::unorm8, family_.texel, family_.alphabet.front());
  one.cutoff = family_.cutoff;
  one.blend = family_.blend;
  one.uv = family_.triangles[spot.triangle];
  one.rules = family_.rules;
  return one;
}

std::vector<State> Enumerated::truth(Level n, std::uint64_t k, Threshold threshold) const {
  if (family_.rules.slack == 0) threshold = Threshold::exact;
  CaseCache::OfLevel* const kept = kept_[static_cast<std::size_t>(threshold)]->of(n, count());
  if (kept == nullptr) return found(n, k, threshold);
  const std::size_t size = std::size_t{1} << 2 * n;
  std::uint8_t* const states = kept->states.data() + k * size;
  std::vector<State> truth(size);
  if (kept->known[k].load(std::memory_order_acquire)) {
    std::transform(states, states + size, truth.begin(),
                   [](std::uint8_t s) { return static_cast<State>(s); });
    return truth;
  }
  truth = found(n, k, threshold);
  static std::mutex lock;
  const std::lock_guard hold(lock);
  if (kept->known[k].load(std::memory_order_relaxed)) return truth;
  std::transform(truth.begin(), truth.end(), states, [](State s) { return static_cast<std::uint8_t>(s); });
  kept->known[k].store(true, std::memory_order_release);
  return truth;
}

std::vector<State> Enumerated::found(Level n, std::uint64_t k, Threshold threshold) const {
  const Spot& spot = spots_.at(k / textures_);
  const std::vector<std::uint8_t> places = values(k % textures_);
  const Geometry::Slot& slot = geometry_->of(family_, spot.triangle, n);
  // Many parts name the same texel.
  const auto columns = static_cast<std::size_t>(slot.last_i - slot.first_i + 1);
  std::vector<std::uint8_t> named;
  for (std::int64_t j = slot.first_j; j <= slot.last_j; ++j)
    for (std::int64_t i = slot.first_i; i <= slot.last_i; ++i) {
      const auto x = bake::wrapped(spot.u, i, family_.side), y = bake::wrapped(spot.v, j, family_.side);
      named.push_back(x && y ? places[*x + family_.side * *y] : std::uint8_t{0});
    }
  const auto value_at = [&](std::int64_t i, std::int64_t j) {
    return named[static_cast<std::size_t>(i - slot.first_i) +
                 columns * static_cast<std::size_t>(j - slot.first_j)];
  };
  const auto marks = [&](const Part& p) {
    return Geometry::marks(
        family_, p,
        family_.filter == Filter::nearest
            ? std::array<std::uint8_t, 4>{value_at(p.i, p.j)}
            : std::array<std::uint8_t, 4>{value_at(p.i, p.j), value_at(p.i + 1, p.j), value_at(p.i, p.j + 1),
                                          value_at(p.i + 1, p.j + 1)},
        threshold);
  };
  std::vector<State> states;
  for (const Micro& micro : slot.micros) {
    Marks all = 0;
    for (const Part& part : micro.parts) {
      all = static_cast<Marks>(all | marks(part));
      if ((all & mixed_cells) == mixed_cells) break;
    }
    if ((all & mixed_cells) != mixed_cells)
      states.push_back((all & not_opaque) == 0 ? State::O : State::T);
    else
      states.push_back((marks(micro.centroid.front()) & rather_opaque) != 0 ? State::UO : State::UT);
  }
  return states;
}

std::string Enumerated::domain() const {
  return fmt::format(
      "all {} {}x{} textures{} over {}/255, {}, {}, {} pairs of addressing modes, border {}, {} UV triangles",
      textures_, family_.side, family_.side,
      family_.block == 0 ? std::string()
                         : fmt::format(" that vary in {}x{} texels", family_.block, family_.block),
      fmt::join(family_.alphabet, ", "), family_.filter == Filter::nearest ? "nearest" : "bilinear",
      family_.blend ? std::string("BLEND")
                    : fmt::format("cutoff {}/{}", family_.cutoff.numerator, family_.cutoff.denominator),
      family_.wraps.size(), family_.alphabet.front(), family_.triangles.size());
}

Families::Families(std::vector<Family> families) {
  for (Family& f : families) all_.emplace_back(std::move(f));
}

std::pair<const Enumerated*, std::uint64_t> Families::find(std::uint64_t k) const {
  for (const Enumerated& e : all_) {
    if (k < e.count()) return {&e, k};
    k -= e.count();
  }
  throw std::out_of_range("no such case of a family");
}

std::uint64_t Families::count() const {
  std::uint64_t sum = 0;
  for (const Enumerated& e : all_) sum += e.count();
  return sum;
}

Case Families::at(std::uint64_t k) const {
  const auto [family, number] = find(k);
  return family->at(number);
}

std::vector<State> Families::truth(Level n, std::uint64_t k, Threshold threshold) const {
  const auto [family, number] = find(k);
  return family->truth(n, number, threshold);
}

std::string Families::domain() const {
  std::string text;
  for (const Enumerated& e : all_) text += (text.empty() ? "" : "; ") + e.domain();
  return text;
}

namespace {

std::vector<std::pair<Wrap, Wrap>> every_pair() {
  constexpr Wrap every[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::clamp_to_border,
                            Wrap::mirror_once};
  std::vector<std::pair<Wrap, Wrap>> pairs;
  for (const Wrap u : every)
    for (const Wrap v : every) pairs.emplace_back(u, v);
  return pairs;
}

/// Triangles over half of the texture; across texel lines; turned over and beyond every edge; far below 0; on a line;
/// in a point, a texel's centre.
std::vector<Triangle> on_two() {
  return {{0, 0, 1, 0, 0, 1},
          {0.125f, 0.1875f, 1, 0.25f, 0.375f, 0.875f},
          {1.25f, -0.25f, -0.5f, 0.5f, 0.75f, 1.5f},
          {-3, -2, -2.25f, -2, -3, -1.25f},
          {0, 0.25f, 0.5f, 0.5f, 1, 0.75f},
          {0.25f, 0.25f, 0.25f, 0.25f, 0.25f, 0.25f}};
}
/// Triangles of the same kinds on three texels, and a sliver.
std::vector<Triangle> on_three() {
  return {{0, 0, 1, 0, 0, 1},
          {0.125f, 0.125f, 0.9375f, 0.25f, 0.25f, 0.875f},
          {1.25f, -0.25f, -0.25f, 0.5f, 0.75f, 1.25f},
          {0, 0.5f, 1, 0.53125f, 1, 0.5f}};
}

constexpr Cutoff met_by_texels{128, 255}, met_midway{1, 2};

}  // namespace

const Families& bilinear_families() {
  static const Families families(
      {{2, {0, 128, 255}, met_by_texels, Filter::bilinear, false, every_pair(), on_two()},
       {3, {0, 255}, met_midway, Filter::bilinear, false, every_pair(), on_three()}});
  return families;
}

const Families& nearest_families() {
  static const Families families(
      {{2, {0, 128, 255}, met_by_texels, Filter::nearest, false, every_pair(), on_two()},
       {3, {0, 255}, met_midway, Filter::nearest, false, every_pair(), on_three()}});
  return families;
}

const Families& blend_families() {
  static const Families families({{2, {0, 128, 255}, {}, Filter::bilinear, true, every_pair(), on_two()},
                                  {2, {0, 128, 255}, {}, Filter::nearest, true, every_pair(), on_two()}});
  return families;
}

const Families& grid_families() {
  static const Families families = [] {
    // Coordinates beyond the first texel mirrored once, at a centre, and on the texture's edge.
    constexpr float along[] = {-0.8125f, 0.25f, 1};
    Family f{2, {0, 128, 255}, met_by_texels, Filter::bilinear, false, every_pair(), {}};
    const auto point = [&](std::uint32_t k) { return std::pair{along[k % 3], along[k / 3]}; };
    for (std::uint32_t k = 0; k < 9 * 9 * 9; ++k) {
      const auto [p, q, r] = std::tuple{point(k % 9), point(k / 9 % 9), point(k / 81)};
      f.triangles.push_back({p.first, p.second, q.first, q.second, r.first, r.second});
    }
    return Families({f});
  }();
  return families;
}

}  // namespace mmverify::proofs::bake
