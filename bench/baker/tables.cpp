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
      {{text("baker", left_out)}, [](const F& f) { return f.baker; }},
      {{text("file", left_out)}, [](const F& f) { return f.file; }},
  };
  const Fields<L> levels{
      {{.key = level(12), .heading = "level", .leads = true}, [](const L& l) { return l.level; }},
      {{positive("triangles", same, "distinct by their texture coordinates"), "triangles"},
       [](const L& l) { return l.triangles; }},
      {{count("outside", less, "of these, beyond what the baker declares, and not asked"), "outside"},
       [](const L& l) { return l.outside; }},
      {{count("declined", less, "of these, not baked when asked"), "declined"},
       [](const L& l) { return l.declined; }},
      {{count("micro_triangles", more, "of those that were baked"), "states"},
       [](const L& l) { return l.micro_triangles; }},
      {{count("wrong", less, "O or T, and not so on all of it"), "wrong"},
       [](const L& l) { return l.wrong; }},
      {{real("wrong_per_million", left_out, {0, 1000000}, "of micro_triangles"),
        "wrong",
        "",
        {.digits = 1, .unit = "a million"}},
       [](const L& l) { return 1e6 * part(l.wrong, l.micro_triangles); }},
      {{count("needless", less, "unknown, and O or T on all of it"), "needless"},
       [](const L& l) { return l.needless; }},
      {{share("needless_share", left_out, "of micro_triangles"), "needless", "", percents(3)},
       [](const L& l) { return part(l.needless, l.micro_triangles); }},
      {{time("ns", "ns a micro-triangle, the question, the answer and the worker process included"),
        "a state", "ns"},
       [](const L& l) { return l.ns; }},
      {{time("our_ns", "the same of ours, the texture made ready"), "ours", "ns"},
       [](const L& l) { return l.our_ns; }},
      {{ratio("times_ours", speed_less, "ns / our_ns; 0 where nothing was baked"), "x ours"},
       [](const L& l) { return l.our_ns > 0 ? l.ns / l.our_ns : 0; }},
  };
  return {.topic = "baker",
          .description =
              "mmverify bench bake --subject NAME|FILE: what a baker gets wrong of a scene or a folder of "
              "textures, and its time, beside ours",
          .settings = {},
          .about = figures.baker + " on " + figures.file +
                   ", one thread. wrong: O or T, and not so on all of it; needless: unknown, and O or T on "
                   "all of it, by what it\ndeclares. outside: beyond that, and not asked. A state's time has "
                   "the question, the answer and the worker process in it",
          .tables = {table_of<F>({.form = Form::members}, members, {figures}),
                     table_of<L>({.key = "rows"}, levels, figures.levels)}};
}

}  // namespace mmverify::bench
