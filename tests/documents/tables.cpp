// The tables of docs/ that are computed, each between marks that name it, and docs/PAPERS.md, which is computed whole.
//   document_tables            prints them
//   document_tables --update   puts them into docs/
//   document_tables --check    fails where docs/ says something else
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "bench/papers/page.hpp"
#include "delivery/vectors/families.hpp"
#include "delivery/vectors/forms/forms.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "proofs/engine/kinds.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/micromap/maps.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/traverse/combinations.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/vuids.hpp"

namespace {

using namespace mmverify::proofs;

// ---- Verdicts on each reading of the paper

std::string row(const Result& r) {
  const auto cell = [&](Kind kind) {
    const Count& c = r.by_kind[static_cast<std::size_t>(kind)];
    return fmt::format("{} / {}", c.mismatches, c.cases);
  };
  std::string first = "-";
  if (!r.counterexamples.empty()) {
    const Counterexample& c = r.counterexamples.front();
    first = fmt::format("{}: {}, got {}", c.at, c.expected, c.got);
  }
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", r.subject, r.level, to_string(r.verdict),
                     cell(Kind::vertex), cell(Kind::edge), cell(Kind::interior), first);
}

std::string readings() {
  constexpr Level last_level = 6;
  std::string text =
      "| subject | level | verdict | vertices wrong | edges wrong | interiors wrong | simplest "
      "counterexample |\n"
      "|---|---|---|---|---|---|---|\n";
  const Law& law = *find_law("index.equals_reference");
  for (const char* subject :
       {"step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names", "step-restarted"})
    for (Level n = 0; n <= last_level; ++n) text += row(run_level(law, *find_subject(subject), n, Run{}));
  return text;
}

// ---- The cost of one bit a state

/// -sum p log2 p, in bits.
double entropy(const mmverify::impl::micromap::StateCounts& states, double all) {
  double bits = 0;
  for (const std::uint64_t n : states)
    if (n != 0) bits -= static_cast<double>(n) / all * std::log2(static_cast<double>(n) / all);
  return bits;
}

std::string modes() {
  namespace micromap = mmverify::impl::micromap;
  constexpr std::uint64_t seed = 1, discs = 40;
  std::string text =
      "| level | T | O | C | asks in 4-state | in T/C | in O/C | entropy, bits a state |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const Level n : {3u, 5u, 7u, 9u}) {
    micromap::StateCounts sum{};
    for (std::uint64_t k = 0; k < discs; ++k) {
      // Every tenth sample, from the fourth on, is a disc in four states.
      const mmverify::proofs::micromap::Map map = mmverify::proofs::micromap::sample_map(n, seed, 10 * k + 3);
      const auto states =
          micromap::count_states(map.packed, micromap::Format::four_state, micromap::micro_triangles(n));
      for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += states[s];
    }
    const auto all = static_cast<double>(discs * micromap::micro_triangles(n));
    const auto asks = [&](const micromap::Cost& cost) { return static_cast<double>(cost.any_hit) / all; };
    text += fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} |\n", n,
                        static_cast<double>(sum[0]) / all, static_cast<double>(sum[1]) / all,
                        static_cast<double>(sum[2] + sum[3]) / all, asks(micromap::cost(sum)),
                        asks(micromap::cost(sum, micromap::Mode::T_C)),
                        asks(micromap::cost(sum, micromap::Mode::O_C)), entropy(sum, all));
  }
  return text;
}

// ---- Decisions on a candidate hit

namespace flow = mmverify::spec::traverse;

/// The outcomes of all combinations that share a row and a column, which should be one.
using Cell = std::set<flow::Outcome>;

/// The state or flag that a decision starts from, before any flag overrides it.
std::string read_in(const flow::Combination& c) {
  if (!flow::consulted(c))
    return c.candidate.geometry_opaque ? "no micromap, opaque geometry" : "no micromap, geometry not opaque";
  const bool two = flow::two_state_override(c) && mmverify::spec::micromap::unknown(c.candidate.state);
  return fmt::format("{}{}", mmverify::spec::micromap::name_of(c.candidate.state),
                     two ? ", force-2-state" : "");
}

std::string forced_by(const flow::Instance& i) {
  return i.force_opaque ? "FORCE_OPAQUE" : i.force_no_opaque ? "FORCE_NO_OPAQUE" : "-";
}

std::string ray_of(const flow::Ray& r) {
  flow::Ray one = r;
  one.force_two_state = false;
  return traverse::flags_of(one);
}

/// The decision for every combination that an API defines; throws where combinations of one cell differ.
std::string decisions() {
  std::map<std::pair<std::string, std::string>, std::map<std::string, Cell>> rows;
  std::map<std::string, std::uint64_t> counts;
  for (const flow::Combination& c : traverse::defined()) {
    const auto key = std::pair(read_in(c), forced_by(c.instance));
    rows[key][ray_of(c.ray)].insert(flow::decide(c));
    ++counts[key.first + key.second];
  }
  std::string text =
      "| what is read | instance | no ray flag | Opaque | NoOpaque | CullOpaque | CullNoOpaque | "
      "combinations |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const char* read : {"no micromap, geometry not opaque", "no micromap, opaque geometry", "T", "O", "UT",
                           "UO", "UT, force-2-state", "UO, force-2-state"})
    for (const char* forced : {"-", "FORCE_OPAQUE", "FORCE_NO_OPAQUE"}) {
      text += fmt::format("| {} | {} |", read, forced);
      for (const char* ray : {"none", "opaque", "no-opaque", "cull-opaque", "cull-no-opaque"}) {
        const Cell& outcomes = rows.at({read, forced}).at(ray);
        if (outcomes.size() != 1)
          throw std::logic_error(fmt::format("{}, {}, {}: not one outcome", read, forced, ray));
        text += fmt::format(" {} |", flow::name_of(*outcomes.begin()));
      }
      text += fmt::format(" {} |\n", counts.at(std::string(read) + forced));
    }
  return text;
}

/// How many combinations of each way to trace are defined, and how many have each reason not to be.
std::string undefined_ones() {
  struct Row {
    std::uint64_t all = 0, defined = 0, ray_flags = 0, instance_flags = 0, not_enabled = 0;
  };
  std::map<std::pair<flow::Api, bool>, Row> rows;
  for (std::uint64_t k = 0; k < traverse::all_combinations; ++k) {
    const flow::Combination c = traverse::combination(k);
    const flow::Undefined u = flow::undefined(c);
    Row& row = rows[{c.api, !c.enabled}];
    ++row.all;
    row.defined += !u.any();
    row.ray_flags += u.ray_flags;
    row.instance_flags += u.instance_flags;
    row.not_enabled += u.not_enabled;
  }
  std::string text =
      "| API | set up for micromaps | combinations | defined | ray flags | instance flags | not enabled |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const auto& [way, r] : rows)
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", traverse::name_of(way.first),
                        way.second                    ? "no"
                        : flow::has_switch(way.first) ? "yes"
                                                      : "always",
                        r.all, r.defined, r.ray_flags, r.instance_flags, r.not_enabled);
  return text;
}

// ---- Findings in a file

std::string issues() {
  std::string text = "| code | severity | says | who says so | remedy |\n|---|---|---|---|---|\n";
  for (const mmverify::scene::Issue& i : mmverify::scene::issues())
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", i.code, name_of(i.severity), i.says, i.source,
                        i.remedy);
  return text;
}

/// The cases in which a VUID applies, in words.
std::string in_words(mmverify::scene::Cases when) {
  namespace cases = mmverify::scene::cases;
  constexpr std::pair<mmverify::scene::Cases, const char*> words[] = {
      {cases::array, "the array's counts"},
      {cases::geometry, "a geometry's counts"},
      {cases::two_state, "2-state"},
      {cases::four_state, "4-state"},
      {cases::null_micromap, "the null micromap"},
      {cases::has_records, "an array with records"},
      {cases::with_indices, "with an index buffer"},
      {cases::without_indices, "without an index buffer"}};
  std::string text;
  for (const auto& [one, word] : words)
    if ((when & one) != 0) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

std::string vuids() {
  std::string text = "| code | API | VUID | where | on the GPU |\n|---|---|---|---|---|\n";
  for (const mmverify::scene::Vuid& one : mmverify::scene::vuids())
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", one.code,
                        one.api == mmverify::impl::micromap::EXT ? "EXT" : "KHR", one.name,
                        in_words(one.when), one.missing_there ? "missing" : "");
  return text;
}

// ---- Files that mmverify vectors writes

std::string vector_families() {
  std::string text =
      "| family | version | tables, and their vectors | vectors | bytes |\n|---|---|---|---|---|\n";
  std::size_t all = 0, all_bytes = 0;
  for (const mmverify::vectors::FamilyRow& row : mmverify::vectors::families()) {
    const mmverify::vectors::Family family = row.make();
    std::string tables;
    std::size_t vectors = 0;
    for (const mmverify::vectors::Table& table : family.tables) {
      tables += fmt::format("{}`{}` {}", tables.empty() ? "" : ", ", table.name, table.records());
      vectors += table.records();
    }
    const std::size_t bytes = mmverify::vectors::payload(family).size();
    text +=
        fmt::format("| `{}` | {} | {} | {} | {} |\n", family.name, family.version, tables, vectors, bytes);
    all += vectors;
    all_bytes += bytes;
  }
  return text + fmt::format("| all | | | {} | {} |\n", all, all_bytes);
}

std::string papers() {
  mmverify::bench::papers::Measured measured({});
  return mmverify::bench::papers::index(measured);
}

// ---- Into the documents

struct Table {
  const char *name, *document;  ///< an empty name: the whole document
  std::string (*make)();
};
constexpr Table tables[] = {{"readings", MMVERIFY_DOCS "/ERRATA.md", readings},
                            {"modes", MMVERIFY_DOCS "/MICROMAP.md", modes},
                            {"decisions", MMVERIFY_DOCS "/TRAVERSE.md", decisions},
                            {"undefined", MMVERIFY_DOCS "/TRAVERSE.md", undefined_ones},
                            {"issues", MMVERIFY_DOCS "/ISSUES.md", issues},
                            {"vuids", MMVERIFY_DOCS "/ISSUES.md", vuids},
                            {"vectors", MMVERIFY_DOCS "/VECTORS.md", vector_families},
                            {"", MMVERIFY_DOCS "/PAPERS.md", papers}};

std::string read(const char* path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The document with the table as it is now; empty where the marks are missing.
std::string renewed(std::string text, const Table& table) {
  if (*table.name == 0) return table.make();
  const std::string begin = fmt::format("<!-- table {} -->\n", table.name), end = "<!-- end of table -->\n";
  const auto from = text.find(begin);
  const auto to = text.find(end, from == std::string::npos ? from : from + begin.size());
  if (from == std::string::npos || to == std::string::npos) return {};
  return text.replace(from + begin.size(), to - from - begin.size(), table.make());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view asked = argc == 2 ? argv[1] : "";
  if (argc > 2 || (argc == 2 && asked != "--update" && asked != "--check")) {
    fmt::print(stderr, "usage: document_tables [--update | --check]\n");
    return 2;
  }
  int code = 0;
  for (const Table& table : tables) {
    if (argc == 1) {
      fmt::print("{}\n", table.make());
      continue;
    }
    const std::string before = read(table.document), after = renewed(before, table);
    if (after.empty()) {
      fmt::print(stderr, "{}: the marks of table {} are missing\n", table.document, table.name);
      code = 4;
    } else if (before != after && asked == "--check") {
      fmt::print(stderr, "{}: {} {} is not what is computed; if the change is meant, run ./run tables\n",
                 table.document, *table.name == 0 ? "the page" : "table", table.name);
      code = 1;
    } else if (before != after) {
      std::ofstream(table.document) << after;
    }
  }
  return code;
}
