#include "cli/prove/short/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/arguments/arguments.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/short/faults.hpp"
#include "cli/prove/short/rows.hpp"
#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

using namespace proofs;

namespace {

using Lines = std::vector<std::string>;

void append(Lines& lines, const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); }

constexpr std::size_t most_notes = 4;
constexpr const char more_in_details[] = "(--details names them)";

/// The rows of each subject.
std::vector<std::vector<Row>> by_subject(const std::vector<Row>& rows) {
  std::vector<std::vector<Row>> all;
  for (const Row& row : rows) {
    auto found = std::find_if(all.begin(), all.end(), [&](const std::vector<Row>& one) {
      return one.front().first->subject == row.first->subject;
    });
    if (found == all.end()) found = all.insert(all.end(), std::vector<Row>{});
    found->push_back(row);
  }
  return all;
}

bool has_fault(const std::vector<Row>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.is_fault(); });
}

/// The subjects, those with faults first. A later subject whose faults do not fit gets one line.
Lines subjects_with_faults(const Report& report, const std::vector<Row>& rows,
                           const std::vector<SubjectPtr>& subjects) {
  constexpr std::size_t most = 14;
  std::vector<std::vector<Row>> all = by_subject(rows);
  // A run of the laws' own subjects names only subjects with a fault.
  const bool any = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return !row.judged.empty(); });
  if (subjects.empty() && all.size() > 1 && any)
    std::erase_if(all, [](const auto& one) { return !has_fault(one); });
  std::stable_partition(all.begin(), all.end(), has_fault);
  Lines lines;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (lines.size() + 1 >= most) {
      lines.push_back(fmt::format("{} more subjects {}", all.size() - k, more_in_details));
      break;
    }
    const std::string& name = all[k].front().first->subject;
    const auto asked = std::find_if(subjects.begin(), subjects.end(),
                                    [&](const SubjectPtr& s) { return s->name() == name; });
    Lines of_one = subject_lines(all[k], asked == subjects.end() ? nullptr : asked->get(), report.diagnoses);
    if (lines.size() + of_one.size() > most) of_one.resize(lines.empty() ? most : 1);
    append(lines, of_one);
  }
  if (lines.empty()) lines.push_back(fmt::format("nothing is refuted: {}", count_of_laws(rows)));
  return lines;
}

/// The rows that judged something within `most` lines: each a line, or faults first and topics counted.
Lines law_lines(const std::vector<Row>& rows, std::size_t most) {
  std::vector<Row> judged;
  std::set<std::string> subjects;
  for (const Row& row : rows)
    if (!row.judged.empty()) {
      judged.push_back(row);
      subjects.insert(row.first->subject);
    }
  const auto faults =
      std::stable_partition(judged.begin(), judged.end(), [](const Row& r) { return r.is_fault(); });
  const auto lines_of = [&](std::size_t count) {
    Lines lines;
    for (std::size_t k = 0; k < count; ++k) lines.push_back(row_line(judged[k], subjects.size() > 1));
    return lines;
  };
  if (judged.size() <= most) return lines_of(judged.size());
  const auto weak = static_cast<std::size_t>(faults - judged.begin());
  const Lines topics = topic_lines(judged);
  const std::size_t left = most > topics.size() ? most - topics.size() : 0;
  Lines lines = lines_of(weak <= left ? weak : left == 0 ? 0 : left - 1);
  if (lines.size() < weak)
    lines.push_back(fmt::format("{} more such laws {}", weak - lines.size(), more_in_details));
  append(lines, topics);
  return lines;
}

/// Laws that do not apply, or that have no case in this shard, counted.
Lines left_out_lines(const std::vector<Row>& rows) {
  std::set<std::string> judged, empty, unfit;
  const Row* last = nullptr;
  for (const Row& row : rows)
    if (!row.judged.empty()) judged.insert(row.first->law);
  for (const Row& row : rows) {
    if (judged.contains(row.first->law)) continue;
    (row.first->share ? empty : unfit).insert(row.first->law);
    if (!row.first->share) last = &row;
  }
  Lines lines;
  if (judged.empty()) return lines;
  if (unfit.size() == 1)
    lines.push_back(fmt::format("{} does not apply: {}", last->first->law, last->first->reason));
  if (unfit.size() > 1)
    lines.push_back(fmt::format("{} laws do not apply {}", unfit.size(), more_in_details));
  if (!empty.empty())
    lines.push_back(fmt::format("{} laws have no case in this shard {}", empty.size(), more_in_details));
  return lines;
}

/// Mutants that survived: their laws cannot fail, so their verdicts are worth nothing.
Lines survivors(const Report& report) {
  constexpr std::size_t most = 2;
  Lines lines;
  for (const MutantResult& m : report.mutants)
    if (!m.killed && lines.size() < most) lines.push_back(fmt::format("SURVIVED {}: {}", m.law, m.mutant));
  return lines;
}

Lines resumed_line(const Report& report) {
  std::uint64_t resumed = 0;
  for (const Result& r : report.results) resumed += r.resumed;
  if (resumed == 0) return {};
  return {fmt::format("resumed: {} of these cases, taken from the journal", grouped(resumed))};
}

}  // namespace

std::vector<std::string> short_answer(const Report& report, const std::vector<SubjectPtr>& subjects,
                                      const Lines& first, const Lines& last) {
  const std::vector<Row> rows = rows_of(report);
  Lines lines(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(std::min(first.size(), most_notes)));
  append(lines, subjects_with_faults(report, rows, subjects));
  Lines end = left_out_lines(rows);
  append(end, survivors(report));
  append(end, resumed_line(report));
  append(end, last);
  end.push_back(sum_line(report));
  append(lines, law_lines(rows, most_lines - std::min(most_lines, lines.size() + end.size())));
  append(lines, end);
  return lines;
}

}  // namespace mmverify::cli
