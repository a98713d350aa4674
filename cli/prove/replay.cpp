// mmverify replay: judges one case again, and draws it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/prove/shader.hpp"
#include "proofs/index/subject.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

struct ReplayOptions {
  std::string law, level, at, subject, picture;
  std::optional<double> timeout;
  std::optional<std::string> answer;
};

/// The subject to replay. A library may have several: FILE:KIND names one, FILE is the first of the law's
/// topic.
SubjectPtr parse_one(const ReplayOptions& options, const Law& law) {
  if (options.answer) try {
      return index::given_answer(*options.answer);
    } catch (const BadCase& error) {
      throw UsageError(fmt::format("--answer {}", error.what()));
    }
  if (options.subject.empty()) return find_subject(law.subjects.front());
  const auto offered = parse_subject(options.subject, timeout_of(options.subject, options.timeout));
  for (const SubjectPtr& subject : offered)
    if (subject->topic() == law.topic) return subject;
  return offered.front();
}

int replay(const ReplayOptions& options) {
  const Law* law = find_law(options.law);
  if (law == nullptr)
    throw UsageError(fmt::format("no law is called '{}'; `mmverify list` names them all{}", options.law,
                                 meant_law(options.law, false)));
  const Level level = parse_level(options.level);
  const SubjectPtr subject = parse_one(options, *law);
  if (const std::string why = subject->absent(); !why.empty())
    throw UsageError(fmt::format("{}: {}", subject->name(), why));
  if (const auto why = law->unfit(*subject, level)) throw UsageError(*why);
  if (!law->replay)
    throw UsageError(
        fmt::format("{} is not judged case by case; run `mmverify prove {}` again", law->id, law->id));
  std::optional<OutputFile> picture;
  if (!options.picture.empty()) picture.emplace(options.picture);
  try {
    const Replayed r = law->replay(*subject, level, options.at);
    if (picture && r.picture.empty()) throw UsageError(fmt::format("--picture: {} has none", law->id));
    say(stdout, "{} {} level {} case {} subject {} expected {} got {}\n", r.holds ? "holds" : "refuted",
        law->id, level, options.at, subject->name(), r.expected, r.got);
    if (picture) {
      picture->commit(r.picture);
      say(stdout, "picture: {} is written\n", options.picture);
    }
    return r.holds ? ExitCode::complete : ExitCode::failed;
  } catch (const SubjectBroken& broken) {
    say(stdout, "broken {} level {} case {} subject {}: {}\n", law->id, level, options.at, subject->name(),
        broken.what());
    return ExitCode::failed;
  } catch (const BadCase& error) {
    throw UsageError(fmt::format("--case {}", error.what()));
  }
}

}  // namespace

Action add_replay(CLI::App& program) {
  auto* command = program.add_subcommand("replay", "judge one case again, as a counterexample's line says");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("law", options->law, "the law")->type_name("LAW")->required();
  command->add_option("--level", options->level, "the level")->type_name("N")->required();
  command->add_option("--case", options->at, "the case as printed, for example u=3/8,v=5/16 or k=22")
      ->type_name("TEXT")
      ->required();
  command
      ->add_option("--subject", options->subject,
                   "who is judged; the law's first built-in one where not given")
      ->type_name("NAME|FILE.so");
  command->add_option("--answer", options->answer, "judge this answer instead of asking a subject")
      ->type_name("INDEX|CORNERS");
  command->add_option("--timeout", options->timeout, "seconds that a library may take")
      ->check(finite_within(0.01, 86400));
  command->add_option("--picture", options->picture, "draw it")->type_name("FILE.svg");
  return [options] { return replay(*options); };
}

}  // namespace mmverify::cli
