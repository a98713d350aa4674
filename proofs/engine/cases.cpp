#include "proofs/engine/cases.hpp"

namespace mmverify::proofs {
namespace {

/// Broken where the subject broke on the case and the law goes on.
Finding checked(const NumberedCases& cases, const Subject& subject, Level n, std::uint64_t k,
                const Run& run) {
  if (run.breaks == nullptr) return cases.check(subject, n, k, run);
  try {
    Finding found = cases.check(subject, n, k, run);
    run.breaks->answered();
    return found;
  } catch (const dock::CaseBroken& broken) {
    run.breaks->note(n, k, broken);
    Finding found;
    found.broken = true;
    return found;
  }
}

}  // namespace

Tally judge_numbered_cases(const NumberedCases& cases, const Subject& subject, Level n, const Run& run) {
  return sweep(run, cases.count(n, run), cases.chunk, [&](Chunk chunk, Tally& tally) {
    for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
      const Finding found = checked(cases, subject, n, k, run);
      if (found.broken)
        tally.leave_unjudged(cases.kind);
      else if (found.declined)
        tally.decline(cases.kind);
      else
        tally.count(cases.kind, 1);
      if (found.allowed) tally.allow(cases.kind);
      tally.digest(k, found.answer);
      if (found.holds) continue;
      const Simplicity simplicity{n, found.lesser ? 1u : 0u, k};
      tally.mismatch(cases.kind, simplicity, [&] {
        const Words words = found.words();
        return Counterexample{simplicity, n, cases.text(subject, n, k, run), {}, words.expected, words.got};
      });
    }
  });
}

Law on_numbered_cases(Law law, const NumberedCases& cases) {
  law.divisible = true;
  if (!law.how) law.how = to_string(law.method);
  law.cases = cases.count;
  law.judge = [cases](const Subject& s, Level n, const Run& run) {
    return judge_numbered_cases(cases, s, n, run);
  };
  law.replay = [cases](const Subject& s, Level n, const std::string& at) {
    const Finding found = cases.read(s, n, at);
    if (found.declined) throw BadCase("'" + at.substr(0, 60) + "': the subject does not support it");
    Replayed again = replayed(found);
    if (cases.draw) again.picture = cases.draw(s, n, at);
    return again;
  };
  return law;
}

}  // namespace mmverify::proofs
