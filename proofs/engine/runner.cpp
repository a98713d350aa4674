#include "proofs/engine/runner.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

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

/// The result of a law that cannot be divided and that another shard runs.
Result of_another_shard(const Law& law, const Subject& subject, Level level, const Run& run) {
  if (const auto why = law.unfit(subject, level)) return not_applicable(law, subject, level, run, *why);
  Result r = not_applicable(law, subject, level, run, "another shard runs all of it");
  r.cases_expected = law.cases(level, run);
  r.share = Share{0, 0, 1};
  return r;
}

/// The journal's name for a job's level.
std::string about(const Job& job, Level level) {
  return fmt::format("{} {} level {}", job.law->id, job.subject->name(), level);
}

/// The reason why the job has no level to run; empty if it has one.
std::string unfit_throughout(const Job& job) {
  std::string why = job.unfit;
  for (Level n = job.levels.first; why.empty() && n <= job.levels.last; ++n)
    if (!job.law->unfit(*job.subject, n)) return {};
  return why.empty() ? job.law->unfit(*job.subject, job.levels.first).value_or("no level") : why;
}

/// The job's results at the levels that ran, if one of them is refuted; else none.
std::vector<Result> refuting(const Report& report, const Job& job) {
  std::vector<Result> of_job;
  for (const Result& r : report.results)
    if (r.law == job.law->id && r.subject == job.subject->name() && r.verdict != Verdict::not_applicable)
      of_job.push_back(r);
  if (std::none_of(of_job.begin(), of_job.end(),
                   [](const Result& r) { return r.verdict == Verdict::refuted; }))
    of_job.clear();
  return of_job;
}

/// Whether another law gave the same diagnosis.
bool said_before(const Report& report, const Diagnosis& diagnosis) {
  return std::any_of(report.diagnoses.begin(), report.diagnoses.end(), [&](const Diagnosis& d) {
    return d.subject == diagnosis.subject && d.lines == diagnosis.lines;
  });
}

/// Withdraws the results of subjects whose files have changed: they may come from either version.
void withdraw_changed(const std::vector<Job>& jobs, const RunOptions& options, Report& report) {
  if (!options.change_of) return;
  bool some = false;
  std::vector<const Subject*> looked_at;
  for (const Job& job : jobs) {
    const Subject* subject = job.subject.get();
    if (std::find(looked_at.begin(), looked_at.end(), subject) != looked_at.end()) continue;
    looked_at.push_back(subject);
    const std::string change = options.change_of(*subject);
    if (change.empty()) continue;
    some = true;
    report.gave_up = change;
    for (Result& r : report.results) {
      if (r.subject != subject->name() || r.verdict == Verdict::not_applicable) continue;
      r.verdict = Verdict::incomplete;
      r.reason = change;
      r.breaks.clear();
      r.by_kind = {};
      r.counterexamples.clear();
      r.digest = 0;
      r.resumed = 0;
    }
    std::erase_if(report.diagnoses, [&](const Diagnosis& d) { return d.subject == subject->name(); });
  }
  if (some && options.journal != nullptr) options.journal->discard();
}

/// Runs a mutant; nothing if an interrupt came first.
std::optional<MutantResult> run_mutant(const Law& law, const Mutant& mutant, const Run& run) {
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

Run run_by(const RunOptions& options, oneapi::tbb::task_arena& arena) {
  Run run;
  run.arena = &arena;
  run.errors = options.errors;
  run.seed = options.seed;
  run.tier = options.tier;
  run.cases = options.cases;
  run.options = options.options;
  run.near = options.near;
  return run;
}

std::uint64_t count_cases(const std::vector<Job>& jobs, const Run& run, const Shard& shard) {
  std::uint64_t total = 0;
  for (const Job& job : jobs)
    for (Level n = job.levels.first; job.unfit.empty() && n <= job.levels.last; ++n)
      if (!job.law->unfit(*job.subject, n)) total += job.law->cases(n, run) / shard.of;
  return total;
}

void diagnose(const std::vector<Job>& jobs, Report& report) {
  for (const Job& job : jobs)
    if (const auto results = refuting(report, job);
        job.law->diagnose && !results.empty() && !interrupted() && report.gave_up.empty()) {
      try {
        Diagnosis diagnosis{job.law->id, job.subject->name(), job.law->diagnose(*job.subject, results)};
        if (!said_before(report, diagnosis)) report.diagnoses.push_back(std::move(diagnosis));
      } catch (const Interrupted&) {
      } catch (const NoResources&) {
        // The verdict stands without the diagnosis.
      } catch (const SubjectBroken& broken) {
        report.diagnoses.push_back({job.law->id, job.subject->name(), {broken.what()}});
      }
    }
}

/// The laws of the jobs that are run at some level, each once.
std::vector<const Law*> laws_run(const std::vector<Job>& jobs) {
  std::vector<const Law*> laws;
  for (const Job& job : jobs)
    if (unfit_throughout(job).empty() && std::find(laws.begin(), laws.end(), job.law) == laws.end())
      laws.push_back(job.law);
  return laws;
}

}  // namespace

void name_proof(Result& r, const Law& law) {
  r.at_once = law.at_once;
  r.replayed_by = law.replayed_by;
  if (law.method == Method::induction || law.method == Method::bit_vectors) r.proof = to_string(law.method);
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
  run.until_refuted = asked.until_refuted && law.divisible;
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

std::vector<MutantResult> run_mutants(const Law& law, const Run& run) {
  return run_mutants(std::vector<const Law*>{&law}, run);
}

std::vector<MutantResult> run_mutants(const std::vector<const Law*>& laws, const Run& asked) {
  // A mutant's run must not depend on the requested sample.
  Run run = asked;
  run.seed = Run().seed;
  run.tier = Tier::fast;
  run.cases = 0;
  run.near = 0;
  run.until_refuted = true;
  std::vector<std::pair<const Law*, const Mutant*>> all;
  for (const Law* law : laws)
    for (const Mutant& mutant : law->mutants) all.emplace_back(law, &mutant);
  std::vector<std::optional<MutantResult>> found(all.size());
  const auto one = [&](std::size_t k) {
    Run of_law = run;
    of_law.options = all[k].first->mutants_with;
    found[k] = run_mutant(*all[k].first, *all[k].second, of_law);
  };
  const auto each = [&] {
    // Many runs are short, or a prover's, which has one thread.  Isolation keeps a waiting thread from beginning
    // another mutant while the first has a lock.
    oneapi::tbb::parallel_for(
        std::size_t{0}, all.size(),
        [&](std::size_t k) { oneapi::tbb::this_task_arena::isolate([&] { one(k); }); },
        oneapi::tbb::simple_partitioner());
  };
  if (run.arena != nullptr)
    run.arena->execute(each);
  else
    for (std::size_t k = 0; k < all.size(); ++k) one(k);
  std::vector<MutantResult> results;
  for (const auto& m : found)
    if (m) results.push_back(*m);
  return results;
}

Report run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const OnResult& on_result) {
  Report report;
  report.threads = options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  oneapi::tbb::task_arena arena(static_cast<int>(report.threads));
  Run run = run_by(options, arena);
  const Shard shard = options.shard.value_or(Shard{});
  Progress progress(count_cases(jobs, run, shard), options.show_progress);
  const InterruptGuard guard;
  run.progress = &progress;
  const auto add = [&](const Job& job, Result r) {
    // A scene has no file, and its fingerprint takes a second.
    if (options.change_of) r.fingerprint = job.subject->fingerprint();
    report.results.push_back(r);
    on_result(r);
  };
  std::uint64_t whole_laws = 0;  // dealt to the shards in turn
  for (const Job& job : jobs) {
    if (!report.gave_up.empty()) break;
    if (const std::string why = unfit_throughout(job); !why.empty()) {
      add(job, not_applicable(*job.law, *job.subject, job.levels.first, run, why));
      continue;
    }
    Breaks breaks;
    run.breaks = &breaks;
    for (Level n = job.levels.first; n <= job.levels.last; ++n) {
      Division division{options.shard, options.journal, about(job, n), {}, 0, false};
      if (options.journal != nullptr || options.shard) run.division = &division;
      const bool elsewhere = !job.law->divisible && whole_laws++ % shard.of != shard.number - 1;
      try {
        add(job, elsewhere ? of_another_shard(*job.law, *job.subject, n, run)
                           : run_level(*job.law, *job.subject, n, run));
      } catch (const NoResources& why) {
        // This shows nothing about the subject; earlier results stand.
        report.gave_up = why.what();
        add(job, cut_short(*job.law, *job.subject, n, run, report.gave_up));
      }
      run.division = nullptr;
      if (!report.gave_up.empty()) break;
      // A subject that breaks on all of a level would do so at the next level; the run continues with the next law.
      const Result& last = report.results.back();
      if (last.verdict == Verdict::broken && last.breaks.empty()) break;
    }
    run.breaks = nullptr;
  }

  run.progress = nullptr;
  run.division = nullptr;
  withdraw_changed(jobs, options, report);
  diagnose(jobs, report);
  if (shard.number == 1 && options.mutants && report.gave_up.empty())
    report.mutants = run_mutants(laws_run(jobs), run);
  report.interrupted = interrupted();
  return report;
}

}  // namespace mmverify::proofs
