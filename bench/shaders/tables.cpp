#include "bench/shaders/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {

Result shader_tables(const ShaderFigures& figures) {
  using S = ShaderSpeed;
  const Fields<S> fields{
      {{.key = "function", .heading = "function", .leads = true}, [](const S& s) { return s.function; }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const S& s) { return s.level ? Value(*s.level) : Value(); }},
      {{"lookups_per_second", "lookups", "1/s", {2, 'f', millions, "M/s"}},
       [](const S& s) { return s.device_ns > 0 ? 1e9 / s.device_ns : 0; }},
      {{"device_ns", "device", "ns"}, [](const S& s) { return s.device_ns; }},
      {{"cpu_ns", "ours", "ns"}, [](const S& s) { return s.cpu_ns ? Value(*s.cpu_ns) : Value(); }},
      {{"ratio", "x ours"}, [](const S& s) { return s.cpu_ns ? Value(s.device_ns / *s.cpu_ns) : Value(); }},
      {{"differing", "differing"}, [](const S& s) { return s.differing; }},
  };
  using About = std::pair<std::string, std::string>;
  const Fields<About> about{
      {{.key = "what", .heading = "device", .leads = true}, [](const About& a) { return a.first; }},
      {{"is", "is"}, [](const About& a) { return a.second; }},
  };
  return {.topic = "shaders",
          .settings = {{"device", figures.device}, {"batch", figures.batch}, {"seed", figures.seed}},
          .about =
              "device: wall time of a lookup in a batch, its copies included, on all threads that the driver "
              "takes; ours: the library's, one by one in one thread; differing: of a batch, answers unlike "
              "the library's",
          .tables = {table_of<About>({.key = "runs_on"}, about, figures.about),
                     table_of<S>({.key = "rows"}, fields, figures.rows)}};
}

}  // namespace mmverify::bench
