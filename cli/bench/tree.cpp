#include "cli/bench/tree.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::cli {
namespace {

using bench::TreeBenchOptions;
using bench::TreeFigures;
using bench::TreeForm;
using bench::TreeFormFigures;
using Json = nlohmann::ordered_json;

constexpr TreeForm forms[] = {TreeForm::flat, TreeForm::paper, TreeForm::ours, TreeForm::sdsl};

int states(const TreeFigures& f) { return f.bits == 1 ? 2 : 4; }

std::string short_number(double x) { return x < 9.995 ? fmt::format("{:.2f}", x) : fmt::format("{:.4g}", x); }

void print_lookups(std::FILE* out, const std::vector<TreeFigures>& figures) {
  const auto four = [out](const TreeFigures& f, double TreeFormFigures::*figure, const char* format) {
    for (const TreeForm form : forms) fmt::print(out, fmt::runtime(format), f.form(form).*figure);
  };
  fmt::print(out, "{:<12}{:^32}{:^36}{:^36}{:^24}{:^30}\n", "", "bits a micro-triangle", "ns a lookup",
             "ns in a chain", "cache lines", "paper's stream");
  fmt::print(out, "{:<6} {:>5}", "states", "level");
  for (int group = 0; group < 4; ++group)
    for (const TreeForm form : forms)
      fmt::print(out, fmt::runtime(group == 0 ? "{:>8}" : group == 3 ? "{:>6}" : "{:>9}"), to_string(form));
  fmt::print(out, " {:>9}{:>10}{:>10}\n", "maps", "nodes", "bits read");
  for (const TreeFigures& f : figures) {
    fmt::print(out, "{:<6} {:>5}", states(f), f.level);
    four(f, &TreeFormFigures::bits, "{:>8.4f}");
    four(f, &TreeFormFigures::ns, "{:>9.1f}");
    four(f, &TreeFormFigures::chained_ns, "{:>9.1f}");
    four(f, &TreeFormFigures::lines, "{:>6.1f}");
    fmt::print(out, " {:>9}{:>10.0f}{:>10.0f}\n", f.maps, f.nodes, f.bits_read);
  }
}

void print_ratios(std::FILE* out, const std::vector<TreeFigures>& figures) {
  fmt::print(out, "{:<6} {:>5} {:>12} {:>11} {:>11} {:>13} {:>15} {:>21} {:>15} {:>21}\n", "states", "level",
             "paper / ours", "sdsl / ours", "ours / flat", "memory, ours", "encode obvious",
             "stream, ours faster", "decode obvious", "stream, ours faster");
  for (const TreeFigures& f : figures)
    fmt::print(
        out, "{:<6} {:>5} {:>12} {:>11} {:>11} {:>13.3f} {:>15.4g} {:>21} {:>15.4g} {:>21}\n", states(f),
        f.level, short_number(f.paper_over_ours), short_number(f.sdsl_over_ours),
        short_number(f.ours_over_flat), f.memory_over_paper, f.obvious_encode,
        fmt::format("{:.1f}x, {:.1f}x", f.obvious_encode / f.encode_stream, f.obvious_encode / f.encode_tree),
        f.obvious_decode,
        fmt::format("{:.1f}x, {:.1f}x", f.obvious_decode / f.decode_stream,
                    f.obvious_decode / f.decode_tree));
}

Json tree_json(const TreeFigures& f) {
  Json j{
      {"states", states(f)},
      {"level", f.level},
      {"maps", f.maps},
      {"nodes", f.nodes},
      {"paper_bits_read", f.bits_read},
      {"forms", Json::array()},
      {"ratio_paper_to_ours", f.paper_over_ours},
      {"ratio_sdsl_to_ours", f.sdsl_over_ours},
      {"ratio_ours_to_flat", f.ours_over_flat},
      {"memory_ours_to_paper", f.memory_over_paper},
      {"ratio_encode_obvious_to_ours", f.obvious_encode / f.encode_tree},
      {"ratio_decode_obvious_to_ours", f.obvious_decode / f.decode_tree},
      {"encode_ns", {{"obvious", f.obvious_encode}, {"stream", f.encode_stream}, {"ours", f.encode_tree}}},
      {"decode_ns", {{"obvious", f.obvious_decode}, {"stream", f.decode_stream}, {"ours", f.decode_tree}}}};
  for (const TreeForm form : forms) {
    const TreeFormFigures& figures = f.form(form);
    j["forms"].push_back({{"form", to_string(form)},
                          {"bits_per_micro_triangle", figures.bits},
                          {"ns_per_lookup", figures.ns},
                          {"ns_per_chained_lookup", figures.chained_ns},
                          {"cache_lines", figures.lines}});
  }
  return j;
}

Json tree_json(const std::vector<TreeFigures>& figures, const TreeBenchOptions& options) {
  Json j{{"schema", "mmverify.bench/1"},
         {"topic", "tree"},
         {"tool", tool({{"seed", options.seed},
                        {"samples", options.lookups},
                        {"maps", options.textures.empty() ? "generated" : "textures"}})},
         {"rows", Json::array()}};
  for (const TreeFigures& f : figures) j["rows"].push_back(tree_json(f));
  return j;
}

}  // namespace

std::string tree_plot_script(const std::vector<TreeFigures>& figures) {
  constexpr const char* colours[] = {"#888888", "#D55E00", "#009E73", "#0072B2"};  // Okabe and Ito's
  constexpr const char* names[] = {"flat", "paper, Algorithm 3", "ours", "sdsl"};
  constexpr int shapes[] = {7, 9, 5, 13};
  std::string script =
      "set terminal svg size 1000,1000 font 'sans-serif,13' background rgb 'white'\n"
      "set border lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n"
      "set logscale xy\nset format x '10^{%L}'\nset xlabel 'ns a lookup, one thread'\n"
      "set ylabel 'bits a micro-triangle'\nset key outside right\n";
  std::string plots[2];
  for (const std::uint32_t bits : {1u, 2u})
    for (std::size_t form = 0; form < bench::tree_forms; ++form) {
      const std::string block = fmt::format("$form{}_{}", bits, form);
      std::string points;
      for (const TreeFigures& f : figures)
        if (f.bits == bits)
          points += fmt::format("{:.6g} {:.6g} {}\n", f.forms[form].ns, f.forms[form].bits, f.level);
      if (points.empty()) continue;
      script += block + " << EOD\n" + points + "EOD\n";
      std::string& plot = plots[bits - 1];
      plot += fmt::format(
          "{0}{1} using 1:2 with linespoints pt {2} ps 0.9 lw 1.2 lc rgb '{3}' title '{4}', "
          "{1} using 1:2:3 with labels offset 0.9,0.6 font ',10' tc rgb '{3}' notitle",
          plot.empty() ? "" : ", ", block, shapes[form], colours[form], names[form]);
    }
  script += "set multiplot layout 2,1\n";
  for (int row = 0; row < 2; ++row)
    if (!plots[row].empty())
      script += fmt::format("set title '{} states: size against time, a mark a level'\nplot {}\n",
                            row == 0 ? 2 : 4, plots[row]);
  return script + "unset multiplot\n";
}

BenchOutput bench_tree(const TreeBenchOptions& given, bool quiet, std::FILE* out) {
  TreeBenchOptions options = given;
  options.progress = [quiet](const std::string& what) {
    if (proofs::interrupted()) throw proofs::Interrupted();
    if (!quiet) fmt::print(stderr, "bench tree: {}\n", what);
  };
  std::vector<TreeFigures> figures;
  try {
    figures = tree_figures(options);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  if (proofs::interrupted()) throw proofs::Interrupted();
  fmt::print(
      out,
      "tree, levels {}..{}, seed {}, maps {}, {} random lookups over all maps of a level, one thread\n\n"
      "flat: the array. paper: the two bit sequences, Algorithm 3. ours: impl/tree. sdsl: the tree in level "
      "order,\nbit_vector and rank_support_v5. Cache lines are those of a model\n",
      options.first, options.last, options.seed, options.textures.empty() ? "generated" : "of alpha textures",
      grouped(options.lookups));
  print_lookups(out, figures);
  fmt::print(
      out,
      "\nRatios of one run: of times a lookup; of memory to the paper's sequences; encoding and decoding a "
      "map, ns the\nobvious way, and how often faster the stream and our form are\n");
  print_ratios(out, figures);
  return {tree_json(figures, options).dump(1) + "\n", tree_plot_script(figures)};
}

}  // namespace mmverify::cli
