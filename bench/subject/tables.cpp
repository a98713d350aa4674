#include "bench/subject/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {

Result subject_tables(const SubjectFigures& figures) {
  using F = SubjectFigures;
  const Fields<F> fields{
      {{"subject"}, [](const F& f) { return f.library; }},
      {{"level"}, [](const F& f) { return f.level; }},
      {{"bare_ns", "bare loop in this process", "ns"}, [](const F& f) { return f.bare_ns; }},
      {{"isolated_ns", "asked in a worker process", "ns"}, [](const F& f) { return f.isolated_ns; }},
      {{"isolated_ratio", "  x the bare loop"}, [](const F& f) { return f.isolated_ratio; }},
      {{"judged_ns", "judged (index.equals_reference, all of it)", "ns"},
       [](const F& f) { return f.judged_ns; }},
      {{"judged_ratio", "  x the bare loop"}, [](const F& f) { return f.judged_ns / f.bare_ns; }},
      {{"verdict", "verdict"}, [](const F& f) { return f.verdict; }},
  };
  return {.topic = "subject",
          .settings = {},
          .about = fmt::format("{} at level {}, one thread, batches of {}; times are of one index",
                               figures.library, figures.level, figures.batch),
          .tables = {table_of<F>({.form = Form::members}, fields, {figures})}};
}

}  // namespace mmverify::bench
