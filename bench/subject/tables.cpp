#include "bench/subject/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {

Result subject_tables(const SubjectFigures& figures) {
  using F = SubjectFigures;
  const Fields<F> fields{
      {{text("subject", left_out, "the library's file")}, [](const F& f) { return f.library; }},
      {{level(16, setting)}, [](const F& f) { return f.level; }},
      {{time("bare_ns", "ns an index, in a loop in this process"), "bare loop in this process", "ns"},
       [](const F& f) { return f.bare_ns; }},
      {{time("isolated_ns", "ns an index, asked in a worker process"), "asked in a worker process", "ns"},
       [](const F& f) { return f.isolated_ns; }},
      {{ratio("isolated_ratio", speed_less, "isolated / bare: the median of the rounds' ratios"),
        "  x the bare loop"},
       [](const F& f) { return f.isolated_ratio; }},
      {{time("judged_ns", "ns a cell of index.equals_reference"),
        "judged (index.equals_reference, all of it)", "ns"},
       [](const F& f) { return f.judged_ns; }},
      {{ratio("judged_ratio", speed_less, "judged_ns / bare_ns"), "  x the bare loop"},
       [](const F& f) { return f.judged_ns / f.bare_ns; }},
      {{one_of("verdict", verdict, {"proved", "refuted", "checked", "broken", "not_applicable", "incomplete"},
               "of index.equals_reference at this level"),
        "verdict"},
       [](const F& f) { return f.verdict; }},
  };
  return {
      .topic = "subject",
      .description = "mmverify bench index --subject FILE: what judging a library costs, beside calling it",
      .settings = {},
      .about = fmt::format("{} at level {}, one thread, batches of {}; times are of one index",
                           figures.library, figures.level, figures.batch),
      .tables = {table_of<F>({.form = Form::members}, fields, {figures})}};
}

}  // namespace mmverify::bench
