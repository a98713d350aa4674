#include "proofs/index/source/law.hpp"

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/index/floats/published.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/picture.hpp"
#include "proofs/induction/prover.hpp"

namespace mmverify::proofs::index::source {
namespace {

using induction::Answer;
using induction::Solved;
using induction::Statement;

constexpr Level highest = 16;
/// The number of stiff pairs that run before any prover: most wrong functions are wrong on one of them.
constexpr std::uint64_t pairs_run = 1 << 15;
const SourceSubject& of_source(const Subject& s) { return dynamic_cast<const SourceSubject&>(s); }

std::string number_text(float x) { return fmt::format("{:a}", x); }
std::string pair_text(float u, float v) { return fmt::format("u={},v={}", number_text(u), number_text(v)); }

std::uint32_t asked(const IndexSubject& s, Level n, float u, float v) {
  std::uint32_t got = 0;
  s.functions.index_floats(n, FloatBatch{{&u, 1}, {&v, 1}}, {&got, 1});
  return got;
}
/// The compiled function's index as text. A function whose index is undefined may break, or answer twice differently.
std::string answer_where_undefined(const IndexSubject& s, Level n, float u, float v) {
  try {
    return fmt::format("{}", asked(s, n, u, v));
  } catch (const SubjectBroken&) {
    return "no index";
  }
}
std::uint32_t due(Dialect dialect, Level n, float u, float v) {
  if (dialect == Dialect::published) return published(n, u, v);
  return spec::index::reference(RationalPoint{rational(u), rational(v)}, n);
}

/// A prover's counterexample to a statement.
struct Claimed {
  float u, v;
  std::uint32_t index;
  bool undefined;
  std::string cause;
};

std::uint32_t bits_from(const Solved& found, const char* name, const Range& range) {
  const std::string n = name;
  if (const auto whole = found.values.find(n); whole != found.values.end())
    return static_cast<std::uint32_t>(whole->second);
  const auto fraction = found.values.find(n + "_fraction");
  return range.first << 23 |
         (fraction == found.values.end() ? 0 : static_cast<std::uint32_t>(fraction->second));
}

Claimed claimed_by(const Solved& found, const Pair& pair, const Formula& formula) {
  const auto value = [&](const std::string& name) {
    const auto one = found.values.find(name);
    return one == found.values.end() ? 0 : one->second;
  };
  Claimed c{std::bit_cast<float>(bits_from(found, "u", pair.u)),
            std::bit_cast<float>(bits_from(found, "v", pair.v)),
            static_cast<std::uint32_t>(value(claimed_index)),
            value(claimed_undefined) != 0,
            {}};
  for (std::size_t k = 0; k < formula.causes.size() && c.cause.empty(); ++k)
    if (value(claimed_cause(k)) != 0) c.cause = formula.causes[k].what;
  return c;
}

/// The statements of one level, each settled once.
class OfLevel {
 public:
  OfLevel(const SourceSubject& subject, Dialect dialect, Level n)
      : subject_(subject), dialect_(dialect), level_(n), pairs_(pairs_of(n, subject.code.fields(n))) {}

  std::uint64_t count() const { return pairs_.size(); }

  void judge(std::uint64_t k, Tally& tally) {
    // One counterexample is enough; the remaining statements are neither tried nor kept as finished.
    if (refuted_) return tally.break_off();
    const Pair& pair = pairs_[k];
    const Formula formula = subject_.code.formulas(level_, pair.u, pair.v);
    const Statement witness = witness_of(level_, pair),
                    statement = statement_of(level_, pair, formula, dialect_);
    if (const Solved found = induction::ask_words(witness); found.answer != Answer::sat)
      return undecided(witness.name + ": its hypotheses: " + said(found), tally);
    const Solved found = induction::ask_words(statement);
    if (found.answer == Answer::unknown) return undecided(statement.name + ": " + said(found), tally);
    if (found.answer == Answer::sat) return refute(claimed_by(found, pair, formula), tally);
    tally.count(Kind::interior, 1);
    tally.digest(k, hash_of(statement.text));
  }

  /// Throws NotProved if some statement is neither proved nor refuted and there is no counterexample.
  void settled(const Tally& tally) const {
    if (tally.mismatches() == 0 && !failed_.empty()) throw NotProved(failed_);
  }

 private:
  static std::string said(const Solved& found) {
    return fmt::format("{} says {}{}", induction::prover_name(), to_string(found.answer),
                       found.reason.empty() ? "" : " (" + found.reason + ")");
  }

  void undecided(const std::string& why, Tally& tally) {
    const std::lock_guard hold(lock_);
    if (failed_.empty()) failed_ = why;
    tally.break_off();
  }

  void refute(const Claimed& c, Tally& tally) {
    const std::uint32_t want = due(dialect_, level_, c.u, c.v);
    const std::string at = pair_text(c.u, c.v);
    // The compiled function decides, but an undefined result may be right by chance.
    const std::string got = c.undefined ? answer_where_undefined(subject_, level_, c.u, c.v)
                                        : fmt::format("{}", asked(subject_, level_, c.u, c.v));
    if (!c.undefined && got == fmt::format("{}", want))
      return undecided(
          fmt::format("level {} case {}: by the formula the index is {}, the compiled function gives {}, "
                      "which is right, and nothing is proved: either the source leaves its result open there "
                      "(a NaN's sign, which of -0 and 0 fminf gives, a frozen value), so that another "
                      "compiler may give the other one, or the code breaks a promise that it makes (const, "
                      "pure, restrict), or the translator or the prover is wrong",
                      level_, at, c.index, got),
          tally);
    refuted_ = true;
    tally.break_off();
    tally.count(Kind::interior, 1);
    const RationalPoint p{rational(c.u), rational(c.v)};
    const std::string what = c.undefined ? fmt::format("{}, undefined: {}", got, c.cause) : got;
    tally.mismatch(Kind::interior, simplicity(p), [&] {
      return Counterexample{simplicity(p), level_, at, {}, fmt::format("{}", want), what};
    });
  }

  const SourceSubject& subject_;
  Dialect dialect_;
  Level level_;
  std::vector<Pair> pairs_;
  std::atomic<bool> refuted_ = false;
  std::mutex lock_;
  std::string failed_;
};

Tally judge(const Subject& any, Dialect dialect, Level n, const Run& run) {
  const SourceSubject& subject = of_source(any);
  Run quick = run;
  quick.options = {};
  quick.near = 0;
  quick.progress = nullptr;
  quick.division = nullptr;
  const auto on_sample = dialect == Dialect::exact ? exact_on_floats : equals_published;
  if (const Tally sample = on_sample(subject, n, quick, pairs_run); sample.mismatches() != 0) {
    Tally tally(run.errors);
    for (Counterexample c : sample.found()) {
      tally.count(Kind::interior, 1);
      tally.mismatch(Kind::interior, c.simplicity, [&] { return c; });
    }
    return tally;
  }
  OfLevel level(subject, dialect, n);
  const Tally tally = sweep(run, level.count(), 1, [&](Chunk chunk, Tally& part) {
    for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) level.judge(k, part);
  });
  if (interrupted()) return tally;
  level.settled(tally);
  return tally;
}

/// The numbers of a case's text.  Throws BadCase.
FloatPair floats_of(const std::string& at) {
  const Groups parts = groups_of(at, "(?:[a-z]:)?u=([^,=]+),v=([^,=]+)");
  if (!parts) throw BadCase(fmt::format("{}: write u=...,v=..., for example u=0x1.8p-2,v=0.25", at));
  const auto number = [&](const std::string& text) {
    char* end = nullptr;
    const float x = std::strtof(text.c_str(), &end);
    if (*end == 0 && x >= 0 && x <= 1) return x;
    // The text of a sample's case has fractions.
    const RationalPoint p = parse_point("u=" + text + ",v=0");
    const auto y = static_cast<float>(nearest(p.u));
    if (rational(y) != p.u) throw BadCase(fmt::format("{}: no binary32 number in [-0, 1]", text));
    return y;
  };
  return {number((*parts)[1]), number((*parts)[2])};
}

std::string published_here_too(const std::string& index) {
  return fmt::format("the published code gives {} here, too", index);
}

/// The published code's index on the first counterexample of exact arithmetic.
std::vector<std::string> beside_the_published_code(const Subject&, const std::vector<Result>& results) {
  for (const Result& r : results)
    for (const Counterexample& c : r.counterexamples) {
      const auto [u, v] = floats_of(c.at);
      const std::string code = fmt::format("{}", published(c.level, u, v));
      return {fmt::format("level {} case {}: {}", c.level, c.at,
                          c.got == code
                              ? published_here_too(code) +
                                    "; add --dialect published for a function that follows it to the letter"
                              : fmt::format("the published code gives {} here", code))};
    }
  return {};
}

/// The reason why the index of a pair is undefined, though it came out right; empty if it is defined.
std::string undefined_at(const IndexSubject& any, Level n, float u, float v) {
  const auto* subject = dynamic_cast<const SourceSubject*>(&any);
  if (subject == nullptr || subject->code.not_known(n)) return {};
  const auto range = [](float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return Range{bits >> 31 != 0, bits >> 23 & 255, bits >> 23 & 255};
  };
  const Pair pair{range(u), range(v)};
  const Formula formula = subject->code.formulas(n, pair.u, pair.v);
  // Either dialect shows what is undefined.
  const Solved found = induction::ask_words(
      statement_of(n, pair, formula, Dialect::exact,
                   Bits{std::bit_cast<std::uint32_t>(u), std::bit_cast<std::uint32_t>(v)}));
  const Claimed c = claimed_by(found, pair, formula);
  return found.answer == Answer::sat && c.undefined ? c.cause : "";
}

}  // namespace

SourceSubject::SourceSubject(std::string name, std::string about, Functions f, std::string fingerprint,
                             Code c)
    : IndexSubject(std::move(name), std::move(about), std::move(f), std::move(fingerprint)),
      code(std::move(c)) {}

Law law(Dialect dialect, std::string replayed_by) {
  const bool exact = dialect == Dialect::exact;
  Law l{.id = "index.floats",
        .topic = "index",  // no registry fills it in: a source is the law's only subject
        .says = fmt::format(
            "for every pair of binary32 numbers the function's index is defined and {}",
            exact ? "that of the exact reference" : "bit for bit that of the published code in binary32"),
        .source = vulkan,
        .method = Method::bit_vectors,
        .tiers = {.fast = {9, 9}, .long_run = {0, highest}},
        .cases = [](Level n, const Run&) { return count_of_pairs(n); },
        .domain =
            "every pair of binary32 numbers u and v in [-0, 1] with u + v <= 1 + 2^-23, by pairs of "
            "exponents",
        .how =
            [](const Subject& s, Level) {
              return fmt::format("bit vectors, {}; {}", induction::prover_name(), of_source(s).code.read_as);
            },
        .unfit = [](const Subject& s, Level n) -> std::optional<std::string> {
          if (n > highest) return fmt::format("levels 0..{}", highest);
          return of_source(s).code.not_known(n);
        },
        .divisible = true,
        .judge = [dialect](const Subject& s, Level n, const Run& run) { return judge(s, dialect, n, run); },
        .replay = [dialect](
                      const Subject& s, Level n,
                      const std::string& at) { return replay(subject_as<IndexSubject>(s), dialect, n, at); },
        .diagnose = exact ? beside_the_published_code : decltype(Law::diagnose)(),
        .dialect = exact ? "" : "published"};
  l.replayed_by = std::move(replayed_by);
  return l;
}

Replayed replay(const IndexSubject& subject, Dialect dialect, Level n, const std::string& at) {
  if (n > highest) throw BadCase(fmt::format("{}: levels 0..{}", at, highest));
  const auto [u, v] = floats_of(at);
  if (static_cast<double>(u) + static_cast<double>(v) > 1 + 0x1p-23)
    throw BadCase(fmt::format("{}: the law is about u + v <= 1 + 2^-23", at));
  const std::uint32_t want = due(dialect, n, u, v);
  const std::string expected = fmt::format("{}", want), first = answer_where_undefined(subject, n, u, v);
  const std::string cause = first == expected || first == "no index" ? undefined_at(subject, n, u, v) : "";
  if (!cause.empty()) return {false, expected, fmt::format("{}, undefined: {}", first, cause), {}};
  const std::string got = first == "no index" ? fmt::format("{}", asked(subject, n, u, v)) : first;
  const bool here_too =
      dialect == Dialect::exact && got != expected && got == fmt::format("{}", published(n, u, v));
  return {
      got == expected, expected, here_too ? fmt::format("{} ({})", got, published_here_too(got)) : got, {}};
}

}  // namespace mmverify::proofs::index::source
