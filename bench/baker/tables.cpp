#include "bench/baker/tables.hpp"

namespace mmverify::bench {
namespace {

double part(std::uint64_t some, std::uint64_t all) {
  return all == 0 ? 0 : static_cast<double>(some) / static_cast<double>(all);
}

}  // namespace

Result baker_tables(const BakerFigures& figures) {
  using F = BakerFigures;
  using L = BakerLevel;
  const Fields<F> members{
      {{"baker"}, [](const F& f) { return f.baker; }},
      {{"file"}, [](const F& f) { return f.file; }},
  };
  const Fields<L> levels{
      {{.key = "level", .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{"triangles", "triangles"}, [](const L& l) { return l.triangles; }},
      {{"outside", "outside"}, [](const L& l) { return l.outside; }},
      {{"declined", "declined"}, [](const L& l) { return l.declined; }},
      {{"micro_triangles", "states"}, [](const L& l) { return l.micro_triangles; }},
      {{"wrong", "wrong"}, [](const L& l) { return l.wrong; }},
      {{"wrong_per_million", "wrong", "", {.digits = 1, .unit = "a million"}},
       [](const L& l) { return 1e6 * part(l.wrong, l.micro_triangles); }},
      {{"needless", "needless"}, [](const L& l) { return l.needless; }},
      {{"needless_share", "needless", "", {.digits = 3, .factor = per_cent, .unit = "%"}},
       [](const L& l) { return part(l.needless, l.micro_triangles); }},
      {{"ns", "a state", "ns"}, [](const L& l) { return l.ns; }},
      {{"our_ns", "ours", "ns"}, [](const L& l) { return l.our_ns; }},
      {{"times_ours", "x ours"}, [](const L& l) { return l.our_ns > 0 ? l.ns / l.our_ns : 0; }},
  };
  return {.topic = "baker",
          .settings = {},
          .about = figures.baker + " on " + figures.file +
                   ", one thread. wrong: O or T, and not so on all of it; needless: unknown, and O or T on "
                   "all of it, by what it\ndeclares. outside: beyond that, and not asked. A state's time has "
                   "the question, the answer and the worker process in it",
          .tables = {table_of<F>({.form = Form::members}, members, {figures}),
                     table_of<L>({.key = "rows"}, levels, figures.levels)}};
}

}  // namespace mmverify::bench
