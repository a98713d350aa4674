// Laws of plans: the level of each triangle of a mesh.
#include "proofs/attribute/bake/parts.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

constexpr Entry plans{"plan", [](const Functions& f) { return bool(f.baking.plan); }};

using Mesh = std::vector<Neighbours>;

/// An open strip: triangle t is beside t - 1 and t + 1.
Mesh strip(std::int32_t count) {
  Mesh mesh;
  for (std::int32_t t = 0; t < count; ++t) mesh.push_back({t - 1, t + 1 < count ? t + 1 : -1, -1});
  return mesh;
}
/// A closed strip: triangles about a vertex.
Mesh fan(std::int32_t count) {
  Mesh mesh;
  for (std::int32_t t = 0; t < count; ++t) mesh.push_back({(t + count - 1) % count, (t + 1) % count, -1});
  return mesh;
}
/// The faces of a tetrahedron, each beside the others.
Mesh tetrahedron() { return {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}; }
/// The faces of an octahedron, numbered by the signs of their coordinates: neighbours differ in one sign.
Mesh octahedron() {
  Mesh mesh;
  for (std::int32_t t = 0; t < 8; ++t) mesh.push_back({t ^ 1, t ^ 2, t ^ 4});
  return mesh;
}

struct NamedMesh {
  const char* name;
  Mesh mesh;
};
const std::vector<NamedMesh>& meshes() {
  static const std::vector<NamedMesh> all{
      {"strip", strip(6)}, {"fan", fan(5)}, {"tetrahedron", tetrahedron()}, {"octahedron", octahedron()}};
  return all;
}

// ---- Graded

/// The wanted level of each triangle; no_map, if the triangle has a single value.
struct GradedCase {
  std::size_t mesh = 0;
  std::vector<Level> wanted;
};
constexpr Level no_map = 9;

/// The number of assignments: each triangle wants a level of 0..n or no map.
std::uint64_t assignments(Level n, std::size_t mesh) {
  std::uint64_t count = 1;
  for (std::size_t t = 0; t < meshes()[mesh].mesh.size(); ++t) count *= n + 2;
  return count;
}

std::string levels_text(const std::vector<Level>& levels) {
  std::string text;
  for (const Level l : levels) text += l == no_map ? '-' : static_cast<char>('0' + l);
  return text;
}

Finding is_graded(const AttributeSubject& s, Level n, const GradedCase& g) {
  PlanCase one;
  one.neighbours = meshes()[g.mesh].mesh;
  one.highest = n;
  Mesh apart = one.neighbours;  // the mesh without triangles that have no map
  std::vector<Level> wanted = g.wanted;
  for (std::size_t t = 0; t < wanted.size(); ++t) {
    one.special.push_back(wanted[t] == no_map);
    for (std::int32_t& k : apart[t])
      if (one.special[t] || (k >= 0 && g.wanted[static_cast<std::size_t>(k)] == no_map))
        k = slow::no_neighbour;
  }
  for (Level& l : wanted)
    if (l == no_map) l = 0;
  one.keeps = [&](std::size_t t, Level level, std::uint8_t) { return level >= wanted[t]; };
  const auto got = s.functions.baking.plan(one);
  const std::vector<Level> expected = slow::graded(wanted, apart);
  std::vector<Level> levels;
  for (const PlannedTriangle& p : got) levels.push_back(p.level);
  if (levels != expected)
    return wrong(fmt::format("levels {} of wanted {}", levels_text(expected), levels_text(g.wanted)),
                 levels_text(levels));
  std::uint64_t digest = 0;
  for (std::size_t t = 0; t < got.size(); ++t) {
    const std::uint8_t flags = slow::decimated_edges(expected, apart[t], t);
    if (got[t].decimated != flags || !got[t].kept)
      return wrong(fmt::format("edges {:03b} of triangle {} of levels {}, its error kept", flags, t,
                               levels_text(expected)),
                   fmt::format("{:03b}{}", got[t].decimated, got[t].kept ? "" : ", not kept"));
    digest = digest * 31 + expected[t] * 8 + flags;
  }
  return {digest};
}

/// A mutant that changes the subject's plan afterwards.
std::function<void(Functions&)> replanned(
    std::function<void(const PlanCase&, std::vector<PlannedTriangle>&)> change) {
  return spoils(&Functions::baking, &Baking::plan,
                [=](const PlanCase& one, auto& plan) { change(one, plan); });
}

Law graded_law() {
  Cases<GradedCase> cases;
  cases.count = [](Level n, const Run& run) {
    // A level of 3 reaches two triangles further, which the small meshes show as well.
    const std::size_t few = run.tier == Tier::fast && n > 2 ? 2 : meshes().size();
    std::uint64_t count = 0;
    for (std::size_t m = 0; m < few; ++m) count += assignments(n, m);
    return count;
  };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    GradedCase g;
    while (k >= assignments(n, g.mesh)) k -= assignments(n, g.mesh++);
    for (std::size_t t = 0; t < meshes()[g.mesh].mesh.size(); ++t) {
      const auto level = static_cast<Level>(k % (n + 2));
      g.wanted.push_back(level > n ? no_map : level);
      k /= n + 2;
    }
    return g;
  };
  cases.text = [](Level, const GradedCase& g) {
    return fmt::format("{}:{}", meshes()[g.mesh].name, levels_text(g.wanted));
  };
  cases.read = [](Level n, const std::string& text) {
    for (GradedCase g; g.mesh < meshes().size(); ++g.mesh) {
      const std::string name = std::string(meshes()[g.mesh].name) + ":";
      if (!text.starts_with(name) || text.size() != name.size() + meshes()[g.mesh].mesh.size()) continue;
      for (const char c : text.substr(name.size())) {
        if (c != '-' && (c < '0' || c > static_cast<char>('0' + n)))
          throw BadCase(fmt::format("'{:.60}': levels up to {}, or -", text, n));
        g.wanted.push_back(c == '-' ? no_map : static_cast<Level>(c - '0'));
      }
      return g;
    }
    throw BadCase(
        fmt::format("'{:.60}': strip, fan, tetrahedron or octahedron, a colon, a level each", text));
  };
  cases.check = is_graded;
  return on_cases(
      {.id = "attribute.plan_graded",
       .says = "where levels suffice from a wanted one on, each triangle gets the greatest of wanted(s) less "
               "the edges between, neighbours differ by one at most, and flags say on which edges",
       .source = "Color and Attribute Micromaps, 3.2; spec/attribute/plan.hpp",
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 4}, .seconds = 1},
       .domain =
           [](Level n) {
             return fmt::format(
                 "a strip of 6, a fan of 5, {}: every triangle wants 0..{} or no map, all ways",
                 n > 2 ? "in the long tier tetrahedron and octahedron" : "tetrahedron and octahedron", n);
           },
       .mutants = {mutant("triangle 0 has one level less", "attribute", {2, 2},
                          replanned([](const PlanCase&, std::vector<PlannedTriangle>& p) {
                            if (p[0].level == 2 && p[1].level == 2) --p[0].level;
                          }))}},
      needing({plans}), cases);
}

// ---- The error is kept

/// Random answers to whether a triangle keeps its error, by triangle, level and decimated edges.  Some triangles want
/// level 4 in tables with odd numbers, none in the others.
struct ErrorTable {
  std::size_t mesh = 0;
  std::uint64_t seed = 0, number = 0;
};

bool kept(const ErrorTable& e, std::size_t t, Level level, std::uint8_t edges) {
  Random random(e.seed, 0x706c616e, e.number * 4096 + t * 128 + level * 8 + edges);
  const std::uint32_t slope = e.number % 2 == 0 ? 2 : 1;
  return random.below(8) < 3 + slope * level - (edges != 0 ? 2u : 0u) - (level == 0 ? 1u : 0u);
}

Finding keeps_error(const AttributeSubject& s, Level n, const ErrorTable& e) {
  PlanCase one;
  one.neighbours = meshes()[e.mesh].mesh;
  one.highest = n;
  const std::size_t count = one.neighbours.size();
  for (std::size_t t = 0; t < count; ++t)
    one.special.push_back(Random(e.seed, 0x737065, e.number * 64 + t).below(8) == 0);
  one.keeps = [&](std::size_t t, Level level, std::uint8_t edges) { return kept(e, t, level, edges); };
  const auto plan = s.functions.baking.plan(one);
  std::uint64_t digest = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const PlannedTriangle& p = plan[t];
    digest = digest * 31 + p.level * 8 + p.decimated;
    if (one.special[t]) continue;
    const std::string where = fmt::format("triangle {}, level {}, edges {:03b}", t, p.level, p.decimated);
    if (p.level > n) return wrong(fmt::format("a level up to {}", n), where);
    std::uint8_t flags = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t across = one.neighbours[t][k];
      if (across < 0 || one.special[static_cast<std::size_t>(across)]) continue;
      const Level other = plan[static_cast<std::size_t>(across)].level;
      if (other > p.level + 1 || p.level > other + 1)
        return wrong(fmt::format("{}: a level within one of it across edge {}", where, k),
                     fmt::format("level {}", other));
      if (other < p.level) flags = static_cast<std::uint8_t>(flags | 1u << k);
    }
    if (flags != p.decimated) return wrong(fmt::format("edges {:03b}", flags), where);
    if (p.kept != kept(e, t, p.level, p.decimated))
      return wrong(fmt::format("{}: error {}", where, p.kept ? "not kept" : "kept"),
                   p.kept ? "kept" : "not kept");
    if (!p.kept && (p.level < n || (flags != 0 && kept(e, t, p.level, 0))))
      return wrong("an error that a higher level around would keep, kept", where);
  }
  return {digest};
}

Law keeps_law() {
  Cases<ErrorTable> cases;
  cases.count = {4'000, 400'000};
  cases.number = [](Level, std::uint64_t k, std::uint64_t seed) {
    return ErrorTable{k % meshes().size(), seed, k / meshes().size()};
  };
  cases.text = [](Level, const ErrorTable& e) {
    return fmt::format("{}:seed={},table={}", meshes()[e.mesh].name, e.seed, e.number);
  };
  cases.read = [](Level, const std::string& text) {
    const Groups groups = groups_of(text, "([a-z]+):seed=(\\d{1,18}),table=(\\d{1,12})");
    if (groups)
      for (std::size_t m = 0; m < meshes().size(); ++m)
        if ((*groups)[1] == meshes()[m].name)
          return ErrorTable{m, std::stoull((*groups)[2]), std::stoull((*groups)[3])};
    throw BadCase(fmt::format("'{:.60}': write MESH:seed=1,table=2", text));
  };
  cases.check = keeps_error;
  return on_cases(
      {.id = "attribute.plan_keeps_error",
       .says =
           "whatever keeps the error: each triangle of a plan keeps it, with its edges as they are, or has "
           "the highest level and does not keep it undecimated; neighbours differ by one level at most",
       .source = "Color and Attribute Micromaps, 3.2",
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 4}, .seconds = 0.5},
       .domain =
           [](Level n) {
             return fmt::format(
                 "a strip of 6, a fan of 5, tetrahedron and octahedron, levels up to {}, drawn tables of "
                 "what keeps the error",
                 n);
           },
       .mutants = {mutant("decimated edges not asked about where the highest level is 4", "attribute", {4, 4},
                          [](Functions& f) {
                            f.baking.plan = [real = f.baking.plan](const PlanCase& one) {
                              PlanCase other = one;
                              other.keeps = [&](std::size_t t, Level level, std::uint8_t edges) {
                                return one.keeps(t, level, one.highest == 4 ? std::uint8_t{0} : edges);
                              };
                              return real(other);
                            };
                          })}},
      needing({plans}), cases);
}

}  // namespace

std::vector<Law> plan_laws() { return {graded_law(), keeps_law()}; }

}  // namespace mmverify::proofs::attribute
