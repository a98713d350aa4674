#include "bench/stiff/tables.hpp"

namespace mmverify::bench {

Result stiff_tables(const std::vector<StiffFigure>& figures, const StiffBenchOptions& options) {
  using F = StiffFigure;
  const std::string answers = "wrong answers";
  const Fields<F> fields{
      {{.key = text("kind", key, "of stiff inputs: docs/STIFF.md"), .heading = "stiff inputs", .leads = true},
       [](const F& f) { return f.kind; }},
      {{.key = text("method", key), .heading = "method", .leads = true}, [](const F& f) { return f.method; }},
      {{count("cases", same, "answers on stiff inputs that were judged; as many on ordinary ones"), "judged"},
       [](const F& f) { return f.cases; }},
      {{count("wrong", less, "answers on stiff inputs that are not those of exact arithmetic"),
        "stiff",
        "",
        {},
        answers},
       [](const F& f) { return f.wrong; }},
      {{count("ordinary_wrong", less, "the same on ordinary inputs"), "ordinary", "", {}, answers},
       [](const F& f) { return f.ordinary_wrong; }},
      {{share("exact", about_less, "of stiff answers, by our bakers, that took whole numbers").if_any(),
        "whole numbers", "", percents(2)},
       [](const F& f) { return f.exact ? Value(*f.exact) : Value(); }},
      {{time("ns", "ns an answer on stiff inputs"), "an answer", "ns", digits(2), "time"},
       [](const F& f) { return f.ns; }},
      {{time("least_ns", "ns an answer on stiff inputs, of the fastest round").if_any()},
       [](const F& f) { return f.least_ns ? Value(*f.least_ns) : Value(); }},
      {{time("most_ns", "ns an answer on stiff inputs, of the slowest round").if_any()},
       [](const F& f) { return f.most_ns ? Value(*f.most_ns) : Value(); }},
      {{ratio("ratio_stiff_to_ordinary", left_out,
              "of ns an answer: on stiff inputs / on ordinary ones; median of rounds"),
        "stiff / ordinary", "", digits(2), "time"},
       [](const F& f) { return f.ratio; }},
  };
  return {
      .topic = "stiff",
      .description = "mmverify bench stiff: errors and times on stiff inputs",
      .settings = {{count("samples", setting, "points of a kind; bakers, weights and rationals take a part"),
                    options.samples},
                   {seed_of_all(), options.seed},
                   {count("rounds", setting, "of the timing"), std::uint64_t{options.rounds}}},
      .about =
          "Every answer is compared with the exact one, on one thread; docs/STIFF.md describes each kind",
      .tables = {table_of<F>({.key = "rows", .row = "one kind of stiff inputs and one method"}, fields,
                             figures)},
      .drawn = stiff_picture(figures)};
}

}  // namespace mmverify::bench
