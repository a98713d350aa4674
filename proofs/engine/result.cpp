#include "proofs/engine/result.hpp"

#include <fmt/format.h>

namespace mmverify::proofs {

std::string to_string(Verdict v) {
  switch (v) {
    case Verdict::proved: return "proved";
    case Verdict::refuted: return "refuted";
    case Verdict::checked: return "checked";
    case Verdict::broken: return "broken";
    case Verdict::not_applicable: return "not_applicable";
    case Verdict::incomplete: return "incomplete";
  }
  return "?";
}

std::uint64_t Result::cases_run() const {
  std::uint64_t sum = 0;
  for (const Count& c : by_kind) sum += c.cases;
  return sum;
}

std::uint64_t Result::mismatches() const {
  std::uint64_t sum = 0;
  for (const Count& c : by_kind) sum += c.mismatches;
  return sum;
}

std::uint64_t Result::allowed() const {
  std::uint64_t sum = 0;
  for (const Count& c : by_kind) sum += c.allowed;
  return sum;
}

std::uint64_t Result::declined() const {
  std::uint64_t sum = 0;
  for (const Count& c : by_kind) sum += c.declined;
  return sum;
}

void settle(Result& r, bool sample) {
  const std::uint64_t declined = r.declined();
  if (r.mismatches() != 0) {
    r.verdict = Verdict::refuted;
  } else if (r.cases_run() == 0) {
    r.verdict = Verdict::not_applicable;
    r.reason = "the law has no case for this subject at this level";
  } else if (2 * declined > r.cases_run()) {
    r.verdict = Verdict::not_applicable;
    r.reason =
        !r.undecided.empty()
            ? fmt::format("{} of {} cases are those {}", declined, r.cases_run(), r.undecided)
        : declined == r.cases_run()
            ? std::string("the subject supports none of the cases")
            : fmt::format(
                  "the subject declined {} of {} cases, more than half; it should declare what it supports",
                  declined, r.cases_run());
  } else {
    r.verdict = sample || declined != 0 || r.allowed() != 0 ? Verdict::checked : Verdict::proved;
  }
}

}  // namespace mmverify::proofs
