#include "proofs/induction/statement.hpp"

#include <algorithm>
#include <utility>

namespace mmverify::proofs::induction {
namespace {

constexpr std::size_t line_width = 100;
// A formula shorter than this reads better where it stands than under a name.
constexpr std::size_t worth_a_name = 48;

/// Breaks `(head a b c)` into lines where it is too long for one.
std::string laid_out(const std::string& text, std::size_t indent) {
  if (text.size() + indent <= line_width || text.front() != '(') return text;
  std::vector<std::string> parts;
  std::size_t start = 1, depth = 0;
  for (std::size_t k = 1; k + 1 < text.size(); ++k) {
    if (text[k] == '(') ++depth;
    if (text[k] == ')') --depth;
    if (text[k] != ' ' || depth != 0) continue;
    parts.push_back(text.substr(start, k - start));
    start = k + 1;
  }
  parts.push_back(text.substr(start, text.size() - 1 - start));
  std::string out = "(" + parts.front();
  // The condition of an ite, the name and the sort of a definition stay on the first line.
  const std::size_t kept = parts.front() == "define-fun" ? 4 : parts.front() == "ite" ? 2 : 1;
  for (std::size_t k = 1; k < parts.size(); ++k)
    out += k < kept ? " " + parts[k] : "\n" + std::string(indent + 2, ' ') + laid_out(parts[k], indent + 2);
  return out + ")";
}

std::string commented(const std::string& words) {
  std::string out;
  std::size_t start = 0;
  while (start < words.size()) {
    std::size_t end = words.find('\n', start);
    if (end == std::string::npos) end = words.size();
    if (end - start > line_width - 2) end = words.rfind(' ', start + line_width - 2);
    out += "; " + words.substr(start, end - start) + "\n";
    start = end + 1;
  }
  return out;
}

}  // namespace

std::string to_string(Answer a) {
  switch (a) {
    case Answer::unsat: return "unsat";
    case Answer::sat: return "sat";
    case Answer::unknown: return "unknown";
  }
  return "?";
}

Script::Script(std::string name, Answer expected, const std::string& claim)
    : name_(std::move(name)),
      head_(commented(claim) +
            "; Written by the program itself from the specification's templates (./run statements); a test "
            "compares.\n"),
      expected_(expected) {}

void Script::comment(const std::string& words) { body_ += "\n" + commented(words); }

Term Script::declare(const std::string& name, const std::string& sort) {
  body_ += "(declare-const " + name + " " + sort + ")\n";
  return {name, sort};
}

std::size_t Script::key(const Term& t) {
  if (const auto known = key_of_.find(t.id()); known != key_of_.end()) return known->second;
  std::string text = t.head();
  std::size_t length = t.head().size();
  for (const Term& part : t.of()) {
    const std::size_t k = key(part);
    text += " " + std::to_string(k);
    length += 1 + length_[k];
  }
  const std::size_t k = keys_.emplace(text + " : " + t.sort(), keys_.size()).first->second;
  length_[k] = length + (t.of().empty() ? 0 : 2);
  key_of_[t.id()] = k;
  alive_.push_back(t);
  return k;
}

void Script::count(const Term& t, std::map<std::size_t, int>& uses) {
  if (t.of().empty() || names_.count(key(t)) != 0) return;
  if (++uses[key(t)] > 1) return;
  for (const Term& part : t.of()) count(part, uses);
}

std::string Script::print(const Term& t, std::map<std::size_t, int>& uses) {
  if (t.of().empty()) return t.head();
  const std::size_t k = key(t);
  if (const auto name = names_.find(k); name != names_.end()) return name->second;
  std::string text = "(" + t.head();
  for (const Term& part : t.of()) text += " " + print(part, uses);
  text += ")";
  if (uses[k] < 2 || length_[k] < worth_a_name) return text;
  std::string name = "part_" + std::string(1, static_cast<char>('a' + helpers_ % 26));
  for (std::size_t rest = helpers_ / 26; rest > 0; rest = (rest - 1) / 26)
    name += static_cast<char>('a' + (rest - 1) % 26);
  ++helpers_;
  body_ += laid_out("(define-fun " + name + " () " + t.sort() + " " + text + ")", 0) + "\n";
  return names_[k] = name;
}

std::string Script::text_of(const Term& t) {
  std::map<std::size_t, int> uses;
  count(t, uses);
  return print(t, uses);
}

Term Script::define(const std::string& name, const Term& formula) {
  const std::string text = text_of(formula);
  body_ += laid_out("(define-fun " + name + " () " + formula.sort() + " " + text + ")", 0) + "\n";
  if (!formula.of().empty()) names_.emplace(key(formula), name);
  return {name, formula.sort()};
}

void Script::require(const Term& condition) {
  const std::string text = text_of(condition);
  body_ += laid_out("(assert " + text + ")", 0) + "\n";
}

Statement Script::denying(std::vector<Term> claims) {
  require(no(claims.size() == 1 ? claims.front() : both(std::move(claims))));
  return finish();
}

Statement Script::finish() {
  return {
      name_, expected_,
      head_ + "(set-logic ALL)\n(set-info :status " + to_string(expected_) + ")\n" + body_ + "(check-sat)\n"};
}

}  // namespace mmverify::proofs::induction
