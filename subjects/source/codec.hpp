// A codec's source: compiled to bitcode, of which laws are proved, and natively, to run what refutes them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "subjects/program/folder.hpp"
#include "subjects/source/errors.hpp"

namespace mmverify::source {

/// A function of a harness, with the values of its macros LEVEL, FORMAT and SIZE.
struct HarnessCall {
  std::string file, function;  ///< "tree.c", "round_trip"
  unsigned level = 0, format = 1;
  std::uint64_t size = 0;
};

/// The answer to one call of any() in a harness.
struct Choice {
  unsigned bits = 0;
  std::uint64_t number = 0;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// The prover's answer about a harness.
struct CodecAnswer {
  enum class Kind { proved, refuted, unknown } kind = Kind::unknown;
  std::string text;             ///< refuted: "codec.c:12: a read outside ..."; unknown: the reason
  std::vector<Choice> choices;  ///< refuted: of the calls of any(), in their order
  std::uint64_t nodes = 0, lemmas = 0, obligations = 0;  ///< proved
};

/// Bounds on a proof, and whom it tells.
struct ProofLimits {
  double seconds = 60;
  std::function<void()> stop = {};  ///< called all the time; an exception ends the proof
  std::function<void(std::uint64_t lemmas, std::uint64_t open)> progress = {};
  std::string certificate = {};  ///< the file that a proof leaves; empty: none
};

/// A run of the compiled codec on choices.
struct CodecRun {
  bool fails = false;
  bool no_room = false;  ///< the harness has too little room for this codec, so the run shows nothing
  std::string expected;  ///< what the law wants, if the codec's answer is another; else empty
  /// The other answer or the fault: "1 in state[k] (the law's tree.c:17)", "AddressSanitizer: ...".
  std::string how;
  /// "expected 0 got 1 in state[k] (the law's tree.c:17)".
  std::string text() const { return expected.empty() ? how : "expected " + expected + " got " + how; }
};

/// A codec in C, in C++ without exceptions, in Rust that aborts where it panics, or in LLVM bitcode.
class Codec {
 public:
  /// Compiles the codec. `texts`: files that harnesses include, and the harnesses, by name.
  /// Errors: NoSource, BadSource, NotAvailable, UnknownInstruction.
  Codec(const std::string& file, const std::vector<std::string>& flags,
        const std::map<std::string, std::string>& texts);

  /// Asks the prover about a harness, for all choices at once.
  /// Errors: UnknownInstruction if it cannot read the codec; BadSource; NotAvailable.
  CodecAnswer prove(const HarnessCall& call, const ProofLimits& limits);

  /// Runs the harness on the compiled codec: at -O2, then under AddressSanitizer and UndefinedBehaviorSanitizer, then
  /// under MemorySanitizer, then under each of these at -O0, then with
  /// buffers at odd addresses and a check of each address, until one run fails.
  CodecRun run(const HarnessCall& call, const std::vector<Choice>& choices,
               const std::function<void()>& stop = {});

  /// Runs the harness at -O2 on all its choices, if their bits together are at most `bits`. `cases`: their number; 0 if
  /// there are more, or a run fails.
  CodecRun run_all(const HarnessCall& call, unsigned bits, std::uint64_t& cases);

  /// A shared library of the codec.
  const std::string& library() const { return library_; }
  /// "clang version 14.0.6".
  const std::string& compiler() const { return compiler_; }
  /// The bytes of the codec's bitcode.
  std::string bitcode() const;
  /// The folder of the files; they exist as long as the pointer does.
  std::shared_ptr<const program::Folder> files() const { return folder_; }

 private:
  /// The codec as an object of that kind of run, compiled when it is first asked for.
  const std::string& object(std::size_t kind);
  /// The flag that leaves the folder out of the names of files in messages.
  std::string without_folder() const;
  /// The harness in bitcode, compiled with these options, its buffers of bytes at odd addresses.
  std::string odd(const HarnessCall& call, const std::vector<std::string>& words);
  /// The harness with its driver as a program of that kind of run.
  std::string program(const HarnessCall& call, std::size_t kind);
  CodecRun run_once(const HarnessCall& call, std::size_t kind, const std::vector<std::string>& arguments,
                    const std::function<void()>& stop, std::string* out);

  std::string file_, bitcode_, library_, compiler_;
  std::vector<std::string> flags_;
  std::shared_ptr<const program::Folder> folder_;
  std::map<std::string, std::string> made_;  ///< files by what they are made of
};

}  // namespace mmverify::source
