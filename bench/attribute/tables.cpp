#include "bench/attribute/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {
namespace {

Value or_none(const std::optional<double>& x) { return x ? Value(*x) : Value(); }

// ---- Lookups

Fields<AttributeOrderTimes> order_fields() {
  using O = AttributeOrderTimes;
  const std::string index = "index of a vertex", triplet = "(u, v) to three indices",
                    value = "(u, v) to a value of RGBA8";
  return {
      {{.key =
            one_of("order", key,
                   {"W-minor", "W-minor, batched", "U-major", "U-major, batched", "Bird", "Bird, batched"}),
        .heading = "order",
        .leads = true},
       [](const O& o) { return o.order; }},
      {{time("index_ns", "ns from a vertex to its index"), "from it", "ns", plain, index},
       [](const O& o) { return o.index_ns; }},
      {{time("vertex_ns", "ns from an index to its vertex"), "and back", "ns", plain, index},
       [](const O& o) { return o.vertex_ns; }},
      {{time("triplet_ns", "ns from (u, v) to three indices"), "ours", "ns", plain, triplet},
       [](const O& o) { return o.triplet_ns; }},
      {{ratio("figure_4_to_ours", speed_more, "of triplets: the median of the rounds' ratios"),
        "figure 4 / ours", "", plain, triplet},
       [](const O& o) { return o.figure_4_to_ours; }},
      {{time("lookup_ns", "ns from (u, v) to a value of RGBA8").if_any(), "ours", "ns", plain, value},
       [](const O& o) { return or_none(o.lookup_ns); }},
      {{ratio("lookup_to_bilinear", speed_less,
              "of lookup_ns to a bilinear sample of the same run, one by one or batched as this is: the "
              "median of the rounds' ratios")
            .if_any(),
        "/ bilinear", "", plain, value},
       [](const O& o) { return or_none(o.lookup_to_bilinear); }},
  };
}

Table lookups_table(const AttributeFigures& figures) {
  using L = AttributeLookupLevel;
  const std::string bilinear = "bilinear";
  const Fields<L> fields{
      {{.key = level(16), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{time("figure_4_ns", "ns from (u, v) to three indices, figure 4 of the paper in binary32"), "figure 4",
        "ns"},
       [](const L& l) { return l.figure_4_ns; }},
      {{time("bilinear_ns", "ns a bilinear sample of RGBA8, one by one").if_any(), "one by one", "ns", plain,
        bilinear},
       [](const L& l) { return or_none(l.bilinear_ns); }},
      {{time("bilinear_simd_ns", "ns a bilinear sample of RGBA8, batched").if_any(), "batched", "ns", plain,
        bilinear},
       [](const L& l) { return or_none(l.bilinear_simd_ns); }},
      within<L, AttributeOrderTimes>({.key = list("orders", "", {6, 6}),
                                      .heading = "orders",
                                      .row = "an order of vertices; above level 12 there is no map"},
                                     order_fields(), [](const L& l) { return l.orders; }),
  };
  return table_of<L>(
      {.key = "rows", .row = "one level", .caption = "Vertices of a map, and values between them"}, fields,
      figures.lookups);
}

// ---- Remaps

struct RemapOf {
  Remap remap;
  std::uint64_t samples;
  RemapFigure figure;
};

Fields<RemapOf> remap_fields() {
  using R = RemapOf;
  constexpr double ulp = 0x1p24;  // of numbers from 1/2 to 1
  return {
      {{.key =
            one_of("remap", key, {"3x3 by Cramer", "two equations", "pattern", "ours, locates too, batched"}),
        .heading = "remap",
        .leads = true},
       [](const R& r) { return to_string(r.remap); }},
      {{time("ns", "ns a point, its micro-triangle known; ours finds that, too"), "a point", "ns"},
       [](const R& r) { return r.figure.ns; }},
      {{number("least_ns", left_out, "of the fastest round").if_any()},
       [](const R& r) { return r.figure.least_ns; }},
      {{number("most_ns", left_out, "of the slowest round").if_any()},
       [](const R& r) { return r.figure.most_ns; }},
      {{number("worst", about_less, "greatest error of a weight, in heights of the micro-triangle"),
        "worst",
        "heights",
        {.digits = 1, .type = 'e'}},
       [](const R& r) { return r.figure.worst; }},
      {{"", "worst", "2^-24", digits(2)}, [](const R& r) { return r.figure.worst * ulp; }},
      {{number("worst_ulp", about_less, "the same in ulps of the right weight, of weights of 2^-12 and more"),
        "worst", "ulp", digits(0)},
       [](const R& r) { return r.figure.worst_ulp; }},
      {{real("condition", about_less, {1},
             "of the system that the way solves, in the 1-norm, of the worst micro-triangle")
            .if_any(),
        "condition", "", digits(0)},
       [](const R& r) { return or_none(r.figure.condition); }},
      {{count("no_number", less, "points with a weight that is no number"), "no number"},
       [](const R& r) { return r.figure.no_number; }},
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
      {{.key = level(16), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{count("samples", same, "points, half of them near grid lines"), "points"},
       [](const L& l) { return l.samples; }},
      within<L, RemapOf>({.key = list("ways", "", {4, 4}), .heading = "ways"}, remap_fields(), remaps_of),
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
      {{.key = one_of("remap", left_out,
                      {"3x3 by Cramer", "two equations", "pattern", "ours, locates too, batched"}),
        .heading = "remap",
        .leads = true},
       [](const GrowthOf& g) { return to_string(g.remap); }},
      {{text("law", left_out, "of the worst error from level to level, in words"),
        "worst error from level to level"},
       [](const GrowthOf& g) { return to_string(g.growth); }},
  };
  return table_of<GrowthOf>({.key = list("growth", "", {4, 4}), .caption = "Growth"}, fields, all);
}

// ---- Bakes

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
      {{.key = one_of("way", key,
                      {"faces, ours", "faces, clipped in binary64", "faces, centres inside", "vertices, ours",
                       "vertices, binary32"}),
        .heading = "way",
        .leads = true},
       [](const B& b) { return to_string(b.way); }},
      {{time("ns", "ns a value"), "a value", "ns"}, [](const B& b) { return b.figure.ns; }},
      {{"", "a second", "million", digits(1)}, [](const B& b) { return 1e3 / b.figure.ns; }},
      {{ratio("times_ours", speed_more, "ns / that of ours, of faces or of vertices"), "x ours"},
       [](const B& b) { return b.figure.ns / b.ns_of_ours; }},
      {{count("values", same, "compared with ours")}, [](const B& b) { return b.values; }},
      {{count("wrong", less, "values with a code that is not the exact one")},
       [](const B& b) { return b.figure.wrong; }},
      {{"", "wrong", "%", digits(3)},
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
      {{.key = level(8), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{.key = one_of("meaning", key, {"linear", "sRGB"}), .heading = "codes", .leads = true},
       [](const L& l) { return l.srgb ? "sRGB" : "linear"; }},
      {{share("exact", less, "of our values, those that took whole numbers"), "in whole numbers", "",
        percents(4)},
       [](const L& l) { return l.exact; }},
      within<L, BakeOf>({.key = list("ways", "", {5, 5}), .heading = "ways"}, bake_fields(), bakes_of),
  };
  return table_of<L>({.key = "bakes",
                      .caption = "Maps of a texture of 2048 x 2048 texels, by triangles of about 4,000 "
                                 "texels; wrong: a code that is not the exact one"},
                     fields, figures.bakes);
}

// ---- Mips, levels of detail

Table mips_table(const AttributeFigures& figures) {
  using L = MipLevel;
  const Fields<MipTime> ways{
      {{.key = text("way", key), .heading = "way", .leads = true}, [](const MipTime& m) { return m.way; }},
      {{time("ns", "ns a value of the base"), "a value of the base", "ns", digits(3)},
       [](const MipTime& m) { return m.ns; }},
      {{ratio("plain_to_this", speed_more,
              "a mip in plain bytes of the same run / this: the median of the rounds' ratios"),
        "plain mip / this"},
       [](const MipTime& m) { return m.ratio_to_obvious; }},
  };
  const Fields<L> fields{
      {{.key = whole("level", key, {1, 12}), .heading = "level", .leads = true},
       [](const L& l) { return l.level; }},
      within<L, MipTime>({.key = "ways", .heading = "ways"}, ways, [](const L& l) { return l.ways; }),
  };
  return table_of<L>({.key = list("mips", "of bases up to level 10", {0}),
                      .caption = "Mips; those of vertices in the Bird order take no time"},
                     fields, figures.mips);
}

Table lods_table(const AttributeFigures& figures) {
  using F = LodFigure;
  const Fields<F> fields{
      {{.key = text("way", key), .heading = "way", .leads = true}, [](const F& f) { return f.way; }},
      {{time("ns", "ns a pair of areas"), "a pair of areas", "ns"}, [](const F& f) { return f.ns; }},
      {{count("samples", same, "pairs of areas at a change of level, or a step of binary32 or two beside it"),
        "near a change"},
       [](const F& f) { return f.samples; }},
      {{count("wrong", less, "of these"), "wrong"}, [](const F& f) { return f.wrong; }},
  };
  return table_of<F>({.key = "lods", .caption = "Levels of detail"}, fields, figures.lods);
}

}  // namespace

Result attribute_tables(const AttributeFigures& figures, const AttributeBenchOptions& options) {
  return {
      .topic = "attribute",
      .description =
          "mmverify bench attribute: what attribute micromaps take and lose, beside the obvious ways",
      .settings =
          {{count("seed", setting, "of the points, maps and textures that are generated"), options.seed},
           {positive("samples", setting, "points a level that judge remaps; pairs of areas"),
            options.samples},
           {positive("rounds", setting, "of the timing, those of bakes are fewer; a time is their median"),
            std::uint64_t{options.rounds}},
           {positive("triangles", setting, "that are baked, at most"), std::uint64_t{options.triangles}}},
      .about =
          "One thread; uniform points, 16,384 at a time. bilinear: a texture of 2^level texels a side, in "
          "software; one by one beside\none by one, batched beside batched. Half the points that judge "
          "remaps lie near grid lines. A sample is checked, never proved",
      .tables = {lookups_table(figures), remaps_table(figures), growth_table(figures), bakes_table(figures),
                 mips_table(figures), lods_table(figures)},
      .drawn = attribute_picture(figures)};
}

}  // namespace mmverify::bench
