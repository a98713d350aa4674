// Where vertices and faces lie in a map.
#include <atomic>
#include <vector>

#include "proofs/attribute/batches.hpp"
#include "proofs/attribute/law_groups.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::attribute::face_count;
using spec::attribute::face_orders;
using spec::attribute::vertex_count;
using spec::attribute::vertex_orders;

const Entry vertex_index{"vertex -> index", [](const Functions& f) { return bool{f.orders.vertex_index}; }};

std::vector<std::string> vertex_settings() {
  std::vector<std::string> names;
  for (const VertexOrder order : vertex_orders) names.emplace_back(name_of(order));
  return names;
}

/// One bit an index of each of three orders.
class Seen {
 public:
  explicit Seen(std::uint64_t count)
      : count_(count), words_(static_cast<std::size_t>((3 * count + 63) / 64)) {}
  /// Marks the index; says whether it is new, and one of the level.
  bool mark(std::size_t order, std::uint64_t index) {
    if (index >= count_) return false;
    const std::uint64_t place = order * count_ + index, bit = std::uint64_t{1} << (place % 64);
    return (words_[place / 64].fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
  }

 private:
  std::uint64_t count_;
  std::vector<std::atomic<std::uint64_t>> words_;
};

/// The elements before number `last` in one order that have `index` too, the first of them.
std::optional<Vertex> earlier_owner(const AttributeSubject& s, Level n, VertexOrder order,
                                    std::uint32_t index, const Vertex& before) {
  std::vector<Vertex> at(elements_per_chunk);
  std::vector<std::uint32_t> found(elements_per_chunk);
  for (std::uint64_t first = 0; first < vertex_count(n); first += elements_per_chunk) {
    const std::size_t size = std::min<std::uint64_t>(elements_per_chunk, vertex_count(n) - first);
    fill(n, first, std::span(at).first(size));
    s.functions.orders.vertex_index(order, n, std::span(at).first(size), std::span(found).first(size));
    for (std::size_t t = 0; t < size; ++t) {
      if (at[t] == before) return std::nullopt;
      if (found[t] == index) return at[t];
    }
  }
  return std::nullopt;
}

Words not_its_own(const AttributeSubject& s, Level n, VertexOrder order, const Vertex& at) {
  std::uint32_t index = 0;
  s.functions.orders.vertex_index(order, n, {&at, 1}, {&index, 1});
  if (index >= vertex_count(n))
    return {"an index of its own", fmt::format("{}, not below {}", index, vertex_count(n))};
  const auto owner = earlier_owner(s, n, order, index, at);
  return {"an index of its own",
          owner ? fmt::format("{}, which {} has", index, text_of(*owner)) : fmt::format("{}", index)};
}

Tally bijective(const AttributeSubject& s, Level n, const Run& run) {
  const std::uint64_t count = vertex_count(n);
  // Which of two comes second depends on the threads, how many do not: they are named afterwards.
  const auto pass = [&](const Run& with, auto report) {
    Seen seen(count);
    return sweep(with, 3 * count, elements_per_chunk, [&](Chunk chunk, Tally& tally) {
      std::vector<Vertex> at;
      std::vector<std::uint32_t> index;
      each_setting(chunk, count, [&](std::size_t order, std::uint64_t first, std::size_t size) {
        at.resize(size);
        index.assign(size, 0);
        fill(n, first, std::span(at));
        s.functions.orders.vertex_index(vertex_orders[order], n, at, index);
        tally.count(Kind::vertex, size);
        for (std::size_t t = 0; t < size; ++t) {
          tally.digest(order * count + first + t, index[t]);
          if (!seen.mark(order, index[t])) report(tally, order, first + t, at[t]);
        }
      });
    });
  };
  Tally tally = pass(run, [](Tally& part, std::size_t, std::uint64_t, const Vertex&) {
    part.mismatch(Kind::vertex, {}, [] { return Counterexample{}; });
  });
  if (tally.mismatches() == 0 || interrupted()) return tally;
  Seen again(count);
  Tally named(run.errors);
  std::size_t found = 0;
  std::vector<Vertex> at(1);
  for (std::uint64_t k = 0; k < 3 * count && found < run.errors; ++k) {
    const auto order = static_cast<std::size_t>(k / count);
    fill(n, k % count, std::span(at));
    std::uint32_t index = 0;
    s.functions.orders.vertex_index(vertex_orders[order], n, at, {&index, 1});
    if (again.mark(order, index)) continue;
    ++found;
    const Simplicity simplicity{n, k % count, order};
    named.mismatch(Kind::vertex, simplicity, [&] {
      const Words words = not_its_own(s, n, vertex_orders[order], at[0]);
      return Counterexample{
          simplicity,     n,        fmt::format("{}:{}", name_of(vertex_orders[order]), text_of(at[0])), {},
          words.expected, words.got};
    });
  }
  tally.replace_found(named);
  return tally;
}

Law bijective_law() {
  const auto changed = [](VertexOrder of, Level level, Vertex where, auto index_of) {
    return [=](Functions& f) {
      f.orders.vertex_index = [=, real = f.orders.vertex_index](VertexOrder order, Level n,
                                                                std::span<const Vertex> at,
                                                                std::span<std::uint32_t> out) {
        real(order, n, at, out);
        if (order != of || n != level) return;
        for (std::size_t k = 0; k < at.size(); ++k)
          if (at[k] == where) out[k] = index_of(out[k]);
      };
    };
  };
  Batches<Vertex> cases;
  cases.settings = vertex_settings();
  cases.count = vertex_count;
  cases.kind = Kind::vertex;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t order, std::span<const Vertex> at,
                   std::span<Outcome> out) {
    const VertexOrder of = vertex_orders[order];
    for (std::size_t k = 0; k < at.size(); ++k) {
      std::uint32_t index = 0;
      s.functions.orders.vertex_index(of, n, at.subspan(k, 1), {&index, 1});
      out[k] = {index, index < vertex_count(n) && !earlier_owner(s, n, of, index, at[k])};
    }
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t order, const Vertex& at) {
    return not_its_own(s, n, vertex_orders[order], at);
  };
  Law law = on_batches(
      {.id = "attribute.order_bijective",
       .topic = "attribute",
       .says = "each vertex of a level has an index of its own below V(n), in each of the three orders",
       .source = cam_2,
       .subjects = {"attribute-spec"},
       .fast = {0, 9},
       .long_run = {0, 16},
       .fast_seconds = 1,
       .domain = [](const Subject&, Level) { return std::string("the V(n) vertices, in 3 orders"); },
       .mutants = {mutant("one vertex inside level 7 has its neighbour's", "attribute-spec", {7, 7},
                          changed(VertexOrder::u_major, 7, {30, 40}, [](std::uint32_t x) { return x + 1; })),
                   mutant("the last of Bird's level 5 is V(5)", "attribute-spec", {5, 5},
                          changed(VertexOrder::bird, 5, {1, 30},
                                  [](std::uint32_t) { return static_cast<std::uint32_t>(vertex_count(5)); })),
                   mutant("W-minor's v-corner of level 6 is its neighbour", "attribute-spec", {6, 6},
                          changed(VertexOrder::w_minor, 6, {0, 64}, [](std::uint32_t x) { return x - 1; }))}},
      needing({vertex_index}), std::move(cases));
  law.divisible = false;
  law.judge = [](const Subject& s, Level n, const Run& run) { return bijective(of_attribute(s), n, run); };
  return law;
}

}  // namespace

std::vector<Law> order_laws() { return {bijective_law()}; }

std::vector<Law> order_paper_laws() { return {}; }

}  // namespace mmverify::proofs::attribute
