// The laws of topic index, and its subjects.
#pragma once

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// The highest level that any law of the topic is defined at.
constexpr Level max_level = 30;

/// About the arithmetic: floats, fixed point, and what a representative stands for.
std::vector<Law> arithmetic_laws();

/// About binary32 code: beside exact arithmetic the published code, or either.
std::vector<Law> dialect_laws();

/// About floats: the companions of those over cells.
std::vector<Law> float_laws();

/// About samples of every level up to 16.
std::vector<Law> sample_laws();

/// About levels beyond 16.
std::vector<Law> wide_laws();

/// About what the papers claim.  equals_reference: the law that Algorithm 4's claim is an instance of.
std::vector<Law> paper_laws(const Law& equals_reference);

/// The order of the subject's corners of the first indices of a level, in words: "base, +u, +v", "children 0, 2, 3",
/// one of these permuted, or no common order.
std::string name_corner_order(const IndexSubject& subject, Level n);

/// The reason why the law about a declared order does not apply: none is declared; it names the order that was found.
std::optional<std::string> declares_no_order(const Subject& subject, Level n);

/// The diagnosis of a refuted subject: its order of corners at the first refuted level.
std::vector<std::string> diagnose_corner_order(const Subject& subject, const std::vector<Result>& results);

}  // namespace mmverify::proofs::index
