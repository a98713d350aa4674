#include "cli/prove/source.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <mutex>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "proofs/engine/bytes.hpp"
#include "proofs/index/source/law.hpp"
#include "proofs/index/subject.hpp"
#include "proofs/registry/plugin.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/source/compile.hpp"
#include "subjects/source/encode/encode.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;
namespace law = proofs::index::source;

/// The function's program at each level, read on demand.
class Programs {
 public:
  explicit Programs(source::Compiled made) : made_(std::move(made)) {}

  const source::Program& at(Level n) {
    const std::lock_guard hold(lock_);
    std::optional<source::Program>& program = programs_.at(n);
    if (!program) program = made_.at_level(n);
    return *program;
  }

  std::optional<std::string> not_known(Level n) {
    try {
      // Any pair of ranges shows whether every operation has a formula.
      formula(n, {false, 0, 100 - n}, {false, 126, 126});
      return std::nullopt;
    } catch (const source::UnknownInstruction& why) {
      return why.what();
    } catch (const source::NotEncoded& why) {
      return why.what();
    }
  }

  law::Formula formula(Level n, const law::Range& u, const law::Range& v) {
    source::Formula f =
        source::encode(at(n), {u.negative, u.first, u.last}, {v.negative, v.first, v.last}, "u", "v");
    law::Formula formula{
        std::move(f.declarations), std::move(f.definitions), std::move(f.index), std::move(f.undefined), {}};
    for (source::Cause& cause : f.causes)
      formula.causes.push_back({std::move(cause.condition), std::move(cause.what)});
    return formula;
  }

  /// Exponent fields of the constants at a level: of floats, of words that may be floats' bits, and, n lower,
  /// of floats that coordinates times 2^n may be compared with.
  std::vector<unsigned> fields(Level n) {
    std::vector<unsigned> all;
    for (const source::Node& node : at(n).nodes) {
      if (node.op != source::Op::constant || node.type.bits != 32) continue;
      const auto field = static_cast<unsigned>(node.numbers[0] >> 23 & 255);
      if (!node.type.floating && (node.numbers[0] >> 31 != 0 || field < 40)) continue;
      // 1, its halves and 2^n occur in every index function, so they tell nothing.
      if ((node.numbers[0] & 0x7fffff) == 0 && field >= 126) continue;
      all.push_back(field);
      if (field > n) all.push_back(field - n);
    }
    return all;
  }

  const source::Compiled& made() const { return made_; }

 private:
  const source::Compiled made_;
  std::mutex lock_;
  std::array<std::optional<source::Program>, 17> programs_;
};

/// The SPIR-V file that a shader's compiler makes; empty if the file is in no shading language.
std::string compiled_shader(const SourceOptions& options, const program::Folder& folder) {
  const std::string& file = options.file;
  if (!shaders::shader_name(file) || file.ends_with(".spv")) return {};
  try {
    return shaders::compile_function(file, options.function, folder);
  } catch (const shaders::BadShader& why) {
    throw source::BadSource(why.what());
  } catch (const shaders::NotAvailable& why) {
    throw source::NotAvailable(why.what());
  }
}

/// The reading of the source that a proof is about: a shader's floats depend on the device.
std::string read_as(const source::Compiled& made, const SourceOptions& options) {
  if (made.compiler() != "SPIR-V") {
    std::string text = "LLVM bitcode of " + made.compiler();
    for (const std::string& flag : options.flags) text += " " + flag;
    return text;
  }
  return "SPIR-V of a device that rounds to nearest, keeps subnormal numbers and contracts nothing";
}

/// Throws UnknownInstruction for a library that names what is defined nowhere; other errors are the
/// environment's.
[[noreturn]] void refuse_library(const std::string& name, const std::string& why) {
  constexpr std::string_view begins = "undefined symbol: ";
  const std::size_t at = why.find(begins);
  if (at == std::string::npos) throw EnvironmentError(fmt::format("{}: {}", name, why));
  const std::string symbol =
      why.substr(at + begins.size(), why.find_first_of(" ,;\n", at + begins.size()) - at - begins.size());
  throw source::UnknownInstruction(fmt::format("{}: the symbol {} is defined nowhere", name, symbol));
}

SubjectPtr subject_of(const SourceOptions& options, const std::string& name, double timeout_seconds) {
  const program::Folder folder("source");
  const auto programs = std::make_shared<Programs>(
      source::Compiled(options.file, options.function, options.flags, compiled_shader(options, folder)));
  const source::Compiled& made = programs->made();
  dock::Options dock;
  dock.timeout_seconds = timeout_seconds;
  dock.called = name;
  dock.keeps = made.files();
  // A journal of one dialect must not go on in the other.
  dock.fingerprint = fmt::format("{} {:016x}{}", made.compiler(), hash_of(made.bitcode()),
                                 options.published ? " published" : "");
  const auto library = [&] {
    try {
      return open_library(made.library(), dock);
    } catch (const dock::CannotLoad& why) {
      refuse_library(options.file, why.what());
    }
  }();
  const auto run = index::plugin_subjects(library).front();
  law::SourceSubject::Code code{
      [programs](Level n, const law::Range& u, const law::Range& v) { return programs->formula(n, u, v); },
      [programs](Level n) { return programs->not_known(n); },
      [programs](Level n) { return programs->fields(n); }, read_as(made, options)};
  return std::make_shared<law::SourceSubject>(name, "a function in a source", run->functions,
                                              run->fingerprint(), std::move(code));
}

}  // namespace

std::string to_text(const SourceOptions& options) {
  std::string text =
      fmt::format("--source {} --function {}", shell_quoted(options.file), shell_quoted(options.function));
  for (const std::string& flag : options.flags) text += fmt::format(" --flag={}", shell_quoted(flag));
  return text + (options.published ? " --dialect published" : "");
}

Job source_job(const SourceOptions& options, const std::optional<Levels>& levels, Tier tier,
               double timeout_seconds) {
  // The law lives as long as the program, as the registry's laws do.
  static const Law of_source = law::law(options.published ? law::Dialect::published : law::Dialect::exact,
                                        "mmverify prove index.floats " + to_text(options));
  const std::string name = options.file + ":" + options.function;
  Job job{&of_source,
          nullptr,
          levels.value_or(tier == Tier::fast ? of_source.tiers.fast : of_source.tiers.long_run),
          {},
          nullptr};
  try {
    job.subject = subject_of(options, name, timeout_seconds);
  } catch (const source::NoSource& why) {
    throw EnvironmentError(why.what());
  } catch (const source::BadSource& why) {
    throw UsageError(why.what());
  } catch (const source::NotAvailable& why) {
    throw EnvironmentError(fmt::format("{}: {}", name, why.what()));
  } catch (const source::UnknownInstruction& why) {
    job.subject = absent_subjects(name, {}, why.what()).front();
    job.unfit = why.what();
  }
  return job;
}

}  // namespace mmverify::cli
