// Reads and checks arguments that several commands take.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/bake/subject.hpp"
#include "proofs/engine/law.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::cli {

/// Reads "3..7" or "5", both ends included. UsageError unless first <= last <= proofs::max_level().
proofs::Levels parse_levels(const std::string& text);

/// Reads levels for the named option, without an upper limit: the caller checks its own.
proofs::Levels parse_levels(const std::string& text, const char* option);

/// The baker of a subject. Throws UsageError if it has none, and whatever parse_subject throws.
proofs::bake::BakeSubjectPtr parse_baker(const std::string& text, double timeout_seconds);

/// Reads "5", the value of --level.
proofs::Level parse_level(const std::string& text);

/// A check for a double's option: finite and within [least, most]. CLI11's own range lets NaN through.
std::function<std::string(const std::string&)> finite_within(double least, double most);

/// A check for an option of several numbers, "2,4,8", each as for finite_within. It refuses an empty part, as
/// in "4,".
std::function<std::string(const std::string&)> each_finite_within(double least, double most);

/// The numbers of a text that each_finite_within() accepts.
std::vector<double> parse_numbers(const std::string& text);

/// A check for an integer option: a whole number within [least, most]. The check returns the fault, or an
/// empty text.
std::function<std::string(const std::string&)> whole_within(std::uint64_t least, std::uint64_t most);

/// A check for a seed: a whole number below 2^64. CLI11 would take a greater one for 2^64 - 1.
std::string fits_64_bits(const std::string& text);

/// A check for an option of bytes, "500MB", which CLI::AsSizeValue reads.
std::string fits_a_size(const std::string& text);

/// The text quoted as one word of a shell.
std::string shell_quoted(const std::string& text);

/// The law, topic or option that an unknown law's name was probably meant to be, as the rest of a sentence; empty
/// if none is near. topics_too: whether a topic may stand in the law's place.
std::string meant_law(const std::string& name, bool topics_too);

/// The laws that the names stand for, in the registry's order, each once. UsageError for a name that stands
/// for none.
std::vector<const proofs::Law*> parse_laws(const std::vector<std::string>& names, proofs::Tier tier);

/// A subject's description of the place where it runs, for printing.
struct RunsOn {
  std::string subject;
  std::vector<std::pair<std::string, std::string>> about;  ///< key and value
  std::vector<std::string> warnings;
};

/// The subjects of a name or a file: a built-in one, or those of a shared library or a shader
/// (cli/prove/shader.cpp). timeout_seconds: for one batch of a library. UsageError for an unknown name and for a
/// shader that does not compile; EnvironmentError for a file that is missing or is no subject.
std::vector<proofs::SubjectPtr> parse_subject(const std::string& name, double timeout_seconds,
                                              std::vector<RunsOn>* runs_on = nullptr);

/// Throws EnvironmentError for a file that is missing, is a folder, or is a source: it says how to build that.
void refuse_no_library(const std::string& file);

/// The subjects of an open library, of one kind if `kind` names it.
std::vector<proofs::SubjectPtr> subjects_of(const dock::LibraryPtr& library, const std::string& kind,
                                            std::vector<RunsOn>* runs_on);

/// The levels as ranges: 4, 5, 6 and 9 as "4..6, 9".
std::string level_ranges(const std::vector<proofs::Level>& levels);

/// The number with separators: 1234567 as 1,234,567.
std::string grouped(std::uint64_t n);

}  // namespace mmverify::cli
