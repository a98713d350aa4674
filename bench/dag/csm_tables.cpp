#include "bench/dag/csm_tables.hpp"

#include <string>

namespace mmverify::bench {
namespace {

using C = CsmFigures;

double over(std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); }

/// Bits a micro-triangle.
double bits_each(const C& f, std::uint64_t bytes) {
  return 8 * over(bytes, f.maps) / static_cast<double>(std::uint64_t{1} << 2 * f.level);
}

/// The bytes of a form.
struct MergedForm {
  const char* form;
  std::uint64_t apart, together;
};

}  // namespace

Table csm_table(const std::vector<CsmFigures>& figures) {
  const std::string map = "a map", micro_triangle = "a micro-triangle", flat = "memory", time = "a lookup",
                    worst = "worst case / flat";
  const Print whole{.digits = 0}, three{.digits = 3}, two{.digits = 2}, one{.digits = 1};
  const Fields<C> fields{
      {{.key = one_of("states", key, {2, 4}), .heading = "states", .leads = true},
       [](const C& f) { return f.bits == 1 ? 2u : 4u; }},
      {{.key = level(12), .heading = "level", .leads = true}, [](const C& f) { return f.level; }},
      {{positive("maps", same), "maps"}, [](const C& f) { return f.maps; }},
      {{count("dag_bytes", about_less, "bytes of the graph, 8 a map for its place")},
       [](const C& f) { return f.dag_bytes; }},
      {{count("csm_bytes", same, "bytes of csm, 8 a map for its place, mean opacity included")},
       [](const C& f) { return f.csm_bytes; }},
      {{count("csm_plain_bytes", same, "bytes of csm without mean opacity")},
       [](const C& f) { return f.csm_plain_bytes; }},
      {{"", "dag", "bytes", whole, map}, [](const C& f) { return over(f.dag_bytes, f.maps); }},
      {{"", "csm", "bytes", whole, map}, [](const C& f) { return over(f.csm_bytes, f.maps); }},
      {{"", "csm, no means", "bytes", whole, map},
       [](const C& f) { return over(f.csm_plain_bytes, f.maps); }},
      {{"", "dag", "bits", three, micro_triangle}, [](const C& f) { return bits_each(f, f.dag_bytes); }},
      {{"", "csm", "bits", three, micro_triangle}, [](const C& f) { return bits_each(f, f.csm_bytes); }},
      {{number("memory_flat_to_csm", same, "bytes of flat / bytes of csm"), "flat / csm", "", one, flat},
       [](const C& f) { return over(f.flat_bytes, f.csm_bytes); }},
      {{number("memory_once_to_csm", same, "bytes of maps that are the same once / bytes of csm"),
        "once / csm", "", one, flat},
       [](const C& f) { return over(f.once_bytes, f.csm_bytes); }},
      {{number("memory_dag_to_csm", about_less, "bytes of the graph / bytes of csm"), "dag / csm", "", two,
        flat},
       [](const C& f) { return over(f.dag_bytes, f.csm_bytes); }},
      {{number("dag_worst", about_less,
               "bytes of a map of noise in the graph / bytes of the map, without the 8 for its place"),
        "dag", "", two, worst},
       [](const C& f) { return f.dag_worst; }},
      {{number("csm_worst", same, "the same in csm"), "csm", "", two, worst},
       [](const C& f) { return f.csm_worst; }},
      {{bench::time("once_ns", "ns a lookup in maps that are the same once"), "once", "ns", one, time},
       [](const C& f) { return f.once_ns; }},
      {{bench::time("dag_ns", "ns a lookup in the graph, in the same rounds"), "dag", "ns", one, time},
       [](const C& f) { return f.dag_ns; }},
      {{bench::time("csm_ns", "ns a lookup in csm, in the same rounds"), "csm", "ns", one, time},
       [](const C& f) { return f.csm_ns; }},
      {{ratio("ratio_dag_to_once", speed_less, "of ns a lookup: the median of the rounds' ratios"),
        "dag / once", "", two, time},
       [](const C& f) { return f.dag_over_once; }},
      {{ratio("ratio_csm_to_once", left_out, "of ns a lookup: the median of the rounds' ratios"),
        "csm / once", "", two, time},
       [](const C& f) { return f.csm_over_once; }},
      {{ratio("ratio_dag_to_csm", speed_less, "of ns a lookup: the median of the rounds' ratios"),
        "dag / csm", "", two, time},
       [](const C& f) { return f.dag_over_csm; }},
      {{number("csm_build_rate", left_out, "M micro-triangles/s: millions of them a second, from flat maps"),
        "csm added", "M micro-triangles/s", whole, "building"},
       [](const C& f) { return f.csm_build_rate; }},
  };
  return table_of<C>({.key = list("csm"),
                      .row = "one level and format",
                      .caption = "Common Subtree Merging (csm) beside our graph (dag)"},
                     fields, figures);
}

Table merged_levels_table(const std::vector<CsmFigures>& figures, const MergedBytes& merged) {
  using M = MergedForm;
  std::uint64_t dag = 0, csm = 0;
  for (const C& f : figures) {
    dag += f.dag_bytes;
    csm += f.csm_bytes;
  }
  const Fields<M> fields{
      {{.key = one_of("form", key, {"dag", "csm"}), .heading = "form", .leads = true},
       [](const M& m) { return m.form; }},
      {{count("apart_bytes", about_less, "bytes of the rows' structures, each level and format by itself"),
        "apart", "bytes"},
       [](const M& m) { return m.apart; }},
      {{count("together_bytes", about_less,
              "bytes of all levels together: of dag two graphs, one a format; of csm one for both formats"),
        "together", "bytes"},
       [](const M& m) { return m.together; }},
      {{"", "together / apart", "", {.digits = 3}},
       [](const M& m) -> Value {
         if (m.apart == 0) return {};
         return over(m.together, m.apart);
       }},
  };
  return table_of<M>(
      {.key = list("merged_levels"), .row = "one form", .caption = "All these levels and formats merged"},
      fields, {{"dag", dag, merged.dag}, {"csm", csm, merged.csm}});
}

}  // namespace mmverify::bench
