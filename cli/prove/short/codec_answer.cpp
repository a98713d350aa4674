#include "cli/prove/short/codec_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "cli/arguments/arguments.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/short/answer.hpp"
#include "cli/prove/short/rows.hpp"

namespace mmverify::cli {

using namespace proofs;

namespace {

using Lines = std::vector<std::string>;

constexpr std::array<std::string_view, 2> formats{"2-state ", "4-state "};

/// The results that the row's verdict is of.
std::vector<const Result*> decisive(const Row& row) {
  std::vector<const Result*> all;
  for (const Result* r : row.judged)
    if (!row.is_fault() || r->verdict == row.verdict) all.push_back(r);
  return all;
}

/// ", 2-state and 4-state"; empty for a law of no format.
std::string formats_of(const Row& row) {
  std::string text;
  for (const std::string_view format : formats)
    for (const Result* r : decisive(row))
      if (r->domain.starts_with(format)) {
        text += (text.empty() ? ", " : " and ") + std::string(format.substr(0, format.size() - 1));
        break;
      }
  return text;
}

/// "every map, up to 4^16": the largest of the domains.
std::string domain_of(const Row& row) {
  std::string text = decisive(row).back()->domain;
  for (const std::string_view format : formats)
    if (text.starts_with(format)) text.erase(0, format.size());
  const std::size_t power = text.rfind(", ");
  if (decisive(row).size() > 1 && power != std::string::npos && text.find('^', power) != std::string::npos)
    text.insert(power + 2, "up to ");
  return text;
}

/// "SAT; SAT, by contract": the ways of the proofs, in their order.
std::string proofs_of(const Row& row) {
  std::vector<std::string> all;
  for (const Result* r : row.judged)
    if (std::find(all.begin(), all.end(), r->proof) == all.end()) all.push_back(r->proof);
  return fmt::format("{}", fmt::join(all, "; "));
}

std::string law_line(const Row& row) {
  double seconds = 0;
  std::uint64_t cases = 0;
  for (const Result* r : row.judged) {
    seconds += r->seconds;
    cases += r->cases_run();
  }
  const Result& last = *row.judged.back();
  const std::string what = last.proof.empty() ? fmt::format("{} cases, a sample", grouped(cases))
                                              : fmt::format("{} ({})", domain_of(row), proofs_of(row));
  return fmt::format("{:<9} {} {} {}{}: {} {:.1f} s", codec_verdict(row.verdict, last.reason), last.law,
                     last.subject, levels_of(row), formats_of(row), what, seconds);
}

/// Below a law's line: the first case and the command that runs it again, or the reason why nothing is settled.
Lines lines_below(const Row& row) {
  if (!row.is_fault()) return {};
  const Result& r = *decisive(row).front();
  if (r.counterexamples.empty()) return {"  " + r.reason};
  const Counterexample& c = r.counterexamples.front();
  return {fmt::format("  case {}: {}", c.at, codec_case(c)), "  replay: " + replay_command(r, c)};
}

/// Laws that are not judged, by reason; and levels of laws that are judged elsewhere.
Lines not_judged(const Report& report, const std::vector<Row>& rows) {
  constexpr std::size_t most = 5;
  std::vector<std::pair<std::string, std::set<std::string>>> laws_of;
  std::map<std::string, std::string> level_of;
  for (const Result& r : report.results) {
    if (r.verdict != Verdict::not_applicable) continue;
    const bool judged_elsewhere = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      return !row.judged.empty() && row.first->law == r.law;
    });
    const std::string at = r.at_once.empty() ? fmt::format(" level {}", r.level) : "";
    const std::string name = fmt::format("{} {}{}", r.law, r.subject, judged_elsewhere ? at : "");
    auto found =
        std::find_if(laws_of.begin(), laws_of.end(), [&](const auto& one) { return one.first == r.reason; });
    if (found == laws_of.end()) found = laws_of.insert(found, {r.reason, {}});
    found->second.insert(name);
  }
  Lines lines;
  for (const auto& [reason, names] : laws_of) {
    if (lines.size() + 1 == most && laws_of.size() > most) {
      lines.push_back(
          fmt::format("{:<9} {} more reasons (--details names them)", "n/a", laws_of.size() - lines.size()));
      break;
    }
    lines.push_back(fmt::format("{:<9} {}{}: {}", "n/a", *names.begin(),
                                names.size() == 1 ? "" : fmt::format(" and {} more", names.size() - 1),
                                reason));
  }
  return lines;
}

std::size_t count(const std::vector<Lines>& blocks) {
  std::size_t all = 0;
  for (const Lines& block : blocks) all += block.size();
  return all;
}

}  // namespace

std::string codec_case(const Counterexample& c) {
  return c.expected == "the law" ? c.got : fmt::format("expected {} got {}", c.expected, c.got);
}

std::string codec_verdict(Verdict verdict, const std::string& reason) {
  return verdict == Verdict::incomplete && reason != "interrupted" ? "unknown" : to_string(verdict);
}

std::vector<std::string> codec_answer(const Report& report, const Lines& last) {
  const std::vector<Row> rows = rows_of(report);
  std::vector<Lines> faults, others;
  for (const Row& row : rows) {
    if (row.judged.empty()) continue;
    Lines block{law_line(row)};
    for (const std::string& line : lines_below(row)) block.push_back(line);
    (row.is_fault() ? faults : others).push_back(std::move(block));
  }
  Lines end = not_judged(report, rows);
  end.insert(end.end(), last.begin(), last.end());
  end.push_back(sum_line(report));
  const std::size_t room = most_lines - end.size();
  if (count(faults) + count(others) > room) {
    const Lines topics = topic_lines(rows);
    if (topics.size() < others.size()) others.assign(1, topics);
  }
  // The last faults lose what is below their lines.
  for (auto block = faults.rbegin(); block != faults.rend() && count(faults) + count(others) > room; ++block)
    block->resize(1);
  Lines lines;
  for (const std::vector<Lines>* part : {&faults, &others})
    for (const Lines& block : *part) lines.insert(lines.end(), block.begin(), block.end());
  if (lines.size() > room) {
    const std::size_t more = lines.size() - (room - 1);
    lines.resize(room - 1);
    lines.push_back(fmt::format("{} more lines (--details prints them)", more));
  }
  lines.insert(lines.end(), end.begin(), end.end());
  return lines;
}

}  // namespace mmverify::cli
