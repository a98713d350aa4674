#include "bench/index/bench.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "bench/exact.hpp"
#include "bench/index/distance.hpp"
#include "bench/index/subjects.hpp"

namespace mmverify::bench {
namespace {

using spec::Level;

constexpr std::size_t block = 4096;
constexpr std::uint64_t slow_share = 256;  // a rational index takes microseconds

// A rate from fewer hits is off by a third or more; a rate near 1 has no room to double.
constexpr std::uint64_t fewest_mismatches = 10;
constexpr double highest_rate = 0.25;

template <class Q>
std::uint64_t samples_of(const IndexBenchOptions& options) {
  return slow<Q> ? std::max<std::uint64_t>(options.samples / slow_share, 1) : options.samples;
}

/// A block of points, in doubles for the judge and in Q for the subjects, with the specification's answers.
template <class Q>
struct Block {
  std::vector<InputPoint> points = std::vector<InputPoint>(block);
  std::vector<StiffRecipe> kinds = std::vector<StiffRecipe>(block);
  std::vector<Q> u = std::vector<Q>(block), v = std::vector<Q>(block);
  std::vector<std::uint32_t> curve = std::vector<std::uint32_t>(block),
                             rows = std::vector<std::uint32_t>(block);
  std::vector<std::uint32_t> out = std::vector<std::uint32_t>(block);
  std::size_t size = block;

  void fill(IndexInputs& inputs, std::size_t count, Level n, bool with_rows) {
    size = count;
    for (std::size_t k = 0; k < count; ++k) {
      const InputPoint p = points[k] = inputs.next(kinds[k]);
      u[k] = received<Q>(p.u);
      v[k] = received<Q>(p.v);
      curve[k] = on_exact(p.u, p.v, [n](const auto& q) { return spec::index::reference(q, n); });
      if (with_rows) rows[k] = on_exact(p.u, p.v, [n](const auto& q) { return spec::index::w_minor(q, n); });
    }
  }
};

template <class Q>
void judge(const IndexSubject<Q>& subject, Block<Q>& b, Level n, bool stiff, IndexErrors& errors) {
  const std::span<std::uint32_t> out = std::span(b.out).first(b.size);
  subject.index(std::span(b.u).first(b.size), std::span(b.v).first(b.size), n, out);
  const std::vector<std::uint32_t>& expected = subject.order == Order::curve ? b.curve : b.rows;
  const Triangle exact = exact_triangle(subject.order);
  const std::uint64_t count = std::uint64_t{1} << (2 * n);

  errors.samples += b.size;
  for (std::size_t k = 0; k < b.size; ++k) {
    const bool same = out[k] == expected[k];
    if (same && subject.triangle == exact) continue;
    const spec::index::Corners corners = subject.triangle(out[k], n);
    if (same && corners == exact(expected[k], n)) continue;
    ++errors.mismatches;
    if (stiff) ++errors.by_kind[static_cast<std::size_t>(b.kinds[k])];
    if (out[k] >= count || !on_grid(corners, n)) {
      ++errors.off_grid;
      continue;
    }
    const Distance d = distance(b.points[k], corners, n, received_by<Q>);
    errors.worst_heights = std::max(errors.worst_heights, d.heights);
    errors.worst_ulp = std::max(errors.worst_ulp, d.ulp);
  }
}

/// Measures all subjects over Q at one level with one kind of inputs: their figures begin at `figures`.
template <class Q>
void measure(const IndexBenchOptions& options, Inputs kind, Level n, IndexFigures* figures) {
  const std::vector<IndexSubject<Q>> subjects = index_subjects<Q>();
  const bool with_rows =
      std::any_of(subjects.begin(), subjects.end(), [](const auto& s) { return s.order == Order::rows; });
  const bool stiff = kind == Inputs::stiff;
  IndexInputs inputs(received_by<Q>, kind, n, options.seed);
  Block<Q> b;
  for (std::uint64_t left = samples_of<Q>(options); left > 0; left -= b.size) {
    b.fill(inputs, static_cast<std::size_t>(std::min<std::uint64_t>(left, block)), n, with_rows);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      if (n > subjects[s].max_level) continue;
      std::vector<IndexErrors>& levels = stiff ? figures[s].stiff : figures[s].uniform;
      judge(subjects[s], b, n, stiff, levels[n - options.first]);
    }
    if (options.progress) options.progress(b.size);
  }
}

using Task = std::function<void()>;

/// Adds the subjects over Q to the figures, with a place for each level, and the tasks that fill them.
template <class Q>
void add(const IndexBenchOptions& options, std::vector<IndexFigures>& figures, std::vector<Task>& tasks) {
  const std::size_t first_subject = figures.size();
  Level last = 0;
  for (const IndexSubject<Q>& s : index_subjects<Q>()) {
    IndexFigures f;
    f.name = s.name;
    f.numbers = number_name<Q>;
    f.order = s.order == Order::curve ? "curve" : "rows";
    f.max_level = s.max_level;
    for (Level n = options.first; n <= std::min(options.last, s.max_level); ++n) {
      f.uniform.push_back({.level = n});
      f.stiff.push_back({.level = n});
    }
    last = std::max(last, std::min(options.last, s.max_level));
    figures.push_back(std::move(f));
  }
  for (const Inputs kind : {Inputs::uniform, Inputs::stiff})
    for (Level n = options.first; n <= last; ++n)
      tasks.push_back([&options, &figures, first_subject, kind, n] {
        measure<Q>(options, kind, n, figures.data() + first_subject);
      });
}

/// The law of a figure over the levels for which `counts` is true.
template <class Counts, class Figure>
Growth growth_of(const std::vector<IndexErrors>& levels, Counts counts, Figure figure) {
  std::vector<LevelValue> values;
  bool any = false;
  for (const IndexErrors& e : levels) {
    any = any || e.mismatches > 0;
    if (counts(e)) values.push_back({e.level, figure(e)});
  }
  Growth growth = fit_growth(values);
  if (any && growth.law == GrowthLaw::none) growth.law = GrowthLaw::too_few;
  return growth;
}

void check(const IndexBenchOptions& options) {
  if (options.first > options.last || options.last > 16 || options.samples == 0)
    throw std::invalid_argument("index bench: levels are A..B with A <= B <= 16, and samples are at least 1");
}

}  // namespace

std::vector<IndexFigures> index_errors(const IndexBenchOptions& options) {
  check(options);
  std::vector<IndexFigures> figures;
  std::vector<Task> tasks;
  add<impl::Binary16>(options, figures, tasks);
  add<float>(options, figures, tasks);
  add<double>(options, figures, tasks);
  add<spec::Fixed64>(options, figures, tasks);
  add<spec::Rational>(options, figures, tasks);

  // Each task has its own stream of points and its own places in the figures, so threads change nothing.
  tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t k) { tasks[k](); });

  for (IndexFigures& f : figures) {
    const auto rate = [](const IndexErrors& e) { return e.rate(); };
    const auto enough = [](const IndexErrors& e) { return e.mismatches >= fewest_mismatches; };
    f.uniform_rate = growth_of(
        f.uniform, [&](const IndexErrors& e) { return enough(e) && e.rate() <= highest_rate; }, rate);
    f.stiff_rate = growth_of(f.stiff, enough, rate);
    f.stiff_heights = growth_of(
        f.stiff, [](const IndexErrors& e) { return e.mismatches - e.off_grid >= fewest_mismatches; },
        [](const IndexErrors& e) { return e.worst_heights; });
  }
  return figures;
}

std::uint64_t index_points(const IndexBenchOptions& options) {
  check(options);
  const std::uint64_t levels = options.last - options.first + 1;
  const std::uint64_t binary16_levels =
      options.first > 15 ? 0 : std::min(options.last, 15u) - options.first + 1;
  return 2 * (samples_of<float>(options) * (binary16_levels + 3 * levels) +
              samples_of<spec::Rational>(options) * levels);
}

}  // namespace mmverify::bench
