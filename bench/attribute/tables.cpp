#include "bench/attribute/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {
namespace {

Value or_none(const std::optional<double>& x) { return x ? Value(*x) : Value(); }

// ---------------------------------------------------------------------------------------------------------------------
// Lookups
// ---------------------------------------------------------------------------------------------------------------------

Fields<AttributeOrderTimes> order_fields() {
  using O = AttributeOrderTimes;
  const std::string index = "index of a vertex", triplet = "(u, v) to three indices",
                    value = "(u, v) to a value of RGBA8";
  return {
      {{.key = "order", .heading = "order", .leads = true}, [](const O& o) { return o.order; }},
      {{"index_ns", "from it", "ns", {}, index}, [](const O& o) { return o.index_ns; }},
      {{"vertex_ns", "and back", "ns", {}, index}, [](const O& o) { return o.vertex_ns; }},
      {{"triplet_ns", "ours", "ns", {}, triplet}, [](const O& o) { return o.triplet_ns; }},
      {{"figure_4_to_ours", "figure 4 / ours", "", {}, triplet},
       [](const O& o) { return o.figure_4_to_ours; }},
      {{"lookup_ns", "ours", "ns", {}, value}, [](const O& o) { return or_none(o.lookup_ns); }},
      {{"lookup_to_bilinear", "/ bilinear", "", {}, value},
       [](const O& o) { return or_none(o.lookup_to_bilinear); }},
  };
}

Table lookups_table(const AttributeFigures& figures) {
  using L = AttributeLookupLevel;
  const std::string bilinear = "bilinear";
  const Fields<L> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{"figure_4_ns", "figure 4", "ns"}, [](const L& l) { return l.figure_4_ns; }},
      {{"bilinear_ns", "one by one", "ns", {}, bilinear}, [](const L& l) { return or_none(l.bilinear_ns); }},
      {{"bilinear_simd_ns", "batched", "ns", {}, bilinear},
       [](const L& l) { return or_none(l.bilinear_simd_ns); }},
      within<L, AttributeOrderTimes>({.key = "orders", .heading = "orders"}, order_fields(),
                                     [](const L& l) { return l.orders; }),
  };
  return table_of<L>({.key = "rows", .caption = "Vertices of a map, and values between them"}, fields,
                     figures.lookups);
}

// ---------------------------------------------------------------------------------------------------------------------
// Remaps
// ---------------------------------------------------------------------------------------------------------------------

struct RemapOf {
  Remap remap;
  std::uint64_t samples;
  RemapFigure figure;
};

Fields<RemapOf> remap_fields() {
  using R = RemapOf;
  constexpr double ulp = 0x1p24;  // of numbers from 1/2 to 1
  return {
      {{.key = "remap", .heading = "remap", .leads = true}, [](const R& r) { return to_string(r.remap); }},
      {{"ns", "a point", "ns"}, [](const R& r) { return r.figure.ns; }},
      {{"worst", "worst", "heights", {.digits = 1, .type = 'e'}}, [](const R& r) { return r.figure.worst; }},
      {{"", "worst", "2^-24", {.digits = 2}}, [](const R& r) { return r.figure.worst * ulp; }},
      {{"worst_ulp", "worst", "ulp", {.digits = 0}}, [](const R& r) { return r.figure.worst_ulp; }},
      {{"condition", "condition", "", {.digits = 0}}, [](const R& r) { return or_none(r.figure.condition); }},
      {{"no_number", "no number"}, [](const R& r) { return r.figure.no_number; }},
  };
}

Table remaps_table(const AttributeFigures& figures) {
  using L = RemapLevel;
  const auto remaps_of = [](const L& l) {
    std::vector<RemapOf> all;
    for (const Remap r : all_remaps) all.push_back({r, l.samples, l.of(r)});
    return all;
  };
  const Fields<L> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{"samples", "points"}, [](const L& l) { return l.samples; }},
      within<L, RemapOf>({.key = "ways", .heading = "ways"}, remap_fields(), remaps_of),
  };
  return table_of<L>({.key = "remaps",
                      .caption = "Barycentrics on the micro-triangle, in binary32, beside exact ones; an "
                                 "error in heights of the micro-triangle,\nin ulps of weights of 2^-12 and "
                                 "more; condition: of the system that a way solves"},
                     fields, figures.remaps);
}

struct GrowthOf {
  Remap remap;
  Growth growth;
};

Table growth_table(const AttributeFigures& figures) {
  std::vector<GrowthOf> all;
  for (const Remap r : all_remaps) all.push_back({r, figures.growth[static_cast<std::size_t>(r)]});
  const Fields<GrowthOf> fields{
      {{.key = "remap", .heading = "remap", .leads = true},
       [](const GrowthOf& g) { return to_string(g.remap); }},
      {{"law", "worst error from level to level"}, [](const GrowthOf& g) { return to_string(g.growth); }},
  };
  return table_of<GrowthOf>({.key = "growth", .caption = "Growth"}, fields, all);
}

// ---------------------------------------------------------------------------------------------------------------------
// Bakes
// ---------------------------------------------------------------------------------------------------------------------

constexpr AttributeBakeWay all_ways[] = {AttributeBakeWay::faces, AttributeBakeWay::clipped,
                                         AttributeBakeWay::centres, AttributeBakeWay::vertices,
                                         AttributeBakeWay::binary32};

struct BakeOf {
  AttributeBakeWay way;
  AttributeWay figure;
  std::uint64_t values;  ///< that were compared
  double ns_of_ours;

  bool of_faces() const { return way < AttributeBakeWay::vertices; }
};

std::vector<BakeOf> bakes_of(const AttributeBakeLevel& l) {
  std::vector<BakeOf> all;
  for (const AttributeBakeWay w : all_ways) {
    BakeOf of{w, l.of(w), l.face_values, l.of(AttributeBakeWay::faces).ns};
    if (!of.of_faces()) {
      of.values = l.vertex_values;
      of.ns_of_ours = l.of(AttributeBakeWay::vertices).ns;
    }
    all.push_back(of);
  }
  return all;
}

Fields<BakeOf> bake_fields() {
  using B = BakeOf;
  return {
      {{.key = "way", .heading = "way", .leads = true}, [](const B& b) { return to_string(b.way); }},
      {{"ns", "a value", "ns"}, [](const B& b) { return b.figure.ns; }},
      {{"", "a second", "million", {.digits = 1}}, [](const B& b) { return 1e3 / b.figure.ns; }},
      {{"times_ours", "x ours"}, [](const B& b) { return b.figure.ns / b.ns_of_ours; }},
      {{"values"}, [](const B& b) { return b.values; }},
      {{"wrong"}, [](const B& b) { return b.figure.wrong; }},
      {{"", "wrong", "%", {.digits = 3}},
       [](const B& b) {
         return b.values == 0
                    ? 0
                    : per_cent * static_cast<double>(b.figure.wrong) / static_cast<double>(b.values);
       }},
  };
}

Table bakes_table(const AttributeFigures& figures) {
  using L = AttributeBakeLevel;
  const Fields<L> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{.key = "meaning", .heading = "codes", .leads = true},
       [](const L& l) { return l.srgb ? "sRGB" : "linear"; }},
      {{"exact", "in whole numbers", "", {.digits = 4, .factor = per_cent, .unit = "%"}},
       [](const L& l) { return l.exact; }},
      within<L, BakeOf>({.key = "ways", .heading = "ways"}, bake_fields(), bakes_of),
  };
  return table_of<L>({.key = "bakes",
                      .caption = "Maps of a texture of 2048 x 2048 texels, by triangles of about 4,000 "
                                 "texels; wrong: a code that is not the exact one"},
                     fields, figures.bakes);
}

// ---------------------------------------------------------------------------------------------------------------------
// Mips, levels of detail
// ---------------------------------------------------------------------------------------------------------------------

Table mips_table(const AttributeFigures& figures) {
  using L = MipLevel;
  const Fields<MipTime> ways{
      {{.key = "way", .heading = "way", .leads = true}, [](const MipTime& m) { return m.way; }},
      {{"ns", "a value of the base", "ns", {.digits = 3}}, [](const MipTime& m) { return m.ns; }},
      {{"plain_to_this", "plain mip / this"}, [](const MipTime& m) { return m.ratio_to_obvious; }},
  };
  const Fields<L> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      within<L, MipTime>({.key = "ways", .heading = "ways"}, ways, [](const L& l) { return l.ways; }),
  };
  return table_of<L>({.key = "mips", .caption = "Mips; those of vertices in the Bird order take no time"},
                     fields, figures.mips);
}

Table lods_table(const AttributeFigures& figures) {
  using F = LodFigure;
  const Fields<F> fields{
      {{.key = "way", .heading = "way", .leads = true}, [](const F& f) { return f.way; }},
      {{"ns", "a pair of areas", "ns"}, [](const F& f) { return f.ns; }},
      {{"samples", "near a change"}, [](const F& f) { return f.samples; }},
      {{"wrong", "wrong"}, [](const F& f) { return f.wrong; }},
  };
  return table_of<F>({.key = "lods", .caption = "Levels of detail"}, fields, figures.lods);
}

}  // namespace

Result attribute_tables(const AttributeFigures& figures, const AttributeBenchOptions& options) {
  return {.topic = "attribute",
          .settings = {{"seed", options.seed},
                       {"samples", options.samples},
                       {"rounds", std::uint64_t{options.rounds}},
                       {"triangles", std::uint64_t{options.triangles}}},
          .about =
              "One thread; uniform points, 16,384 at a time. bilinear: a texture of 2^level texels a side, "
              "in software; one by one beside\none by one, batched beside batched. Half the points that "
              "judge remaps lie near grid lines. A sample is checked, never proved",
          .tables = {lookups_table(figures), remaps_table(figures), growth_table(figures),
                     bakes_table(figures), mips_table(figures), lods_table(figures)},
          .drawn = attribute_picture(figures)};
}

}  // namespace mmverify::bench
