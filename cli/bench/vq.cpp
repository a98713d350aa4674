#include "cli/bench/vq.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::cli {
namespace {

using bench::Vq2Encoder;
using bench::Vq4Encoder;
using bench::VqBenchOptions;
using bench::VqDecodeTimes;
using bench::VqFigures;
using bench::VqRow;
using Json = nlohmann::ordered_json;

constexpr Vq2Encoder all_vq2[] = {Vq2Encoder::paper, Vq2Encoder::paper_highest_first, Vq2Encoder::optimal};
constexpr Vq4Encoder all_vq4[] = {Vq4Encoder::paper,    Vq4Encoder::paper_free_c, Vq4Encoder::fast,
                                  Vq4Encoder::balanced, Vq4Encoder::thorough,     Vq4Encoder::proved};

/// Of all rows together.
struct Sums {
  double states = 0, least = 0;

  explicit Sums(const std::vector<VqRow>& rows, bool vq4) {
    for (const VqRow& row : rows) {
      states += vq4 ? row.states_32 : row.states_16;
      least += vq4 ? row.least : row.by(Vq2Encoder::optimal).substitutions;
    }
  }
};

template <class Encoder>
double substitutions(const std::vector<VqRow>& rows, Encoder e) {
  double sum = 0;
  for (const VqRow& row : rows) sum += row.by(e).substitutions;
  return sum;
}
template <class Encoder>
double total_ms(const std::vector<VqRow>& rows, Encoder e) {
  double sum = 0;
  for (const VqRow& row : rows) sum += row.by(e).ms;
  return sum;
}
template <class Encoder>
std::vector<double> sorted_ms(const std::vector<VqRow>& rows, Encoder e) {
  std::vector<double> ms;
  for (const VqRow& row : rows) ms.push_back(row.by(e).ms);
  std::sort(ms.begin(), ms.end());
  return ms;
}
template <class Encoder>
double mean_savings(const std::vector<VqRow>& rows, Encoder e) {
  double sum = 0;
  for (const VqRow& row : rows) sum += row.savings(e);
  return sum / static_cast<double>(rows.size());
}
double mean(const std::vector<VqRow>& rows, double VqRow::*figure) {
  double sum = 0;
  for (const VqRow& row : rows) sum += row.*figure;
  return sum / static_cast<double>(rows.size());
}

void print_rows(std::FILE* out, const std::vector<VqRow>& rows) {
  fmt::print(out, "{:<28} {:^36} {:^63}\n", "", "VQ2, 16x16", "VQ4, 32x32");
  fmt::print(out, "{:<28} {:>5} {:>6} {:>14} {:>8} {:>6} {:>6} {:>13} {:>5} {:>8} {:>8} {:>6} {:>5}\n", "map",
             "O+T", "paper", "paper, highest", "optimal", "O+T", "paper", "paper, C free", "fast", "balanced",
             "thorough", "proved", "bound");
  for (const VqRow& r : rows) {
    std::string name = std::filesystem::path(r.of).filename().string();
    if (name.size() > 28) name = name.substr(0, 27) + "~";
    fmt::print(out, "{:<28} {:>5} {:>6} {:>14} {:>8} {:>6}", name, r.states_16,
               r.by(Vq2Encoder::paper).substitutions, r.by(Vq2Encoder::paper_highest_first).substitutions,
               r.by(Vq2Encoder::optimal).substitutions, r.states_32);
    constexpr int widths[] = {6, 13, 5, 8, 8, 6};
    for (const Vq4Encoder e : all_vq4)
      fmt::print(out, " {:>{}}", r.by(e).substitutions, widths[static_cast<std::size_t>(e)]);
    fmt::print(out, " {:>5}\n", r.least);
  }
}

template <class Encoder>
void print_encoder(std::FILE* out, const VqFigures& f, const char* codec, Encoder e, Encoder baseline,
                   const Sums& sums) {
  const double lost = substitutions(f.rows, e), ms = total_ms(f.rows, e);
  const double of_paper = substitutions(f.rows, baseline);
  const std::vector<double> each = sorted_ms(f.rows, e);
  fmt::print(out, "{:<5} {:<14} {:>8.0f} {:>9.2f} {:>9.1f} {:>9.1f} {:>9.2f} {:>10.3f} {:>10.3f} {:>10.2f}\n",
             codec, bench::to_string(e), lost, sums.states > 0 ? 100 * lost / sums.states : 0,
             of_paper > 0 ? 100 * (of_paper - lost) / of_paper : 0, lost - sums.least,
             100 * mean_savings(f.rows, e), each[each.size() / 2], each.back(),
             ms / total_ms(f.rows, baseline));
}

void print_encoders(std::FILE* out, const VqFigures& f) {
  fmt::print(out, "{:<5} {:<14} {:>8} {:>9} {:>9} {:>9} {:>9} {:>10} {:>10} {:>10}\n", "", "encoder", "lost",
             "% of O+T", "% < paper", "> bound", "savings %", "ms, median", "ms, most", "x paper's");
  const Sums sums_2(f.rows, false), sums_4(f.rows, true);
  for (const Vq2Encoder e : all_vq2) print_encoder(out, f, "VQ2", e, Vq2Encoder::paper, sums_2);
  for (const Vq4Encoder e : all_vq4) print_encoder(out, f, "VQ4", e, Vq4Encoder::paper, sums_4);
}

std::string name_of(std::uint32_t transforms) {
  constexpr const char* names[] = {"identity",   "R90",         "reflect TB", "reflect X=-Y",
                                   "reflect LR", "reflect X=Y", "R180",       "R270"};
  return fmt::format("TR {}, BL {}, BR {}", names[transforms & 7], names[transforms >> 3 & 7],
                     names[transforms >> 6 & 7]);
}

template <class Encoder>
void print_transforms(std::FILE* out, const std::vector<VqRow>& rows, const char* codec, Encoder e) {
  const auto counts = bench::transform_counts(rows, [e](const VqRow& row) { return row.by(e).transforms; });
  const auto once = std::count_if(counts.begin(), counts.end(), [](const auto& c) { return c.second == 1; });
  fmt::print(out, "{:<5} {:<14} {} of 512 combinations, {} of them once; most often, {} of {}: {}\n", codec,
             bench::to_string(e), counts.size(), once, counts.front().second, rows.size(),
             name_of(counts.front().first));
}

void print_decoding(std::FILE* out, const char* codec, const VqDecodeTimes& t) {
  fmt::print(out, "{:<5} whole map {:.0f} ns, {:.1f}x as fast as region after region; one region {:.1f} ns\n",
             codec, t.map_ns, t.map_by_regions_ns / t.map_ns, t.region_ns);
}

template <class Encoder>
Json encoded_json(const VqRow& row, Encoder e) {
  const bench::VqEncoded& by = row.by(e);
  return {{"encoder", bench::to_string(e)},
          {"substitutions", by.substitutions},
          {"savings", row.savings(e)},
          {"transforms", {by.transforms & 7, by.transforms >> 3 & 7, by.transforms >> 6 & 7}},
          {"ms", by.ms},
          {"times_paper", by.ms / row.by(Encoder::paper).ms}};
}

Json vq_json(const VqRow& row) {
  Json j{{"map", std::filesystem::path(row.of).filename().string()},
         {"states_16", row.states_16},
         {"states_32", row.states_32},
         {"discontinuous_vectors", row.discontinuous},
         {"savings",
          {{"64x2", row.savings_64x2},
           {"8x8", row.savings_8},
           {"16x16", row.savings_16},
           {"32x32", row.savings_32}}},
         {"vq2", Json::array()},
         {"vq4", Json::array()},
         {"vq2_bound", row.by(Vq2Encoder::optimal).substitutions},
         {"vq4_bound", row.least}};
  for (const Vq2Encoder e : all_vq2) j["vq2"].push_back(encoded_json(row, e));
  for (const Vq4Encoder e : all_vq4) j["vq4"].push_back(encoded_json(row, e));
  return j;
}

Json vq_json(const VqDecodeTimes& t) {
  return {{"map_ns", t.map_ns},
          {"map_by_regions_ns", t.map_by_regions_ns},
          {"region_ns", t.region_ns},
          {"ratio_regions_to_map", t.map_by_regions_ns / t.map_ns}};
}

Json vq_json(const VqFigures& figures, const VqBenchOptions& options) {
  Json j{{"schema", "mmverify.bench/1"},
         {"topic", "vq"},
         {"tool", tool({{"seed", options.seed},
                        {"rounds", options.rounds},
                        {"maps", options.textures.empty() ? "generated" : "textures"}})},
         {"left_out", figures.left_out},
         {"decode", {{"vq2", vq_json(figures.vq2)}, {"vq4", vq_json(figures.vq4)}}},
         {"rows", Json::array()}};
  for (const VqRow& row : figures.rows) j["rows"].push_back(vq_json(row));
  return j;
}

}  // namespace

BenchOutput bench_vq(const VqBenchOptions& given, bool quiet, std::FILE* out) {
  VqBenchOptions options = given;
  options.progress = [quiet](const std::string& what) {
    if (proofs::interrupted()) throw proofs::Interrupted();
    if (!quiet) fmt::print(stderr, "bench vq: {}\n", what);
  };
  VqFigures figures;
  try {
    figures = vq_figures(options);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  if (proofs::interrupted()) throw proofs::Interrupted();
  const std::vector<VqRow>& rows = figures.rows;
  std::uint32_t discontinuous = 0;
  for (const VqRow& row : rows) discontinuous += row.discontinuous;
  fmt::print(
      out,
      "vq, {} maps {}, exact coverage at alpha 1/2, one thread; {} vectors with O beside T\n\n"
      "O and T that became C. paper: Algorithms 1 and 2 as printed; highest: vectors with more C first; C "
      "free: the all-C\npartition takes no entry. bound: no block of VQ4 loses fewer; of VQ2, optimal is the "
      "bound\n",
      rows.size(),
      options.textures.empty() ? fmt::format("generated from seed {}", options.seed) : "of alpha textures",
      discontinuous);
  print_rows(out, rows);
  if (figures.left_out > 0)
    fmt::print(out, "left out: {} textures with no texel of alpha 1/2 or more\n", figures.left_out);
  fmt::print(out, "\nAll maps together, beside the paper's encoder of the same run\n");
  print_encoders(out, figures);
  fmt::print(out,
             "\nMean savings without a codec: 64 sub-triangles twice (256 bits) {:.2f} %, 16x16 (512 bits) "
             "{:.2f} %, "
             "32x32 (2048 bits)\n{:.2f} %, 8x8 {:.2f} %\n\nTransforms\n",
             100 * mean(rows, &VqRow::savings_64x2), 100 * mean(rows, &VqRow::savings_16),
             100 * mean(rows, &VqRow::savings_32), 100 * mean(rows, &VqRow::savings_8));
  for (const Vq2Encoder e : all_vq2) print_transforms(out, rows, "VQ2", e);
  for (const Vq4Encoder e : {Vq4Encoder::paper, Vq4Encoder::balanced, Vq4Encoder::proved})
    print_transforms(out, rows, "VQ4", e);
  fmt::print(out, "\nDecoding\n");
  print_decoding(out, "VQ2", figures.vq2);
  print_decoding(out, "VQ4", figures.vq4);
  return {vq_json(figures, options).dump(1) + "\n", vq_plot_script(figures)};
}

}  // namespace mmverify::cli
