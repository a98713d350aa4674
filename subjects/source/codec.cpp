#include "subjects/source/codec.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

#include "subjects/source/tools.hpp"

namespace mmverify::source {

namespace fs = std::filesystem;

namespace {

using program::ProgramEnd;

/// A way to compile and run a codec.
struct RunKind {
  const char* name;
  std::vector<std::string> flags;
  bool odd = false;  ///< the harness's buffers lie at odd addresses
};

/// An access whose value is not used is gone at -O2 before a sanitizer sees it, so each sanitizer runs at -O0, too.
const std::array<RunKind, 6>& run_kinds() {
  static const std::vector<std::string> address{"-g", "-fsanitize=address,undefined",
                                                "-fno-sanitize=function,vptr", "-fno-sanitize-recover=all"},
      memory{"-g", "-fsanitize=memory"};
  const auto unoptimised = [](std::vector<std::string> flags) {
    flags.push_back("-O0");
    return flags;
  };
  static const std::array<RunKind, 6> kinds{
      RunKind{"plain", {}},
      RunKind{"address", address},
      RunKind{"memory", memory},
      RunKind{"address-unoptimised", unoptimised(address)},
      RunKind{"memory-unoptimised", unoptimised(memory)},
      RunKind{"alignment", {"-g", "-O0", "-fsanitize=alignment", "-fno-sanitize-recover=all"}, true}};
  return kinds;
}

constexpr std::chrono::seconds longest_run{10};
constexpr std::uint64_t prover_memory = std::uint64_t{8} << 30;

std::string prover() {
  return helper(
      "MMVERIFY_CODEC_PROVER", "mmverify-codec",
      "which proves laws of codecs, is missing; install the release's Debian package mmverify-plugins, "
      "or, where you build the sources, llvm-14-dev and libcadical-dev, and build again (./run build does "
      "both)");
}

constexpr std::size_t macros = 3;
void add_macros(std::vector<std::string>& words, const HarnessCall& call) {
  words.push_back("-DLEVEL=" + std::to_string(call.level));
  words.push_back("-DFORMAT=" + std::to_string(call.format));
  words.push_back("-DSIZE=" + std::to_string(call.size));
}

/// The prover's lines, read as they come.
class ProverLines {
 public:
  explicit ProverLines(const ProofLimits& limits) : limits_(limits) {}

  void hear(const std::string& part) {
    rest_ += part;
    for (std::size_t end; (end = rest_.find('\n')) != std::string::npos; rest_.erase(0, end + 1))
      read(rest_.substr(0, end));
  }
  const std::optional<CodecAnswer>& answer() const { return answer_; }

 private:
  void read(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "progress") {
      std::uint64_t lemmas = 0, open = 0;
      if (words >> lemmas >> open && limits_.progress) limits_.progress(lemmas, open);
    } else if (word == "choice" && answer_) {
      Choice choice;
      if (words >> choice.bits >> choice.number) answer_->choices.push_back(choice);
    } else if (word == "proved") {
      answer_ = CodecAnswer{CodecAnswer::Kind::proved, {}, {}, 0, 0, 0};
      words >> answer_->nodes >> answer_->lemmas >> answer_->obligations;
    } else if (word == "refuted" || word == "unknown") {
      const auto kind = word == "refuted" ? CodecAnswer::Kind::refuted : CodecAnswer::Kind::unknown;
      answer_ = CodecAnswer{kind, line.size() > word.size() ? line.substr(word.size() + 1) : "", {}, 0, 0, 0};
    }
  }

  const ProofLimits& limits_;
  std::string rest_;
  std::optional<CodecAnswer> answer_;
};

/// The line of a sanitizer's report that says what is wrong; empty if there is none.
std::string sanitizer_line(const std::string& errors) {
  std::istringstream lines(errors);
  std::string line, summary;
  while (std::getline(lines, line)) {
    if (line.find(": runtime error: ") != std::string::npos) return "UndefinedBehaviorSanitizer: " + line;
    if (line.starts_with("SUMMARY: ")) summary = line.substr(std::string("SUMMARY: ").size());
  }
  return summary;
}

/// The rest of the line of the driver's message that begins with a word; empty if there is none.
std::string after_word(const std::string& message, std::string_view word) {
  std::istringstream lines(message);
  std::string line;
  while (std::getline(lines, line))
    if (line.starts_with(word) && line.substr(word.size()).starts_with(' '))
      return line.substr(word.size() + 1);
  return {};
}

/// The harness's line that the driver names, as "the law's tree.c:17"; empty if it names none.
std::string harness_line(const HarnessCall& call, const std::string& errors) {
  if (!errors.starts_with("line ")) return {};
  return "the law's " + call.file + ":" + after_word(errors, "line");
}

/// A check of the harness that failed.
CodecRun failed_check(const std::string& errors, const std::string& place) {
  constexpr std::string_view of_codec = "codec()->";  // before each entry point in a harness
  std::string name = after_word(errors, "name");
  for (std::size_t at; (at = name.find(of_codec)) != std::string::npos;) name.erase(at, of_codec.size());
  const std::string got = after_word(errors, "got");
  if (got.empty()) return {true, false, {}, name + " is false (" + place + ")"};
  return {true, false, after_word(errors, "expected"), got + " in " + name + " (" + place + ")"};
}

}  // namespace

Codec::Codec(const std::string& file, const std::vector<std::string>& flags,
             const std::map<std::string, std::string>& texts)
    : file_(file), flags_(flags), folder_(std::make_shared<const program::Folder>("codec")) {
  prover();
  refuse_unfit(file, flags);
  compiler_ = clang_version();
  for (const auto& [name, text] : texts) std::ofstream(folder_->file(name)) << text;
  folder_->check_room();
  // The rest is told by clang; a read of the file as it is follows the same words.
  if (is_rust(file)) {
    bitcode_ = folder_->file("codec.bc");
    compiler_ = compile_rust(file, flags, bitcode_, *folder_);
    flags_.clear();
  } else if (is_bitcode(file)) {
    bitcode_ = folder_->file("codec" + fs::path(file).extension().string());
    fs::copy_file(file, bitcode_);
  } else {
    bitcode_ = folder_->file("codec.bc");
    // Messages name variables, which clang drops by itself.
    std::vector<std::string> words{"-O1",
                                   "-g",
                                   "-fno-discard-value-names",
                                   "-Xclang",
                                   "-disable-llvm-passes",
                                   "-emit-llvm",
                                   "-ffp-contract=off"};
    if (is_cpp(file)) words.push_back("-std=c++20");
    words.insert(words.end(), flags.begin(), flags.end());
    compile_file(file, words, bitcode_, *folder_);
  }
  library_ = folder_->file("codec.so");
  std::vector<std::string> link{"-shared", "-o", library_, object(0), "-lm"};
  if (is_cpp(file)) link.push_back("-lstdc++");
  if (const ProgramEnd end = run_clang(link); !end.succeeded)
    throw BadSource(file + ": clang makes no shared library of it (" + end.how +
                    "): " + program::one_line(end.errors));
}

const std::string& Codec::object(std::size_t kind) {
  const RunKind& of = run_kinds().at(kind);
  std::string& made = made_[std::string("codec ") + of.name];
  if (!made.empty()) return made;
  std::vector<std::string> words{"-O2", "-fPIC", "-ffp-contract=off", "-Wno-override-module"};
  if (is_cpp(file_)) words.push_back("-std=c++20");
  words.insert(words.end(), flags_.begin(), flags_.end());
  words.insert(words.end(), of.flags.begin(), of.flags.end());
  const std::string out = folder_->file(std::string("codec.") + of.name + ".o");
  try {
    compile_file(is_bitcode(file_) || is_rust(file_) ? bitcode_ : file_, words, out, *folder_);
  } catch (const BadSource& why) {
    // A copy of bitcode is read; the message names the file that was given.
    std::string text = why.what();
    if (const std::size_t at = text.find(bitcode_); at == 0) text.replace(at, bitcode_.size(), file_);
    throw BadSource(text);
  }
  return made = out;
}

std::string Codec::without_folder() const { return "-fdebug-prefix-map=" + folder_->file("") + "="; }

std::string Codec::odd(const HarnessCall& call, const std::vector<std::string>& words) {
  const std::string even = folder_->file("even." + std::to_string(made_.size()) + ".bc"),
                    out = even + ".odd.bc";
  std::vector<std::string> compile = words;
  compile.insert(compile.end(),
                 {"-fno-sanitize=all", "-c", "-emit-llvm", "-o", even, folder_->file(call.file)});
  if (const ProgramEnd end = run_clang(compile); !end.succeeded)
    throw BadSource(call.file + ": clang does not compile it (" + end.how +
                    "): " + program::one_line(end.errors));
  if (const ProgramEnd end = run_tool({prover(), "--odd", even, out}); !end.succeeded)
    throw BadSource(call.file + ": mmverify-codec: " + end.how + ": " + program::one_line(end.errors));
  return out;
}

std::string Codec::program(const HarnessCall& call, std::size_t kind) {
  const RunKind& of = run_kinds().at(kind);
  std::vector<std::string> words{"-O2", "-w", "-I" + header_folder(), "-DMMVERIFY_REPLAY",
                                 "-DFUNCTION=" + call.function};
  add_macros(words, call);
  std::string key = call.file + of.name + call.function;
  for (std::size_t k = words.size() - macros; k < words.size(); ++k) key += words[k];
  std::string& made = made_[key];
  if (!made.empty()) return made;
  words.insert(words.end(), of.flags.begin(), of.flags.end());
  const std::string law = of.odd ? odd(call, words) : folder_->file(call.file);
  const std::string out = folder_->file("replay." + std::to_string(made_.size()));
  words.insert(words.end(), {law, folder_->file("replay.c"), object(kind), "-o", out, "-lm"});
  if (is_cpp(file_)) words.push_back("-lstdc++");
  if (const ProgramEnd end = run_clang(words); !end.succeeded)
    throw BadSource(file_ + ": clang does not compile it with a law (" + end.how +
                    "): " + program::one_line(end.errors));
  return made = out;
}

CodecAnswer Codec::prove(const HarnessCall& call, const ProofLimits& limits) {
  std::string key = call.file;
  std::vector<std::string> words{"-O1",        "-g", "-Xclang",       "-disable-llvm-passes",
                                 "-emit-llvm", "-w", without_folder()};
  if (is_cpp(call.file)) {
    // A law of the library itself sees its headers, and all fields of its classes.
    words.insert(words.end(), {"-std=c++20", "-fno-access-control"});
    std::copy_if(flags_.begin(), flags_.end(), std::back_inserter(words),
                 [](const std::string& flag) { return flag.starts_with("-I"); });
  }
  add_macros(words, call);
  for (std::size_t k = words.size() - macros; k < words.size(); ++k) key += words[k];
  std::string& law = made_[key];
  if (law.empty()) {
    const std::string out = folder_->file("law." + std::to_string(made_.size()) + ".bc");
    try {
      compile_file(folder_->file(call.file), words, out, *folder_);
    } catch (const BadSource& why) {
      std::string text = why.what();
      for (std::size_t at; (at = text.find(folder_->file(""))) != std::string::npos;)
        text.erase(at, folder_->file("").size());
      throw BadSource(file_ + ": a law does not fit it: " + text);
    }
    law = out;
  }
  std::ostringstream budget;
  budget << limits.seconds;
  std::vector<std::string> run{prover(), bitcode_, law, call.function, "--budget", budget.str()};
  if (!limits.certificate.empty()) run.insert(run.end(), {"--certificate", limits.certificate});
  ProverLines lines(limits);
  constexpr double grace = 30;  // the prover ends by itself; this bounds one that does not
  const program::Bounds bounds{
      std::chrono::seconds(static_cast<std::int64_t>(std::ceil(limits.seconds + grace))), prover_memory,
      std::numeric_limits<std::uint64_t>::max()};
  ProgramEnd end;
  try {
    end = program::run_program(run, {}, limits.stop, bounds,
                               [&](const std::string& part) { lines.hear(part); });
  } catch (const program::NoProgram& why) {
    throw NotAvailable(why.what());
  }
  if (end.how == "exit code 3") throw UnknownInstruction(program::one_line(end.errors));
  if (end.how == "exit code 2") throw BadSource(file_ + ": mmverify-codec: " + program::one_line(end.errors));
  if (end.succeeded && lines.answer()) return *lines.answer();
  CodecAnswer none;
  none.text = "mmverify-codec: " + end.how + (end.errors.empty() ? "" : ": " + program::one_line(end.errors));
  return none;
}

CodecRun Codec::run_once(const HarnessCall& call, std::size_t kind, const std::vector<std::string>& arguments,
                         const std::function<void()>& stop, std::string* out) {
  std::vector<std::string> words{program(call, kind)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  // A sanitizer reserves address space beyond any bound.
  const program::Bounds bounds{longest_run, std::numeric_limits<std::uint64_t>::max(),
                               std::uint64_t{256} << 20};
  const ProgramEnd end = program::run_program(words, {}, stop, bounds);
  if (out != nullptr) *out = end.out;
  if (end.succeeded) return {};
  if (end.how == "exit code 3") return {false, true, {}, harness_line(call, end.errors)};
  if (end.how == "exit code 5") return {false, false, {}, "too many choices to run all"};
  const std::string place = harness_line(call, end.errors), report = sanitizer_line(end.errors);
  if (!place.empty()) return failed_check(end.errors, place);
  if (!report.empty()) return {true, false, {}, report};
  return {true, false, {}, "the compiled codec ends by " + end.how};
}

CodecRun Codec::run(const HarnessCall& call, const std::vector<Choice>& choices,
                    const std::function<void()>& stop) {
  std::vector<std::string> numbers;
  for (const Choice& choice : choices) numbers.push_back(std::to_string(choice.number));
  CodecRun last;
  for (std::size_t kind = 0; kind < run_kinds().size(); ++kind) {
    last = run_once(call, kind, numbers, stop, nullptr);
    if (last.fails || last.no_room) return last;
  }
  return last;
}

CodecRun Codec::run_all(const HarnessCall& call, unsigned bits, std::uint64_t& cases) {
  std::string out;
  CodecRun run = run_once(call, 0, {"--all", std::to_string(bits)}, {}, &out);
  std::from_chars(out.data(), out.data() + out.size(), cases);
  return run;
}

std::string Codec::bitcode() const {
  std::ifstream in(bitcode_, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace mmverify::source
