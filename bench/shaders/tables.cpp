#include "bench/shaders/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {

Result shader_tables(const ShaderFigures& figures) {
  using S = ShaderSpeed;
  const Fields<S> fields{
      {{.key = text("function", key, "of shaders/subjects"), .heading = "function", .leads = true},
       [](const S& s) { return s.function; }},
      {{.key = level(12, key, "not there of VQ2 and VQ4").if_any(), .heading = "level", .leads = true},
       [](const S& s) { return s.level ? Value(*s.level) : Value(); }},
      {{number("lookups_per_second", left_out, "1/s: 10^9 / device_ns"),
        "lookups",
        "1/s",
        {2, 'f', millions, "M/s"}},
       [](const S& s) { return s.device_ns > 0 ? 1e9 / s.device_ns : 0; }},
      {{time("device_ns", "ns of wall time a lookup in a batch, copies included; the best of three turns"),
        "device", "ns"},
       [](const S& s) { return s.device_ns; }},
      {{time("cpu_ns",
             "ns of wall time a lookup, impl's, one by one in one thread; not there where impl has no such "
             "function")
            .if_any(),
        "ours", "ns"},
       [](const S& s) { return s.cpu_ns ? Value(*s.cpu_ns) : Value(); }},
      {{ratio("ratio", left_out, "device_ns / cpu_ns").if_any(), "x ours"},
       [](const S& s) { return s.cpu_ns ? Value(s.device_ns / *s.cpu_ns) : Value(); }},
      {{count("differing", less, "answers of a batch unlike impl's"), "differing"},
       [](const S& s) { return s.differing; }},
  };
  using About = std::pair<std::string, std::string>;
  const Fields<About> about{
      {{.key = text("what", key), .heading = "device", .leads = true},
       [](const About& a) { return a.first; }},
      {{text("is", left_out), "is"}, [](const About& a) { return a.second; }},
  };
  return {.topic = "shaders",
          .description =
              "mmverify bench shaders: what a lookup costs in a shader on a device, beside the library's own",
          .settings = {{count("device", left_out, "its number"), figures.device},
                       {count("batch", setting, "lookups a call"), figures.batch},
                       {count("seed", setting, "of the points"), figures.seed}},
          .about =
              "device: wall time of a lookup in a batch, its copies included, on all threads that the driver "
              "takes; ours: the library's, one by one in one thread; differing: of a batch, answers unlike "
              "the library's",
          .tables = {table_of<About>(
                         {.key = list("runs_on", "device, driver, versions, what it promises of floats", {})},
                         about, figures.about),
                     table_of<S>({.key = "rows"}, fields, figures.rows)}};
}

}  // namespace mmverify::bench
