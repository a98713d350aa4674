// A law to try the engine on: 1000 numbers, each right or wrong as the subject says.
#pragma once

#include <atomic>
#include <string>

#include "proofs/engine/kinds.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::tests {

using namespace mmverify::proofs;

constexpr std::uint64_t numbers = 1000, numbers_per_chunk = 50;

/// Answers k with k*k, but for those that `wrong` divides; counts how often it is asked.
class Squares : public Subject {
 public:
  explicit Squares(std::uint64_t wrong = 0) : Subject("test", "squares", "for a test"), wrong_(wrong) {}
  bool exact() const override { return true; }
  bool right(std::uint64_t k) const {
    ++asked;
    return wrong_ == 0 || k % wrong_ != 0;
  }
  mutable std::atomic<std::uint64_t> asked = 0;

 private:
  std::uint64_t wrong_;
};

inline Law counting_law() {
  Law law;
  law.id = "test.squares";
  law.topic = "test";
  law.cases = [](Level, const auto&) { return numbers; };
  law.domain = [](const Subject&, Level) { return std::string("numbers"); };
  law.how = [](const Subject&, Level) { return std::string("counting"); };
  law.unfit = [](const Subject&, Level) { return std::optional<std::string>(); };
  law.divisible = true;
  law.judge = [](const Subject& s, Level level, const auto& run) {
    const auto& squares = dynamic_cast<const Squares&>(s);
    return sweep(run, numbers, numbers_per_chunk, [&](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        tally.count(Kind::edge, 1);
        tally.digest(k, k * k + level);
        if (!squares.right(k))
          tally.mismatch(Kind::edge, {k % 7, k, 0}, [&] {
            return Counterexample{{k % 7, k, 0}, level, "k=" + std::to_string(k), {}, "right", "wrong"};
          });
      }
    });
  };
  return law;
}

inline RunOptions silent(unsigned threads = 2) {
  RunOptions options;
  options.threads = threads;
  options.errors = 3;
  options.show_progress = false;
  return options;
}

inline Report run_it(const Law& law, const SubjectPtr& subject, const RunOptions& options) {
  return run_jobs({{&law, subject, {4, 5}}}, options, [](const Result&) {});
}

/// All of a report that does not depend on how the work was divided.
inline std::string essence(const Report& report) {
  std::string text;
  for (const Result& r : report.results) {
    text += r.law + " " + std::to_string(r.level) + " " + to_string(r.verdict) + " " +
            std::to_string(r.cases_run()) + " " + std::to_string(r.mismatches()) + " " +
            std::to_string(r.digest);
    for (const Counterexample& c : r.counterexamples) text += " " + c.at + "@" + std::to_string(c.level);
    text += "\n";
  }
  return text;
}

}  // namespace mmverify::tests
