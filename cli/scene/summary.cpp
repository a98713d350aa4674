// The six lines of `mmverify scene`, and its table of materials.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/arguments/arguments.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using proofs::Verdict;

/// The most coarser levels that are named.
constexpr std::size_t most_levels = 3;

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

void summary_line(std::FILE* out, std::string_view what, const std::string& text) {
  say(out, "  {:<10}{}\n", what, text);
}

std::string level_range(unsigned least, unsigned greatest) {
  return least == greatest ? fmt::format("level {}", least) : fmt::format("levels {} to {}", least, greatest);
}

/// The least and the greatest level of the maps.
std::string levels_of(const SceneFigures& f) {
  const auto [least, greatest] = std::minmax_element(f.made.levels.of.begin(), f.made.levels.of.end());
  return level_range(*least, *greatest);
}

std::string triangles_text(const SceneFigures& f) {
  const TriangleCounts all = count_triangles(f.scene);
  const PlanCounts baked = counts(f.made.plan);
  std::string text =
      fmt::format("{} of {} are alpha-tested, by {} material{}: {} distinct maps of {}",
                  grouped(baked.unique), grouped(all.unique), f.materials.size(),
                  f.materials.size() == 1 ? "" : "s", grouped(f.made.plan.triangles.size()), levels_of(f));
  if (f.made.levels.lowered != 0)
    text += fmt::format(", {} of them lowered to fit --memory", grouped(f.made.levels.lowered));
  if (baked.limited != 0) text += fmt::format(", {} of them by --level-limit", grouped(baked.limited));
  return text;
}

/// The triangles that --moving would add.
std::uint64_t triangles_that_could_move(const SceneFigures& f) {
  std::uint64_t count = 0;
  for (const LeftOutPrimitive& p : f.made.plan.left_out)
    if (const Primitive& primitive = f.scene.primitives[p.primitive];
        p.why == LeftOut::animated && primitive.moving_uvs)
      count += primitive.triangles.size();
  return count;
}

/// The fault of the first animated material whose triangles --moving cannot add.
std::string why_unmoved(const SceneFigures& f) {
  for (const LeftOutPrimitive& p : f.made.plan.left_out) {
    const Primitive& primitive = f.scene.primitives[p.primitive];
    const Material& material = f.scene.material_of(primitive);
    if (p.why == LeftOut::animated && !material.unmoved.empty())
      return fmt::format("{} triangle{} of material {} without maps: {}", grouped(primitive.triangles.size()),
                         primitive.triangles.size() == 1 ? "" : "s", printable(material.name),
                         printable(material.unmoved));
  }
  return {};
}

std::string any_hit_text(const SceneFigures& f) {
  const AnyHitShares& s = f.sizes.any_hit;
  if (s.area == 0) return "not counted: no alpha-tested triangle is placed in the scene";
  return fmt::format("shaders run for {} of the area; {} is transparent, {} opaque", percent(s.unknown),
                     percent(s.transparent), percent(s.opaque));
}

std::string memory_text(const SceneFigures& f) {
  const Footprint& s = f.sizes.footprint;
  return fmt::format("{} of maps, {} of records and indices; the alpha textures take {}",
                     bytes_text(s.array_data), bytes_text(s.record_bytes + s.index_bytes),
                     bytes_text(s.texture));
}

/// The shares and bytes of the levels below the finest one.
std::string coarser_text(const MaterialFigures& all, const char* option) {
  std::string text;
  for (std::size_t k = 1; k <= most_levels && k < all.levels.size(); ++k) {
    const std::size_t level = all.levels.size() - 1 - k;
    text += fmt::format("{}{} {}: {} in {}", text.empty() ? "" : "; ", option, level,
                        percent(all.levels[level].unknown), bytes_text(all.levels[level].bytes));
  }
  return text.empty() ? "level 0 is the coarsest" : text;
}

/// The coarsest level that leaves at most a share to shaders.
std::string asked_text(const MaterialFigures& all, double asks, const char* option) {
  const std::optional<unsigned> level = level_for(all, asks);
  if (!level)
    return fmt::format("no level up to {} leaves at most {} to shaders", all.levels.size() - 1,
                       percent(asks));
  return fmt::format("{} {} leaves {} to shaders, in {}", option, *level, percent(all.levels[*level].unknown),
                     bytes_text(all.levels[*level].bytes));
}

std::string laws_text(const proofs::Report& report) {
  if (report.results.empty()) return "none were run";
  std::map<Verdict, std::size_t> count;
  for (const proofs::Result& r : report.results) ++count[r.verdict];
  std::string text;
  for (const auto& [verdict, number] : count)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, to_string(verdict));
  return text + (count.contains(Verdict::refuted) ? "" : "; none refuted");
}

}  // namespace

namespace {

/// The next command: the same maps as a file; after -o their check, or the maps that --asks names.
std::string next_text(const std::optional<unsigned>& level, const char* option, const std::string& file,
                      const AskedOf& asked) {
  if (!level && !asked.written.empty()) return "mmverify check maps " + shell_quoted(asked.written);
  return fmt::format("{}mmverify scene {}{}{}-o {}",
                     asked.written.empty() ? "" : "the file was written without this limit; with it: ",
                     file.empty() ? "" : shell_quoted(file) + " ",
                     level ? fmt::format("{} {} ", option, *level) : asked.levels, asked.options,
                     asked.written.empty() ? "OUT.glb" : shell_quoted(asked.written));
}

}  // namespace

void print_summary(std::FILE* out, const SceneFigures& f, const proofs::Report& report,
                   const std::optional<double>& asks, const std::string& file, const AskedOf& asked) {
  const MaterialFigures all = total(f.materials);
  // Maps whose own level is coarser keep it.
  const char* const option = f.one_level ? "--level" : "--level-limit";
  say(out, "{}\n", printable(f.scene.file));
  summary_line(out, "triangles", triangles_text(f));
  if (const std::uint64_t moving = triangles_that_could_move(f); moving != 0)
    summary_line(
        out, "moving",
        fmt::format("{} triangle{} without maps, whose UVs an animation moves; --moving bakes maps that "
                    "hold wherever it moves them",
                    grouped(moving), moving == 1 ? "" : "s"));
  if (const std::string why = why_unmoved(f); asked.moving && !why.empty()) summary_line(out, "unmoved", why);
  summary_line(out, "any-hit", any_hit_text(f));
  summary_line(out, "memory", memory_text(f));
  if (asks)
    summary_line(out, "asks", asked_text(all, *asks, option));
  else if (f.two_state)
    summary_line(out, "coarser", "not counted: with --states 2 no shader is called");
  else
    summary_line(out, "coarser", coarser_text(all, option));
  summary_line(out, "laws", laws_text(report));
  summary_line(out, "next",
               next_text(asks ? level_for(all, *asks) : std::nullopt, option, file, asked) +
                   "; --picture DIR shows the maps; --details: all figures");
}

void print_materials(std::FILE* out, const SceneFigures& f, const std::optional<double>& asks) {
  std::map<std::size_t, std::pair<unsigned, unsigned>> levels;  // by material, the least and the greatest
  for (const PlannedPrimitive& planned : f.made.plan.primitives)
    for (const TriangleUse& use : planned.triangles) {
      const unsigned level = f.made.baked.triangles[use.triangle].level;
      auto& [least, greatest] =
          levels.try_emplace(*f.scene.primitives[planned.primitive].material, level, level).first->second;
      least = std::min(least, level), greatest = std::max(greatest, level);
    }
  say(out,
      "\nmaterials; asks: share of the placed area that calls the any-hit shader\n  "
      "{:<32}{:>10}{:>10}{:>17}{:>12}{:>10}",
      "", "triangles", "distinct", "levels", "bytes", "asks");
  say(out, "{}\n", asks ? fmt::format("{:>24}", fmt::format("level for {}", percent(*asks))) : "");
  for (const MaterialFigures& m : f.materials) {
    const std::string& name = f.scene.materials[m.material].name;
    const auto [least, greatest] = levels.at(m.material);
    say(out, "  {:<32.32}{:>10}{:>10}{:>17}{:>12}{:>10}", fmt::format("{} {}", m.material, printable(name)),
        grouped(m.triangles), grouped(m.distinct), level_range(least, greatest),
        bytes_text(m.levels.back().bytes), percent(m.levels.back().unknown));
    if (asks) {
      const std::optional<unsigned> level = level_for(m, *asks);
      say(out, "{:>24}",
          level ? fmt::format("{}: {} in {}", *level, percent(m.levels[*level].unknown),
                              bytes_text(m.levels[*level].bytes))
                : "none");
    }
    say(out, "\n");
  }
}

}  // namespace mmverify::cli
