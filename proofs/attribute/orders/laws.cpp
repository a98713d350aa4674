// Laws of the places of vertices and faces in a map: each has its own, it is the walk's, and it can be inverted.
#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/orders/parts.hpp"
#include "proofs/attribute/orders/walks.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/points/cells.hpp"

namespace mmverify::proofs::attribute {
namespace {

const std::vector<std::string> all_subjects{"attribute-spec", "attribute", "attribute-single"};

/// One bit for each index of the three orders.
class MarkedIndices {
 public:
  explicit MarkedIndices(std::uint64_t count)
      : count_(count), words_(static_cast<std::size_t>((3 * count + 63) / 64)) {}
  /// Marks the index; returns whether it is new and belongs to the level.
  bool mark(std::size_t order, std::uint64_t index) {
    if (index >= count_) return false;
    const std::uint64_t place = order * count_ + index, bit = std::uint64_t{1} << (place % 64);
    return (words_[place / 64].fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
  }

 private:
  std::uint64_t count_;
  std::vector<std::atomic<std::uint64_t>> words_;
};

/// The first vertex before another with the same index, if any.
std::optional<Vertex> earlier_owner(const AttributeSubject& s, Level n, VertexOrder order,
                                    std::uint32_t index, const Vertex& before) {
  std::vector<Vertex> at(elements_per_chunk);
  for (std::uint64_t first = 0; first < vertex_count(n); first += elements_per_chunk) {
    at.resize(std::min<std::uint64_t>(elements_per_chunk, vertex_count(n) - first));
    fill(n, first, std::span(at));
    const auto found = indices_of(s, order, n, at);
    for (std::size_t t = 0; t < at.size(); ++t) {
      if (at[t] == before) return std::nullopt;
      if (found[t] == index) return at[t];
    }
  }
  return std::nullopt;
}

Words not_its_own(const AttributeSubject& s, Level n, VertexOrder order, const Vertex& at) {
  const std::uint32_t index = indices_of(s, order, n, {&at, 1})[0];
  const auto words = [](std::string got) { return Words{"an index of its own", std::move(got)}; };
  if (index >= vertex_count(n)) return words(fmt::format("{}, not below {}", index, vertex_count(n)));
  const auto owner = earlier_owner(s, n, order, index, at);
  return words(owner ? fmt::format("{}, which {} has", index, text_of(*owner)) : fmt::format("{}", index));
}

/// Calls report(order, number, vertex) for each index of [begin, end) that was seen before or lies outside the level.
template <class Report>
void each_repeat(const AttributeSubject& s, Level n, Chunk chunk, MarkedIndices& seen, Tally& tally,
                 Report report) {
  const std::uint64_t count = vertex_count(n);
  std::vector<Vertex> at;
  each_setting(chunk, count, [&](std::size_t order, std::uint64_t first, std::size_t size) {
    at.resize(size);
    fill(n, first, std::span(at));
    const auto index = indices_of(s, vertex_orders[order], n, at);
    tally.count(Kind::vertex, size);
    for (std::size_t t = 0; t < size; ++t) {
      tally.digest(order * count + first + t, index[t]);
      if (!seen.mark(order, index[t])) report(order, first + t, at[t]);
    }
  });
}

Tally bijective(const AttributeSubject& s, Level n, const Run& run) {
  // The number of repeated indices does not depend on the threads; the vertex that repeats one does.
  const std::uint64_t count = vertex_count(n);
  MarkedIndices seen(count);
  Tally tally = sweep(run, 3 * count, 16 * elements_per_chunk, [&](Chunk chunk, Tally& part) {
    each_repeat(s, n, chunk, seen, part, [&](std::size_t, std::uint64_t, const Vertex&) {
      part.mismatch(Kind::vertex, {}, [] { return Counterexample{}; });
    });
  });
  if (tally.mismatches() == 0 || interrupted()) return tally;
  MarkedIndices again(count);
  Tally named(run.errors), uncounted;
  std::size_t found = 0;
  for (std::uint64_t k = 0; k < 3 * count && found < run.errors; k += elements_per_chunk)
    each_repeat(s, n, {k, std::min(3 * count, k + elements_per_chunk)}, again, uncounted,
                [&](std::size_t order, std::uint64_t number, const Vertex& at) {
                  ++found;
                  const Simplicity simplicity{n, number, order};
                  named.mismatch(Kind::vertex, simplicity, [&] {
                    const Words words = not_its_own(s, n, vertex_orders[order], at);
                    return Counterexample{simplicity,
                                          n,
                                          fmt::format("{}:{}", name_of(vertex_orders[order]), text_of(at)),
                                          {},
                                          words.expected,
                                          words.got};
                  });
                });
  tally.replace_found(named);
  return tally;
}

Law bijective_law() {
  Batches<Vertex> cases;
  cases.settings = settings_of(vertex_orders);
  cases.count = vertex_count;
  cases.kind = Kind::vertex;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t order, std::span<const Vertex> at,
                   std::span<Outcome> out) {
    const VertexOrder of = vertex_orders[order];
    const auto index = indices_of(s, of, n, at);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {index[k], index[k] < vertex_count(n) && !earlier_owner(s, n, of, index[k], at[k])};
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t order, const Vertex& at) {
    return not_its_own(s, n, vertex_orders[order], at);
  };
  Law law = on_batches(
      {.id = "attribute.order_bijective",
       .says = "each vertex of a level has an index of its own below V(n), in each of the three orders",
       .source = cam_2,
       .subjects = all_subjects,
       .tiers = {.fast = {0, 11}, .long_run = {0, 16}, .seconds = 1},
       .domain = vertices_in_orders,
       .mutants = {mutant("one vertex inside level 7 has its neighbour's", "attribute-spec", {7, 7},
                          on_vertex_index(VertexOrder::u_major,
                                          [](Level n, const Vertex& v, std::uint32_t x) {
                                            return n == 7 && v == Vertex{30, 40} ? x + 1 : x;
                                          }))}},
      needing({entry::vertex_index}), std::move(cases));
  law.divisible = false;
  law.judge = [](const Subject& s, Level n, const Run& run) {
    return bijective(subject_as<AttributeSubject>(s), n, run);
  };
  return law;
}

Law inverse_law() {
  Batches<Vertex> cases;
  cases.settings = settings_of(vertex_orders);
  cases.count = vertex_count;
  cases.kind = Kind::vertex;
  const auto back = [](const AttributeSubject& s, Level n, std::size_t order, std::span<const Vertex> at,
                       std::vector<std::uint32_t>& index) {
    index = indices_of(s, vertex_orders[order], n, at);
    std::vector<Vertex> found(at.size());
    // An index beyond the level is outside the inverse's domain.
    std::vector<std::uint32_t> asked = index;
    for (std::uint32_t& x : asked) x = std::min(x, static_cast<std::uint32_t>(vertex_count(n) - 1));
    s.functions.orders.vertex_at(vertex_orders[order], n, asked, found);
    return found;
  };
  cases.check = [back](const AttributeSubject& s, Level n, std::size_t order, std::span<const Vertex> at,
                       std::span<Outcome> out) {
    std::vector<std::uint32_t> index;
    const auto found = back(s, n, order, at, index);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {index[k], index[k] < vertex_count(n) && found[k] == at[k]};
  };
  cases.words = [back](const AttributeSubject& s, Level n, std::size_t order, const Vertex& at) {
    std::vector<std::uint32_t> index;
    const auto found = back(s, n, order, {&at, 1}, index);
    return Words{text_of(at), fmt::format("index {}, which is {}", index[0], text_of(found[0]))};
  };
  const auto on_way_back = [](VertexOrder of, auto change) {
    return spoils(&Functions::orders, &Orders::vertex_at,
                  [of, change](VertexOrder order, Level n, std::span<const std::uint32_t> index,
                               std::span<Vertex> out) {
                    if (order != of) return;
                    for (std::size_t k = 0; k < index.size(); ++k) out[k] = change(n, index[k], out[k]);
                  });
  };
  return on_batches({.id = "attribute.order_inverse",
                     .says = "the vertex of a vertex's index is that vertex, in each of the three orders",
                     .source = cam_2,
                     .subjects = all_subjects,
                     .tiers = {.fast = {0, 10}, .long_run = {0, 16}, .seconds = 1},
                     .domain = vertices_in_orders,
                     .mutants = {mutant(
                         "U-major of level 8 begins its last column a vertex early", "attribute-spec", {8, 8},
                         on_way_back(VertexOrder::u_major,
                                     [](Level n, std::uint32_t x, const Vertex& v) {
                                       return n == 8 && x == vertex_count(8) - 2 ? Vertex{v.i + 1, 0} : v;
                                     }))}},
                    needing({entry::vertex_index, entry::vertex_at}), std::move(cases));
}

Law walk_law() {
  Batches<Vertex> cases;
  cases.settings = settings_of(vertex_orders);
  cases.count = vertex_count;
  cases.kind = Kind::vertex;
  cases.check = [](const AttributeSubject& s, Level n, std::size_t order, std::span<const Vertex> at,
                   std::span<Outcome> out) {
    const VertexWalks& walks = vertex_walks(n);
    const auto index = indices_of(s, vertex_orders[order], n, at);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {index[k], index[k] == walks.index(vertex_orders[order], at[k])};
  };
  cases.words = [](const AttributeSubject& s, Level n, std::size_t order, const Vertex& at) {
    return Words{fmt::format("{}", vertex_walks(n).index(vertex_orders[order], at)),
                 fmt::format("{}", indices_of(s, vertex_orders[order], n, {&at, 1})[0])};
  };
  return on_batches(
      {.id = "attribute.order_is_walk",
       .says = "an index is the number of vertices that the order's walk meets before: rows, columns, or "
               "level by level along the curve",
       .source = cam_2,
       .subjects = all_subjects,
       .tiers = {.fast = {0, 10}, .long_run = {0, 13}, .seconds = 1},
       .domain = vertices_in_orders,
       .mutants = {mutant(
           "two vertices of W-minor's row 200 change places", "attribute", {8, 8},
           on_vertex_index(VertexOrder::w_minor,
                           [](Level, const Vertex& v, std::uint32_t x) {
                             return v == Vertex{50, 150} ? x + 1 : v == Vertex{49, 151} ? x - 1 : x;
                           }))}},
      needing({entry::vertex_index}), std::move(cases));
}

/// The index of a face, from a point inside it: by the index algorithms, and for U-major from the area of the strips
/// before it.
std::uint32_t face_index_of_point(FaceOrder order, Level n, const MicroTriangle& t) {
  const points::GridPoint inside = points::representative(points::MicroTriangle{t.iu, t.iv, t.upper}, n);
  switch (order) {
    case FaceOrder::curve: return spec::index::reference(inside, n);
    case FaceOrder::rows: return spec::index::w_minor(inside, n);
    case FaceOrder::u_major: break;
  }
  // The faces from column iu on form a triangle with N-iu on a side.
  const std::uint64_t left = spec::side(n) - t.iu;
  return static_cast<std::uint32_t>(face_count(n) - left * left) + 2 * t.iv + (t.upper ? 1 : 0);
}

Law faces_law() {
  Batches<MicroTriangle> cases;
  cases.settings = settings_of(face_orders);
  cases.count = face_count;
  cases.kind = Kind::interior;
  const auto back = [](const AttributeSubject& s, FaceOrder order, Level n,
                       const std::vector<std::uint32_t>& index) {
    std::vector<std::uint32_t> asked = index;
    for (std::uint32_t& x : asked) x = std::min(x, static_cast<std::uint32_t>(face_count(n) - 1));
    std::vector<MicroTriangle> found(index.size());
    s.functions.orders.face_at(order, n, asked, found);
    return found;
  };
  cases.check = [back](const AttributeSubject& s, Level n, std::size_t order,
                       std::span<const MicroTriangle> at, std::span<Outcome> out) {
    const FaceOrder of = face_orders[order];
    const auto index = indices_of(s, of, n, at);
    const auto found = back(s, of, n, index);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {index[k], index[k] == face_index_of_point(of, n, at[k]) && found[k] == at[k]};
  };
  cases.words = [back](const AttributeSubject& s, Level n, std::size_t order, const MicroTriangle& at) {
    const FaceOrder of = face_orders[order];
    const auto index = indices_of(s, of, n, {&at, 1});
    return Words{fmt::format("index {} and back", face_index_of_point(of, n, at)),
                 fmt::format("index {}, which is {}", index[0], text_of(back(s, of, n, index)[0]))};
  };
  return on_batches(
      {.id = "attribute.face_orders",
       .says = "a face's index on the curve and in rows is that of a point inside it, in U-major the number "
               "of faces before it; and there is a way back",
       .source = "Color and Attribute Micromaps, 3.1; VK_EXT_opacity_micromap, appendix \"Reference Code\"",
       .subjects = all_subjects,
       .tiers = {.fast = {0, 9}, .long_run = {0, 16}, .seconds = 1},
       .domain = faces_in_orders,
       .mutants = {mutant("the last row of level 5 begins one late", "attribute", {5, 5},
                          on_face_index(FaceOrder::rows,
                                        [](Level n, const MicroTriangle& t, std::uint32_t x) {
                                          return n == 5 && t.iu + t.iv + (t.upper ? 1 : 0) == 31 ? x + 1 : x;
                                        }))}},
      needing({entry::face_index, entry::face_at}), std::move(cases));
}

}  // namespace

std::vector<Law> order_laws() {
  std::vector<Law> all{bijective_law(), inverse_law(), walk_law(), faces_law()};
  for (Law& law : order_relation_laws()) all.push_back(std::move(law));
  for (Law& law : order_sample_laws()) all.push_back(std::move(law));
  return all;
}

}  // namespace mmverify::proofs::attribute
