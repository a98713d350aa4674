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
  const Print one{.digits = 1}, two{.digits = 2}, three{.digits = 3},
      in_per_cent{.digits = 2, .factor = per_cent, .unit = "%"};
  const std::string of_all = "substitutions", of_maps = "maps with", encoding = "encoding a map",
                    decoding = "decoding", to_vq = "x VQ's";
  const Fields<R> fields{
      {{.key = "regions", .heading = "regions", .leads = true},
       [](const R& r) { return regions(r.by.side); }},
      {{.key = "codec", .heading = "codec", .leads = true}, [](const R& r) { return r.by.codec; }},
      {{"bits", "bits"}, [](const R& r) { return r.by.bits; }},
      {{"substitutions", "all", "", {}, of_all}, [](const R& r) { return r.by.substitutions; }},
      {{"lost_share", "of O+T", "", in_per_cent, of_all},
       [](const R& r) {
         const auto states = static_cast<double>(r.by.states);
         return states > 0 ? static_cast<double>(r.by.substitutions) / states : 0;
       }},
      {{"savings", "savings", "", in_per_cent}, [](const R& r) { return r.by.savings; }},
      {{"whole", "no loss", "", {}, of_maps}, [](const R& r) { return r.by.whole; }},
      {{"fewer_than_vq", "less than VQ's", "", {}, of_maps}, [](const R& r) { return r.fewer(); }},
      {{"lossless_bits", "bits for no loss", "", {.digits = 0}},
       [](const R& r) -> Value {
         if (r.by.lossless_bits) return *r.by.lossless_bits;
         return {};
       }},
      {{"encode_ms", "median", "ms", three, encoding}, [](const R& r) { return r.by.encode_ms; }},
      {{"encode_to_vq", to_vq, "", two, encoding},
       [](const R& r) { return r.by.encode_ms / r.vq.encode_ms; }},
      {{"map_ns", "a map", "ns", {.digits = 0}, decoding}, [](const R& r) { return r.by.map_ns; }},
      {{"region_ns", "a region", "ns", one, decoding}, [](const R& r) { return r.by.region_ns; }},
      {{"region_to_vq", to_vq, "", two, decoding},
       [](const R& r) { return r.by.region_ns / r.vq.region_ns; }},
  };
  return table_of<R>({.key = "rivals", .caption = "VQ beside its rivals, in the same bits"}, fields, rows);
}

Table readings_table(const Figures& figures) {
  using M = ReadMaps;
  using F = ReadingFigures;
  const Print in_per_cent{.digits = 2, .factor = per_cent, .unit = "%"};
  const Fields<F> by{
      {{"reading", "reading"}, [](const F& f) { return to_string(f.reading); }},
      {{"wrong", "wrong", "", in_per_cent}, [](const F& f) { return f.wrong; }},
      {{"shade", "shade", "", in_per_cent}, [](const F& f) { return f.shade; }},
  };
  const Fields<M> fields{
      {{.key = "regions", .heading = "regions", .leads = true}, [](const M& m) { return regions(m.side); }},
      {{.key = "map", .heading = "map", .leads = true}, [](const M& m) { return m.map; }},
      {{"lost_t", "lost T"}, [](const M& m) { return m.lost_t; }},
      {{"lost_o", "lost O"}, [](const M& m) { return m.lost_o; }},
      {{"checked", "hits on C", "", in_per_cent}, [](const M& m) { return m.checked; }},
      within<M, F>({.key = "by", .heading = "by", .within = Within::beside}, by,
                   [](const M& m) { return std::vector<F>(m.by.begin(), m.by.end()); }),
  };
  return table_of<M>(
      {.key = "readings", .caption = "Read as two states: hits that are wrong, and a map's shade that is"},
      fields, figures.read);
}

}  // namespace mmverify::bench::rivals
