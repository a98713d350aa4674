#include "cli/prove/short/faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/arguments/arguments.hpp"
#include "cli/output/text.hpp"
#include "proofs/index/in_characters.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {

using namespace proofs;

namespace {

constexpr std::size_t most_diagnoses = 4, most_faults = 2, most_errors = 5, most_of_a_case = 120;

/// The part of a law's name before its dot: laws of one family judge the same entry points.
std::string family(const Result& r) { return r.law.substr(0, r.law.find('.')); }

/// The row's lowest level with a counterexample; null if there is none.
const Result* refuted_at(const Row& row) {
  const auto found = std::find_if(row.judged.begin(), row.judged.end(),
                                  [](const Result* r) { return !r->counterexamples.empty(); });
  return found == row.judged.end() ? nullptr : *found;
}

/// The results whose counterexamples are shown: the first law of each family, as a fault that one law finds is
/// found by the laws after it. Laws of papers' claims come last.
std::vector<const Result*> shown_faults(const std::vector<Row>& rows) {
  std::vector<const Result*> shown;
  std::set<std::string> families;
  for (const bool of_papers : {false, true})
    for (const Row& row : rows) {
      const Result* r = refuted_at(row);
      if (r == nullptr || (family(*r) == "paper") != of_papers || (of_papers && !shown.empty())) continue;
      if (shown.size() < most_faults && families.insert(family(*r)).second) shown.push_back(r);
    }
  return shown;
}

/// The counterexample drawn, or the way to draw it; empty if it has no picture.
std::vector<std::string> drawing(const Result& r, const Counterexample& c, const Subject* subject) {
  if (auto lines = index::in_characters(r, c); !lines.empty()) return lines;
  const Law* law = find_law(r.law);
  if (subject == nullptr || law == nullptr || !law->replay || !r.replayed_by.empty()) return {};
  try {
    const Level level = r.at_once.empty() ? r.level : c.level;
    if (!law->replay(*subject, level, c.at).picture.empty())
      return {"  the same command with --picture wrong.svg draws it"};
  } catch (const std::exception&) {
    // A subject that breaks when asked again has no picture.
  }
  return {};
}

/// The first law's lowest level at which the subject broke; null if it never did.
const Result* first_break(const std::vector<Row>& rows) {
  for (const Row& row : rows)
    for (const Result* r : row.judged)
      if (r->verdict == Verdict::broken) return r;
  return nullptr;
}

std::string not_judged(const std::vector<Row>& rows) {
  std::set<std::string> reasons;
  for (const Row& row : rows) reasons.insert(row.first->reason);
  if (reasons.size() == 1) return *reasons.begin();
  return fmt::format("{} laws, none of which applies; {}: {}", rows.size(), rows.front().first->law,
                     rows.front().first->reason);
}

}  // namespace

std::vector<std::string> subject_lines(const std::vector<Row>& rows, const Subject* subject,
                                       const std::vector<Diagnosis>& diagnoses) {
  const std::string& name = rows.front().first->subject;
  Verdict verdict = Verdict::not_applicable;
  for (const Row& row : rows) verdict = weaker(verdict, row.verdict);
  if (verdict == Verdict::not_applicable) {
    std::vector<std::string> lines{fmt::format("subject {}: not judged: {}", name, not_judged(rows))};
    if (subject != nullptr && subject->absent().empty() && subject->topic() != rows.front().first->topic)
      lines.push_back(fmt::format("  its own laws: mmverify prove {} --subject {}", subject->topic(),
                                  shell_quoted(name)));
    return lines;
  }
  // A reader takes the word `checked` alone for a doubt.
  const std::string word = verdict == Verdict::checked ? "nothing is refuted" : to_string(verdict);
  std::vector<std::string> lines{fmt::format("subject {}: {} ({})", name, word, count_of_laws(rows))};
  for (const Diagnosis& d : diagnoses)
    for (const std::string& line : d.lines)
      if (d.subject == name && lines.size() <= most_diagnoses) lines.push_back("  " + line);
  if (const Result* r = first_break(rows); r != nullptr)
    lines.push_back(fmt::format("broken {} level {}: {}", r->law, r->level,
                                r->breaks.empty() ? r->reason : r->breaks.front()));
  bool is_drawn = false;
  for (const Result* r : shown_faults(rows)) {
    // --errors asks for more than one.
    for (std::size_t k = 0; k < std::min(most_errors, r->counterexamples.size()); ++k)
      lines.push_back(counterexample_line(*r, r->counterexamples[k], most_of_a_case));
    if (is_drawn) continue;
    const std::vector<std::string> drawn = drawing(*r, r->counterexamples.front(), subject);
    lines.insert(lines.end(), drawn.begin(), drawn.end());
    is_drawn = !drawn.empty();
  }
  return lines;
}

}  // namespace mmverify::cli
