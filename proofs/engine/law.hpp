// A law: a statement for all inputs of a domain, the judge of one level, and mutants that must fail it.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "proofs/engine/sweep.hpp"
#include "subjects/dock/broken.hpp"

namespace mmverify::proofs {

/// An implementation under test.  Topics derive from it.
class Subject {
 public:
  Subject(std::string topic, std::string name, std::string about)
      : topic_(std::move(topic)), name_(std::move(name)), about_(std::move(about)) {}
  virtual ~Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;
  const std::string& topic() const { return topic_; }
  const std::string& name() const { return name_; }
  const std::string& about() const { return about_; }

  /// Distinguishes implementations of the same name.  Empty if the program itself is the implementation.
  virtual std::string fingerprint() const { return {}; }

  /// The reason why it cannot be called on this machine, if any; it then has no topic's own type, and its laws are
  /// not_applicable.
  virtual std::string absent() const { return {}; }

  /// Whether its answers on the cases of a law decide all inputs that the cases stand for.
  virtual bool exact() const = 0;

 private:
  std::string topic_, name_, about_;
};
using SubjectPtr = std::shared_ptr<const Subject>;

/// A range of levels, both ends included, as on the command line.
struct Levels {
  Level first = 0, last = 0;
  friend bool operator==(const Levels&, const Levels&) = default;
};

/// The kind of a passing run.  Exhaustive and witness runs prove, a sample only checks.  An induction and bit vectors
/// prove if a prover has discharged every statement.
enum class Method { exhaustive, sample, witness, induction, bit_vectors };

constexpr const char* to_string(Method method) {
  switch (method) {
    case Method::exhaustive: return "exhaustive";
    case Method::sample: return "sample";
    case Method::witness: return "witness";
    case Method::induction: return "induction";
    case Method::bit_vectors: return "bit vectors";
  }
  return "?";
}

/// A wrong subject that the law must refute within these levels.
struct Mutant {
  std::string name;
  SubjectPtr subject;
  Levels levels;
};

/// One case judged again, for `replay`.
struct Replayed {
  bool holds = false;
  std::string expected, got;
  std::string picture;  ///< SVG text; empty if a picture shows nothing
};

/// The levels that a law runs at in each tier.
struct Tiers {
  Levels fast = {}, long_run = {};
  double seconds = 0;  ///< of the fast tier on two cores of the machine the README names, mutants included
};

/// A number of cases: the same for all levels, one for each tier, or by level and run.
class CaseCount {
 public:
  CaseCount() = default;
  CaseCount(std::uint64_t all) : CaseCount(all, all) {}  // NOLINT: a number is a count
  CaseCount(std::uint64_t fast, std::uint64_t long_run)
      : count_([=](Level, const Run& run) { return run.tier == Tier::fast ? fast : long_run; }) {}
  template <std::invocable<Level, const Run&> Function>
  CaseCount(Function count) : count_(std::move(count)) {}  // NOLINT: so is a function
  template <std::invocable<Level> Function>
  CaseCount(Function count) : count_([count](Level n, const Run&) { return count(n); }) {}  // NOLINT
  explicit operator bool() const { return bool{count_}; }
  std::uint64_t operator()(Level n, const Run& run) const { return count_(n, run); }

 private:
  std::function<std::uint64_t(Level, const Run&)> count_;
};

/// Words about a law on a subject at a level: the same for all, or what a function says of them.
class Wording {
 public:
  Wording() = default;
  Wording(std::string words)  // NOLINT: words are a wording
      : words_([words = std::move(words)](const Subject&, Level) { return words; }) {}
  Wording(const char* words) : Wording(std::string(words)) {}  // NOLINT: so are these
  template <std::invocable<const Subject&, Level> Words>
  Wording(Words words) : words_(std::move(words)) {}  // NOLINT
  template <std::invocable<Level> Words>
  Wording(Words words) : words_([words](const Subject&, Level n) { return words(n); }) {}  // NOLINT
  explicit operator bool() const { return bool{words_}; }
  std::string operator()(const Subject& subject, Level n) const { return words_(subject, n); }

 private:
  std::function<std::string(const Subject&, Level)> words_;
};

struct Law {
  std::string id;
  std::string topic = {};  ///< filled in by the registry
  std::string says = {}, source = {};
  Method method = Method::exhaustive;
  /// Built-in subjects of a run that names none; the law holds for them.
  std::vector<std::string> subjects = {};
  Tiers tiers = {};
  /// The levels that one run settles together, in words.  The law then runs once, as level 0, for any requested
  /// levels, and its counterexamples and mutants name levels of their own.  Empty: a run settles its level.
  std::string at_once = {};

  CaseCount cases = {};           ///< closed form
  Wording domain = {}, how = {};  ///< how: "exhaustive, rational", ...
  /// The reason why the law does not apply, if any.
  std::function<std::optional<std::string>(const Subject&, Level)> unfit = {};
  /// Whether its cases are judged one by one, in a single sweep, so that shards and resumed runs add up.
  bool divisible = false;
  std::function<Tally(const Subject&, Level, const Run&)> judge = {};
  /// Throws BadCase; empty if the law has no replay.
  std::function<Replayed(const Subject&, Level, const std::string&)> replay = {};
  std::vector<Mutant> mutants = {};
  /// Given its results on a subject, at least one of them refuted, lines that describe the subject's mistake.  Empty:
  /// no diagnosis.
  std::function<std::vector<std::string>(const Subject&, const std::vector<Result>&)> diagnose = {};
  bool long_only = false;     ///< not part of the fast tier, unless its id is requested
  bool by_id_only = false;    ///< part of no tier: it runs if its id is requested
  bool general = true;        ///< about any subject that fits; else only about those that it names
  Options heeds = {};         ///< the options that its judge knows
  bool knows_near = false;    ///< whether it knows Run::near
  Options mutants_with = {};  ///< options for its mutants, which stay wrong and finish sooner
  /// The command that shows its counterexample again, without --case LEVEL@CASE; empty: `mmverify replay`.
  std::string replayed_by = {};
  /// The law that runs with it on an inexact subject, whose other inputs its cases do not decide.  The companion of
  /// that law runs as well.
  std::string companion = {};
  std::string dialect = {};    ///< as the Result's
  std::string undecided = {};  ///< as the Result's
  /// Laws that replace this one on subjects that they fit, by the dialect of a run.
  std::vector<std::pair<std::string, std::string>> in_dialect = {};
  /// Whether it runs only in another law's place, or if its id is requested.
  bool alternative = false;
};

/// Ends the law with `broken`.
using dock::SubjectBroken;
/// Ends the run.
using dock::NoResources;

/// A statement that no prover discharged and no counterexample denies; what() names it.  Ends the law with
/// `incomplete`.
struct NotProved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A case text that the law cannot read; what() names the error.
struct BadCase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::proofs
