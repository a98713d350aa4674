// The judges on sampled indices, for the levels that no sweep of the fast tier reaches.
#include "proofs/engine/random.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/picture.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint64_t indices_per_chunk = 1 << 10;

/// Index number `sample` of a level: any; a prefix and one digit over and over, as on a side or at a corner;
/// beside a square, where a row begins; beside a multiple of a power of 4; among the first and last 1024. The last three
/// of 16 follow each other over such a multiple: who steps from one index to the next carries there.
std::uint32_t sampled_index(Level n, std::uint64_t seed, std::uint64_t sample) {
  const std::uint64_t all = triangle_count(n);
  const auto within = [all](std::int64_t k) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(k, 0, static_cast<std::int64_t>(all) - 1));
  };
  if (sample % 16 >= 13) {
    Random carry(seed, n, ~(sample / 16));
    const std::uint64_t step = std::uint64_t{1} << 2 * carry.below(n + 1);
    return within(static_cast<std::int64_t>(carry.below(all) / step * step + sample % 16) - 14);
  }
  Random random(seed, n, sample);
  const std::uint64_t any = random.below(all);
  switch (sample % 5) {
    case 0: {
      const auto low = static_cast<Level>(random.below(n + 1));
      const std::uint64_t mask = (std::uint64_t{1} << 2 * low) - 1;
      return static_cast<std::uint32_t>((any & ~mask) | (random.below(4) * (mask / 3)));
    }
    case 1: {
      const auto row = static_cast<std::int64_t>(random.below(side(n)) + 1);
      return within(row * row + random.between(-3, 2));
    }
    case 2: {
      const std::uint64_t step = std::uint64_t{1} << 2 * random.below(n + 1);
      return within(static_cast<std::int64_t>(any / step * step) + random.between(-1, 1));
    }
    case 3: {
      const std::int64_t k = random.between(0, 1023);
      return within(random.below(2) == 0 ? k : static_cast<std::int64_t>(all) - 1 - k);
    }
    default: return static_cast<std::uint32_t>(any);
  }
}

/// A micro-triangle's seven cells: its vertices, the middles of its edges, a point inside.
std::array<GridPoint, 7> cells_of(const Corners& c, Level n) {
  std::array<GridPoint, 7> points;
  const auto mean = [n](const std::array<std::uint32_t, 4>& k) {
    return coordinate(std::int64_t{k[0]} + k[1] + k[2] + k[3], n);
  };
  const auto of = [&](std::size_t a, std::size_t b, std::size_t d, std::size_t e) {
    return GridPoint{mean({c[a].i, c[b].i, c[d].i, c[e].i}), mean({c[a].j, c[b].j, c[d].j, c[e].j})};
  };
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] = of(k, k, k, k);
    points[3 + k] = of(k, k, (k + 1) % 3, (k + 1) % 3);
  }
  points[6] = of(0, 0, 1, 2);
  return points;
}

using Indices = std::span<const std::uint32_t>;

/// Finds of each index what is wrong with it first; an answer goes to the finding's hash.
class Bench {
 public:
  explicit Bench(Indices indices) : indices_(indices), found_(indices.size()) {}

  /// Compares the corners of each index, in order or not.
  template <class Ask, class Right>
  void corners(const char* what, Ask ask, Right right, bool in_order) {
    std::vector<Corners> got(indices_.size());
    ask(got);
    for (std::size_t k = 0; k < got.size(); ++k) {
      const Corners want = right(indices_[k]);
      for (const auto& vertex : got[k]) fold(k, std::uint64_t{vertex.i} << 32 | vertex.j);
      if (in_order ? want != got[k] : sorted(want) != sorted(got[k]))
        wrong(k, fmt::format("{} {}", what, text(want)), text(got[k]));
    }
  }

  /// Compares the answers on the seven cells of each index's micro-triangle, as the subject receives them.
  template <class Cell, class Ask, class Right>
  void points(const char* what, const IndexSubject& s, Level n, Cell corners_of, Ask ask, Right right) {
    std::vector<GridPoint> points;
    for (const std::uint32_t index : indices_)
      for (const GridPoint& p : cells_of(corners_of(index), n)) points.push_back(p);
    s.functions.receive(points);
    std::vector<std::uint32_t> got(points.size());
    ask(points, got);
    for (std::size_t t = 0; t < points.size(); ++t) {
      const std::uint32_t want = right(points[t]);
      fold(t / 7, got[t]);
      if (want != got[t])
        wrong(t / 7, fmt::format("{} {} at {}", what, want, case_text(rational(points[t]), n)),
              fmt::format("{}", got[t]));
    }
  }

  const std::vector<Finding>& found() const { return found_; }

 private:
  void fold(std::size_t k, std::uint64_t answer) {
    found_[k].answer = (found_[k].answer ^ answer) * 0x100000001B3u;
  }
  void wrong(std::size_t k, std::string expected, std::string got) {
    if (!found_[k].holds) return;
    found_[k] = {found_[k].answer, false, std::move(expected), std::move(got)};
  }

  Indices indices_;
  std::vector<Finding> found_;
};

std::vector<Finding> everything(const IndexSubject& s, Level n, Indices indices) {
  Bench bench(indices);
  const auto on_curve = [n](std::uint32_t k) { return spec::index::corners(k, n); };
  const auto in_rows = [](std::uint32_t k) { return spec::index::w_minor_corners(k); };
  if (s.functions.index)
    bench.points(
        "index", s, n, on_curve,
        [&](const auto& points, auto& got) {
          s.functions.index(n, Batch{points, false}, got);
        },
        [n](const GridPoint& p) { return spec::index::reference(p, n); });
  if (s.functions.corners)
    bench.corners(
        "corners", [&](auto& got) { s.functions.corners(n, indices, got); }, on_curve, false);
  if (s.functions.row_index)
    bench.points(
        "row-order index", s, n, in_rows,
        [&](const auto& points, auto& got) {
          s.functions.row_index(n, Batch{points, false}, got);
        },
        [n](const GridPoint& p) { return spec::index::w_minor(p, n); });
  if (s.functions.row_corners)
    bench.corners(
        "row-order corners", [&](auto& got) { s.functions.row_corners(n, indices, got); }, in_rows, false);
  return bench.found();
}

std::vector<Finding> corners_alone(const IndexSubject& s, Level n, Indices indices) {
  Bench bench(indices);
  bench.corners(
      "corners", [&](auto& got) { s.functions.corners(n, indices, got); },
      [n, order = s.functions.corner_order](std::uint32_t k) { return corners_in(order, k, n); },
      s.functions.corner_order != CornerOrder::undeclared);
  return bench.found();
}

using Check = std::vector<Finding> (*)(const IndexSubject&, Level, Indices);

Tally judged(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples, Check check) {
  return sweep(
      run, samples, indices_per_chunk,
      [&](Chunk chunk, Tally& tally) {
        std::vector<std::uint32_t> indices;
        for (std::uint64_t k = chunk.begin; k < chunk.end; ++k)
          indices.push_back(sampled_index(n, run.seed, k));
        const std::vector<Finding> found = check(s, n, indices);
        tally.count(Kind::interior, indices.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
          tally.digest(chunk.begin + k, found[k].answer);
          if (!found[k].holds)
            tally.mismatch(Kind::interior, {indices[k], 0, 0}, [&] {
              return Counterexample{{indices[k], 0, 0}, n,           case_of(indices[k]), {},
                                    found[k].expected,  found[k].got};
            });
        }
      },
      as_one_case(Kind::interior));
}

Replayed again(const IndexSubject& s, Level n, const std::string& at, Check check) {
  const std::uint32_t index = parse_index(at, n);
  Replayed replay = replayed(check(s, n, {&index, 1}).front());
  const Corners c = spec::index::corners(index, n);
  replay.picture = picture(n, rational(cells_of(c, n).back()), index, index, Order::curve);
  return replay;
}

}  // namespace

Tally on_samples(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return judged(s, n, run, samples, everything);
}
Replayed replay_on_samples(const IndexSubject& s, Level n, const std::string& at) {
  return again(s, n, at, everything);
}

Tally corners_on_samples(const IndexSubject& s, Level n, const Run& run, std::uint64_t samples) {
  return judged(s, n, run, samples, corners_alone);
}
Replayed replay_corners_on_samples(const IndexSubject& s, Level n, const std::string& at) {
  return again(s, n, at, corners_alone);
}

}  // namespace mmverify::proofs::index
