// The judges of all micro-triangles of a level together: each index occurs once, and neighbours follow each other.
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/picture.hpp"

namespace mmverify::proofs::index {
namespace {

// The approximate number of micro-triangles in a group of strips that is judged together.
constexpr std::uint64_t triangles_per_chunk = 1 << 16;

std::uint64_t strips_per_chunk(Level n) {
  return std::max<std::uint64_t>(1, triangles_per_chunk / (2 * side(n)));
}

/// The number of a micro-triangle along v = const strips, a strip's upright ones before its inverted ones.
std::uint64_t number_in(const MicroTriangle& m, Level n) {
  const std::uint64_t N = side(n), left = N - m.j;
  return N * N - left * left + (m.inverted ? left : 0) + m.i;
}

MicroTriangle upright(std::uint32_t i, std::uint32_t j) { return {i, j, false}; }
MicroTriangle inverted(std::uint32_t i, std::uint32_t j) { return {i, j, true}; }

/// A subject's indices of the micro-triangles of strip j: [0] upright, [1] inverted.
using Strip = std::array<std::vector<std::uint32_t>, 2>;

Strip ask_strip(const IndexSubject& s, Level n, std::uint32_t j) {
  Strip answers;
  for (const bool upside_down : {false, true}) {
    std::vector<GridPoint> points;
    const std::uint32_t count = side(n) - j - (upside_down ? 1 : 0);
    for (std::uint32_t i = 0; i < count; ++i)
      points.push_back(representative(MicroTriangle{i, j, upside_down}, n));
    if (points.empty()) continue;
    s.functions.receive(points);
    answers[upside_down].resize(points.size());
    s.functions.index(n, {points, s.functions.arithmetic != Arithmetic::binary16}, answers[upside_down]);
  }
  return answers;
}

/// Calls visit(micro-triangle, its index) for every micro-triangle of strip j.
template <class Visit>
void each(const Strip& strip, std::uint32_t j, Visit visit) {
  for (const bool upside_down : {false, true})
    for (std::uint32_t i = 0; i < strip[upside_down].size(); ++i)
      visit(MicroTriangle{i, j, upside_down}, strip[upside_down][i]);
}

Counterexample at_triangle(const MicroTriangle& m, Level n, std::string expected, std::string got) {
  return at_point(representative(m, n), n, std::move(expected), std::move(got));
}

/// One bit for each index: 4^n / 8 bytes, 512 MiB at level 16.
class MarkedIndices {
 public:
  explicit MarkedIndices(Level n) : words_(static_cast<std::size_t>((triangle_count(n) + 63) / 64)) {}
  /// Marks the index; returns whether it was marked before.
  bool mark(std::uint32_t index) {
    const std::uint64_t bit = std::uint64_t{1} << (index % 64);
    return (words_[index / 64].fetch_or(bit, std::memory_order_relaxed) & bit) != 0;
  }

 private:
  std::vector<std::atomic<std::uint64_t>> words_;
};

/// The indices of strip j; nothing if the subject breaks on one of them.
std::optional<Strip> answered_strip(const IndexSubject& s, Level n, std::uint32_t j) {
  try {
    return ask_strip(s, n, j);
  } catch (const dock::CaseBroken&) {
    return std::nullopt;
  }
}

/// Declines a strip that the subject breaks on with all its micro-triangles, since the law compares them with one
/// another.
DeclineUnit as_a_strip(Level n) {
  return [n](std::uint64_t j, Tally& tally) {
    for (std::uint64_t t = 0; t < 2 * (side(n) - j) - 1; ++t) tally.decline(Kind::interior);
  };
}

/// The first micro-triangle before `m` with the same index, if any.
std::optional<MicroTriangle> earlier_owner(const IndexSubject& s, Level n, const MicroTriangle& m,
                                           std::uint32_t index) {
  std::optional<MicroTriangle> owner;
  for (std::uint32_t j = 0; j <= m.j && !owner; ++j)
    if (const auto strip = answered_strip(s, n, j))
      each(*strip, j, [&](const MicroTriangle& other, std::uint32_t other_index) {
        if (!owner && other_index == index && number_in(other, n) < number_in(m, n)) owner = other;
      });
  return owner;
}

std::string not_taken() { return "an index of its own"; }

std::string taken(const IndexSubject& s, Level n, const MicroTriangle& m, std::uint32_t index) {
  if (index >= triangle_count(n)) return fmt::format("{}, not below 4^{}", index, n);
  const auto owner = earlier_owner(s, n, m, index);
  if (!owner) return fmt::format("{}", index);
  return fmt::format("{}, which {} has", index, case_text(rational(representative(*owner, n)), n));
}

/// The micro-triangle whose inside holds the point; the subject receives that point later in its own numbers.
MicroTriangle triangle_at(Level n, const std::string& at) {
  const RationalPoint p = parse_point(at);
  if (kind_of(p, n) != Kind::interior)
    throw BadCase(fmt::format("'{}' is not inside a micro-triangle of level {}", at, n));
  const Rational u = p.u * spec::Integer(side(n)), v = p.v * spec::Integer(side(n));
  const std::uint32_t i = whole(u), j = whole(v);
  if (i + j >= side(n)) throw BadCase(fmt::format("'{}' lies outside the triangle", at));
  return {i, j, !(u + v - spec::Integer(i) - spec::Integer(j) < Rational(spec::Integer(1)))};
}

std::uint32_t index_of(const IndexSubject& s, Level n, const MicroTriangle& m) {
  return s.functions.index_at(n, s.functions.receive_at(rational(representative(m, n))));
}

/// Whether the highest digit that changes from an index to the next goes from 2 to 3.  The two micro-triangles then
/// meet only in a vertex, (4^n-1)/3 times in all.
bool meets_in_a_vertex(std::uint32_t index) {
  while (index % 4 == 3) index /= 4;
  return index % 4 == 2;
}

std::array<MicroTriangle, 3> across_edges(const MicroTriangle& m) {
  const auto [i, j, upside_down] = m;
  if (upside_down) return {upright(i, j), upright(i + 1, j), upright(i, j + 1)};
  // i-1 and j-1 wrap if there is no neighbour; exists() then rejects it.
  return {inverted(i, j), inverted(i - 1, j), inverted(i, j - 1)};
}

bool exists(const MicroTriangle& m, Level n) {
  const std::uint64_t N = side(n);
  return m.i < N && m.j < N && std::uint64_t{m.i} + m.j + (m.inverted ? 1 : 0) < N;
}

std::array<spec::index::Vertex, 3> corners_of(const MicroTriangle& m) {
  using spec::index::Vertex;
  if (m.inverted) return {Vertex{m.i + 1, m.j + 1}, Vertex{m.i, m.j + 1}, Vertex{m.i + 1, m.j}};
  return {Vertex{m.i, m.j}, Vertex{m.i + 1, m.j}, Vertex{m.i, m.j + 1}};
}

int shared_vertices(const MicroTriangle& a, const MicroTriangle& b) {
  int shared = 0;
  for (const auto& x : corners_of(a))
    for (const auto& y : corners_of(b)) shared += x == y ? 1 : 0;
  return shared;
}

/// Whether a micro-triangle with the index `wanted` touches m across an edge or, with `in_a_vertex`, only in a
/// vertex; `at(m)` gives an existing micro-triangle's index.
template <class At>
bool touches(const MicroTriangle& m, std::uint32_t wanted, bool in_a_vertex, Level n, At at) {
  if (!in_a_vertex) {
    for (const MicroTriangle& other : across_edges(m))
      if (exists(other, n) && at(other) == wanted) return true;
    return false;
  }
  for (std::uint32_t j = m.j - 1; j != m.j + 2; ++j)
    for (std::uint32_t i = m.i - 2; i != m.i + 3; ++i)
      for (const bool upside_down : {false, true}) {
        const MicroTriangle other{i, j, upside_down};
        if (exists(other, n) && shared_vertices(m, other) == 1 && at(other) == wanted) return true;
      }
  return false;
}

/// A gap of the curve at m, which has `index`: the micro-triangle before it or after it is not a neighbour.
struct Gap {
  std::uint64_t wanted;
  bool in_a_vertex;
};
template <class At>
std::optional<Gap> gap_at(const MicroTriangle& m, std::uint32_t index, Level n, At at) {
  if (index != triangle_count(n) - 1) {
    const Gap next{std::uint64_t{index} + 1, meets_in_a_vertex(index)};
    if (!touches(m, index + 1, next.in_a_vertex, n, at)) return next;
  }
  if (index != 0) {
    const Gap before{std::uint64_t{index} - 1, meets_in_a_vertex(index - 1)};
    if (!touches(m, index - 1, before.in_a_vertex, n, at)) return before;
  }
  return std::nullopt;
}

std::string adjacency(const Gap& gap) {
  return fmt::format("{} across {}", gap.wanted, gap.in_a_vertex ? "one vertex, no edge" : "an edge");
}

}  // namespace

Tally bijective(const IndexSubject& s, Level n, const Run& run) {
  // First all together: the numbers of answers out of range and of repeated ones do not depend on the order.
  MarkedIndices seen(n);
  Tally tally = sweep(
      run, side(n), strips_per_chunk(n),
      [&](Chunk chunk, Tally& part) {
        // All strips are read before one is marked: if the subject breaks, the chunk is judged again, in parts.
        std::vector<Strip> strips;
        for (auto j = static_cast<std::uint32_t>(chunk.begin); j < chunk.end; ++j)
          strips.push_back(ask_strip(s, n, j));
        for (auto j = static_cast<std::uint32_t>(chunk.begin); j < chunk.end; ++j)
          each(strips[j - chunk.begin], j, [&](const MicroTriangle& m, std::uint32_t index) {
            part.count(Kind::interior, 1);
            part.digest(number_in(m, n), index);
            if (index >= triangle_count(n) || seen.mark(index))
              part.mismatch(Kind::interior, simplicity(representative(m, n)),
                            [&] { return at_triangle(m, n, not_taken(), fmt::format("{}", index)); });
          });
      },
      as_a_strip(n));
  if (tally.found().empty() || interrupted()) return tally;

  // Then in order, to find the first ones.
  MarkedIndices again(n);
  Tally named(run.errors);
  std::vector<std::pair<MicroTriangle, std::uint32_t>> repeats;
  for (std::uint32_t j = 0; j < side(n) && repeats.size() < run.errors; ++j)
    if (const auto strip = answered_strip(s, n, j))
      each(*strip, j, [&](const MicroTriangle& m, std::uint32_t index) {
        if (repeats.size() < run.errors && (index >= triangle_count(n) || again.mark(index)))
          repeats.emplace_back(m, index);
      });
  for (const auto& [m, index] : repeats)
    named.mismatch(Kind::interior, simplicity(representative(m, n)), [&, &m = m, &index = index] {
      return at_triangle(m, n, not_taken(), taken(s, n, m, index));
    });
  tally.replace_found(named);
  return tally;
}

Replayed replay_bijective(const IndexSubject& s, Level n, const std::string& at) {
  const MicroTriangle m = triangle_at(n, at);
  const std::uint32_t index = index_of(s, n, m);
  const bool holds = index < triangle_count(n) && !earlier_owner(s, n, m, index);
  const RationalPoint p = rational(representative(m, n));
  return {holds, not_taken(), holds ? fmt::format("{}", index) : taken(s, n, m, index),
          picture(n, p, spec::index::reference(p, n), index, Order::curve)};
}

Tally contiguous(const IndexSubject& s, Level n, const Run& run) {
  const std::uint32_t N = side(n);
  return sweep(
      run, N, strips_per_chunk(n),
      [&](Chunk chunk, Tally& tally) {
        const auto first = static_cast<std::uint32_t>(chunk.begin),
                   last = static_cast<std::uint32_t>(chunk.end);
        const std::uint32_t from = first == 0 ? 0 : first - 1;
        std::vector<Strip> strips;
        for (std::uint32_t j = from; j < std::min(last + 1, N); ++j) strips.push_back(ask_strip(s, n, j));
        const auto at = [&](const MicroTriangle& m) { return strips[m.j - from][m.inverted][m.i]; };

        for (std::uint32_t j = first; j < last; ++j)
          each(strips[j - from], j, [&](const MicroTriangle& m, std::uint32_t index) {
            tally.count(Kind::interior, 1);
            tally.digest(number_in(m, n), index);
            const auto gap = gap_at(m, index, n, at);
            if (!gap) return;
            tally.mismatch(Kind::interior, simplicity(representative(m, n)), [&] {
              return at_triangle(m, n, adjacency(*gap),
                                 fmt::format("{} here, {} not there", index, gap->wanted));
            });
          });
      },
      as_a_strip(n));
}

Replayed replay_contiguous(const IndexSubject& s, Level n, const std::string& at) {
  const MicroTriangle m = triangle_at(n, at);
  const std::uint32_t index = index_of(s, n, m);
  const auto gap = gap_at(m, index, n, [&](const MicroTriangle& other) { return index_of(s, n, other); });
  const RationalPoint p = rational(representative(m, n));
  return {!gap, gap ? adjacency(*gap) : "its neighbours on the curve",
          gap ? fmt::format("{} here, {} not there", index, gap->wanted)
              : fmt::format("{} here, its neighbours there", index),
          picture(n, p, spec::index::reference(p, n), index, Order::curve)};
}

}  // namespace mmverify::proofs::index
