#include "bench/shaders/tables.hpp"

#include <fmt/format.h>

namespace mmverify::bench {
namespace {

using S = KernelSpeed;

double bytes_per_second(const S& s) {
  return 1e9 * static_cast<double>(s.hits * (s.bytes_in + s.bytes_out)) / s.ns;
}

Fields<S> fields_of_kernels(double bandwidth) {
  return {
      {{.key = text("kernel", key, "a function of shaders/subjects or shaders/kernels, or a copy"),
        .heading = "kernel",
        .leads = true},
       [](const S& s) { return s.kernel; }},
      {{.key = level(16, key, "not there of blocks and copies").if_any(), .heading = "level", .leads = true},
       [](const S& s) { return s.level ? Value(*s.level) : Value(); }},
      {{.key = positive("hits", key, "of a dispatch"), .heading = "hits", .leads = true},
       [](const S& s) { return s.hits; }},
      {{.key = one_of("order", key, {"coherent", "shuffled"}, "of the hits; not there of copies").if_any(),
        .heading = "order",
        .leads = true},
       [](const S& s) { return s.order.empty() ? Value() : Value(s.order); }},
      {{number("lookups_per_second", left_out, "1/s: 10^9 hits / ns"),
        "lookups",
        "1/s",
        {2, 'f', millions, "M/s"}},
       [](const S& s) { return 1e9 * static_cast<double>(s.hits) / s.ns; }},
      {{time("ns", "ns of a dispatch between two timestamps of the device: the median of the runs")},
       [](const S& s) { return s.ns; }},
      {{ratio("spread", left_out, "(slowest run - fastest run) / median"), "spread", "", percents(0)},
       [](const S& s) { return s.spread; }},
      {{count("bytes_in", key, "B that a hit is given as"), "in", "B"},
       [](const S& s) { return s.bytes_in; }},
      {{count("bytes_out", key, "B of a hit's answer"), "out", "B"}, [](const S& s) { return s.bytes_out; }},
      {{number("bytes_per_second", left_out, "B/s: hits (bytes_in + bytes_out) / time"),
        "moved",
        "B/s",
        {2, 'f', 1e-9, "GB/s"}},
       bytes_per_second},
      {{ratio("share_of_copy", left_out,
              "time of the copy kernel with the same bytes in and out on as many hits / time; not there of "
              "copies")
            .if_any(),
        "of copy", "", percents(0)},
       [](const S& s) { return s.share_of_copy ? Value(*s.share_of_copy) : Value(); }},
      {{ratio("share_of_bandwidth", left_out, "bytes_per_second / bandwidth"), "of bandwidth", "",
        percents(0)},
       [bandwidth](const S& s) { return bytes_per_second(s) / bandwidth; }},
      {{.key = count("checked", same, "hits whose answer equals the library's; not there of vkCmdCopyBuffer")
                   .if_any()},
       [](const S& s) { return s.checked ? Value(*s.checked) : Value(); }},
  };
}

/// The lines above the tables name the device and explain the columns.
std::string above(const ShaderFigures& figures) {
  const std::string name = figures.about.empty() ? "a device" : figures.about.front().second;
  std::string text;
  if (figures.is_processor) text = fmt::format("no GPU here: {}, on the processor\n", name);
  if (!figures.bounded_by.empty())
    text += fmt::format("hits of a dispatch are bounded by {}\n", figures.bounded_by);
  return text + fmt::format(
                    "Data stay in the device's memory; a time is the median of {} runs between the device's "
                    "timestamps,\nspread the slowest run less the fastest, over the median. Coherent: "
                    "neighbouring hits go to neighbouring\nmicro-triangles; shuffled: the same hits in "
                    "random order. of copy: the time of a kernel that only copies\nthe same bytes, over the "
                    "lookup's. Bandwidth is that of the fastest copy of the most hits, {:.2f} GB/s,\nread "
                    "and written bytes together; fewer hits may lie in a cache. A sample of the answers is "
                    "the library's.",
                    figures.runs, figures.bandwidth * 1e-9);
}

}  // namespace

Result shader_tables(const ShaderFigures& figures) {
  using About = std::pair<std::string, std::string>;
  const Fields<About> facts{
      {{.key = text("what", key), .heading = "device", .leads = true},
       [](const About& a) { return a.first; }},
      {{text("is", left_out), "is"}, [](const About& a) { return a.second; }},
  };
  const Fields<ShaderFigures> whole{
      {{one_of("kind", left_out, {"processor", "GPU"}, "of the device"), "kind of device"},
       [](const ShaderFigures& f) { return std::string(f.is_processor ? "processor" : "GPU"); }},
      {{number("bandwidth", left_out,
               "B/s of the fastest copy of the most hits, read and written bytes together"),
        "bandwidth",
        "B/s",
        {2, 'f', 1e-9, "GB/s"}},
       [](const ShaderFigures& f) { return f.bandwidth; }},
  };
  return {
      .topic = "shaders",
      .description = "mmverify bench shaders: lookups a second as kernels on a device, beside a copy kernel",
      .settings = {{count("device", left_out, "its number"), figures.device},
                   {count("hits", setting, "of a dispatch, at most"), figures.hits},
                   {count("runs", setting, "of each kernel"), figures.runs}},
      .about = above(figures),
      .tables = {table_of<About>(
                     {.key = list("runs_on", "device, driver, versions, what it promises of floats", {})},
                     facts, figures.about),
                 table_of<ShaderFigures>({.form = Form::members}, whole, {figures}),
                 table_of<S>({.key = "rows"}, fields_of_kernels(figures.bandwidth), figures.rows)}};
}

}  // namespace mmverify::bench
