// Common parts of the laws of topic attribute: the check of a case, and the cases that it runs on.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>

#include "proofs/attribute/subject.hpp"
#include "proofs/engine/cases.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::proofs::attribute {

inline constexpr char cam_2[] = "Color and Attribute Micromaps, 3.1, figure 2";
inline constexpr char cam_3[] = "Color and Attribute Micromaps, 3.2, figure 3";
inline constexpr char cam_4[] = "Color and Attribute Micromaps, 4.1, figure 4";

/// Domain: a subject of this topic.
const AttributeSubject& of_attribute(const Subject& s);

/// The reason why a subject does not fit, if any: most often a missing entry point.
using Lacks = std::function<std::optional<std::string>(const AttributeSubject&)>;

/// An entry point that a law needs, and its name in messages.
struct Entry {
  const char* name;
  bool (*there)(const Functions&);
};
Lacks needing(std::vector<Entry> entries);

/// The reason why a law does not apply to a subject at a level: another topic, a level beyond the subject's, or a
/// missing entry point.
std::function<std::optional<std::string>(const Subject&, Level)> unfit_by(Lacks lacks);

/// Cases by number: their count, a case by number, its text, the case of a text (or BadCase), and its check.
template <class Case>
struct Cases {
  std::function<std::uint64_t(Level, const Run&)> count;
  std::function<Case(Level, std::uint64_t k, std::uint64_t seed)> number;
  std::function<std::string(Level, const Case&)> text;
  std::function<Case(Level, const std::string&)> read;
  std::function<Finding(const AttributeSubject&, Level, const Case&)> check;
  std::uint64_t chunk = 256;
  Kind kind = Kind::interior;
  /// Changes a drawn case to one that the subject supports; empty: no change.
  std::function<Case(const AttributeSubject&, const Case&)> fit = {};
};

/// The law on numbered cases.
template <class Case>
Law on_cases(Law law, Lacks lacks, Cases<Case> cases) {
  law.topic = "attribute";
  law.unfit = unfit_by(std::move(lacks));
  const auto drawn = [cases](const Subject& s, Level n, std::uint64_t k, const Run& run) {
    const Case one = cases.number(n, k, run.seed);
    return cases.fit ? cases.fit(of_attribute(s), one) : one;
  };
  return on_numbered_cases(std::move(law),
                           {cases.count,
                            [cases, drawn](const Subject& s, Level n, std::uint64_t k, const Run& run) {
                              return cases.check(of_attribute(s), n, drawn(s, n, k, run));
                            },
                            [cases, drawn](const Subject& s, Level n, std::uint64_t k, const Run& run) {
                              return cases.text(n, drawn(s, n, k, run));
                            },
                            [cases](const Subject& s, Level n, const std::string& at) {
                              return cases.check(of_attribute(s), n, cases.read(n, at));
                            },
                            cases.chunk, cases.kind});
}

}  // namespace mmverify::proofs::attribute
