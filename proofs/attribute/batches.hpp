// A law whose cases are the elements of a level under several settings (orders, pairs of orders), asked in batches.
#pragma once

#include "proofs/attribute/elements.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

/// The outcome of one element: a number for the digest, and whether the law holds.
struct Outcome {
  std::uint64_t answer = 0;
  bool holds = true;
};

/// The cases of a law: setting 0 with all elements, setting 1 with all, and so on.
template <class Element>
struct Batches {
  std::vector<std::string> settings;          ///< their names; a case is named "SETTING:ELEMENT"
  std::function<std::uint64_t(Level)> count;  ///< the number of elements
  /// Writes one outcome for each element.
  std::function<void(const AttributeSubject&, Level, std::size_t setting, std::span<const Element>,
                     std::span<Outcome>)>
      check;
  /// The words for an element that fails.
  std::function<Words(const AttributeSubject&, Level, std::size_t setting, const Element&)> words;
  Kind kind;  ///< the kind that all elements count as, unless kind_of() is overloaded
  /// Draws the elements from number `first` on; empty: all elements of a level, by number.
  std::function<void(Level, std::uint64_t first, std::span<Element>, std::uint64_t seed)> draw = {};
  /// The number of drawn elements.
  std::function<std::uint64_t(Level, const Run&)> drawn = {};
};

/// The kind that an element counts as.
template <class Element>
Kind kind_of(const Element&, Kind of_all) {
  return of_all;
}

/// Enough elements to spread the cost of a call, few enough for the cache.
inline constexpr std::uint64_t elements_per_chunk = 4096;

/// Calls visit(first, count) for two parts of a batch, the first of odd length.  Chunks and levels hold multiples of
/// eight, so an implementation that takes eight or sixteen at a time would otherwise never have a remainder.
template <class Visit>
void in_uneven_parts(std::size_t size, Visit visit) {
  const std::size_t first = size * 5 / 8 | 1;
  if (size == 0) return;
  visit(std::size_t{0}, std::min(first, size));
  if (first < size) visit(first, size - first);
}

/// Calls visit(setting, first, count) for a chunk of the cases, cut where a setting ends.
template <class Visit>
void each_setting(Chunk chunk, std::uint64_t elements, Visit visit) {
  for (std::uint64_t k = chunk.begin; k < chunk.end;) {
    const std::uint64_t setting = k / elements, to = std::min(chunk.end, (setting + 1) * elements);
    visit(static_cast<std::size_t>(setting), k - setting * elements, static_cast<std::size_t>(to - k));
    k = to;
  }
}

template <class Element>
Replayed replay_element(const Batches<Element>& cases, const AttributeSubject& s, Level n,
                        const std::string& at) {
  const auto colon = at.find(':');
  const auto setting = std::find(cases.settings.begin(), cases.settings.end(), at.substr(0, colon));
  if (colon == std::string::npos || setting == cases.settings.end())
    throw BadCase(
        fmt::format("'{:.60}': begin with one of {}, then a colon", at, fmt::join(cases.settings, ", ")));
  Element element{};
  read(n, at.substr(colon + 1), element);
  const auto number = static_cast<std::size_t>(setting - cases.settings.begin());
  Outcome outcome;
  cases.check(s, n, number, {&element, 1}, {&outcome, 1});
  if (outcome.holds) return {true, "ok", "ok", {}};
  const Words words = cases.words(s, n, number, element);
  return {false, words.expected, words.got, {}};
}

template <class Element>
Law on_batches(Law law, Lacks lacks, Batches<Element> cases) {
  law.unfit = unfit_by(std::move(lacks));
  law.divisible = true;
  if (!law.how) law.how = to_string(law.method);
  const auto count_of = [cases](Level n, const Run& run) {
    return cases.drawn ? cases.drawn(n, run) : cases.count(n);
  };
  law.cases = [cases, count_of](Level n, const Run& run) { return cases.settings.size() * count_of(n, run); };
  law.judge = [cases, count_of](const Subject& subject, Level n, const Run& run) {
    const AttributeSubject& s = subject_as<AttributeSubject>(subject);
    const std::uint64_t count = count_of(n, run);
    return sweep(
        run, cases.settings.size() * count, elements_per_chunk,
        [&](Chunk chunk, Tally& tally) {
          std::vector<Element> elements;
          std::vector<Outcome> outcomes;
          each_setting(chunk, count, [&](std::size_t setting, std::uint64_t first, std::size_t size) {
            elements.resize(size);
            outcomes.assign(size, {});
            if (cases.draw)
              cases.draw(n, first, std::span(elements), run.seed);
            else
              fill(n, first, std::span(elements));
            in_uneven_parts(size, [&](std::size_t from, std::size_t of) {
              cases.check(s, n, setting, std::span(elements).subspan(from, of),
                          std::span(outcomes).subspan(from, of));
            });
            for (std::size_t t = 0; t < size; ++t) {
              const Kind kind = kind_of(elements[t], cases.kind);
              tally.count(kind, 1);
              tally.digest(setting * count + first + t, outcomes[t].answer);
              if (outcomes[t].holds) continue;
              const Simplicity simplicity{n, first + t, setting};
              tally.mismatch(kind, simplicity, [&] {
                const Words words = cases.words(s, n, setting, elements[t]);
                return Counterexample{
                    simplicity,     n,        cases.settings[setting] + ":" + text_of(elements[t]), {},
                    words.expected, words.got};
              });
            }
          });
        },
        as_one_case(cases.kind));
  };
  law.replay = [cases](const Subject& subject, Level n, const std::string& at) {
    return replay_element(cases, subject_as<AttributeSubject>(subject), n, at);
  };
  return law;
}

}  // namespace mmverify::proofs::attribute
