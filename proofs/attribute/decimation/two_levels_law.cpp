// Law of neighbours two levels apart, which shows with a picture why one level is the most.
#include "proofs/attribute/lookup/shared_edges.hpp"
#include "proofs/drawing/canvas.hpp"

namespace mmverify::proofs::attribute {
namespace {

using drawing::blue, drawing::Canvas, drawing::grey, drawing::ink, drawing::Pixel, drawing::vermilion;
using spec::side;

/// The edges of a flagged map of level n and of a map of level n-2 agree at the vertices of level n-2 and nowhere else.
Finding cracks(const AttributeSubject& s, Level n, const SharedEdge& e) {
  const auto finer = of_finer(s, n, e), lower = of_neighbour(s, n, n - 2, e);
  const Hats from_finer = along_edge(n, e.at, side(n) / 2), from_lower = along_edge(n, e.at, side(n) / 4);
  if (!finer || *finer != from_finer)
    return wrong(text_of_places(from_finer), finer ? text_of_places(*finer) : "a vertex off the edge");
  if (!lower || *lower != from_lower)
    return wrong(text_of_places(from_lower), lower ? text_of_places(*lower) : "a vertex off the edge");
  const bool at_its_vertex = e.at % 16 == 0, agree = *finer == *lower;
  if (agree != at_its_vertex)
    return wrong(at_its_vertex ? "no crack at a vertex of level n-2" : "a crack", agree ? "none" : "a crack");
  return {.answer = agree ? 1u : 0u};
}

/// A picture of both maps and their common edge.  The value is 1 at the finer map's vertex that level n-2 lacks,
/// nearest to the place of the case, and 0 elsewhere; there the edges part.
std::string drawn(Level n, const SharedEdge& e) {
  const double width = 760, left = 90, size = 580, middle = 380, slope = std::sqrt(3.0) / 2;
  const std::string title = fmt::format("An edge of level {} beside one of level {}", n, n - 2);
  Canvas canvas(width, 700, title);
  canvas.text({24, 34}, title, 19, ink, "start", true);
  const double N = side(n);
  // The vertex of level n-1 between two of level n-2 that is nearest to the place.
  const std::uint32_t lifted =
      static_cast<std::uint32_t>(4 * (e.at / 16)) + (e.at == 4 * std::uint64_t{side(n)} ? -2u : 2u);
  canvas.text(
      {24, 60},
      fmt::format(
          "Values are 0, but 1 at vertex {} of {}: decimated, the finer edge has it; the other passes below.",
          lifted, side(n)),
      15);
  const auto value = [&](double x) { return std::max(0.0, 1 - std::abs(x - lifted) / 2); };
  // The lift is less than a row's height, so that nothing seems turned over.
  const double lift = 0.6 * size * slope / (2 * N);
  const auto on_edge = [&](double x, double high) { return Pixel{left + size * x / N, middle - high}; };
  // The crack between the two edges.
  canvas.polygon({on_edge(lifted - 2, 0), on_edge(lifted, lift), on_edge(lifted + 2, 0)}, vermilion, "none",
                 0, 0.35);

  // The finer map lies above the edge: its micro-triangles as decimated, the edge along x.
  const EdgeFlags flags = 1;
  const auto above = [&](const Vertex& x) {
    const double along = x.i + x.j / 2.0, high = x.j == 0 ? lift * value(x.i) : 0;
    return Pixel{left + size * along / N, middle - high - size * slope * x.j / (2 * N)};
  };
  for (std::uint32_t iu = 0; iu < side(n); ++iu)
    for (std::uint32_t iv = 0; iu + iv < side(n); ++iv)
      for (const bool upper : {false, true}) {
        if (iu + iv + (upper ? 1 : 0) >= side(n)) continue;
        const Corners c = spec::attribute::snapped(MicroTriangle{iu, iv, upper}, n, flags);
        if (spec::attribute::doubled_area(c) == 0) continue;
        canvas.polygon({above(c[0]), above(c[1]), above(c[2])}, "none", blue, 1.5);
      }
  // The neighbour lies below it.
  const std::uint32_t M = side(n - 2);
  const auto below = [&](const Vertex& x) {
    return Pixel{left + size * (x.i + x.j / 2.0) / M, middle + size * slope * x.j / M * 0.5};
  };
  for (std::uint32_t iu = 0; iu < M; ++iu)
    for (std::uint32_t iv = 0; iu + iv < M; ++iv)
      for (const bool upper : {false, true}) {
        if (iu + iv + (upper ? 1 : 0) >= M) continue;
        const Corners c = spec::attribute::corners_of(MicroTriangle{iu, iv, upper});
        canvas.polygon({below(c[0]), below(c[1]), below(c[2])}, "none", grey, 1.5);
      }
  const double x = static_cast<double>(e.at) / 4;
  canvas.dot(on_edge(x, lift * value(x)), 5, blue, "#ffffff");
  canvas.dot(on_edge(x, 0), 5, grey, "#ffffff");
  canvas.text({24, 660},
              fmt::format("At {}/{} of the edge the finer map reads {}, the other 0.", e.at, 4 * N, value(x)),
              14);
  canvas.text({24, 682}, "Blue: the finer map, decimated. Grey: the neighbour. Filled: the crack.", 13,
              "#555555");
  return canvas.str();
}

Mutant with_place(
    const char* name, Levels levels,
    std::function<WeightedVertices(const Functions& right, Level, EdgeFlags, const DyadicPoint&)> by) {
  const Functions right = built_in("attribute-spec")->functions;
  return mutant(name, "attribute-spec", levels, [by, right](Functions& f) {
    f.decimation.place = [by, right](Level n, EdgeFlags flags, const DyadicPoint& p) {
      return by(right, n, flags, p);
    };
  });
}

}  // namespace

Law two_levels_law() {
  const auto of = [](const Subject& s) -> const AttributeSubject& { return subject_as<AttributeSubject>(s); };
  Law law{.id = "paper.two_levels_crack",
          .says =
              "a flagged edge of level n and an edge of level n-2 agree at the N/4 + 1 vertices of level n-2 "
              "and nowhere else: neighbours may differ by one level, not two",
          .source = cam_3,
          .subjects = {"attribute-spec", "attribute"},
          .tiers = {.fast = {2, 6}, .long_run = {2, 11}, .seconds = 0.3},
          .domain = "3 edges and 4 sets of other flags on either side, the points k/(4N) of the edge",
          .mutants = {with_place("a flagged edge is that of level n-2", {2, 4},
                                 [](const Functions& right, Level n, EdgeFlags flags, const DyadicPoint& p) {
                                   if (n < 2 || (flags & 1) == 0 || !(p.v == spec::Fixed64(0)))
                                     return right.decimation.place(n, flags, p);
                                   WeightedVertices w = right.decimation.place(n - 2, 0, p);
                                   for (Vertex& x : w.corners) x = {4 * x.i, 4 * x.j};
                                   return w;
                                 }),
                      with_place("flags are not looked at", {2, 3},
                                 [](const Functions& right, Level n, EdgeFlags, const DyadicPoint& p) {
                                   return right.decimation.place(n, 0, p);
                                 }),
                      with_place("the flag of v-w is that of w-u at level 5", {5, 5},
                                 [](const Functions& right, Level n, EdgeFlags flags, const DyadicPoint& p) {
                                   return right.decimation.place(
                                       n, n == 5 ? (flags & 3) | (flags & 1) << 2 : flags, p);
                                 })},
          .general = false};
  const Lacks lacks = needing({place_entry});
  law.unfit = [unfit = unfit_by(lacks)](const Subject& s, Level n) -> std::optional<std::string> {
    if (n < 2) return "there is no level n-2";
    return unfit(s, n);
  };
  return on_numbered_cases(
      std::move(law),
      {.count = [](Level n, const Run&) { return shared_edge_cases(n); },
       .check = [of](const Subject& s, Level n, std::uint64_t k,
                     const Run&) { return cracks(of(s), n, shared_edge(n, k)); },
       .text = [](const Subject&, Level n, std::uint64_t k,
                  const Run&) { return text_of(n, shared_edge(n, k)); },
       .read = [of](const Subject& s, Level n,
                    const std::string& at) { return cracks(of(s), n, shared_edge_of_text(n, at)); },
       .kind = Kind::edge,
       .draw = [](const Subject&, Level n,
                  const std::string& at) { return drawn(n, shared_edge_of_text(n, at)); }});
}

}  // namespace mmverify::proofs::attribute
