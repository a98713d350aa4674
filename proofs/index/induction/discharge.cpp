#include <fmt/format.h>

#include "proofs/engine/interrupt.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/judges.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Answer;
using proofs::induction::ask_z3;
using proofs::induction::Found;

namespace {

std::string say(const Statement& s, const Found& found) {
  return fmt::format("statement {}: expected {}, the prover says {}{}", s.name, to_string(s.expected),
                     to_string(found.answer), found.detail.empty() ? "" : " (" + found.detail + ")");
}

/// Of the statement's very text, so that another text is another digest.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t h = 14695981039346656037u;  // FNV-1a, which is the same everywhere
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return h;
}

/// The simplest points, on the lowest level that has any, on which the subject is not the reference.
std::vector<Counterexample> counterexamples(const IndexSubject& subject, Level search, const Run& run) {
  Run quick = run;
  quick.rationals = false;
  quick.interiors_only = false;
  quick.progress = nullptr;
  for (Level n = 0; n <= search && !interrupted(); ++n) {
    std::vector<Counterexample> found = equals_reference(subject, n, quick).found();
    for (Counterexample& c : found) c.level = n;
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

Tally discharge(const std::vector<Statement>& statements, const IndexSubject& subject, Level search,
                const Run& run, const Effort& effort) {
  std::vector<Found> answers(statements.size());
  Tally tally = sweep(run, statements.size(), 1, [&](Chunk chunk, Tally& part) {
    for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
      answers[k] = ask_z3(statements[k], effort);
      part.count(Kind::interior, 1);
      part.digest(k, hash_of(statements[k].text) ^ static_cast<std::uint64_t>(answers[k].answer));
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
  if (failures == 0) return tally;
  const std::vector<Counterexample> found = counterexamples(subject, search, run);
  if (found.empty())
    throw NotProved(fmt::format("{}; no counterexample on the cells of levels 0..{}", failed, search));
  // Every failed statement is one mismatch; the points are those of the lowest level that shows any.
  Tally points(run.errors);
  for (const Counterexample& c : found) points.mismatch(Kind::interior, c.simplicity, [&] { return c; });
  for (std::uint64_t k = 0; k < failures; ++k)
    tally.mismatch(Kind::interior, found.front().simplicity, [&] { return found.front(); });
  tally.replace_found(points);
  return tally;
}

}  // namespace mmverify::proofs::index::induction
