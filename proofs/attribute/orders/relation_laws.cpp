// Relations of orders: to the next level, to each other, and to faces.
#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/orders/parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

const std::vector<std::string> related_subjects{"attribute-spec", "attribute", "attribute-single"};

/// Two lists of answers to compare, as numbers.
struct Compared {
  std::vector<std::uint32_t> left, right;
};

/// A law on two lists of vertex indices in each setting; `holds` judges a pair, `wanted` words the expectation.
struct TwoIndices {
  std::function<Compared(const AttributeSubject&, Level, std::size_t setting, std::span<const Vertex>)> both;
  std::function<bool(Level, std::size_t setting, const Vertex&, std::uint32_t left, std::uint32_t right)>
      holds;
  std::function<std::string(std::size_t setting, std::uint32_t left)> wanted;
};

Batches<Vertex> on_two(std::vector<std::string> settings, const TwoIndices& two) {
  Batches<Vertex> cases;
  cases.settings = std::move(settings);
  cases.count = vertex_count;
  cases.kind = Kind::vertex;
  cases.check = [two](const AttributeSubject& s, Level n, std::size_t setting, std::span<const Vertex> at,
                      std::span<Outcome> out) {
    const Compared found = two.both(s, n, setting, at);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {found.right[k], two.holds(n, setting, at[k], found.left[k], found.right[k])};
  };
  cases.words = [two](const AttributeSubject& s, Level n, std::size_t setting, const Vertex& at) {
    const Compared found = two.both(s, n, setting, {&at, 1});
    return Words{two.wanted(setting, found.left[0]), fmt::format("{}", found.right[0])};
  };
  return cases;
}

std::vector<Vertex> scaled(std::span<const Vertex> at, Level by) {
  std::vector<Vertex> found;
  for (const Vertex& v : at) found.push_back({v.i << by, v.j << by});
  return found;
}

/// The law also needs level n+1.
std::function<std::optional<std::string>(const Subject&, Level)> one_level_more(
    const std::function<std::optional<std::string>(const Subject&, Level)>& unfit) {
  return [unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (auto why = unfit(s, n)) return why;
    if (const Level last = subject_as<AttributeSubject>(s).functions.max_level; n + 1 > last)
      return fmt::format("{} is defined up to level {}", s.name(), last);
    return std::nullopt;
  };
}

Law nested_law() {
  // Settings 0 to 2 take the same vertex at the next level.  Setting 3 takes the same numbers i and j there.
  auto settings = settings_of(vertex_orders);
  settings.emplace_back("w-minor-rows");
  TwoIndices two;
  two.both = [](const AttributeSubject& s, Level n, std::size_t setting, std::span<const Vertex> at) {
    const VertexOrder order = setting == 3 ? VertexOrder::w_minor : vertex_orders[setting];
    return Compared{indices_of(s, order, n, at),
                    indices_of(s, order, n + 1, scaled(at, setting == 3 ? 0 : 1))};
  };
  two.holds = [](Level, std::size_t setting, const Vertex& v, std::uint32_t here, std::uint32_t next) {
    const bool moves = setting < 2 && !(v == Vertex{0, 0});
    return moves ? next > here : next == here;
  };
  two.wanted = [](std::size_t setting, std::uint32_t here) {
    return setting < 2 ? fmt::format("a number above {}, or 0 of the w-corner", here)
                       : fmt::format("{}", here);
  };
  const auto at_level = [](VertexOrder order, Level level, Vertex where, std::uint32_t add) {
    return on_vertex_index(order, [=](Level n, const Vertex& v, std::uint32_t x) {
      return n == level && v == where ? x + add : x;
    });
  };
  Law law = on_batches(
      {.id = "attribute.order_prefix_nested",
       .says =
           "Bird alone keeps a vertex's index from level to level; in W-minor and U-major each vertex but "
           "number 0 moves up; W-minor of a level begins with the rows of the level before, number by number",
       .source = "Color and Attribute Micromaps, 3.1 and 4.4.1, which leave it open",
       .subjects = related_subjects,
       .tiers = {.fast = {0, 10}, .long_run = {0, 15}, .seconds = 1},
       .domain = "the V(n) vertices, in 3 orders and by W-minor's rows",
       .mutants = {mutant("one vertex of Bird's level 8 is another", "attribute-spec", {7, 7},
                          at_level(VertexOrder::bird, 8, {60, 128}, 3))}},
      needing({entry::vertex_index}), on_two(settings, two));
  law.unfit = one_level_more(law.unfit);
  return law;
}

constexpr Level last_level = 16;
/// The number of levels ahead: one more than the setting's number, up to level 16.
Level levels_on(std::size_t setting, Level n) {
  return std::min(static_cast<Level>(setting) + 1, last_level - n);
}

Law prefix_law() {
  std::vector<std::string> settings;
  for (Level on = 1; on <= last_level; ++on) settings.push_back(fmt::format("{}", on));
  TwoIndices two;
  two.both = [](const AttributeSubject& s, Level n, std::size_t setting, std::span<const Vertex> at) {
    const Level a = std::min(levels_on(setting, n), s.functions.max_level - n);
    return Compared{indices_of(s, VertexOrder::bird, n, at),
                    indices_of(s, VertexOrder::bird, n + a, scaled(at, a))};
  };
  two.holds = [](Level n, std::size_t, const Vertex&, std::uint32_t here, std::uint32_t there) {
    return here == there && here < vertex_count(n);
  };
  two.wanted = [](std::size_t, std::uint32_t here) { return fmt::format("{}", here); };
  return on_batches(
      {.id = "attribute.bird_prefix",
       .says = "Bird's map of a level begins with the map of each coarser level: the vertex of index x < "
               "V(n) is the same place any number of levels on, to level 16",
       .source = "Color and Attribute Micromaps, 3.1 and 4.4.1",
       .subjects = related_subjects,
       .tiers = {.fast = {0, 8}, .long_run = {0, 14}, .seconds = 1},
       .domain = "the V(n) vertices, 1 to 16 levels on, to level 16",
       .mutants = {mutant("5 levels on from level 7 one number is another", "attribute-spec", {7, 7},
                          on_vertex_index(VertexOrder::bird,
                                          [](Level n, const Vertex&, std::uint32_t x) {
                                            return n == 12 && x == 8000 ? x + 1 : x;
                                          }))}},
      needing({entry::vertex_index}), on_two(settings, two));
}

Law reversed_law() {
  TwoIndices two;
  two.both = [](const AttributeSubject& s, Level n, std::size_t, std::span<const Vertex> at) {
    std::vector<Vertex> turned;
    for (const Vertex& v : at) turned.push_back({v.j, spec::side(n) - v.i - v.j});
    Compared found{indices_of(s, VertexOrder::w_minor, n, turned),
                   indices_of(s, VertexOrder::u_major, n, at)};
    for (std::uint32_t& x : found.left) x = static_cast<std::uint32_t>(vertex_count(n) - 1 - x);
    return found;
  };
  two.holds = [](Level, std::size_t, const Vertex&, std::uint32_t left, std::uint32_t right) {
    return left == right;
  };
  two.wanted = [](std::size_t, std::uint32_t left) { return fmt::format("{}", left); };
  return on_batches(
      {.id = "attribute.umajor_is_reversed_rows",
       .says = "U-major(i, j) = V(n) - 1 - W-minor(j, N-i-j): the rows from the u-corner, backwards",
       .source = cam_2,
       .subjects = related_subjects,
       .tiers = {.fast = {0, 10}, .long_run = {0, 16}, .seconds = 1},
       .domain = "the V(n) vertices",
       .mutants = {mutant("the last two of level 4 change places", "attribute-spec", {4, 4},
                          on_vertex_index(VertexOrder::u_major,
                                          [](Level n, const Vertex& v, std::uint32_t x) {
                                            return n == 4 && v.i == 15 ? x ^ 3 : x;
                                          }))}},
      needing({entry::vertex_index}), on_two({"u-major"}, two));
}

/// A law that an element's index, converted from one order to another, is its own index there.
template <class Element, class Convert>
Batches<Element> conversions(const auto& of, std::function<std::uint64_t(Level)> count, Kind kind,
                             Convert convert) {
  Batches<Element> cases;
  cases.settings = settings_of(of);
  cases.count = std::move(count);
  cases.kind = kind;
  const auto both = [of, convert](const AttributeSubject& s, Level n, std::size_t setting,
                                  std::span<const Element> at) {
    const auto& pair = of[setting];
    Compared found{indices_of(s, pair.to, n, at), indices_of(s, pair.from, n, at)};
    convert(s.functions)(pair.from, pair.to, n, std::vector(found.right), found.right);
    return found;
  };
  cases.check = [both](const AttributeSubject& s, Level n, std::size_t setting, std::span<const Element> at,
                       std::span<Outcome> out) {
    const Compared found = both(s, n, setting, at);
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = {found.right[k], found.left[k] == found.right[k]};
  };
  cases.words = [both](const AttributeSubject& s, Level n, std::size_t setting, const Element& at) {
    const Compared found = both(s, n, setting, {&at, 1});
    return Words{fmt::format("{}", found.left[0]), fmt::format("{}", found.right[0])};
  };
  return cases;
}

/// A mutant of a converter: change(from, to, n, index, converted).
template <auto convert, class Change>
auto on_conversion(Change change) {
  return [change](Functions& f) {
    auto& function = f.orders.*convert;
    function = [change, real = function](auto from, auto to, Level n, std::span<const std::uint32_t> index,
                                         std::span<std::uint32_t> out) {
      const std::vector<std::uint32_t> kept(index.begin(), index.end());
      real(from, to, n, index, out);
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = change(from, to, n, kept[k], out[k]);
    };
  };
}

Law convert_law() {
  constexpr auto in = &Orders::convert_vertices;
  using enum VertexOrder;
  return on_batches(
      {.id = "attribute.convert",
       .says = "an index made that of another order is the same vertex's there",
       .source = cam_2,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 9}, .long_run = {0, 16}, .seconds = 2},
       .domain = "the V(n) vertices, from each order to each, itself as well",
       .mutants = {mutant("one vertex of level 8 from Bird", "attribute-spec", {8, 8},
                          on_conversion<in>([](auto from, auto, Level n, std::uint32_t x, std::uint32_t y) {
                            return n == 8 && from == bird && x == 12'345 ? y + 1 : y;
                          }))}},
      needing({entry::vertex_index, entry::convert_vertices}),
      conversions<Vertex>(pairs(vertex_orders, vertex_orders), vertex_count, Kind::vertex,
                          [](const Functions& f) { return f.orders.convert_vertices; }));
}

Law convert_faces_law() {
  constexpr auto in = &Orders::convert_faces;
  using enum FaceOrder;
  return on_batches(
      {.id = "attribute.convert_faces",
       .says = "a face's index made that of another order is the same face's there",
       .source = cam_2,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 8}, .long_run = {0, 16}, .seconds = 2},
       .domain = "the 4^n faces, from each order to each, itself as well",
       .mutants = {mutant("to the curve of level 7 the last one is the one before", "attribute", {7, 7},
                          on_conversion<in>([](auto, auto to, Level n, std::uint32_t, std::uint32_t y) {
                            return n == 7 && to == curve && y == face_count(7) - 1 ? y - 1 : y;
                          }))}},
      needing({entry::face_index, entry::convert_faces}),
      conversions<MicroTriangle>(pairs(face_orders, face_orders), face_count, Kind::interior,
                                 [](const Functions& f) { return f.orders.convert_faces; }));
}

/// Triplets of a batch and the faces of the right ones, beside what they must be.
struct FoundTriplets {
  std::vector<Triplet> expected, got;
  std::vector<std::uint32_t> face, back;
};

FoundTriplets found_triplets(const AttributeSubject& s, Level n, const Pair<FaceOrder, VertexOrder>& orders,
                             std::span<const MicroTriangle> at) {
  const auto& [faces, vertices] = orders;
  const Orders& f = s.functions.orders;
  FoundTriplets found;
  found.face = indices_of(s, faces, n, at);
  found.got.resize(at.size());
  f.triplet(faces, vertices, n, found.face, found.got);
  std::vector<Vertex> corners(3 * at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const spec::attribute::Corners three = spec::attribute::corners_of(at[k]);
    std::copy(three.begin(), three.end(), corners.begin() + static_cast<std::ptrdiff_t>(3 * k));
  }
  const auto index = indices_of(s, vertices, n, corners);
  found.expected.resize(at.size());
  for (std::size_t k = 0; k < at.size(); ++k)
    found.expected[k] = {index[3 * k], index[3 * k + 1], index[3 * k + 2]};
  found.back.resize(at.size());
  if (f.face_of) f.face_of(faces, vertices, n, found.expected, found.back);
  return found;
}

void swap_corners_of_one(FaceOrder faces, VertexOrder vertices, Level n, std::uint32_t face, Triplet& t) {
  if (n == 6 && face == 3000 && faces == FaceOrder::curve && vertices == VertexOrder::bird)
    std::swap(t[1], t[2]);
}

Law triangle_vertices_law() {
  const auto of = pairs(face_orders, vertex_orders);
  Batches<MicroTriangle> cases;
  cases.settings = settings_of(of);
  cases.count = face_count;
  cases.kind = Kind::interior;
  cases.check = [of](const AttributeSubject& s, Level n, std::size_t setting,
                     std::span<const MicroTriangle> at, std::span<Outcome> out) {
    const FoundTriplets found = found_triplets(s, n, of[setting], at);
    for (std::size_t k = 0; k < at.size(); ++k)
      out[k] = {found.got[k][0] + std::uint64_t{found.got[k][1]} * 3 + std::uint64_t{found.got[k][2]} * 5,
                found.got[k] == found.expected[k] && found.back[k] == found.face[k]};
  };
  cases.words = [of](const AttributeSubject& s, Level n, std::size_t setting, const MicroTriangle& at) {
    const FoundTriplets found = found_triplets(s, n, of[setting], {&at, 1});
    return Words{fmt::format("{}, of face {}", text_of(found.expected[0]), found.face[0]),
                 fmt::format("{}, of face {}", text_of(found.got[0]), found.back[0])};
  };
  const auto on_triplet = [](auto change) {
    return spoils(&Functions::orders, &Orders::triplet,
                  [change](FaceOrder faces, VertexOrder vertices, Level n,
                           std::span<const std::uint32_t> face, std::span<Triplet> out) {
                    for (std::size_t k = 0; k < out.size(); ++k) change(faces, vertices, n, face[k], out[k]);
                  });
  };
  return on_batches(
      {.id = "attribute.triangle_vertices",
       .says = "a face's triplet are its base's index and those one step along u and along v from there, "
               "backwards of an upper one; and of the triplet's faces it is that one",
       .source = cam_4,
       .subjects = related_subjects,
       .tiers = {.fast = {0, 7}, .long_run = {0, 16}, .seconds = 3},
       .domain = "the 4^n faces, 3 orders of faces by 3 of vertices",
       .mutants = {mutant("the last two corners of one face of level 6 change places", "attribute-spec",
                          {6, 6}, on_triplet(swap_corners_of_one))}},
      needing({entry::face_index, entry::vertex_index, entry::triplet, entry::face_of}), std::move(cases));
}

}  // namespace

std::vector<Law> order_relation_laws() {
  return {nested_law(),  prefix_law(),        reversed_law(),
          convert_law(), convert_faces_law(), triangle_vertices_law()};
}

}  // namespace mmverify::proofs::attribute
