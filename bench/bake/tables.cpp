#include "bench/bake/tables.hpp"

namespace mmverify::bench {
namespace {

constexpr Baker all_bakers[] = {Baker::centre,     Baker::corners, Baker::sixteen_samples,
                                Baker::rasterised, Baker::ours,    Baker::rational};

const Print shares = percents(3);
const Print a_million{.digits = 1, .unit = "a million"};

struct BakerOf {
  Baker baker;
  BakeFigure figure;
  double ns_of_ours;
};

std::vector<BakerOf> bakers_of(const BakeLevel& level) {
  std::vector<BakerOf> all;
  for (const Baker b : all_bakers) all.push_back({b, level.of(b), level.of(Baker::ours).ns});
  return all;
}

Fields<BakerOf> baker_fields() {
  using B = BakerOf;
  return {
      {{.key = one_of(
            "baker", key,
            {"centre sample", "corner samples", "16 samples", "binary64", "ours, exact", "exact rational"}),
        .heading = "baker",
        .leads = true},
       [](const B& b) { return to_string(b.baker); }},
      {{count("states", same, "micro-triangles baked: all, of exact rational a sample"), "states"},
       [](const B& b) { return b.figure.micro_triangles; }},
      {{count("wrong", less, "O or T, and not so on all of it")}, [](const B& b) { return b.figure.wrong; }},
      {{count("needless", less, "unknown, and O or T on all of it")},
       [](const B& b) { return b.figure.needless; }},
      {{real("wrong_per_million", left_out, {0, 1000000}), "wrong", "", a_million},
       [](const B& b) { return b.figure.wrong_per_million(); }},
      {{real("needless_per_million", left_out, {0, 1000000}), "needless", "", a_million},
       [](const B& b) { return b.figure.needless_per_million(); }},
      {{time("ns", "ns a micro-triangle, textures ready"), "a state", "ns"},
       [](const B& b) { return b.figure.ns; }},
      {{number("least_ns", left_out, "of the fastest round").if_any()},
       [](const B& b) { return b.figure.least_ns; }},
      {{number("most_ns", left_out, "of the slowest round").if_any()},
       [](const B& b) { return b.figure.most_ns; }},
      {{ratio("times_ours", speed_more, "ns / that of ours"), "x ours"},
       [](const B& b) { return b.figure.ns / b.ns_of_ours; }},
  };
}

Table levels_table(const BakeFigures& figures) {
  using L = BakeLevel;
  const Fields<L> fields{
      {{.key = level(12), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{share("unknown", less, "of the exact states"), "unknown", "", shares},
       [](const L& l) { return l.unknown; }},
      {{share("exact", less, "of our leaves, those that took whole numbers"), "in whole numbers", "", shares},
       [](const L& l) { return l.exact; }},
      {{time("whole_ns",
             "ns a micro-triangle by the specification in whole numbers, of those that exact "
             "rational judges"),
        "by whole numbers", "ns"},
       [](const L& l) { return l.whole_ns; }},
      {{ratio("times_rational", speed_more, "ns of exact rational / whole_ns"), "rational / whole"},
       [](const L& l) { return l.rational_over_whole(); }},
      within<L, BakerOf>({.key = list("bakers", "", {6, 6}), .heading = "bakers"}, baker_fields(), bakers_of),
  };
  return table_of<L>({.key = "rows", .row = "one level"}, fields, figures.levels);
}

Table sizes_table(const BakeFigures& figures) {
  using S = BakeSize;
  const Fields<S> fields{
      {{.key = positive("texels", key, "the side of the texture"), .heading = "texels", .leads = true},
       [](const S& s) { return static_cast<std::uint64_t>(s.size); }},
      {{time("ns", "ns a micro-triangle, ours"), "ours", "ns"}, [](const S& s) { return s.ns; }},
      {{time("binary64_ns", "ns a micro-triangle, binary64"), "binary64", "ns"},
       [](const S& s) { return s.ns_rasterised; }},
      {{"", "ratio", "", digits(1)}, [](const S& s) { return s.ns_rasterised / s.ns; }},
      {{time("ready_ms", "ms to make a texture ready"), "made ready in", "ms"},
       [](const S& s) { return s.ready_ms; }},
  };
  return table_of<S>(
      {.key = list("sizes", "level 6, generated textures"), .caption = "Textures by size, level 6"}, fields,
      figures.sizes);
}

Table margins_table(const BakeFigures& figures) {
  using M = BakeMargin;
  const double without = figures.margins.empty() ? 0 : figures.margins.front().unknown;
  const Fields<M> fields{
      {{.key = number("texels", key, "the margin"), .heading = "texels", .print = digits(5), .leads = true},
       [](const M& m) { return m.texels; }},
      {{share("unknown", less, "of the states"), "unknown", "", shares},
       [](const M& m) { return m.unknown; }},
      {{"", "x no margin", "", digits(4)},
       [without](const M& m) { return without > 0 ? m.unknown / without : 0; }},
      {{time("ns", "ns a micro-triangle, ours"), "ours", "ns"}, [](const M& m) { return m.ns; }},
  };
  return table_of<M>({.key = list("margins", "level 6"),
                      .caption = "Margins, level 6; 1/512 is half a step of a filter's 8-bit weights"},
                     fields, figures.margins);
}

Table updates_table(const BakeFigures& figures) {
  using U = BakeUpdate;
  const Fields<U> fields{
      {{.key = positive("texels", key, "the side of the changed square"), .heading = "texels", .leads = true},
       [](const U& u) { return std::uint64_t{u.texels}; }},
      {{share("baked_again", same, "of the micro-triangles"), "baked again", "", shares},
       [](const U& u) { return u.baked_again; }},
      {{time("ns", "ns a map, brought up to date"), "updated in", "ns"}, [](const U& u) { return u.ns; }},
      {{time("whole_ns", "ns a map, baked afresh"), "afresh in", "ns"},
       [](const U& u) { return u.ns_whole; }},
      {{ratio("times_faster", speed_more, "whole_ns / ns"), "x faster"},
       [](const U& u) { return u.ns_whole / u.ns; }},
  };
  return table_of<U>(
      {.key = list("updates", "level 8"),
       .caption = "A map of level 8 after a square of texels changed; each is the one that a whole "
                  "bake gives, bit for bit"},
      fields, figures.updates);
}

}  // namespace

Result bake_tables(const BakeFigures& figures, const BakeBenchOptions& options) {
  const Fields<BakeFigures> loose{
      {{positive("textures", setting, "how many, both halves of each"), "textures, both halves of each"},
       [](const BakeFigures& f) { return std::uint64_t{f.textures.size()}; }},
      {{count("compared", same,
              "states of ours that were compared with the specification's; all were the same"),
        "states of ours compared with the specification's, all the same"},
       [](const BakeFigures& f) { return f.compared; }},
  };
  return {.topic = "bake",
          .description = "mmverify bench bake: what bakers get wrong, against what they take",
          .settings = {{seed_of_all(), options.seed},
                       {positive("rounds", setting, "of the timing; a time is their median"),
                        std::uint64_t{options.rounds}},
                       {one_of("maps", setting, {"generated", "textures"}, "textures: those of --textures"),
                        options.textures.empty() ? "generated" : "textures"}},
          .about =
              "Textures are repeated, bilinear, cutoff 1/2; one thread. wrong: O or T, and not so on all of "
              "it; needless: unknown, and O or T\non all of it. Judged by ours, of which some are compared "
              "with the specification's, half of them unknown where there are as many.\nunknown: share of "
              "the exact states; in whole numbers: share of our leaves that took them\nby whole numbers: the "
              "specification's time of a state in them; rational / whole: that of exact rational over it",
          .tables = {table_of<BakeFigures>({.form = Form::members}, loose, {figures}), levels_table(figures),
                     sizes_table(figures), margins_table(figures), updates_table(figures)},
          .drawn = bake_picture(figures)};
}

}  // namespace mmverify::bench
