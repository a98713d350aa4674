#include "proofs/induction/discharge.hpp"

#include <fmt/format.h>

#include <map>

#include "proofs/engine/bytes.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::proofs::induction {
namespace {

std::string say(const Statement& s, const ProverAnswer& found) {
  return fmt::format("statement {}: expected {}, the prover says {}{}", s.name, to_string(s.expected),
                     to_string(found.answer), found.detail.empty() ? "" : " (" + found.detail + ")");
}

std::optional<std::vector<Statement>> statements_about(const std::vector<About>& known,
                                                       const Subject& subject) {
  if (const auto* own = dynamic_cast<const Provable*>(&subject)) return own->statements();
  for (const About& a : known)
    if (subject.name() == a.subject) return a.statements();
  return std::nullopt;
}

/// The statements' numbers, those of one text together: the prover is asked once for them.
std::vector<std::vector<std::size_t>> alike_in(const std::vector<Statement>& statements) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::string_view, std::size_t> group_of;
  for (std::size_t k = 0; k < statements.size(); ++k) {
    const auto [at, is_new] = group_of.emplace(statements[k].text, groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(k);
  }
  return groups;
}

/// How many statements there are.  Writing them takes half of a program's start, and most commands never ask.
struct CountedOnce {
  std::once_flag once;
  std::uint64_t of = 0;
};

}  // namespace

Law on_statements(Law law, std::vector<About> known, Settle settle) {
  law.cases = [statements = known.front().statements, count = std::make_shared<CountedOnce>()](Level) {
    std::call_once(count->once, [&] { count->of = statements().size(); });
    return count->of;
  };
  law.how = [method = law.method](Level) { return fmt::format("{}, {}", to_string(method), prover_name()); };
  law.unfit = [known](const Subject& s, Level) -> std::optional<std::string> {
    if (dynamic_cast<const Provable*>(&s) != nullptr) return std::nullopt;
    std::vector<std::string> names;
    for (const About& a : known) names.push_back(a.subject);
    if (std::find(names.begin(), names.end(), s.name()) != names.end()) return std::nullopt;
    return fmt::format("no statements about {}: there are some about {}", s.name(), fmt::join(names, ", "));
  };
  law.judge = [known = std::move(known), settle = std::move(settle)](const Subject& s, Level,
                                                                     const Run& asked) {
    Run run = asked;
    run.until_refuted = false;  // a search names the simplest counterexample
    // Without statements only the search runs: a counterexample refutes, whatever a prover would say.
    if (asked.until_refuted)
      if (Tally found = settle({}, s, run); found.mismatches() != 0) return found;
    return settle(statements_about(known, s).value(), s, run);
  };
  return law;
}

Tally discharge(const std::vector<Statement>& statements, const Search& search, const Run& run,
                const Effort& effort) {
  std::vector<ProverAnswer> answers(statements.size());
  const std::vector<std::vector<std::size_t>> alike = alike_in(statements);
  Tally tally = sweep(run, alike.size(), 1, [&](Chunk chunk, Tally& part) {
    for (std::uint64_t one = chunk.begin; one < chunk.end; ++one) {
      const ProverAnswer answer = ask_z3(statements[alike[one].front()], effort);
      for (const std::size_t k : alike[one]) {
        answers[k] = answer;
        part.count(Kind::interior, 1);
        part.digest(k, hash_of(statements[k].text) ^ static_cast<std::uint64_t>(answer.answer));
      }
    }
  });
  // Every statement is a case, answered or not: a run that was cut short has proved nothing.
  if (interrupted()) throw Interrupted();

  std::string failed;
  std::uint64_t failures = 0;
  for (std::size_t k = 0; k < statements.size(); ++k) {
    if (answers[k].answer == statements[k].expected) continue;
    ++failures;
    failed += (failed.empty() ? "" : "; ") + say(statements[k], answers[k]);
  }
  // Also where every statement is discharged: the statements are about a text, and nothing else asks the
  // subject whether it is that text's.
  const std::vector<Counterexample> found = search.run();
  if (interrupted()) throw Interrupted();
  if (failures == 0 && found.empty()) return tally;
  if (found.empty()) throw NotProved(fmt::format("{}; no counterexample on {}", failed, search.where));
  // Every failed statement is one mismatch, and so is a subject that the statements are not about; the
  // counterexamples are those of the lowest level that shows any.
  Tally points(run.errors);
  for (const Counterexample& c : found) points.mismatch(Kind::interior, c.simplicity, [&] { return c; });
  for (std::uint64_t k = 0; k < std::max<std::uint64_t>(failures, 1); ++k)
    tally.mismatch(Kind::interior, found.front().simplicity, [&] { return found.front(); });
  tally.replace_found(points);
  return tally;
}

}  // namespace mmverify::proofs::induction
