#include "proofs/pipe/questions.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "proofs/engine/bytes.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/pipe/lines.hpp"
#include "proofs/planning/plan.hpp"

namespace mmverify::proofs::pipe {
namespace {

/// The questions so far, by two hashes of their text: a texture's text is long.
class Numbers {
 public:
  /// The question's number, and whether it is new.
  std::pair<std::uint64_t, bool> add(const std::string& question) {
    const auto [at, added] = known_.try_emplace(key_of(question), known_.size());
    return {at->second, added};
  }
  const std::uint64_t* find(const std::string& question) const {
    const auto at = known_.find(key_of(question));
    return at == known_.end() ? nullptr : &at->second;
  }
  std::uint64_t size() const { return known_.size(); }

 private:
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  struct Low {
    std::size_t operator()(const Key& key) const { return key.first; }
  };
  static Key key_of(const std::string& question) {
    return {hash_of(question), std::hash<std::string>()(question)};
  }
  std::unordered_map<Key, std::uint64_t, Low> known_;
};

/// Judges the laws one after the other on one thread, so that questions come in one order.
std::vector<Result> judged(const PipeRun& asked, const SubjectPtr& subject, Progress* progress) {
  Request request;
  request.laws = asked.laws;
  request.subjects = {subject};
  request.levels = asked.levels;
  request.companions = false;
  Run run;
  run.errors = asked.errors;
  run.seed = asked.seed;
  run.cases = asked.cases;
  run.progress = progress;
  std::vector<Result> results;
  for (const Job& job : plan(request))
    for (Level n = job.levels.first; n <= job.levels.last && job.unfit.empty() && !interrupted(); ++n)
      if (!job.law->unfit(*subject, n)) results.push_back(run_level(*job.law, *subject, n, run));
  return results;
}

/// The first line, with all that the questions depend on.
std::string heading(const PipeRun& asked) {
  std::string text = fmt::format("{}{} levels {}..{} seed {}", heading_begins, asked.topic,
                                 asked.levels.first, asked.levels.last, asked.seed);
  if (asked.cases != 0) text += fmt::format(" cases {}", asked.cases);
  for (const std::string& law : asked.chosen) text += " " + law;
  return text;
}

/// The number of cases, which all run twice.
std::uint64_t cases_of(const PipeRun& asked) {
  std::uint64_t cases = 0;
  Run run;
  run.cases = asked.cases;
  const SubjectPtr subject = asked.dialogue.subject(asked.dialogue.answer);
  for (const Law* law : asked.laws)
    for (Level n = asked.levels.first; n <= asked.levels.last; ++n)
      if (!law->unfit(*subject, n)) cases += law->cases(n, run);
  return 2 * cases;
}

}  // namespace

bool generate_questions(const PipeRun& asked, std::FILE* out) {
  const InterruptGuard guard;
  Written written(out);
  bool open = written.line(heading(asked));
  Numbers numbers;
  judged(asked, asked.dialogue.subject([&](const std::string& question) {
    const auto [number, added] = numbers.add(question);
    if (added && open) open = written.line(fmt::format("{} {}", number, question));
    return asked.dialogue.answer(question);
  }),
         nullptr);
  if (open && !interrupted()) written.line(fmt::format("# {} cases", numbers.size()));
  return written.end() && !interrupted();
}

Report check_questions(const PipeRun& asked, std::istream& in) {
  const InterruptGuard guard;
  Progress progress(cases_of(asked), asked.show_progress);
  Numbers numbers;
  judged(asked, asked.dialogue.subject([&](const std::string& question) {
    numbers.add(question);
    return asked.dialogue.answer(question);
  }),
         &progress);
  Report report;
  if (!interrupted()) {
    Answers lines(in, heading(asked), "CASE ANSWER",
                  "answer, in pairs of the digits 0 to 9 and a to f, or -");
    std::vector<std::string> given;
    for (std::uint64_t k = 0; k < numbers.size(); ++k) {
      given.emplace_back(lines.text(k, numbers.size()));
      if (given.back() != no_answer && !bytes_from_hex(given.back())) lines.garbled(k);
    }
    lines.end(numbers.size());
    report.results = judged(asked, asked.dialogue.subject([&](const std::string& question) {
      const std::uint64_t* number = numbers.find(question);
      return number == nullptr ? std::string(no_answer) : given[*number];
    }),
                            &progress);
  }
  report.interrupted = interrupted();
  return report;
}

}  // namespace mmverify::proofs::pipe
