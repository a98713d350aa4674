// Stiff points for the index functions.
#include <utility>

#include "bench/exact.hpp"
#include "bench/index/inputs.hpp"
#include "bench/index/subjects.hpp"
#include "bench/stiff/parts.hpp"

namespace mmverify::bench::stiff {
namespace {

constexpr std::uint32_t point_level = 8;
constexpr std::size_t timed_points = 2048;
constexpr std::uint64_t points_a_rational_one = 256;

struct JudgedPoints {
  std::vector<InputPoint> points;
  std::vector<std::uint32_t> truth;

  void add(const InputPoint& p) {
    points.push_back(p);
    truth.push_back(
        on_exact(p.u, p.v, [](const auto& at) { return spec::index::reference(at, point_level); }));
  }
};

/// The points of stiff recipes that `wanted` holds of.
template <class Wanted>
JudgedPoints of_recipes(const StiffBenchOptions& o, Wanted wanted) {
  JudgedPoints all;
  IndexInputs inputs(binary32, Inputs::stiff, point_level, o.seed);
  StiffRecipe recipe{};
  while (all.points.size() < o.samples)
    if (const InputPoint p = inputs.next(recipe); wanted(recipe)) all.add(p);
  return all;
}

JudgedPoints ordinary_points(const StiffBenchOptions& o) {
  JudgedPoints all;
  IndexInputs inputs(binary32, Inputs::uniform, point_level, o.seed);
  StiffRecipe recipe{};
  while (all.points.size() < o.samples) all.add(inputs.next(recipe));
  return all;
}

/// A subnormal number beside one of any kind: subnormal, on a grid line, or a few ulp beside it.
JudgedPoints subnormals(const StiffBenchOptions& o) {
  JudgedPoints all;
  Random random = stream(o.seed, 0);
  const double N = 1u << point_level;
  while (all.points.size() < o.samples) {
    InputPoint p{double{subnormal(random)}, double{subnormal(random)}};
    if (coin(random)) {
      const double line = static_cast<double>(below(random, 1u << point_level)) / N;
      p.v = binary32.neighbour(line, static_cast<int>(below(random, 7)) - 3);
    }
    if (coin(random)) std::swap(p.u, p.v);
    all.add(p);
  }
  return all;
}

template <class Q>
struct ReceivedPoints {
  std::vector<Q> u, v;
  std::vector<std::uint32_t> out;

  ReceivedPoints(const JudgedPoints& judged, std::size_t count) : out(count) {
    for (std::size_t k = 0; k < count; ++k) {
      u.push_back(received<Q>(judged.points[k].u));
      v.push_back(received<Q>(judged.points[k].v));
    }
  }
  void run(const IndexSubject<Q>& subject, std::size_t count) {
    subject.index(std::span(u).first(count), std::span(v).first(count), point_level,
                  std::span(out).first(count));
  }
  std::uint64_t wrong(const IndexSubject<Q>& subject, const JudgedPoints& judged) {
    run(subject, out.size());
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < out.size(); ++k) count += out[k] != judged.truth[k] ? 1 : 0;
    return count;
  }
};

template <class Q>
void add_methods(const char* kind, const JudgedPoints& stiff, const JudgedPoints& ordinary,
                 std::size_t rounds, std::vector<StiffFigure>& figures) {
  const std::uint64_t all = stiff.points.size(),
                      count = slow<Q> ? std::max<std::uint64_t>(1, all / points_a_rational_one) : all;
  ReceivedPoints<Q> received_stiff(stiff, count), received_ordinary(ordinary, count);
  for (const IndexSubject<Q>& subject : index_subjects<Q>()) {
    if (subject.order != Order::curve || (slow<Q> && subject.name.starts_with("step"))) continue;
    StiffFigure figure{.kind = kind,
                       .method = std::string(subject.name),
                       .cases = count,
                       .wrong = received_stiff.wrong(subject, stiff),
                       .ordinary_wrong = received_ordinary.wrong(subject, ordinary),
                       .is_ours = subject.name.starts_with("impl")};
    const std::size_t few =
        slow<Q> ? std::min<std::size_t>(count, 64) : std::min<std::size_t>(count, timed_points);
    add_times(figure, few, few, rounds,
              [&](bool is_stiff) { (is_stiff ? received_stiff : received_ordinary).run(subject, few); });
    figures.push_back(figure);
  }
}

}  // namespace

void add_points(const StiffBenchOptions& o, std::vector<StiffFigure>& figures) {
  const auto begins = [&](const char* kind) {
    if (o.progress) o.progress(kind);
  };
  begins("ordinary points");
  const JudgedPoints ordinary = ordinary_points(o);
  const auto measure = [&](const char* kind, const JudgedPoints& stiff) {
    add_methods<float>(kind, stiff, ordinary, o.rounds, figures);
    add_methods<double>(kind, stiff, ordinary, o.rounds, figures);
    add_methods<spec::Rational>(kind, stiff, ordinary, o.rounds, figures);
  };
  begins("lines");
  measure("lines", of_recipes(o, [](StiffRecipe r) { return r == StiffRecipe::lines; }));
  begins("sums");
  measure("sums", of_recipes(o, [](StiffRecipe r) {
            return r == StiffRecipe::straddling || r == StiffRecipe::hypotenuse;
          }));
  begins("subnormal points");
  measure("subnormal points", subnormals(o));
}

}  // namespace mmverify::bench::stiff
