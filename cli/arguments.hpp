// Arguments that several commands take, read and checked once.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dock/library.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// "3..7" or "5".  Both ends included; UsageError unless first <= last <= proofs::max_level().
proofs::Levels parse_levels(const std::string& text);

/// The same of an option with another name, and without an upper limit: the caller has its own.
proofs::Levels parse_levels(const std::string& text, const char* option);

/// The baker that a subject has.  Throws UsageError where it has none, and what parse_subject does.
proofs::bake::BakeSubjectPtr parse_baker(const std::string& text, double timeout_seconds);

/// "5", of the option --level.
proofs::Level parse_level(const std::string& text);

/// For a double's option: finite and within [least, most].  CLI11's own range lets NaN through.
std::function<std::string(const std::string&)> finite_within(double least, double most);

/// For an option of several: each of "2,4,8" such a number.  An empty one is refused, as in "4,".
std::function<std::string(const std::string&)> each_finite_within(double least, double most);

/// The numbers of a text that each_finite_within() takes.
std::vector<double> parse_numbers(const std::string& text);

/// For a whole number's option: one within [least, most], or what is wrong.
std::function<std::string(const std::string&)> whole_within(std::uint64_t least, std::uint64_t most);

/// For a seed's option: a whole number below 2^64, or what is wrong.  CLI11 takes a greater one for 2^64 - 1.
std::string fits_64_bits(const std::string& text);

/// The text as one word of a shell.
std::string shell_quoted(const std::string& text);

/// Every law that the names mean, in the registry's order and once each; UsageError for a name that means
/// none.
std::vector<const proofs::Law*> parse_laws(const std::vector<std::string>& names, proofs::Tier tier);

/// What is known of where a subject runs, for who prints results.
struct RunsOn {
  std::string subject;
  std::vector<std::pair<std::string, std::string>> about;  ///< key and value
  std::vector<std::string> warnings;
};

/// The subjects that a name or a file means: one built-in, or those that a shared library or a shader offers; the latter are
/// in cli/shader.cpp.  timeout_seconds: for one batch of a library.  UsageError for an unknown name and for a shader that
/// does not compile; EnvironmentError for a file that is missing or is no subject.
std::vector<proofs::SubjectPtr> parse_subject(const std::string& name, double timeout_seconds,
                                              std::vector<RunsOn>* runs_on = nullptr);

/// The subjects of a library that is open; of a kind alone where one is named.
std::vector<proofs::SubjectPtr> subjects_of(const dock::LibraryPtr& library, const std::string& kind,
                                            std::vector<RunsOn>* runs_on);

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t n);

}  // namespace mmverify::cli
