// Laws of orders on samples of the levels that are too high for the sweeps of the fast tier.

#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/orders/parts.hpp"
#include "proofs/attribute/orders/walks.hpp"

namespace mmverify::proofs::attribute {
namespace {

const std::vector<std::string> sampled_subjects{"attribute-spec", "attribute", "attribute-single"};

std::uint64_t how_many(Level, const Run& run) { return run.tier == Tier::fast ? 1'024 : 262'144; }

/// The specification's index, in words of 64 bits; `attribute.w_minor_all_levels` and similar laws prove those.
template <class Order, class Element>
std::uint32_t specified(Order order, const Element& at, Level n) {
  if constexpr (std::is_same_v<Element, Vertex>)
    return static_cast<std::uint32_t>(spec::attribute::vertex_index(order, at, n));
  else
    return static_cast<std::uint32_t>(spec::attribute::face_index(order, at, n));
}

/// A subject's answers for each element of a batch, as numbers, beside the right ones.
class AnswerTable {
 public:
  explicit AnswerTable(std::size_t elements) : of_each_(elements) {}
  /// Adds the numbers `what` of each element k: right(k) is expected, got(k) is the subject's.
  template <class Right, class Got>
  void add(std::string what, Right right, Got got) {
    what_.push_back(std::move(what));
    for (std::size_t k = 0; k < of_each_.size(); ++k) {
      of_each_[k].expected.push_back(right(k));
      of_each_[k].got.push_back(got(k));
    }
  }
  Outcome outcome(std::size_t k) const {
    std::uint64_t answer = 0;
    for (const std::uint64_t x : of_each_[k].got) answer = answer * 5 + x;
    return {answer, of_each_[k].got == of_each_[k].expected};
  }
  /// The words of the first wrong number of element k.  Domain: element k has one.
  Words words(std::size_t k) const {
    const auto& [expected, got] = of_each_[k];
    const auto at = static_cast<std::size_t>(
        std::mismatch(expected.begin(), expected.end(), got.begin()).first - expected.begin());
    return {fmt::format("{} {}", what_[at], expected[at]), fmt::format("{} {}", what_[at], got[at])};
  }

 private:
  struct Numbers {
    std::vector<std::uint64_t> expected, got;
  };
  std::vector<std::string> what_;
  std::vector<Numbers> of_each_;
};

/// The cases of a law; `found` asks a batch.
template <class Element>
Batches<Element> drawn_cases(
    std::vector<std::string> settings, Kind kind, Element (*draw)(Level, std::uint64_t, std::uint64_t),
    std::function<AnswerTable(const AttributeSubject&, Level, std::size_t setting, std::span<const Element>)>
        found) {
  Batches<Element> cases;
  cases.settings = std::move(settings);
  cases.drawn = how_many;
  cases.kind = kind;
  cases.draw = [draw](Level n, std::uint64_t first, std::span<Element> out, std::uint64_t seed) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = draw(n, first + k, seed);
  };
  cases.check = [found](const AttributeSubject& s, Level n, std::size_t setting, std::span<const Element> at,
                        std::span<Outcome> out) {
    const AnswerTable all = found(s, n, setting, at);
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = all.outcome(k);
  };
  cases.words = [found](const AttributeSubject& s, Level n, std::size_t setting, const Element& at) {
    return found(s, n, setting, {&at, 1}).words(0);
  };
  return cases;
}

AnswerTable found_of_vertices(const AttributeSubject& s, Level n, std::size_t setting,
                              std::span<const Vertex> at) {
  const VertexOrder order = vertex_orders[setting];
  const Orders& f = s.functions.orders;
  AnswerTable all(at.size());
  std::vector<std::uint32_t> right;
  for (const Vertex& v : at) right.push_back(specified(order, v, n));
  const auto index = indices_of(s, order, n, at);
  const auto given = [&](std::size_t k) { return right[k]; };
  all.add("index", given, [&](std::size_t k) { return index[k]; });
  if (f.vertex_at) {
    std::vector<Vertex> back(at.size());
    f.vertex_at(order, n, right, back);
    all.add(
        "back at i", [&](std::size_t k) { return at[k].i; }, [&](std::size_t k) { return back[k].i; });
    all.add(
        "back at j", [&](std::size_t k) { return at[k].j; }, [&](std::size_t k) { return back[k].j; });
  }
  if (f.convert_vertices)
    for (const VertexOrder to : vertex_orders) {
      std::vector<std::uint32_t> other(at.size());
      f.convert_vertices(order, to, n, right, other);
      all.add(
          fmt::format("in {}", name_of(to)), [&](std::size_t k) { return specified(to, at[k], n); },
          [&](std::size_t k) { return other[k]; });
    }
  return all;
}

void lessen_converted_bird(Functions& f) {
  f.orders.convert_vertices = [real = f.orders.convert_vertices](VertexOrder from, VertexOrder to, Level n,
                                                                 std::span<const std::uint32_t> index,
                                                                 std::span<std::uint32_t> out) {
    real(from, to, n, index, out);
    if (from == to || to != VertexOrder::bird) return;
    for (std::uint32_t& x : out) x -= x >> 26 != 0 ? 1 : 0;
  };
}

Law sampled_vertices_law() {
  return on_batches(
      {.id = "attribute.vertices_on_samples",
       .says = "a vertex's index, the way back and its index in the other orders are the specification's",
       .source = cam_2,
       .method = Method::sample,
       .subjects = sampled_subjects,
       .tiers = {.fast = {8, 16}, .long_run = {1, 16}, .seconds = 1},
       .domain = "a sample of the V(n) vertices in 3 orders: corners, edges, ends of rows, powers of two",
       .mutants = {mutant("Bird's indices above 2^26 are one less when they come from another order",
                          "attribute", {13, 14}, lessen_converted_bird)}},
      needing({entry::vertex_index}),
      drawn_cases<Vertex>(settings_of(vertex_orders), Kind::vertex, drawn_vertex, found_of_vertices));
}

AnswerTable found_of_faces(const AttributeSubject& s, Level n, const Pair<FaceOrder, VertexOrder>& orders,
                           std::span<const MicroTriangle> at) {
  const auto& [faces, vertices] = orders;
  const Orders& f = s.functions.orders;
  AnswerTable all(at.size());
  std::vector<std::uint32_t> right;
  std::vector<Triplet> corners;
  for (const MicroTriangle& t : at) {
    right.push_back(specified(faces, t, n));
    const auto c = spec::attribute::corners_of(t);
    corners.push_back(
        {specified(vertices, c[0], n), specified(vertices, c[1], n), specified(vertices, c[2], n)});
  }
  const auto index = indices_of(s, faces, n, at);
  const auto given = [&](std::size_t k) { return right[k]; };
  all.add("index", given, [&](std::size_t k) { return index[k]; });
  if (f.face_at) {
    std::vector<MicroTriangle> back(at.size());
    f.face_at(faces, n, right, back);
    all.add(
        "back at iu", [&](std::size_t k) { return at[k].iu; }, [&](std::size_t k) { return back[k].iu; });
    all.add(
        "back at iv", [&](std::size_t k) { return at[k].iv; }, [&](std::size_t k) { return back[k].iv; });
    all.add(
        "back, upper", [&](std::size_t k) { return at[k].upper; },
        [&](std::size_t k) { return back[k].upper; });
  }
  if (f.convert_faces)
    for (const FaceOrder to : face_orders) {
      std::vector<std::uint32_t> other(at.size());
      f.convert_faces(faces, to, n, right, other);
      all.add(
          fmt::format("in {}", name_of(to)), [&](std::size_t k) { return specified(to, at[k], n); },
          [&](std::size_t k) { return other[k]; });
    }
  if (f.triplet) {
    std::vector<Triplet> got(at.size());
    f.triplet(faces, vertices, n, right, got);
    for (std::size_t c = 0; c < 3; ++c)
      all.add(
          fmt::format("vertex {}", c), [&](std::size_t k) { return corners[k][c]; },
          [&](std::size_t k) { return got[k][c]; });
  }
  if (f.face_of) {
    std::vector<std::uint32_t> face(at.size());
    f.face_of(faces, vertices, n, corners, face);
    all.add("face of its vertices", given, [&](std::size_t k) { return face[k]; });
  }
  return all;
}

void move_converted_rows(Functions& f) {
  f.orders.convert_faces = [real = f.orders.convert_faces](FaceOrder from, FaceOrder to, Level n,
                                                           std::span<const std::uint32_t> index,
                                                           std::span<std::uint32_t> out) {
    real(from, to, n, index, out);
    if (n < 13 || from != FaceOrder::rows || to != FaceOrder::u_major) return;
    for (std::uint32_t& x : out) ++x;
  };
}

Law sampled_faces_law() {
  const auto of = pairs(face_orders, vertex_orders);
  const auto found = [of](const AttributeSubject& s, Level n, std::size_t setting,
                          std::span<const MicroTriangle> at) {
    return found_of_faces(s, n, of[setting], at);
  };
  return on_batches(
      {.id = "attribute.faces_on_samples",
       .says = "a face's index, the way back, its index in the other orders, its three vertices and the face "
               "of these are the specification's",
       .source = cam_4,
       .method = Method::sample,
       .subjects = sampled_subjects,
       .tiers = {.fast = {8, 16}, .long_run = {1, 16}, .seconds = 1},
       .domain = "a sample of the 4^n faces, 3 orders of faces by 3 of vertices",
       .mutants = {mutant("faces of rows are one further in U-major, from level 13 on", "attribute", {12, 13},
                          move_converted_rows)}},
      needing({entry::face_index}),
      drawn_cases<MicroTriangle>(settings_of(of), Kind::interior, drawn_face, found));
}

}  // namespace

std::vector<Law> order_sample_laws() { return {sampled_vertices_law(), sampled_faces_law()}; }

}  // namespace mmverify::proofs::attribute
