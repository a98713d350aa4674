#include "proofs/certificate/statements.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "proofs/certificate/checker.hpp"

namespace mmverify::proofs::certificate {
namespace {

using Clause = std::vector<int>;

bool is_statement(char kind) { return kind == 'm' || kind == 'o'; }

/// The clauses of a line of the circuit, or of a statement that is believed.
std::vector<Clause> clauses_of(char kind, const std::vector<int>& numbers) {
  if (kind == 'i') return {};
  if (kind == 'f') return {{-numbers[0]}};
  if (kind != 'n') return {numbers};
  const int v = numbers[0], a = numbers[1], b = numbers[2];
  return {{-v, a}, {-v, b}, {v, -a, -b}};
}

void write(std::ostream& out, int variables, const std::vector<Clause>& clauses) {
  out << "p cnf " << variables << " " << clauses.size() << "\n";
  for (const Clause& clause : clauses) {
    for (const int l : clause) out << l << " ";
    out << "0\n";
  }
}

void append(std::vector<Clause>& all, const std::vector<Clause>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

Statements::Statements(std::istream& certificate) {
  constexpr std::string_view kinds = "ifnamo";
  std::size_t number = 0;
  for (std::string text; std::getline(certificate, text);) {
    ++number;
    if (text.empty() || kinds.find(text[0]) == std::string_view::npos) continue;
    Line line{text[0], {}};
    std::istringstream words(text.substr(1));
    int n = 0;
    while (words >> n && n != 0) line.numbers.push_back(n);
    const std::size_t least = line.kind == 'n' ? 3 : 1;
    if (n != 0 || !words || line.numbers.size() < least)
      throw NotValid("line " + std::to_string(number) + ": a step is numbers with a 0 at the end");
    for (const int l : line.numbers) variables_ = std::max(variables_, std::abs(l));
    if (is_statement(line.kind)) statements_.push_back(lines_.size());
    lines_.push_back(std::move(line));
  }
}

void Statements::write_one(std::ostream& out, std::size_t k) const {
  std::vector<Clause> clauses;
  for (std::size_t at = 0; at < statements_[k]; ++at)
    append(clauses, clauses_of(lines_[at].kind, lines_[at].numbers));
  for (const int l : lines_[statements_[k]].numbers) clauses.push_back({-l});
  write(out, variables_, clauses);
}

void Statements::write_all(std::ostream& out) const {
  std::vector<Clause> clauses;
  Clause some_is_false;
  int variables = variables_;
  for (const Line& line : lines_) {
    if (!is_statement(line.kind)) {
      append(clauses, clauses_of(line.kind, line.numbers));
      continue;
    }
    // A new variable: true only if the statement is false.
    some_is_false.push_back(++variables);
    for (const int l : line.numbers) clauses.push_back({-variables, -l});
  }
  clauses.push_back(some_is_false);
  write(out, variables, clauses);
}

}  // namespace mmverify::proofs::certificate
