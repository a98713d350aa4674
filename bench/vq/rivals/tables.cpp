#include "bench/vq/rivals/tables.hpp"

#include <algorithm>

namespace mmverify::bench::rivals {
namespace {

std::string regions(std::uint32_t side) { return std::to_string(side) + "x" + std::to_string(side); }

/// A codec, and VQ on the same maps.
struct BesideVq {
  CodecFigures by, vq;

  /// The number of maps of which the codec loses fewer regions than VQ.
  std::uint64_t fewer() const {
    std::uint64_t maps = 0;
    for (std::size_t k = 0; k < by.lost.size(); ++k) maps += by.lost[k] < vq.lost[k] ? 1 : 0;
    return maps;
  }
};

}  // namespace

Table codecs_table(const Figures& figures) {
  std::vector<BesideVq> rows;
  for (const CodecFigures& by : figures.codecs)
    rows.push_back({by, *std::find_if(figures.codecs.begin(), figures.codecs.end(),
                                      [&](const CodecFigures& f) { return f.side == by.side; })});
  using R = BesideVq;
  const Print one{.digits = 1}, two{.digits = 2}, three{.digits = 3}, in_per_cent = percents(2);
  const std::string of_all = "substitutions", of_maps = "maps with", encoding = "encoding a map",
                    decoding = "decoding", to_vq = "x VQ's";
  const Fields<R> fields{
      {{.key = one_of("regions", key, {"16x16", "32x32"}), .heading = "regions", .leads = true},
       [](const R& r) { return regions(r.by.side); }},
      {{.key = text("codec", key, "of VQ the first of each size"), .heading = "codec", .leads = true},
       [](const R& r) { return r.by.codec; }},
      {{count("bits", same, "of a block"), "bits"}, [](const R& r) { return r.by.bits; }},
      {{count("substitutions", less, "regions of O and T that became C"), "all", "", plain, of_all},
       [](const R& r) { return r.by.substitutions; }},
      {{share("lost_share", about_less, "substitutions / regions of O and T"), "of O+T", "", in_per_cent,
        of_all},
       [](const R& r) {
         const auto states = static_cast<double>(r.by.states);
         return states > 0 ? static_cast<double>(r.by.substitutions) / states : 0;
       }},
      {{share("savings", about_more, "mean share of regions that stay O or T"), "savings", "", in_per_cent},
       [](const R& r) { return r.by.savings; }},
      {{count("whole", more, "maps that lost nothing"), "no loss", "", plain, of_maps},
       [](const R& r) { return r.by.whole; }},
      {{count("fewer_than_vq", same, "maps of which it loses fewer regions than VQ"), "less than VQ's", "",
        plain, of_maps},
       [](const R& r) { return r.fewer(); }},
      {{number("lossless_bits", about_less,
               "mean bits that a map takes where nothing is lost; none: not known")
            .if_any(),
        "bits for no loss", "", digits(0)},
       [](const R& r) -> Value {
         if (r.by.lossless_bits) return *r.by.lossless_bits;
         return {};
       }},
      {{time("encode_ms", "ms a map, the median of the maps"), "median", "ms", three, encoding},
       [](const R& r) { return r.by.encode_ms; }},
      {{ratio("encode_to_vq", left_out, "encode_ms / VQ's"), to_vq, "", two, encoding},
       [](const R& r) { return r.by.encode_ms / r.vq.encode_ms; }},
      {{time("map_ns", "ns a whole map"), "a map", "ns", digits(0), decoding},
       [](const R& r) { return r.by.map_ns; }},
      {{time("region_ns", "ns one region; independent random ones over all blocks"), "a region", "ns", one,
        decoding},
       [](const R& r) { return r.by.region_ns; }},
      {{ratio("region_to_vq", left_out, "region_ns / VQ's"), to_vq, "", two, decoding},
       [](const R& r) { return r.by.region_ns / r.vq.region_ns; }},
  };
  return table_of<R>({.key = list("rivals", "VQ beside other codecs in the same bits, on all maps"),
                      .row = "one codec on all maps of 16x16 regions, or 32x32",
                      .caption = "VQ beside its rivals, in the same bits"},
                     fields, rows);
}

Table readings_table(const Figures& figures) {
  using M = ReadMaps;
  using F = ReadingFigures;
  const Print in_per_cent = percents(2);
  const Fields<F> by{
      {{one_of("reading", key, {"C is T", "C is O", "nearer", "even hash", "vector's hash"},
               "what C is read as"),
        "reading"},
       [](const F& f) { return to_string(f.reading); }},
      {{share("wrong", about_less, "share of hits that the texture says the other of"), "wrong", "",
        in_per_cent},
       [](const F& f) { return f.wrong; }},
      {{share("shade", about_less, "mean over the maps of |share read as opaque - share that is opaque|"),
        "shade", "", in_per_cent},
       [](const F& f) { return f.shade; }},
  };
  const Fields<M> fields{
      {{.key = one_of("regions", key, {"16x16", "32x32"}), .heading = "regions", .leads = true},
       [](const M& m) { return regions(m.side); }},
      {{.key = text("map", key, "who encoded it; O alone, T alone: the other state was C before"),
        .heading = "map",
        .leads = true},
       [](const M& m) { return m.map; }},
      {{count("lost_t", same, "regions of T that became C"), "lost T"}, [](const M& m) { return m.lost_t; }},
      {{count("lost_o", same, "regions of O that became C"), "lost O"}, [](const M& m) { return m.lost_o; }},
      {{share("checked", about_less, "share of hits on C"), "hits on C", "", in_per_cent},
       [](const M& m) { return m.checked; }},
      within<M, F>({.key = list("by", "", {5, 5}), .heading = "by", .within = RowLayout::beside}, by,
                   [](const M& m) { return std::vector<F>(m.by.begin(), m.by.end()); }),
  };
  return table_of<M>({.key = list("readings", "maps of three states, read as two"),
                      .row = "maps of one codec, read as two states over 4096 hits a map",
                      .caption = "Read as two states: hits that are wrong, and a map's shade that is"},
                     fields, figures.read);
}

}  // namespace mmverify::bench::rivals
