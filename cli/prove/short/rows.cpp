#include "cli/prove/short/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "cli/arguments/arguments.hpp"
#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

using namespace proofs;

namespace {

/// The sum of a count over the row's results.
std::uint64_t sum(const Row& row, std::uint64_t (Result::*count)() const) {
  std::uint64_t all = 0;
  for (const Result* r : row.judged) all += (r->*count)();
  return all;
}

std::string cases_text(const Row& row) {
  const Result& first = *row.first;
  const std::string cases = grouped(sum(row, &Result::cases_run));
  const std::uint64_t wrong = sum(row, &Result::mismatches);
  std::string text = wrong == 0 ? cases + " cases"
                                : fmt::format("{} of {} {}", grouped(wrong), cases,
                                              first.proof.empty() ? "cases wrong" : "statements not proved");
  if (row.verdict != Verdict::proved && first.method.starts_with("sample")) text += ", a sample";
  if (row.verdict == Verdict::proved && !first.proof.empty()) text += ", by " + first.proof;
  if (const std::uint64_t n = sum(row, &Result::declined); n != 0) text += ", declined: " + grouped(n);
  if (const std::uint64_t n = sum(row, &Result::allowed); n != 0) text += ", allowed: " + grouped(n);
  std::size_t breaks = 0;
  for (const Result* r : row.judged) breaks += r->breaks.size();
  if (breaks != 0) text += ", without an answer: " + grouped(breaks);
  if (row.verdict == Verdict::incomplete) text += ": " + row.judged.back()->reason;
  return text;
}

}  // namespace

bool Row::is_fault() const {
  return verdict == Verdict::broken || verdict == Verdict::refuted || verdict == Verdict::incomplete;
}

std::string levels_of(const Row& row) {
  if (!row.first->at_once.empty()) return row.first->at_once;
  std::set<Level> all, named;
  for (const Result* r : row.judged) {
    all.insert(r->level);
    if (!row.is_fault() || r->verdict == row.verdict) named.insert(r->level);
  }
  const std::string word = named.size() == 1 ? "level" : "levels";
  const auto ranges = [](const std::set<Level>& some) { return level_ranges({some.begin(), some.end()}); };
  return fmt::format("{} {}{}", word, ranges(named), named == all ? "" : " of " + ranges(all));
}

std::vector<Row> rows_of(const Report& report) {
  std::vector<Row> rows;
  for (const Result& r : report.results) {
    const auto same = [&](const Row& row) {
      return row.first->law == r.law && row.first->subject == r.subject;
    };
    auto row = std::find_if(rows.begin(), rows.end(), same);
    if (row == rows.end()) row = rows.insert(rows.end(), Row{&r, {}, Verdict::not_applicable});
    if (r.verdict == Verdict::not_applicable) continue;
    row->judged.push_back(&r);
    row->verdict = weaker(row->verdict, r.verdict);
  }
  return rows;
}

std::string row_line(const Row& row, bool name_subject) {
  const std::string subject = name_subject ? fmt::format("{:<20} ", row.first->subject) : "";
  return fmt::format("{:<10} {:<32} {}{:<22} {}", to_string(row.verdict), row.first->law, subject,
                     levels_of(row), cases_text(row));
}

std::string count_of_laws(const std::vector<Row>& rows) {
  std::map<std::string, Verdict> of_laws;
  for (const Row& row : rows) {
    const auto [law, is_new] = of_laws.try_emplace(row.first->law, row.verdict);
    if (!is_new) law->second = weaker(law->second, row.verdict);
  }
  std::string text;
  for (const Verdict v :
       {Verdict::broken, Verdict::refuted, Verdict::incomplete, Verdict::proved, Verdict::checked}) {
    const auto n =
        std::count_if(of_laws.begin(), of_laws.end(), [v](const auto& law) { return law.second == v; });
    if (n == 0) continue;
    text += text.empty() ? fmt::format("{} {} {}", n, n == 1 ? "law" : "laws", to_string(v))
                         : fmt::format(", {} {}", n, to_string(v));
  }
  return text;
}

std::vector<std::string> topic_lines(const std::vector<Row>& rows) {
  std::vector<std::string> lines, topics;
  for (const Row& row : rows)
    if (std::find(topics.begin(), topics.end(), row.first->topic) == topics.end())
      topics.push_back(row.first->topic);
  for (const std::string& topic : topics) {
    std::vector<Row> of_topic;
    std::set<std::string> subjects;
    std::uint64_t cases = 0;
    bool are_statements = false;
    for (const Row& row : rows) {
      if (row.first->topic != topic || row.is_fault() || row.judged.empty()) continue;
      of_topic.push_back(row);
      subjects.insert(row.first->subject);
      cases += sum(row, &Result::cases_run);
      are_statements = are_statements || row.first->proof.starts_with("SAT");
    }
    if (of_topic.empty()) continue;
    lines.push_back(fmt::format("{:<10} {:<32} {:<22} {} {}", topic, count_of_laws(of_topic),
                                fmt::format("{} subject{}", subjects.size(), subjects.size() == 1 ? "" : "s"),
                                grouped(cases), are_statements ? "statements" : "cases"));
  }
  return lines;
}

}  // namespace mmverify::cli
