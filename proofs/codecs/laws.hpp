// Laws of codecs that are proved from their source: which harness states a law, on which choices.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "subjects/dock/entry_points.hpp"

namespace mmverify::proofs::codecs {

/// The form in which choices are written: a digit each, two hexadecimal digits each, or one decimal number.
enum class Written { digits, bytes, number };

/// Choices of one harness that follow each other: so many numbers of so many bits.
struct Chosen {
  std::string name;  ///< empty: those that the case's text begins with
  Written written = Written::digits;
  unsigned bits = 1;
  std::uint64_t count = 1;
};

/// A function of a harness, at a level, in a format, with a size: what the prover is asked.
struct Question {
  std::string file, function;  ///< "tree.c", "round_trip"
  Level level = 0;
  unsigned format = 1;  ///< bits of a state
  std::uint64_t size = 0;
  std::string begins;  ///< the beginning of its cases' texts: "4-state", "block"
  std::vector<Chosen> chosen;
  bool by_contract = false;  ///< a step from level to level: no case breaks it
};

/// The entry points, flags and highest level that a codec declares.
struct Facts {
  std::function<bool(dock::Call)> offers;
  std::uint32_t flags = 0;
  Level max_level = 0;
  std::function<bool(const std::string& symbol)> defines = {};  ///< a function of that name in its bitcode
};

/// A harness's function as part of a law: it is asked where the codec has the entry points and the flag.
struct Harness {
  const char *file, *function;
  std::vector<dock::Call> needs;
  std::uint32_t flag = 0;  ///< that the codec declares; 0: none
  std::vector<unsigned> formats;
  std::function<std::vector<std::uint64_t>(const Facts&, Level, unsigned format)> sizes;
  std::function<std::vector<Chosen>(Level, unsigned format, std::uint64_t size)> chosen;
  const char* begins = nullptr;  ///< null: the format
};

/// How a law is proved from level to level: functions of a file, for the subtrees of each level and for the entry points.
struct ByContract {
  const char *symbol, *file;  ///< of codecs that define the symbol
  std::vector<const char*> steps, wholes;
  Level first = 0;        ///< the lowest level of a subtree
  bool on_a_map = false;  ///< a step is about a subtree of a map of the level, not about one of any map
};

struct CodecLaw {
  const char* id;  ///< of the law of the registry that it proves
  Levels fast, long_run;
  bool fixed = false;  ///< it has the level `fast.first` alone, and runs for any levels that are asked for
  std::vector<unsigned> formats;
  std::function<std::string(Level, unsigned format)> domain;
  const char* sampled;  ///< the law that runs on the compiled codec if the budget is spent
  std::vector<Harness> harnesses;
  std::vector<ByContract> by_contract = {};
};

const std::vector<CodecLaw>& laws();

/// The reason why a law is not about a codec at a level, if any.
std::optional<std::string> unfit(const CodecLaw& law, const Facts& facts, Level level, unsigned format);

/// The questions that a law is proved by.  Domain: unfit() gives no reason.
std::vector<Question> questions(const CodecLaw& law, const Facts& facts, Level level, unsigned format);

/// The questions that a law is proved by from level to level; none below `by_contract_from`, or if the law or the codec
/// has no contract. No case breaks one of them: a step takes codes that no map has.
std::vector<Question> questions_by_contract(const CodecLaw& law, const Facts& facts, Level level,
                                            unsigned format);

/// Up to the level below, all maps are one formula.
inline constexpr Level by_contract_from = 3;

/// "2-state", "4-state".
std::string format_name(unsigned format);

/// The texts of the harnesses and of what they include, by file name.
const std::map<std::string, std::string>& texts();

}  // namespace mmverify::proofs::codecs
