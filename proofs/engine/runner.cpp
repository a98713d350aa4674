#include "proofs/engine/runner.hpp"

#include <fmt/format.h>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"

namespace mmverify::proofs {
namespace {

void judge(const Law& law, Result& r, bool finished) {
  const bool whole = !r.share || r.share->whole();
  if (whole) finished = r.cases_run() == r.cases_expected;
  if (whole && !finished && r.mismatches() == 0 && !interrupted())
    throw std::logic_error(fmt::format("{} level {}: {} cases run, {} expected", law.id, r.level,
                                       r.cases_run(), r.cases_expected));
  if (r.mismatches() == 0 && !finished) {
    r.verdict = Verdict::incomplete;
  } else if (r.mismatches() == 0 && !whole) {
    // A shard's verdict is checked at most; all shards together may be proved (shards.hpp).
    r.verdict = r.cases_run() == 0 ? Verdict::not_applicable : Verdict::checked;
    if (r.cases_run() == 0) r.reason = "0 cases in this shard";
  } else {
    settle(r, law.method == Method::sample);
  }
}

/// The options that the law heeds.
Options heeded(const Law& law, Options options) {
  std::erase_if(options, [&](const Option* option) {
    return !has(law.heeds, *option) || (option->narrows && !law.general);
  });
  return options;
}

Result named(const Law& law, const Subject& subject, Level level, const Run& run) {
  Result r;
  r.law = law.id;
  r.topic = law.topic;
  r.subject = subject.name();
  r.level = level;
  r.dialect = law.dialect;
  r.undecided = law.undecided;
  name_proof(r, law);
  // A law can only describe its method for a subject of its own topic.
  const bool known = subject.topic() == law.topic && subject.absent().empty();
  r.method = known ? law.how(subject, level) : to_string(law.method);
  r.domain = known ? law.domain(subject, level) : "subjects of topic " + law.topic;
  for (const Option* option : heeded(law, run.options))
    if (option->domain != nullptr) r.domain += std::string(", ") + option->domain;
  if (law.knows_near && run.near != 0)
    r.domain += fmt::format(", a neighbour's index allowed within {} ulps of an edge", run.near);
  return r;
}

bool by_prover(const Law& law) {
  return law.method == Method::induction || law.method == Method::bit_vectors;
}

/// Judges a law that cannot be divided completely, or takes its tally from the journal.
Tally judge_whole(const Law& law, const Subject& subject, Level level, const Run& asked) {
  Run run = asked;
  run.division = nullptr;
  Division* division = asked.division;
  if (division == nullptr || division->journal == nullptr) return law.judge(subject, level, run);
  const auto finished = division->journal->finished(division->about, 1);
  if (!finished.empty()) {
    division->resumed = finished.front().tally.cases();
    return finished.front().tally;
  }
  Tally tally = law.judge(subject, level, run);
  if (!interrupted() && !tally.broke()) division->journal->append({division->about, {0, 1}, 1, tally});
  division->journal->flush();
  return tally;
}

}  // namespace

Result not_applicable(const Law& law, const Subject& subject, Level level, const Run& run,
                      const std::string& why) {
  Result r = named(law, subject, level, run);
  r.verdict = Verdict::not_applicable;
  r.reason = why;
  return r;
}

Result cut_short(const Law& law, const Subject& subject, Level level, const Run& run,
                 const std::string& why) {
  Result r = named(law, subject, level, run);
  r.verdict = Verdict::incomplete;
  r.reason = why;
  r.cases_expected = law.cases(level, run);
  return r;
}

void name_proof(Result& r, const Law& law) {
  r.at_once = law.at_once;
  r.replayed_by = law.replayed_by;
  if (by_prover(law)) r.proof = to_string(law.method);
}

/// The break on the first case that breaks the subject, found on one thread; several threads may find another one
/// first.
std::optional<std::string> first_break(const Law& law, const Subject& subject, Level level,
                                       const Run& of_threads) {
  if (of_threads.arena == nullptr) return std::nullopt;
  Breaks one(1);
  Run run = of_threads;
  run.arena = nullptr;
  run.progress = nullptr;
  std::optional<Division> share;
  if (law.divisible && of_threads.division != nullptr) {
    share = *of_threads.division;
    share->journal = nullptr;
  }
  run.division = share ? &*share : nullptr;
  run.breaks = &one;
  try {
    law.judge(subject, level, run);
  } catch (const SubjectBroken& broken) {
    return broken.what();
  } catch (const Interrupted&) {
  } catch (const std::runtime_error&) {
  }
  return std::nullopt;
}

Result run_level(const Law& law, const Subject& subject, Level level, const Run& asked) {
  Run run = asked;
  run.options = heeded(law, asked.options);
  if (!law.knows_near) run.near = 0;
  run.until_refuted = asked.until_refuted && (law.divisible || by_prover(law));
  Result r = named(law, subject, level, run);
  if (const auto why = law.unfit(subject, level)) return not_applicable(law, subject, level, run, *why);
  Breaks breaks;
  if (run.breaks == nullptr) run.breaks = &breaks;
  run.level = level;
  const auto start = std::chrono::steady_clock::now();
  r.cases_expected = law.cases(level, run);
  if (run.progress != nullptr)
    run.progress->now(fmt::format("{} {} level {}", law.id, subject.name(), level));
  try {
    const Tally tally =
        law.divisible ? law.judge(subject, level, run) : judge_whole(law, subject, level, run);
    bool finished = true;
    if (const Division* division = run.division) {
      r.resumed = division->resumed;
      if (law.divisible) {
        if (division->shard) r.share = division->share;
        finished = division->finished;
      } else if (division->shard) {
        r.share = Share{0, 1, 1};
      }
    }
    r.by_kind = tally.by_kind();
    r.counterexamples = tally.found();
    for (Counterexample& c : r.counterexamples) c.level = law.at_once.empty() ? level : c.level;
    r.digest = tally.digest();
    judge(law, r, finished);
    if (r.verdict == Verdict::incomplete) r.reason = "interrupted";
    r.breaks = run.breaks->at(level);
    if (!r.breaks.empty() && r.verdict != Verdict::refuted) {
      r.verdict = Verdict::broken;
      r.reason = r.breaks.front();
    }
  } catch (const Interrupted&) {
    r.verdict = Verdict::incomplete;
    r.reason = "interrupted";
  } catch (const NotProved& gap) {
    r.verdict = Verdict::incomplete;
    r.reason = gap.what();
  } catch (const SubjectBroken& broken) {
    r.verdict = Verdict::broken;
    r.reason = first_break(law, subject, level, run).value_or(broken.what());
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

std::optional<MutantResult> run_mutant(const Law& law, const Mutant& mutant, const Run& asked) {
  // A mutant's run must not depend on the requested sample.
  Run run = asked;
  run.seed = Run().seed;
  run.tier = Tier::fast;
  run.cases = 0;
  run.near = 0;
  run.until_refuted = true;
  run.options = law.mutants_with;
  MutantResult m{law.id, mutant.name, false, 0, {}};
  const Level last = law.at_once.empty() ? mutant.levels.last : mutant.levels.first;
  for (Level n = mutant.levels.first; n <= last && !m.killed && !interrupted(); ++n) {
    const Result r = run_level(law, *mutant.subject, n, run);
    if (r.verdict != Verdict::refuted) continue;
    m.killed = true;
    m.level = law.at_once.empty() || r.counterexamples.empty() ? n : r.counterexamples.front().level;
    m.at = r.counterexamples.empty() ? std::string() : r.counterexamples.front().at;
  }
  return m.killed || !interrupted() ? std::optional(m) : std::nullopt;
}

std::vector<MutantResult> run_mutants(const Law& law, const Run& run) {
  std::vector<MutantResult> results;
  for (const Mutant& mutant : law.mutants)
    if (const auto m = run_mutant(law, mutant, run)) results.push_back(*m);
  return results;
}

}  // namespace mmverify::proofs
