#include "cli/output/text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "cli/arguments/arguments.hpp"
#include "cli/output/streams.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/registry/registry.hpp"
#include "subjects/dock/clean_text.hpp"

namespace mmverify::cli {

using namespace proofs;

namespace {
/// The level of a counterexample; a result about many levels has one for each counterexample.
Level level_of(const Result& result, const Counterexample& c) {
  return result.at_once.empty() ? result.level : c.level;
}
}  // namespace

std::string replay_command(const Result& result, const Counterexample& c) {
  if (!result.replayed_by.empty())
    return fmt::format("{} --case {}@{}", result.replayed_by, level_of(result, c), shell_quoted(c.at));
  const Law* law = find_law(result.law);
  const Level level = level_of(result, c);
  // The other answers to a law of several questions are not stored, so the replay shows the right one.
  if (result.subject == "standard input" && result.topic != "index")
    return fmt::format("mmverify replay {} --level {} --case {}", result.law, level, shell_quoted(c.at));
  if (result.subject == "standard input")
    return fmt::format("mmverify replay {} --level {} --case {} --answer {}", result.law, level,
                       shell_quoted(c.at), shell_quoted(c.got));
  if (law == nullptr || !law->replay)
    return fmt::format("mmverify prove {} --levels {} --subject {}", result.law, level,
                       shell_quoted(result.subject));
  return fmt::format("mmverify replay {} --level {} --case {} --subject {}", result.law, level,
                     shell_quoted(c.at), shell_quoted(result.subject));
}

std::string counterexample_line(const Result& result, const Counterexample& c, std::size_t most) {
  const std::string at =
      c.at.size() <= most ? c.at
                          : fmt::format("{}... ({} characters)", c.at.substr(0, most), grouped(c.at.size()));
  return fmt::format("refuted {} level {} case {}{} expected {} got {}   replay: {}", result.law,
                     level_of(result, c), at, c.hex.empty() ? "" : " " + c.hex, c.expected, c.got,
                     replay_command(result, c));
}

std::string sum_line(const Report& report) {
  std::map<Verdict, std::size_t> verdicts;
  double all = 0;
  for (const Result& r : report.results) {
    ++verdicts[r.verdict];
    all += r.seconds;
  }
  std::vector<std::string> parts;
  for (const auto& [verdict, count] : verdicts)
    parts.push_back(fmt::format("{} {}", count, to_string(verdict)));
  const auto killed = std::count_if(report.mutants.begin(), report.mutants.end(),
                                    [](const MutantResult& m) { return m.killed; });
  const std::string mutants = report.mutants.empty()
                                  ? "no mutants run"
                                  : fmt::format("{} of {} mutants killed", killed, report.mutants.size());
  return fmt::format("{} results: {}; {}; {:.1f} s on {} thread{}", report.results.size(),
                     fmt::join(parts, ", "), mutants, report.seconds != 0 ? report.seconds : all,
                     report.threads, report.threads == 1 ? "" : "s");
}

namespace {

std::string levels_text(const std::vector<Result>& results) {
  if (!results.front().at_once.empty()) return results.front().at_once;
  const Level first = results.front().level, last = results.back().level;
  return first == last ? fmt::format("level {}", first) : fmt::format("levels {}..{}", first, last);
}

/// The weakest verdict of one law on one subject.
Verdict verdict_of(const std::vector<Result>& results) { return weakest(results, results.front().subject); }

std::string by_kind(const Result& r) {
  return fmt::format("vertices {}, edges {}, interiors {}", grouped(r.by_kind[0].mismatches),
                     grouped(r.by_kind[1].mismatches), grouped(r.by_kind[2].mismatches));
}

}  // namespace

void TextReport::add(const Result& result) {
  if (!pending_.empty() && (pending_.front().law != result.law || pending_.front().subject != result.subject))
    flush();
  pending_.push_back(result);
  if (by_level_) flush();
}

void TextReport::note(const std::string& line) { say(out_, "{}\n", printable(line)); }

void TextReport::flush() {
  if (!pending_.empty()) line(pending_);
  pending_.clear();
}

void TextReport::line(const std::vector<Result>& results) {
  if (isatty(STDERR_FILENO) != 0) say(stderr, "\r\033[K");
  const Result& first = results.front();
  const Verdict verdict = verdict_of(results);
  std::uint64_t cases = 0, resumed = 0, declined = 0, allowed = 0;
  double seconds = 0;
  for (const Result& r : results) {
    cases += r.cases_run();
    resumed += r.resumed;
    declined += r.declined();
    allowed += r.allowed();
    seconds += r.seconds;
  }
  if (verdict == Verdict::not_applicable) {
    say(out_, "{:<10} {:<32} {:<20} {}\n", "n/a", first.law, first.subject, first.reason);
    return;
  }
  const std::string rate =
      seconds > 0.01 ? fmt::format("{:7.1f} M/s", static_cast<double>(cases - resumed) / seconds / 1e6) : "";
  std::string said = fmt::format("{:<10}", to_string(verdict));
  if (verdict == Verdict::proved && !first.proof.empty())
    said = fmt::format("{} ({})", to_string(verdict), first.proof);
  say(out_, "{:<43} {:<20} {:<13} {:>15} cases {:>7.2f} s {}\n", said + " " + first.law, first.subject,
      levels_text(results), grouped(cases), seconds, first.at_once.empty() ? rate : "");
  if (by_level_)
    say(out_, "           domain: {}; {}{}; digest {:016x}\n", first.domain, first.method,
        first.dialect.empty() ? "" : "; dialect: " + first.dialect, first.digest);
  if (declined != 0)
    say(out_, "           declined: {} of these cases, {}: not judged\n", grouped(declined),
        first.undecided.empty() ? "which the subject says it does not support" : first.undecided);
  if (allowed != 0)
    say(out_, "           allowed: {} of these answers, which differ from {} but count as right\n",
        grouped(allowed), first.dialect == "published" ? "the published code" : "exact arithmetic");
  if (resumed != 0)
    say(out_, "           resumed: {} of these cases, taken from the journal\n", grouped(resumed));
  for (const Result& r : results)
    if (by_level_ && r.share)
      say(out_, "           share: units {} to {} of {}\n", grouped(r.share->from), grouped(r.share->to),
          grouped(r.share->of));
  for (const Result& r : results) {
    if (r.mismatches() == 0) continue;
    if (r.at_once.empty())
      say(out_, "  level {}: {} of {} cases wrong ({})\n", r.level, grouped(r.mismatches()),
          grouped(r.cases_run()), by_kind(r));
    else
      say(out_, "  {}: {} of {} {}\n", r.at_once, grouped(r.mismatches()), grouped(r.cases_run()),
          r.proof.empty() ? "cases wrong" : "statements not proved");
    for (const Counterexample& c : r.counterexamples) say(out_, "{}\n", counterexample_line(r, c));
    if (!by_level_) break;
  }
  if (verdict == Verdict::incomplete) say(out_, "  {}\n", results.back().reason);
  for (const Result& r : results) say_breaks(r);
  std::fflush(out_);
}

void TextReport::say_breaks(const Result& r) const {
  constexpr std::size_t shown = 5;
  if (r.verdict == Verdict::broken && r.breaks.empty()) say(out_, "  {}\n", r.reason);
  for (std::size_t k = 0; k < std::min(shown, r.breaks.size()); ++k) say(out_, "  {}\n", r.breaks[k]);
  if (!r.breaks.empty())
    say(out_, "  level {}: no answer to {} of {} cases; the others are judged\n", r.level,
        grouped(r.breaks.size()), grouped(r.cases_run()));
}

void TextReport::print_mutants(const std::vector<MutantResult>& mutants) const {
  for (auto of_law = mutants.begin(); of_law != mutants.end();) {
    const auto next =
        std::find_if(of_law, mutants.end(), [&](const MutantResult& m) { return m.law != of_law->law; });
    const auto dead = std::count_if(of_law, next, [](const MutantResult& m) { return m.killed; });
    say(out_, "mutants    {:<32} {} of {} killed{}\n", of_law->law, dead, next - of_law,
        by_level_ ? ":" : "");
    for (; of_law != next; ++of_law) {
      if (!of_law->killed)
        say(out_, "  SURVIVED {}\n", of_law->mutant);
      else if (by_level_)
        say(out_, "  killed   {} (level {}, {})\n", of_law->mutant, of_law->level, of_law->at);
      else
        say(out_, "  {}\n", of_law->mutant);
    }
  }
}

void TextReport::finish(const Report& report, bool name_subjects) {
  flush();
  print_mutants(report.mutants);
  for (const Diagnosis& d : report.diagnoses) {
    say(out_, "what {} does instead ({}):\n", d.subject, d.law);
    for (const std::string& line : d.lines) say(out_, "  {}\n", line);
  }
  if (name_subjects) {
    std::vector<std::string> named;
    for (const Result& r : report.results) {
      if (std::find(named.begin(), named.end(), r.subject) != named.end()) continue;
      named.push_back(r.subject);
      say(out_, "subject {}: {}, the weakest of its verdicts\n", r.subject,
          to_string(weakest(report.results, r.subject)));
    }
  }
  say(out_, "{}\n", sum_line(report));
  std::fflush(out_);
}

std::string printable(const std::string& text) { return dock::clean_text(text); }

}  // namespace mmverify::cli
