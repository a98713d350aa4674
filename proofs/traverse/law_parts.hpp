// Common parts of the laws of topic traverse: the check of a case, and the cases that it runs on.
#pragma once

#include "proofs/traverse/combinations.hpp"
#include "proofs/traverse/subject.hpp"

namespace mmverify::proofs::traverse {

/// The reason why the law does not apply, if any: another topic, or a missing entry point.
Unfit needing(std::vector<Entry> entries);

/// Cases by number: their count, a case by number, its text, the case of a text (or BadCase), and its check.
template <class Case>
struct Cases {
  std::function<std::uint64_t()> count;
  std::function<Case(std::uint64_t k)> number;
  std::function<std::string(const Case&)> text;
  std::function<Case(const std::string&)> read;
  std::function<Finding(const TraverseSubject&, const Case&)> check;
  std::uint64_t chunk = 1024;
};

/// The law on numbered cases, at all levels at once.
template <class Case>
Law on_cases(Law law, std::vector<Entry> entries, Cases<Case> cases) {
  law.at_once = "all levels";
  law.unfit = needing(std::move(entries));
  return on_numbered_cases(
      std::move(law),
      {[cases](Level, const Run&) { return cases.count(); },
       [cases](const Subject& s, Level, std::uint64_t k, const Run&) {
         return cases.check(subject_as<TraverseSubject>(s), cases.number(k));
       },
       [cases](const Subject&, Level, std::uint64_t k, const Run&) { return cases.text(cases.number(k)); },
       [cases](const Subject& s, Level, const std::string& at) {
         return cases.check(subject_as<TraverseSubject>(s), cases.read(at));
       },
       cases.chunk, Kind::interior});
}

using Check = std::function<Finding(const TraverseSubject&, const Combination&)>;

/// The law on the defined combinations that `about` accepts; the text of another combination is a BadCase.
Law on_defined(Law law, bool (*about)(const Combination&), Check check);

/// A mutant: `wrong` makes its outcome from the combination and the right outcome.
std::function<void(Functions&)> deciding(Outcome (*wrong)(const Combination&, Outcome));
/// A mutant that takes one combination for another.
std::function<void(Functions&)> mistaking(void (*change)(Combination&));

/// A mutant that gathers other hits.
std::function<void(Functions&)> gathering(void (*change)(std::vector<Hit>&));

/// The codes as text, "255 0 0 255".
std::string text_of_colour(const spec::traverse::Colour& c);

/// The name of an outcome, such as `opaque`; the number of a code that is no outcome.
std::string text_of(Outcome o);

/// Holds if the outcomes are equal.
Finding same(Outcome expected, Outcome got);

}  // namespace mmverify::proofs::traverse
