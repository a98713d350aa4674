// A law: a statement for all inputs of a domain, how one level of it is judged, and who must fail it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dock/broken.hpp"
#include "proofs/engine/sweep.hpp"

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

  /// Tells another implementation of the same name apart.  Empty where the program itself is the
  /// implementation.
  virtual std::string fingerprint() const { return {}; }

  /// Why it cannot be asked in this place at all, and is of no topic's own type; its laws are then not_applicable.  Empty:
  /// it can.
  virtual std::string absent() const { return {}; }

  /// Whether its answers on the cases of a law decide all inputs that those stand for.
  virtual bool exact() const = 0;

 private:
  std::string topic_, name_, about_;
};
using SubjectPtr = std::shared_ptr<const Subject>;

/// Both ends included, as on the command line.
struct Levels {
  Level first = 0, last = 0;
  friend bool operator==(const Levels&, const Levels&) = default;
};

/// How a passing run may be called: exhaustive and witness runs prove, a sample only checks; an induction and
/// bit vectors prove if a prover has discharged every statement.
enum class Method { exhaustive, sample, witness, induction, bit_vectors };

constexpr const char* to_string(Method method) {
  switch (method) {
    case Method::exhaustive:
      return "exhaustive";
    case Method::sample:
      return "sample";
    case Method::witness:
      return "witness";
    case Method::induction:
      return "induction";
    case Method::bit_vectors:
      return "bit vectors";
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
  std::string picture;  ///< SVG text, empty where a picture says nothing
};

struct Law {
  std::string id, topic;
  std::string says = {}, source = {};
  Method method = Method::exhaustive;
  /// Built-in subjects of a run that names none: those that the law is true of.
  std::vector<std::string> subjects = {};
  Levels fast = {}, long_run = {};
  /// Where one run settles many levels: which, in words.  It is then run once, as level 0, whatever levels
  /// are asked for, and its counterexamples and mutants name levels of their own.  Empty: a run settles its
  /// level.
  std::string at_once = {};
  double fast_seconds = 0;  ///< on two cores of the machine the README names, mutants included

  std::function<std::uint64_t(Level, const Run&)> cases = {};  ///< closed form
  std::function<std::string(const Subject&, Level)> domain = {};
  std::function<std::string(const Subject&, Level)> how = {};  ///< "exhaustive, rational", ...
  /// Why the law does not apply, if so.
  std::function<std::optional<std::string>(const Subject&, Level)> unfit = {};
  /// Whether its cases are judged one by one, in a single sweep, so that shards and resumed runs add up to
  /// it.
  bool divisible = false;
  std::function<Tally(const Subject&, Level, const Run&)> judge = {};
  /// Throws BadCase; empty: none.
  std::function<Replayed(const Subject&, Level, const std::string&)> replay = {};
  std::vector<Mutant> mutants = {};
  /// Given its results on a subject, of which one is refuted at least, lines that say what the subject did instead.
  /// Empty: nothing to say.
  std::function<std::vector<std::string>(const Subject&, const std::vector<Result>&)> diagnose = {};
  bool long_only = false;     ///< no part of the fast tier, unless asked for by its id
  bool general = true;        ///< about any subject that fits; otherwise about the ones it names only
  Options heeds = {};         ///< the choices of a run that its judge knows
  bool knows_near = false;    ///< whether it knows Run::near
  Options mutants_with = {};  ///< those that its mutants are run with: no less wrong, and sooner done
  /// The command that shows a counterexample of it again, but for --case LEVEL@CASE; empty: `mmverify
  /// replay`.
  std::string replayed_by = {};
  /// The law that runs with it on a subject that is not exact, for which its cases decide nothing else; and so
  /// does that law's own companion.
  std::string companion = {};
  std::string dialect = {};  ///< as in Result
  /// Laws in the place of this one on a subject that they fit, by the dialect that a run is in.
  std::vector<std::pair<std::string, std::string>> in_dialect = {};
  /// Whether it stands in another law's place alone, or where it is asked for by its id.
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

/// A case text that the law cannot read; what() says what is wrong with it.
struct BadCase : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::proofs
