#include "bench/sweep/tables.hpp"

#include <fmt/format.h>

#include <string>

namespace mmverify::bench {
namespace {

const Print in_millions{.digits = 1, .factor = millions, .unit = "M/s"};

Value if_any(const std::optional<double>& figure) { return figure ? Value(*figure) : Value(); }

/// Adds the columns of one subject.
void add_swept(Fields<SweepLevel>& fields, const std::string& subject, Swept SweepLevel::*of) {
  using L = SweepLevel;
  fields.push_back(note<L>(object(subject, no_rule, "a sweep of this subject")));
  fields.push_back({{time(subject + ".seconds", ""), "time", "seconds", digits(3), subject},
                    [of](const L& l) { return (l.*of).seconds; }});
  fields.push_back({{number(subject + ".per_second", left_out, "cells a second"), "cells", "cells a second",
                     in_millions, subject},
                    [of](const L& l) { return (l.*of).per_second; }});
  fields.push_back({{ratio(subject + ".ratio", speed_more,
                           "per_second / the plain loop's, at this level or the highest where that was run; "
                           "absent where it was not")
                         .if_any(),
                     "x plain", "", digits(1), subject},
                    [of](const L& l) { return if_any((l.*of).ratio); }});
  fields.push_back({{"", "growth", "", plain, subject}, [of](const L& l) { return if_any((l.*of).growth); }});
}

}  // namespace

Result sweep_tables(const SweepFigures& figures) {
  using L = SweepLevel;
  Fields<L> fields{
      {{.key = level(16), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{positive("cells", same), "cells"}, [](const L& l) { return l.cells; }},
      {{number("plain_per_second", left_out,
               "cells a second of the plain loop; absent above level 12, where it is not run")
            .if_any(),
        "plain loop", "cells a second", in_millions},
       [](const L& l) { return if_any(l.plain_per_second); }},
  };
  add_swept(fields, "step", &L::step);
  add_swept(fields, "impl", &L::impl);
  fields.push_back({{number("peak_megabytes", left_out, "memory of the process so far, in MiB"), "memory",
                     "MiB", digits(0)},
                    [](const L& l) { return l.peak_megabytes; }});
  const Fields<SweepFigures> loose{{{positive("threads", setting), "threads"},
                                    [](const SweepFigures& f) { return Value(std::uint64_t{f.threads}); }}};
  return {
      .topic = "sweep",
      .description =
          "mmverify bench index --sweep: what a sweep of index.equals_reference costs, beside the plain loop",
      .settings = {},
      .about = fmt::format(
          "index.equals_reference. M/s: million cells a second; growth: time over that of the level below.\n"
          "Above level {} the plain loop is not run, and x plain is to its rate there",
          figures.last_plain),
      .tables = {table_of<SweepFigures>({.form = Form::members}, loose, {figures}),
                 table_of<L>({.key = "levels"}, fields, figures.levels)}};
}

}  // namespace mmverify::bench
