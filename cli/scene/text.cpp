#include "cli/output/text.hpp"

#include <fmt/format.h>

#include <map>

#include "cli/arguments/arguments.hpp"
#include "cli/output/streams.hpp"
#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
namespace micromap = impl::micromap;

double share(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
}

/// The levels in words: "levels 9..11 (9: 12, 10: 340, 11: 12)".
std::string levels_text(const std::vector<unsigned>& of) {
  std::map<unsigned, std::uint64_t> count;
  for (const unsigned level : of) ++count[level];
  if (count.size() == 1) return fmt::format("level {}", count.begin()->first);
  std::string each;
  for (const auto& [level, number] : count)
    each += fmt::format("{}{}: {}", each.empty() ? "" : ", ", level, grouped(number));
  return fmt::format("levels {}..{} ({})", count.begin()->first, count.rbegin()->first, each);
}

void line(std::FILE* out, std::string_view what, const std::string& text) {
  say(out, "  {:<11}{}\n", what, text);
}

}  // namespace

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 10000) return fmt::format("{} B", bytes);
  if (bytes < 10000000) return fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3);
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

void print_plan(std::FILE* out, const Scene& scene, const Plan& plan, const Levels& levels) {
  const TriangleCounts all = count_triangles(scene);
  say(out, "{}: {} triangles, {} placed\n", scene.file, grouped(all.unique), grouped(all.placed));
  say(out, "\nplan\n");
  for (const std::string& note : scene.notes) line(out, "note", printable(note));
  const PlanCounts baked = counts(plan);
  if (plan.triangles.empty())
    line(out, "bake", "nothing to bake: no triangle is alpha-tested by a texture");
  else
    line(
        out, "bake",
        fmt::format(
            "{} triangles ({} placed) of {} primitives on {} surfaces: {} distinct, {} micro-triangles at {}",
            grouped(baked.unique), grouped(baked.placed), plan.primitives.size(), plan.surfaces.size(),
            grouped(plan.triangles.size()), grouped(levels.micro_triangles), levels_text(levels.of)));
  // Primitives and triangles left out by reason, in the order of LeftOut.
  std::map<LeftOut, std::array<std::uint64_t, 2>> why;
  for (const LeftOutPrimitive& p : plan.left_out) {
    auto& [primitives, triangles] = why[p.why];
    ++primitives;
    triangles += scene.primitives[p.primitive].triangles.size();
  }
  for (const auto& [reason, count] : why)
    line(out, "left out",
         fmt::format("{} primitives, {} triangles: {}", count[0], grouped(count[1]), sentence(reason)));
  if (baked.unique > plan.triangles.size())
    line(out, "left out",
         fmt::format("{} triangles that share the map of another one with the same UVs{}",
                     grouped(baked.unique - plan.triangles.size()),
                     baked.reordered == 0
                         ? ""
                         : fmt::format("; for {} triangles, rotated or mirrored ones, the map is reordered",
                                       grouped(baked.reordered))));
  if (baked.lines + baked.points != 0)
    line(out, "note",
         fmt::format("the UVs of {} distinct triangles lie on a line, of {} at a point: they cover no area",
                     baked.lines, baked.points));
  if (baked.varying != 0)
    line(out, "note",
         fmt::format("the vertex alpha of {} triangles varies: they are baked by bounds, T and O only where "
                     "all alpha is so; bake.tight and bake.force2 are not asked of them",
                     grouped(baked.varying)));
  if (baked.limited != 0)
    line(out, "left out",
         fmt::format(
             "levels above {} of {} distinct triangles, by --level-limit; their texture has more detail",
             baked.limit, baked.limited));
  if (levels.lowered != 0)
    line(out, "left out",
         fmt::format("levels of {} distinct triangles, lowered to fit --memory", grouped(levels.lowered)));
}

namespace {

void print_bake(std::FILE* out, const SceneFigures& f) {
  const auto& counts = f.made.baked.counts;
  say(out, "\nbake\n");
  line(out, "time",
       fmt::format("{:.2f} s to load, {:.2f} s to bake: {:.0f} million micro-triangles/s", f.load_seconds,
                   f.made.bake_seconds,
                   static_cast<double>(counts.micro_triangles) / f.made.bake_seconds / 1e6));
  line(out, "work",
       fmt::format("{:.1f} % of micro-triangles judged one by one, {} of them in exact arithmetic",
                   100 * share(counts.leaves, counts.micro_triangles), grouped(counts.exact)));
  micromap::StateCounts states{};
  std::uint64_t uniform = 0, two_state = 0;
  for (const BakedTriangle& t : f.made.baked.triangles) {
    uniform += t.uniform.has_value();
    two_state += !t.uniform && t.format == micromap::Format::two_state;
    for (std::size_t k = 0; k < 4; ++k) states[k] += t.states[k];
  }
  line(out, "states",
       fmt::format(
           "T {:.2f} %, O {:.2f} %, UT {:.2f} %, UO {:.2f} %", 100 * share(states[0], counts.micro_triangles),
           100 * share(states[1], counts.micro_triangles), 100 * share(states[2], counts.micro_triangles),
           100 * share(states[3], counts.micro_triangles)));
  line(out, "uniform",
       fmt::format("{} of {} distinct triangles get a special index, no map; {} more need only 2 states",
                   grouped(uniform), grouped(f.made.baked.triangles.size()), grouped(two_state)));
  if (f.sizes.any_hit.area > 0)
    line(out, "any-hit",
         fmt::format("{:.2f} % of the placed area calls no shader ({:.2f} % transparent, {:.2f} % opaque)",
                     100 * f.sizes.any_hit.known(), 100 * f.sizes.any_hit.transparent,
                     100 * f.sizes.any_hit.opaque));
  else
    line(out, "any-hit", "not counted: no alpha-tested triangle is placed in the scene");
}

void print_sizes(std::FILE* out, const SceneFigures& f) {
  say(out, "\nsizes\n");
  const Footprint& s = f.sizes.footprint;
  line(out, "array",
       fmt::format("{} micromaps, {} special indices: {} of data, {} of records, {} of indices",
                   grouped(s.records), grouped(s.special), bytes_text(s.array_data),
                   bytes_text(s.record_bytes), bytes_text(s.index_bytes)));
  say(out, "  {:<11}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "", "micromaps", "data", "tree", "random",
      "graph", "data/tree", "bitmask");
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const ModeFootprint& m = s.mode[mode];
    say(out, "  {:<11}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12.2f}{:>12}\n", mode == 0 ? "2-state" : "4-state",
        grouped(m.records), bytes_text(m.data), bytes_text(m.tree), bytes_text(m.our_tree),
        bytes_text(m.graph), share(m.data, m.tree), bytes_text(m.bitmask));
  }
  line(out, "else",
       fmt::format("{} of alpha textures, {} of vertex indices and UVs", bytes_text(s.texture),
                   bytes_text(s.vertex_data)));
}

void print_pairs(std::FILE* out, const SceneFigures& f) {
  if (f.made.pairs.unique == 0) {
    line(out, "VQ", "no two triangles of a primitive share an edge in position and UV: no square maps");
  } else {
    line(out, "pairs",
         fmt::format("{} pairs, {} distinct; {} triangles in none", grouped(f.made.pairs.unique),
                     grouped(f.made.pairs.distinct.size()), grouped(f.made.pairs.unpaired)));
    for (const auto& [name, vq] : {std::pair{"VQ2", &f.vq2}, std::pair{"VQ4", &f.vq4}})
      line(out, name,
           fmt::format(
               "{} for {} maps ({} uniform); {:.2f} % of regions unknown, {:.2f} % more by {} substitutions",
               bytes_text(vq->bytes), grouped(vq->maps - vq->uniform), grouped(vq->uniform),
               100 * share(vq->unknown, vq->regions), 100 * share(vq->substitutions, vq->regions),
               grouped(vq->substitutions)));
  }
}

}  // namespace

void print_figures(std::FILE* out, const SceneFigures& f) {
  print_bake(out, f);
  print_sizes(out, f);
  print_pairs(out, f);
}

void print_levels(std::FILE* out, const SceneFigures& f) {
  if (f.at_levels.empty()) return;
  say(out,
      "\nall triangles at one level; asks: share of the placed area where the any-hit shader is called\n  "
      "{:<6}{:>11}{:>11}{:>12}{:>12}{:>10}{:>12}{:>12}{:>10}{:>11}\n",
      "level", "micromaps", "special", "2-st. data", "tree", "data/tree", "4-st. data", "tree", "data/tree",
      "asks");
  for (const auto& at : f.at_levels) {
    const Footprint& p = at.sizes.footprint;
    say(out, "  {:<6}{:>11}{:>11}{:>12}{:>12}{:>10.2f}{:>12}{:>12}{:>10.2f}{:>9.2f} %\n", at.level,
        grouped(p.records), grouped(p.special), bytes_text(p.mode[0].data), bytes_text(p.mode[0].tree),
        share(p.mode[0].data, p.mode[0].tree), bytes_text(p.mode[1].data), bytes_text(p.mode[1].tree),
        share(p.mode[1].data, p.mode[1].tree), 100 * at.sizes.any_hit.unknown);
  }
}

void print_subject(std::FILE* out, const SubjectFigures& f) {
  const auto& t = f.totals;
  const auto a_million = [&t](std::uint64_t count) {
    return t.micro_triangles == 0 ? 0.0
                                  : 1e6 * static_cast<double>(count) / static_cast<double>(t.micro_triangles);
  };
  const auto counted = [&](std::uint64_t count) {
    return fmt::format("{}, {:.1f} a million", grouped(count), a_million(count));
  };
  say(out, "\n{} on this scene\n", f.name);
  line(out, "asked",
       fmt::format("{} distinct triangles: {} not asked, beyond what it declares; {} asked and declined",
                   grouped(t.triangles), grouped(t.outside), grouped(t.declined)));
  line(out, "baked", fmt::format("{} micro-triangles of the other triangles", grouped(t.micro_triangles)));
  line(out, "wrong",
       counted(t.wrong_known) + ": T or O, though alpha is not transparent or opaque on all of it");
  line(out, "needless",
       counted(t.needless_unknown) + ": unknown, though alpha is transparent or opaque on all of it");
  // The specification works in rationals: its time is that of a judge, not of a baker.
  const bool is_specification = f.name == "bake-spec";
  line(out, "time",
       fmt::format("{:.1f} ns a micro-triangle, question and answer included; ours {:.1f} ns{}", t.ns,
                   t.our_ns,
                   is_specification ? std::string() : fmt::format("; {:.1f} times ours", f.times_ours())));
}

void print_left_out(std::FILE* out, const std::vector<proofs::scene::LeftOutLaw>& left_out) {
  for (const auto& [what, why] : left_out) line(out, "left out", fmt::format("{}: {}", what, why));
}

}  // namespace mmverify::cli
