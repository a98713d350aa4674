// The parts that every topic has: a subject made of functions, the entry points that a law needs, a law on numbered
// cases, and mutants.  A topic is its struct of functions, which has two members besides them:
//   static constexpr char topic[] = "vq";
//   bool exact_answers() const;    whether the answers on a law's cases decide all inputs that the cases stand for
#pragma once

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::dock {
class Library;
using LibraryPtr = std::shared_ptr<const Library>;
}  // namespace mmverify::dock

namespace mmverify::proofs {

/// A subject of the topic of these functions, built in or in the dock.
template <class FunctionsOfTopic>
class SubjectOf : public Subject {
 public:
  using Functions = FunctionsOfTopic;
  SubjectOf(std::string name, std::string about, Functions functions, std::string fingerprint = {})
      : Subject(Functions::topic, std::move(name), std::move(about)),
        functions(std::move(functions)),
        fingerprint_(std::move(fingerprint)) {}
  bool exact() const override { return functions.exact_answers(); }
  std::string fingerprint() const override { return fingerprint_; }

  const Functions functions;

 private:
  std::string fingerprint_;
};

/// The subject in its topic's own type.  Domain: a subject of that topic.
template <class TopicSubject>
const TopicSubject& subject_as(const Subject& s) {
  return dynamic_cast<const TopicSubject&>(s);
}

/// The subject of that name.  Domain: one of them has it.
template <class TopicSubject>
std::shared_ptr<const TopicSubject> named(const std::vector<std::shared_ptr<const TopicSubject>>& subjects,
                                          const std::string& name) {
  for (const auto& subject : subjects)
    if (subject->name() == name) return subject;
  throw std::logic_error(
      fmt::format("no subject of topic {} is called {}", TopicSubject::Functions::topic, name));
}

/// The base with one deliberate error.
template <class TopicSubject>
Mutant changed(const TopicSubject& base, std::string name, Levels levels,
               const std::function<void(typename TopicSubject::Functions&)>& change) {
  auto functions = base.functions;
  change(functions);
  auto subject = std::make_shared<TopicSubject>(name, "broken on purpose", std::move(functions));
  return {std::move(name), std::move(subject), levels};
}

/// A topic's built-in subject of that name, and the same with one deliberate error.  Domain: `all` has the name.
template <auto all>
constexpr auto built_in_of = [](const std::string& name) { return named(all(), name); };
template <auto all>
constexpr auto mutant_of = [](std::string name, const std::string& base, Levels levels, const auto& change) {
  return changed(*named(all(), base), std::move(name), levels, change);
};

/// An entry point that a law needs, and its name in messages.
template <class Functions>
struct EntryOf {
  const char* name;
  bool (*there)(const Functions&);
};

/// The reason why a law does not apply to a subject at a level, if any.
using Unfit = std::function<std::optional<std::string>(const Subject&, Level)>;
/// The reason why a subject of the topic does not fit, if any.
template <class TopicSubject>
using UnfitOf = std::function<std::optional<std::string>(const TopicSubject&, Level)>;

/// Another topic, or the reason that `why` gives.
template <class TopicSubject>
Unfit unless_of_topic(UnfitOf<TopicSubject> why) {
  return [why = std::move(why)](const Subject& subject, Level n) -> std::optional<std::string> {
    const auto* s = dynamic_cast<const TopicSubject*>(&subject);
    if (s == nullptr) return fmt::format("not a subject of topic {}", TopicSubject::Functions::topic);
    return why ? why(*s, n) : std::nullopt;
  };
}

/// A missing entry point, or the reason that `why` gives.
template <class TopicSubject>
UnfitOf<TopicSubject> lacking(std::vector<EntryOf<typename TopicSubject::Functions>> entries,
                              UnfitOf<TopicSubject> why = {}) {
  return [entries = std::move(entries), why = std::move(why)](const TopicSubject& s,
                                                              Level n) -> std::optional<std::string> {
    for (const auto& entry : entries)
      if (!entry.there(s.functions)) return fmt::format("{} has no entry point {}", s.name(), entry.name);
    return why ? why(s, n) : std::nullopt;
  };
}

/// A level beyond the subject's.
template <class TopicSubject>
std::optional<std::string> above_its_levels(const TopicSubject& s, Level n) {
  if (const Level last = s.functions.max_level; n > last)
    return fmt::format("{} is defined up to level {}", s.name(), last);
  return std::nullopt;
}

/// Cases by number: the count at a level, the check of a case, its text, and the check of a text (or BadCase).
template <class TopicSubject>
struct CasesOf {
  CaseCount count;
  std::function<Finding(const TopicSubject&, Level, std::uint64_t k, const Run&)> check;
  std::function<std::string(Level, std::uint64_t k, const Run&)> text;
  std::function<Finding(const TopicSubject&, Level, const std::string&)> read;
  std::uint64_t chunk = 256;
};

/// The law on numbered cases.
template <class TopicSubject>
Law on_cases_of(Law law, CasesOf<TopicSubject> cases) {
  return on_numbered_cases(
      std::move(law),
      {std::move(cases.count),
       [check = std::move(cases.check)](const Subject& s, Level n, std::uint64_t k, const Run& run) {
         return check(subject_as<TopicSubject>(s), n, k, run);
       },
       [text = std::move(cases.text)](const Subject&, Level n, std::uint64_t k, const Run& run) {
         return text(n, k, run);
       },
       [read = std::move(cases.read)](const Subject& s, Level n, const std::string& at) {
         return read(subject_as<TopicSubject>(s), n, at);
       },
       cases.chunk, Kind::interior});
}

/// Cases drawn by number: their count, a case by number, its text, the case of a text (or BadCase), and its check.
template <class TopicSubject, class Case>
struct DrawnCasesOf {
  CaseCount count;
  std::function<Case(Level, std::uint64_t k, std::uint64_t seed)> number;
  std::function<std::string(Level, const Case&)> text;
  std::function<Case(Level, const std::string&)> read;
  std::function<Finding(const TopicSubject&, Level, const Case&)> check;
  std::uint64_t chunk = 256;
  Kind kind = Kind::interior;
  /// Changes a drawn case to one that the subject supports; empty: no change.
  std::function<Case(const TopicSubject&, const Case&)> fit = {};
  /// A picture (SVG) of a case; empty: there is none.
  std::function<std::string(const TopicSubject&, Level, const Case&)> draw = {};
};

/// The law on cases drawn by number.
template <class TopicSubject, class Case>
Law on_drawn_cases(Law law, DrawnCasesOf<TopicSubject, Case> cases) {
  const auto drawn = [number = std::move(cases.number), fit = std::move(cases.fit)](
                         const Subject& s, Level n, std::uint64_t k, const Run& run) {
    Case one = number(n, k, run.seed);
    return fit ? fit(subject_as<TopicSubject>(s), one) : one;
  };
  const auto check = std::move(cases.check);
  const auto read = std::move(cases.read);
  std::function<std::string(const Subject&, Level, const std::string&)> draw;
  if (cases.draw)
    draw = [draw = std::move(cases.draw), read](const Subject& s, Level n, const std::string& at) {
      return draw(subject_as<TopicSubject>(s), n, read(n, at));
    };
  return on_numbered_cases(
      std::move(law),
      {std::move(cases.count),
       [check, drawn](const Subject& s, Level n, std::uint64_t k, const Run& run) {
         return check(subject_as<TopicSubject>(s), n, drawn(s, n, k, run));
       },
       [text = std::move(cases.text), drawn](const Subject& s, Level n, std::uint64_t k, const Run& run) {
         return text(n, drawn(s, n, k, run));
       },
       [check, read](const Subject& s, Level n, const std::string& at) {
         return check(subject_as<TopicSubject>(s), n, read(n, at));
       },
       cases.chunk, cases.kind, std::move(draw)});
}

}  // namespace mmverify::proofs
