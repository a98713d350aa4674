#include "bench/vq/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bench/timing.hpp"
#include "bench/vq/encoders.hpp"
#include "bench/vq/rivals/tables.hpp"

namespace mmverify::bench {
namespace {

const Print in_per_cent = percents(2);

// ---- Map by map

struct EncodedMap {
  const char* encoder;
  VqEncoded by;
  double savings, times_paper;
};

template <class Encoder>
EncodedMap encoded(const VqRow& row, Encoder e) {
  return {to_string(e), row.by(e), row.savings(e), row.by(e).ms / row.by(Encoder::paper).ms};
}
std::vector<EncodedMap> encoded_vq2(const VqRow& row) {
  std::vector<EncodedMap> all;
  for (const Vq2Encoder e : all_vq2) all.push_back(encoded(row, e));
  return all;
}
std::vector<EncodedMap> encoded_vq4(const VqRow& row) {
  std::vector<EncodedMap> all;
  for (const Vq4Encoder e : all_vq4) all.push_back(encoded(row, e));
  return all;
}

Fields<EncodedMap> encoded_fields() {
  using E = EncodedMap;
  const auto transforms = [](const E& e) -> Value {
    const std::uint32_t t = e.by.transforms;
    return std::vector<std::uint64_t>{t & 7, t >> 3 & 7, t >> 6 & 7};
  };
  return {
      {{one_of("encoder", key,
               {"paper", "paper, highest", "optimal", "paper, C free", "fast", "balanced", "thorough",
                "proved"}),
        "encoder"},
       [](const E& e) { return e.encoder; }},
      {{count("substitutions", less, "regions of O and T that became C"), "substitutions"},
       [](const E& e) { return e.by.substitutions; }},
      {{share("savings", about_more, "the source's less the substitutions")},
       [](const E& e) { return e.savings; }},
      {{whole("transforms", same, {0, 7}, "of TR, BL and BR, by their numbers in table 1").list_of(3)},
       transforms},
      {{.key = time("ms", "ms a map"), .unit = "ms"}, [](const E& e) { return e.by.ms; }},
      {{number("least_ms", left_out, "of the fastest round").if_any()},
       [](const E& e) { return e.by.least_ms; }},
      {{number("most_ms", left_out, "of the slowest round").if_any()},
       [](const E& e) { return e.by.most_ms; }},
      {{ratio("times_paper", speed_less, "ms / that of paper")}, [](const E& e) { return e.times_paper; }},
  };
}

std::string file_name(const VqRow& row) { return std::filesystem::path(row.of).filename().string(); }

Table maps_table(const VqFigures& figures) {
  const std::string vq2 = "VQ2, 16x16: substitutions", vq4 = "VQ4, 32x32: substitutions";
  const auto printed_name = [](const VqRow& row) {
    const std::string name = file_name(row);
    return name.size() > 28 ? name.substr(0, 27) + "~" : name;
  };
  const Fields<VqRow> fields{
      {{text("map", key, "the texture's file name")}, [](const VqRow& r) { return file_name(r); }},
      {{.key = "", .heading = "map", .leads = true}, printed_name},
      {{whole("states_16", same, {0, 256}, "regions of O and T of the 16x16 source"), "O+T", "", plain, vq2},
       [](const VqRow& r) { return r.states_16; }},
      {{whole("states_32", same, {0, 1024}, "regions of O and T of the 32x32 source"), "O+T", "", plain, vq4},
       [](const VqRow& r) { return r.states_32; }},
      {{count("discontinuous_vectors", same, "vectors of either source with O beside T"), "O beside T"},
       [](const VqRow& r) { return r.discontinuous; }},
      note<VqRow>(object("savings", no_rule, "of uncompressed sources: the share of O and T")),
      {{share("savings.64x2", about_more,
              "of two triangles of 64 micro-triangles, 256 bits without a codec")},
       [](const VqRow& r) { return r.savings_64x2; }},
      {{share("savings.8x8", about_more)}, [](const VqRow& r) { return r.savings_8; }},
      {{share("savings.16x16", about_more)}, [](const VqRow& r) { return r.savings_16; }},
      {{share("savings.32x32", about_more)}, [](const VqRow& r) { return r.savings_32; }},
      within<VqRow, EncodedMap>(
          {.key = list("vq2", "", {3, 3}), .heading = "vq2", .group = vq2, .within = RowLayout::beside},
          encoded_fields(), encoded_vq2),
      within<VqRow, EncodedMap>(
          {.key = list("vq4", "", {6, 6}), .heading = "vq4", .group = vq4, .within = RowLayout::beside},
          encoded_fields(), encoded_vq4),
      {{count("vq2_bound", same, "substitutions that no block undercuts")},
       [](const VqRow& r) { return bound_of(r, Vq2Encoder{}); }},
      {{count("vq4_bound", more, "substitutions that no block undercuts"), "bound", "", plain, vq4},
       [](const VqRow& r) { return bound_of(r, Vq4Encoder{}); }},
  };
  return table_of<VqRow>({.key = "rows", .row = "one texture"}, fields, figures.rows);
}

// ---- All maps together

struct EncoderSums {
  const char *codec, *encoder;
  double lost, states, lost_by_paper, bound, savings, median_ms, most_ms, ms, ms_of_paper;
};

template <class Encoder>
EncoderSums sums_of(const std::vector<VqRow>& rows, const char* codec, Encoder e) {
  std::vector<double> each;
  for (const VqRow& row : rows) each.push_back(row.by(e).ms);
  const auto lost = [](Encoder by) { return [by](const VqRow& r) { return r.by(by).substitutions; }; };
  const auto ms = [](Encoder by) { return [by](const VqRow& r) { return r.by(by).ms; }; };
  return {codec,
          to_string(e),
          sum_over(rows, lost(e)),
          sum_over(rows, [e](const VqRow& r) { return states_of(r, e); }),
          sum_over(rows, lost(Encoder::paper)),
          sum_over(rows, [e](const VqRow& r) { return bound_of(r, e); }),
          mean_over(rows, [e](const VqRow& r) { return r.savings(e); }),
          median(each),
          *std::max_element(each.begin(), each.end()),
          sum_over(rows, ms(e)),
          sum_over(rows, ms(Encoder::paper))};
}

Table encoders_table(const std::vector<VqRow>& rows) {
  using S = EncoderSums;
  std::vector<S> sums;
  for (const Vq2Encoder e : all_vq2) sums.push_back(sums_of(rows, "VQ2", e));
  for (const Vq4Encoder e : all_vq4) sums.push_back(sums_of(rows, "VQ4", e));
  const Print whole{.digits = 0}, one{.digits = 1}, three{.digits = 3};
  const std::string of_all = "substitutions", of_a_map = "time a map";
  const Fields<S> fields{
      {{.heading = "codec", .leads = true}, [](const S& s) { return s.codec; }},
      {{.heading = "encoder", .leads = true}, [](const S& s) { return s.encoder; }},
      {{"", "all", "", whole, of_all}, [](const S& s) { return s.lost; }},
      {{"", "of O+T", "%", {}, of_all}, [](const S& s) { return per_cent_of(s.lost, s.states); }},
      {{"", "fewer than paper's", "%", one, of_all},
       [](const S& s) { return per_cent_of(s.lost_by_paper - s.lost, s.lost_by_paper); }},
      {{"", "above bound", "", whole, of_all}, [](const S& s) { return s.lost - s.bound; }},
      {{"", "savings", "", in_per_cent}, [](const S& s) { return s.savings; }},
      {{"", "median", "ms", three, of_a_map}, [](const S& s) { return s.median_ms; }},
      {{"", "most", "ms", three, of_a_map}, [](const S& s) { return s.most_ms; }},
      {{"", "x paper's", "", plain, of_a_map}, [](const S& s) { return s.ms / s.ms_of_paper; }},
  };
  return table_of<S>(
      {.caption = "All maps together, beside the paper's encoder of the same run", .form = Form::printed},
      fields, sums);
}

struct Source {
  const char* name;
  double VqRow::*savings;
};

Table sources_table(const std::vector<VqRow>& rows) {
  const std::vector<Source> sources{{"two of 64 sub-triangles (256 bits)", &VqRow::savings_64x2},
                                    {"8x8 (128 bits)", &VqRow::savings_8},
                                    {"16x16 (512 bits)", &VqRow::savings_16},
                                    {"32x32 (2048 bits)", &VqRow::savings_32}};
  const Fields<Source> fields{
      {{.heading = "source", .leads = true}, [](const Source& s) { return s.name; }},
      {{"", "savings", "", in_per_cent},
       [&](const Source& s) { return mean_over(rows, [&](const VqRow& r) { return r.*s.savings; }); }},
  };
  return table_of<Source>({.caption = "Mean savings without a codec", .form = Form::printed}, fields,
                          sources);
}

// ---- Transforms, decoding

struct Chosen {
  const char *codec, *encoder;
  std::vector<std::pair<std::uint32_t, std::size_t>> counts;
};

template <class Encoder>
Chosen chosen_by(const std::vector<VqRow>& rows, const char* codec, Encoder e) {
  return {codec, to_string(e),
          transform_counts(rows, [e](const VqRow& row) { return row.by(e).transforms; })};
}

/// The most frequent transform of a codec: which = 0 of TR, 1 of BL, 2 of BR.
std::string most_frequent(const Chosen& c, int which) {
  constexpr const char* names[] = {"identity",   "R90",         "reflect TB", "reflect X=-Y",
                                   "reflect LR", "reflect X=Y", "R180",       "R270"};
  return names[c.counts.front().first >> 3 * which & 7];
}

Table transforms_table(const std::vector<VqRow>& rows) {
  std::vector<Chosen> chosen;
  for (const Vq2Encoder e : all_vq2) chosen.push_back(chosen_by(rows, "VQ2", e));
  for (const Vq4Encoder e : {Vq4Encoder::paper, Vq4Encoder::balanced, Vq4Encoder::proved})
    chosen.push_back(chosen_by(rows, "VQ4", e));
  const auto once = [](const Chosen& c) {
    return static_cast<std::uint64_t>(
        std::count_if(c.counts.begin(), c.counts.end(), [](const auto& one) { return one.second == 1; }));
  };
  const std::string most = "the most frequent one";
  const Fields<Chosen> fields{
      {{.heading = "codec", .leads = true}, [](const Chosen& c) { return c.codec; }},
      {{.heading = "encoder", .leads = true}, [](const Chosen& c) { return c.encoder; }},
      {{"", "combinations"}, [](const Chosen& c) { return std::uint64_t{c.counts.size()}; }},
      {{"", "chosen once"}, once},
      {{"", "maps", "", plain, most}, [](const Chosen& c) { return std::uint64_t{c.counts.front().second}; }},
      {{"", "TR", "", plain, most}, [](const Chosen& c) { return most_frequent(c, 0); }},
      {{"", "BL", "", plain, most}, [](const Chosen& c) { return most_frequent(c, 1); }},
      {{"", "BR", "", plain, most}, [](const Chosen& c) { return most_frequent(c, 2); }},
  };
  return table_of<Chosen>(
      {.caption = fmt::format("Transforms: which of the 512 combinations {} maps chose", rows.size()),
       .form = Form::printed},
      fields, chosen);
}

struct Decoding {
  const char* codec;
  VqDecodeTimes times;
};

Table decoding_table(const VqFigures& figures) {
  using D = Decoding;
  const std::string map = "a whole map";
  const Fields<D> fields{
      {{.key = one_of("", no_rule, {"vq2", "vq4"}), .heading = "codec", .leads = true},
       [](const D& d) { return d.codec; }},
      {{time("map_ns", "ns a whole map"), "at once", "ns", digits(0), map},
       [](const D& d) { return d.times.map_ns; }},
      {{time("map_by_regions_ns", "ns a whole map, region after region"), "region by region", "ns", digits(0),
        map},
       [](const D& d) { return d.times.map_by_regions_ns; }},
      {{time("region_ns", "ns one region; independent random ones over all blocks"), "one region", "ns",
        digits(1)},
       [](const D& d) { return d.times.region_ns; }},
      {{ratio("ratio_regions_to_map", speed_more, "map_by_regions_ns / map_ns"), "ratio", "", digits(1), map},
       [](const D& d) { return d.times.map_by_regions_ns / d.times.map_ns; }},
  };
  return table_of<D>({.key = object("decode", no_rule), .caption = "Decoding", .form = Form::object}, fields,
                     {{"vq2", figures.vq2}, {"vq4", figures.vq4}});
}

}  // namespace

Result vq_tables(const VqFigures& figures, const VqBenchOptions& options) {
  const Fields<VqFigures> loose{
      {{count("left_out", same, "textures with no texel of alpha 1/2 or more"),
        "textures left out, with no texel of alpha 1/2 or more"},
       [](const VqFigures& f) { return std::uint64_t{f.left_out}; }},
      {{"", "maps"}, [](const VqFigures& f) { return std::uint64_t{f.rows.size()}; }},
  };
  return {.topic = "vq",
          .description = "mmverify bench vq: what block codecs lose, against what their encoders take",
          .settings = {{seed_of_all(), options.seed},
                       {positive("rounds", setting, "of the timing; a time is their median"),
                        std::uint64_t{options.rounds}},
                       {one_of("maps", setting, {"generated", "textures"}, "textures: those of --textures"),
                        options.textures.empty() ? "generated" : "textures"}},
          .about =
              "Exact coverage at alpha 1/2, one thread. substitutions: O and T that became C. paper: "
              "Algorithms 1 and 2 as printed;\nhighest: vectors with more C first; C free: the all-C "
              "partition takes no entry. bound: no block of VQ4 loses fewer;\nof VQ2, optimal is the bound. "
              "O beside T: vectors of either source. Rivals: docs/VQ.md. shade: mean over the maps "
              "of\n|share of hits read as opaque - share that is|",
          .tables = {table_of<VqFigures>({.form = Form::members}, loose, {figures}), decoding_table(figures),
                     maps_table(figures), encoders_table(figures.rows), sources_table(figures.rows),
                     transforms_table(figures.rows), rivals::codecs_table(figures.rivals),
                     rivals::readings_table(figures.rivals)},
          .drawn = vq_picture(figures)};
}

}  // namespace mmverify::bench
