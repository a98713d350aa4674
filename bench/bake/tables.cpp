#include "bench/bake/tables.hpp"

namespace mmverify::bench {
namespace {

constexpr Baker all_bakers[] = {Baker::centre,     Baker::corners, Baker::sixteen_samples,
                                Baker::rasterised, Baker::ours,    Baker::rational};

const Print share{.digits = 3, .factor = per_cent, .unit = "%"};
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
      {{.key = "baker", .heading = "baker", .leads = true}, [](const B& b) { return to_string(b.baker); }},
      {{"states", "states"}, [](const B& b) { return b.figure.micro_triangles; }},
      {{"wrong"}, [](const B& b) { return b.figure.wrong; }},
      {{"needless"}, [](const B& b) { return b.figure.needless; }},
      {{"wrong_per_million", "wrong", "", a_million},
       [](const B& b) { return b.figure.wrong_per_million(); }},
      {{"needless_per_million", "needless", "", a_million},
       [](const B& b) { return b.figure.needless_per_million(); }},
      {{"ns", "a state", "ns"}, [](const B& b) { return b.figure.ns; }},
      {{"times_ours", "x ours"}, [](const B& b) { return b.figure.ns / b.ns_of_ours; }},
  };
}

Table levels_table(const BakeFigures& figures) {
  using L = BakeLevel;
  const Fields<L> fields{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{"unknown", "unknown", "", share}, [](const L& l) { return l.unknown; }},
      {{"exact", "in whole numbers", "", share}, [](const L& l) { return l.exact; }},
      within<L, BakerOf>({.key = "bakers", .heading = "bakers"}, baker_fields(), bakers_of),
  };
  return table_of<L>({.key = "rows"}, fields, figures.levels);
}

Table sizes_table(const BakeFigures& figures) {
  using S = BakeSize;
  const Fields<S> fields{
      {{.key = "texels", .heading = "texels", .leads = true},
       [](const S& s) { return static_cast<std::uint64_t>(s.size); }},
      {{"ns", "ours", "ns"}, [](const S& s) { return s.ns; }},
      {{"binary64_ns", "binary64", "ns"}, [](const S& s) { return s.ns_rasterised; }},
      {{"", "ratio", "", {.digits = 1}}, [](const S& s) { return s.ns_rasterised / s.ns; }},
      {{"ready_ms", "made ready in", "ms"}, [](const S& s) { return s.ready_ms; }},
  };
  return table_of<S>({.key = "sizes", .caption = "Textures by size, level 6"}, fields, figures.sizes);
}

Table margins_table(const BakeFigures& figures) {
  using M = BakeMargin;
  const double without = figures.margins.empty() ? 0 : figures.margins.front().unknown;
  const Fields<M> fields{
      {{.key = "texels", .heading = "texels", .print = {.digits = 5}, .leads = true},
       [](const M& m) { return m.texels; }},
      {{"unknown", "unknown", "", share}, [](const M& m) { return m.unknown; }},
      {{"", "x no margin", "", {.digits = 4}},
       [without](const M& m) { return without > 0 ? m.unknown / without : 0; }},
      {{"ns", "ours", "ns"}, [](const M& m) { return m.ns; }},
  };
  return table_of<M>(
      {.key = "margins", .caption = "Margins, level 6; 1/512 is half a step of a filter's 8-bit weights"},
      fields, figures.margins);
}

}  // namespace

Result bake_tables(const BakeFigures& figures, const BakeBenchOptions& options) {
  const Fields<BakeFigures> loose{
      {{"textures", "textures, both halves of each"},
       [](const BakeFigures& f) { return std::uint64_t{f.textures.size()}; }},
      {{"compared", "states of ours compared with the specification's, all the same"},
       [](const BakeFigures& f) { return f.compared; }},
  };
  return {.topic = "bake",
          .settings = {{"seed", options.seed},
                       {"rounds", std::uint64_t{options.rounds}},
                       {"maps", options.textures.empty() ? "generated" : "textures"}},
          .about =
              "Textures are repeated, bilinear, cutoff 1/2; one thread. wrong: O or T, and not so on all of "
              "it; needless: unknown, and O or T\non all of it. Judged by ours, of which some are compared "
              "with the specification's, half of them unknown where there are as many.\nunknown: share of "
              "the exact states; in whole numbers: share of our leaves that took them",
          .tables = {table_of<BakeFigures>({.form = Form::members}, loose, {figures}), levels_table(figures),
                     sizes_table(figures), margins_table(figures)},
          .drawn = bake_picture(figures)};
}

}  // namespace mmverify::bench
