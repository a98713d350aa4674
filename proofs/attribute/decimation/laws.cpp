// Laws of edges beside a neighbour of one level less: the micro-triangles after vertices have snapped.
#include "proofs/attribute/decimation/mesh.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::side;

/// A wrong rule for snapping: the new place of x, given the right one.
using Rule = std::function<Vertex(Level n, EdgeFlags flags, const Vertex& x, const Vertex& right)>;

std::function<void(Functions&)> snapping_by(Rule rule) {
  return spoils(&Functions::decimation, &Decimation::snapped,
                [rule](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<Vertex> out) {
                  for (std::size_t k = 0; k < at.size(); ++k) out[k] = rule(n, flags, at[k], out[k]);
                });
}

/// A rule that moves an odd vertex of a flagged edge to `to` steps from the edge's first end.
Rule along_edges(std::function<std::uint32_t(Level n, std::uint32_t edge, std::uint32_t at)> to) {
  return [to](Level n, EdgeFlags flags, const Vertex& x, const Vertex& right) {
    const auto place = spec::attribute::decimated_at(x, n, flags);
    return place.decimated ? spec::attribute::on_edge(place.edge, to(n, place.edge, place.at), n) : right;
  };
}

const Rule towards_the_middle =
    along_edges([](Level n, std::uint32_t, std::uint32_t at) { return at < side(n) / 2 ? at + 1 : at - 1; });
/// A rule that moves to w on the edges w-u and v-w, and to u on u-v: i or j is one less.
const Rule indices_down =
    along_edges([](Level, std::uint32_t edge, std::uint32_t at) { return edge == 2 ? at + 1 : at - 1; });

Rule only_at(Level level, EdgeFlags with, Vertex where, Vertex to) {
  return [=](Level n, EdgeFlags flags, const Vertex& x, const Vertex& right) {
    return n == level && flags == with && x == where ? to : right;
  };
}

Mutant wrong_rule(const char* name, Levels levels, const Rule& rule, const char* base = "attribute-spec") {
  return mutant(name, base, levels, snapping_by(rule));
}

/// A law whose cases are the 8 sets of flags.
Law on_edge_flags(Law law, std::function<Finding(const AttributeSubject&, Level, EdgeFlags)> check) {
  Cases<EdgeFlags> cases;
  cases.count = spec::attribute::edge_flag_sets;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) { return static_cast<EdgeFlags>(k); };
  cases.text = [](Level, EdgeFlags flags) { return fmt::format("flags={}", flags); };
  cases.read = [](Level, const std::string& at) { return flags_of_text(at); };
  cases.check = std::move(check);
  cases.chunk = 1;
  law.source = cam_3;
  return on_cases(std::move(law), needing({snapped_entry}), std::move(cases));
}

template <VertexChoice asked>
std::function<Finding(const AttributeSubject&, Level, EdgeFlags)> of_mesh(
    Finding (*holds)(const DecimatedMesh&)) {
  return [holds](const AttributeSubject& s, Level n, EdgeFlags flags) {
    return holds(DecimatedMesh(s, n, flags, asked));
  };
}

std::string domain_of_all(const Subject&, Level) { return "the 8 sets of flags, all V(n) vertices"; }
std::string domain_at_edges(const Subject&, Level) {
  return "the 8 sets of flags, vertices on base edges and one step from them; that the others stay is "
         "attribute.decimation_watertight's";
}

Law decimation_watertight_law() {
  return on_edge_flags(
      {.id = "attribute.decimation_watertight",
       .says =
           "with flagged edges decimated, each inner edge of a live micro-triangle meets its opposite once, "
           "a flagged base edge is that of level n-1, the others are of level n, no other vertex moves",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 12}, .long_run = {0, 14}, .seconds = 0.6},
       .domain = domain_of_all,
       .mutants = {wrong_rule("one vertex of level 9 stays", {9, 9}, only_at(9, 5, {0, 101}, {0, 101}))}},
      of_mesh<VertexChoice::all>(watertight));
}

Law decimation_areas_law() {
  return on_edge_flags(
      {.id = "attribute.decimation_areas",
       .says = "decimated micro-triangles add up to the base triangle's area, and none is turned over",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 12}, .long_run = {0, 16}, .seconds = 0.3},
       .domain = domain_at_edges,
       .mutants = {wrong_rule("one vertex of level 11 goes inwards", {11, 11},
                              only_at(11, 4, {0, 301}, {1, 301}), "attribute")}},
      of_mesh<VertexChoice::at_edges>(areas_kept));
}

Law decimation_counts_law() {
  return on_edge_flags({.id = "attribute.decimation_counts",
                        .says = "with p flags, p N/2 micro-triangles are degenerate, 4^n - p N/2 live, and p "
                                "N/2 vertices unused; at level 0 none",
                        .subjects = {"attribute-spec", "attribute"},
                        .tiers = {.fast = {0, 12}, .long_run = {0, 16}, .seconds = 0.3},
                        .domain = domain_at_edges,
                        .mutants = {wrong_rule("one vertex of level 11 stays", {11, 11},
                                               only_at(11, 7, {2047, 1}, {2047, 1}), "attribute")}},
                       of_mesh<VertexChoice::at_edges>(counted));
}

/// The expected lost area, in quarters of a micro-triangle.  From level 2 on, p flags make p N/2 micro-triangles
/// degenerate, and beside these p N/2 lose half.  The corners between two flagged edges count once only (p = 2: 1
/// corner, p = 3: 3).  Level 1 is a case of its own.
std::uint64_t expected_lost_quarters(Level n, EdgeFlags flags) {
  const std::uint64_t odd = odd_vertices(n, flags), N = side(n), p = odd / std::max<std::uint64_t>(N / 2, 1);
  constexpr std::array<std::uint64_t, 4> at_corners{0, 0, 1, 3};
  if (n == 0 || p == 0) return 0;
  // Level 1: the p corners' micro-triangles are lost, and of the middle one 1/2, 1/2 or nothing.
  if (n == 1) return p == 3 ? 12 : 4 * p + 2;
  return 4 * odd + 2 * odd - 4 * at_corners[p];
}

Law lookup_fails_law() {
  return on_edge_flags(
      {.id = "paper.decimated_lookup_fails",
       .says = "if only the vertices' indices are adjusted, the micro-triangle of a point is degenerate or "
               "does not hold it on 3/(4N) of the area with one flag, 3/(2N) - 1/N^2 with two, 9/(4N) - "
               "3/N^2 with three (level 1: 3/8, 5/8, 3/4)",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 12}, .long_run = {0, 16}, .seconds = 0.3},
       .domain = domain_at_edges,
       .mutants = {wrong_rule("one vertex of level 10 stays", {10, 10}, only_at(10, 3, {1023, 1}, {1023, 1})),
                   wrong_rule("odd vertices go towards the edge's middle", {0, 3}, towards_the_middle),
                   wrong_rule("nothing is decimated", {1, 1},
                              [](Level, EdgeFlags, const Vertex& x, const Vertex&) { return x; })},
       .general = false},
      [](const AttributeSubject& s, Level n, EdgeFlags flags) {
        const DecimatedMesh mesh(s, n, flags, VertexChoice::at_edges);
        if (mesh.complaint()) return wrong(mesh.complaint()->expected, mesh.complaint()->got);
        const std::uint64_t expected = expected_lost_quarters(n, flags), got = lost_quarters(mesh);
        const auto share = [n](std::uint64_t quarters) {
          return fmt::format("{} of {} quarters of micro-triangles", quarters,
                             4 * spec::attribute::face_count(n));
        };
        if (got != expected) return wrong(share(expected), share(got));
        return Finding{.answer = got};
      });
}

}  // namespace

constinit const Entry snapped_entry{"vertex -> decimated vertex",
                                    [](const Functions& f) { return bool{f.decimation.snapped}; }};
constinit const Entry averaged_entry{"vertex -> two vertices",
                                     [](const Functions& f) { return bool{f.decimation.averaged}; }};
constinit const Entry place_entry{"point -> decimated micro-triangle",
                                  [](const Functions& f) { return bool{f.decimation.place}; }};

EdgeFlags flags_of_text(const std::string& text) {
  if (text.size() != 7 || !text.starts_with("flags=") || text[6] < '0' || text[6] > '7')
    throw BadCase(fmt::format("'{:.60}': write flags=0 to flags=7", text));
  return static_cast<EdgeFlags>(text[6] - '0');
}

std::vector<Law> decimation_laws() {
  std::vector<Law> all{decimation_watertight_law(), decimation_areas_law(), decimation_counts_law(),
                       decimation_sample_law()};
  const std::vector<Law> values = decimated_value_laws();
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

std::vector<Law> decimation_paper_laws() { return {lookup_fails_law(), two_levels_law()}; }

}  // namespace mmverify::proofs::attribute
