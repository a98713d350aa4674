// The table of docs/ERRATA.md: what each reading of the paper comes to, made by running it.
//   errata_table            prints it
//   errata_table --update F puts it between the marks of F
//   errata_table --check F  fails where F says something else
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "proofs/engine/runner.hpp"
#include "proofs/registry.hpp"

namespace {

using namespace mmverify::proofs;

constexpr Level last_level = 6;
constexpr char begin_mark[] = "<!-- errata_table: begin -->\n", end_mark[] = "<!-- errata_table: end -->\n";

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

std::string table() {
  std::string text =
      "| subject | level | verdict | vertices wrong | edges wrong | interiors wrong | simplest "
      "counterexample |\n"
      "|---|---|---|---|---|---|---|\n";
  const Law& law = *find_law("index.equals_reference");
  for (const char* subject : {"step", "step-appendix-middle", "step-appendix-ties", "step-appendix-names"})
    for (Level n = 0; n <= last_level; ++n) text += row(run_level(law, *find_subject(subject), n, Run{}));
  return text;
}

std::string read(const char* path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1) {
    fmt::print("{}", table());
    return 0;
  }
  const bool update = argc == 3 && std::strcmp(argv[1], "--update") == 0,
             check = argc == 3 && std::strcmp(argv[1], "--check") == 0;
  if (!update && !check) {
    fmt::print(stderr, "usage: errata_table [--update FILE | --check FILE]\n");
    return 2;
  }
  std::string text = read(argv[2]);
  const auto begin = text.find(begin_mark), end = text.find(end_mark);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    fmt::print(stderr, "{}: the marks of the table are missing\n", argv[2]);
    return 4;
  }
  const auto from = begin + std::strlen(begin_mark);
  const std::string right = table();
  if (text.substr(from, end - from) == right) return 0;
  if (check) {
    fmt::print(stderr,
               "{}: the table is not what the proofs find; if the change is meant, run ./run errata\n",
               argv[2]);
    return 1;
  }
  text.replace(from, end - from, right);
  std::ofstream(argv[2]) << text;
  return 0;
}
