#include "proofs/bake/laws/relation_judges.hpp"

#include <cmath>

namespace mmverify::proofs::bake {
std::vector<State> map_of(const BakeSubject& s, const Case& one, Level n, Format format) {
  std::optional<Baked> baked = s.functions.bake(one, n, format);
  if (!baked) throw Declined();
  if (!baked->padded) throw Unpadded();
  return std::move(baked->states);
}

Law on_maps(Law law, const Cases& cases, Finding (*holds)(const BakeSubject&, const Case&, Level),
            const Lacks& lacks) {
  return on_cases(
      std::move(law), cases,
      [holds](const BakeSubject& s, const Case& one, Level n, const std::optional<std::uint64_t>&) {
        try {
          return holds(s, one, n);
        } catch (const Declined&) {
          return unsupported();
        } catch (const Unpadded&) {
          return wrong("zeros after the last state", "others");
        }
      },
      {}, lacks);
}

namespace {

using spec::micromap::as_unknown;
using spec::micromap::force2;
using spec::micromap::unknown;

/// Whether one micro-triangle cannot have both states.  Any state may be unknown, so only O against T contradicts.
/// If unknown states go by the centroid, the two must agree under force-2-state.  A subject that promises to be tight
/// must give the same state.
bool contradict(const BakeSubject& s, State a, State b) {
  if (s.functions.tight) return a != b;
  if (s.functions.centroid) return force2(a) != force2(b);
  return a != b && !unknown(a) && !unknown(b);
}

/// The first micro-triangle whose states contradict each other, if any.
std::optional<Finding> differ(const BakeSubject& s, const char* of, const std::vector<State>& expected,
                              const std::vector<State>& got) {
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (contradict(s, got.at(k), expected[k]))
      return wrong(fmt::format("{} micro-triangle {} {}", of, k, name_of(expected[k])), name_of(got[k]));
  return std::nullopt;
}

Case shifted(Case one, float u, float v) {
  for (std::size_t k = 0; k < 6; k += 2) one.uv[k] += u, one.uv[k + 1] += v;
  return one;
}

bool same_coordinates(const Case& a, const Case& b) { return a.uv == b.uv; }

using Order = std::array<std::size_t, 3>;
constexpr std::array<Order, 5> orders{{{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// Three times the weights of a micro-triangle's centroid, over 3N, for the first, second and third vertex.
using Weights = std::array<std::uint32_t, 3>;
Weights weights_of(std::uint32_t index, Level n) {
  Weights w{3 * spec::side(n), 0, 0};
  for (const spec::index::Vertex& corner : spec::index::corners(index, n)) {
    w[1] += corner.i;
    w[2] += corner.j;
  }
  w[0] -= w[1] + w[2];
  return w;
}

/// The micro-triangle of the original triangle for each one of the triangle with its vertices in `order`.
std::vector<std::uint32_t> places(const Order& order, Level n) {
  std::map<Weights, std::uint32_t> by_weights;
  const std::uint32_t count = std::uint32_t{1} << 2 * n;
  for (std::uint32_t k = 0; k < count; ++k) by_weights.emplace(weights_of(k, n), k);
  std::vector<std::uint32_t> places(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Weights w = weights_of(k, n);
    Weights original{};
    for (std::size_t vertex = 0; vertex < 3; ++vertex) original[order[vertex]] = w[vertex];
    places[k] = by_weights.at(original);
  }
  return places;
}

const std::vector<std::uint32_t>& known_places(std::size_t order, Level n) {
  static std::mutex lock;
  static std::map<std::pair<std::size_t, Level>, std::vector<std::uint32_t>> known;
  const std::lock_guard hold(lock);
  auto& found = known[{order, n}];
  if (found.empty()) found = places(orders.at(order), n);
  return found;
}

/// One mip as a texture.
Case mip_of(const Case& one, std::uint32_t mip) {
  Case other = one;
  other.width = std::max(1u, one.width >> mip);
  other.height = std::max(1u, one.height >> mip);
  other.mips = 1;
  const auto from = one.alpha.begin() + static_cast<std::ptrdiff_t>(texels_of(one.width, one.height, mip));
  other.alpha.assign(from, from + std::ptrdiff_t{other.width} * other.height);
  other.drawn.clear();
  return other;
}

/// The period of a texture along an axis, in repeats; 0 if there is none.
float period(Wrap wrap) { return wrap == Wrap::repeat ? 1.0f : wrap == Wrap::mirrored_repeat ? 2.0f : 0.0f; }

/// Whether each micro-triangle of level n holds a whole period: the legs lie along the axes, and its own are two
/// periods and more.
bool holds_periods(const Case& one, Level n) {
  const float u = period(one.wrap_u), v = period(one.wrap_v);
  const auto long_enough = [n](float from, float to, float repeats) {
    return repeats != 0 && std::fabs(double{to} - from) >= std::ldexp(2.0 * repeats, static_cast<int>(n));
  };
  return one.uv[3] == one.uv[1] && one.uv[4] == one.uv[0] && long_enough(one.uv[0], one.uv[2], u) &&
         long_enough(one.uv[1], one.uv[5], v);
}

/// Whether micro-triangles that hold the same texels cannot have both states, apart from the side of unknown ones.
bool contradict_but_for_side(const BakeSubject& s, State a, State b) {
  if (s.functions.tight) return unknown(a) != unknown(b) || (!unknown(a) && a != b);
  return a != b && !unknown(a) && !unknown(b);
}

}  // namespace

Finding keeps_shifts(const BakeSubject& s, const Case& one, Level n) {
  const float u = period(one.wrap_u), v = period(one.wrap_v);
  const std::vector<State> map = map_of(s, one, n);
  for (const auto& [x, y] : {std::pair{u, 0.0f}, {0.0f, -v}, {-3 * u, 5 * v}, {40 * u, -70 * v}}) {
    const Case other = shifted(one, x, y);
    if (!same_coordinates(shifted(other, -x, -y), one)) continue;        // rounded, and so another triangle
    if (fitted(s.functions.support, other, 0).uv != other.uv) continue;  // outside the subject's support
    if (const auto wrong =
            differ(s, fmt::format("shifted by {:g}, {:g}:", x, y).c_str(), map, map_of(s, other, n)))
      return *wrong;
  }
  return {hash_of(map)};
}

Finding keeps_lengths(const BakeSubject& s, const Case& one, Level n) {
  if (!holds_periods(one, n)) return unsupported();
  const float u = period(one.wrap_u), v = period(one.wrap_v);
  const std::vector<State> map = map_of(s, one, n);
  const State all = map.front();
  for (const float periods : {0.0f, 1.0f, 7.0f, 1'000.0f, 65'536.0f}) {
    Case other = one;
    // The legs lie along the axes: (1) is along u, (2) along v.
    other.uv[2] += std::copysign(periods * u, one.uv[2] - one.uv[0]);
    other.uv[5] += std::copysign(periods * v, one.uv[5] - one.uv[1]);
    if (fitted(s.functions.support, other, 0).uv != other.uv) continue;  // outside the subject's support
    const std::vector<State> states = periods == 0 ? map : map_of(s, other, n);
    for (std::size_t k = 0; k < states.size(); ++k)
      if (contradict_but_for_side(s, states[k], all))
        return wrong(fmt::format("longer by {:g} periods: micro-triangle {} {}, as all that hold a period",
                                 periods, k, name_of(all)),
                     name_of(states[k]));
  }
  return {hash_of(map)};
}

Finding keeps_orders(const BakeSubject& s, const Case& one, Level n) {
  const std::vector<State> map = map_of(s, one, n);
  for (std::size_t order = 0; order < orders.size(); ++order) {
    Case other = one;
    for (std::size_t k = 0; k < 3; ++k) {
      other.uv[2 * k] = one.uv[2 * orders[order][k]];
      other.uv[2 * k + 1] = one.uv[2 * orders[order][k] + 1];
    }
    const auto& place = known_places(order, n);
    std::vector<State> expected(map.size());
    for (std::size_t k = 0; k < map.size(); ++k) expected[k] = map[place[k]];
    const auto& o = orders[order];
    if (const auto wrong = differ(s, fmt::format("vertices {}, {}, {}:", o[0], o[1], o[2]).c_str(), expected,
                                  map_of(s, other, n)))
      return *wrong;
  }
  return {hash_of(map)};
}

Finding keeps_formats(const BakeSubject& s, const Case& one, Level n) {
  std::vector<State> forced = map_of(s, one, n);
  for (State& state : forced) state = force2(state);
  const std::vector<State> two = map_of(s, one, n, Format::two_state);
  if (const auto wrong = differ(s, "2-state", forced, two)) return *wrong;
  return {hash_of(two)};
}

Finding keeps_levels(const BakeSubject& s, const Case& one, Level n) {
  const std::vector<State> parents = map_of(s, one, n), children = map_of(s, one, n + 1);
  for (std::size_t k = 0; k < parents.size(); ++k) {
    const auto four = children.begin() + static_cast<std::ptrdiff_t>(4 * k);
    const bool uniform = !unknown(*four) && std::count(four, four + 4, *four) == 4;
    const auto is_other = [&](State child) { return contradict(s, parents[k], child); };
    if (unknown(parents[k]) ? uniform && is_other(*four) : std::any_of(four, four + 4, is_other))
      return wrong(fmt::format("micro-triangle {} {}", k, uniform ? name_of(*four) : "unknown"),
                   name_of(parents[k]));
  }
  return {hash_of(children)};
}

Finding keeps_cutoffs(const BakeSubject& s, const Case& one, Level n) {
  // Cutoffs over 255, which alpha meets exactly, and the case's own.
  std::vector<Cutoff> rising{{0, 1}, {1, 255}, {1, 2}, {128, 255}, {1, 1}, {256, 255}, one.cutoff};
  std::sort(rising.begin(), rising.end(), [](const Cutoff& a, const Cutoff& b) {
    return std::uint64_t{a.numerator} * b.denominator < std::uint64_t{b.numerator} * a.denominator;
  });
  std::vector<State> before;
  std::uint64_t hash = 0;
  for (const Cutoff& cutoff : rising) {
    Case other = one;
    other.blend = false;
    other.cutoff = s.functions.support.float_cutoffs ? float_cutoff(cutoff) : cutoff;
    std::vector<State> map = map_of(s, other, n);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const std::string what =
          fmt::format("cutoff {}/{}: micro-triangle {}", cutoff.numerator, cutoff.denominator, k);
      if (map[k] == State::O && contradict(s, before[k], State::O)) return wrong(what + " not O", "O");
      if (before[k] == State::T && contradict(s, State::T, map[k]))
        return wrong(what + " T", name_of(map[k]));
    }
    before = std::move(map);
    hash = hash * 31 + hash_of(before);
  }
  return {hash};
}

Finding keeps_margins(const BakeSubject& s, const Case& one, Level n) {
  std::vector<State> before;
  std::uint64_t hash = 0;
  for (const float margin : {0.0f, 0x1p-8f, 0.5f, 3.0f}) {
    Case other = one;
    other.margin = margin;
    std::vector<State> map = map_of(s, other, n);
    for (std::size_t k = 0; k < before.size(); ++k)
      if (!unknown(map[k]) && contradict(s, map[k], before[k]))
        return wrong(fmt::format("margin {}: micro-triangle {} {} or unknown", margin, k, name_of(before[k])),
                     name_of(map[k]));
    before = std::move(map);
    hash = hash * 31 + hash_of(before);
  }
  return {hash};
}

Finding keeps_mips(const BakeSubject& s, const Case& one, Level n) {
  const std::vector<State> map = map_of(s, one, n);
  std::vector<State> all = map_of(s, mip_of(one, 0), n);
  for (std::uint32_t mip = 1; mip < one.mips; ++mip) {
    const std::vector<State> other = map_of(s, mip_of(one, mip), n);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (!unknown(all[k]) && all[k] != other[k]) all[k] = as_unknown(all[k]);
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!contradict(s, all[k], map[k])) continue;
    return wrong(fmt::format("micro-triangle {} {}", k, name_of(all[k])), name_of(map[k]));
  }
  return {hash_of(map)};
}

}  // namespace mmverify::proofs::bake
