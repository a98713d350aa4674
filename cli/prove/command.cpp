// mmverify prove: runs laws on subjects and reports the verdicts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/junit.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/codec.hpp"
#include "cli/prove/left_out.hpp"
#include "cli/prove/run_identity.hpp"
#include "cli/prove/shader.hpp"
#include "cli/prove/short/run_text.hpp"
#include "cli/prove/source.hpp"
#include "cli/prove/time_table.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/index/options.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/registry/plugin.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

struct ProveOptions {
  std::vector<std::string> laws, subjects;
  std::optional<std::string> levels;
  std::string tier = "fast", cells = "all", dialect = "either", json, junit;
  unsigned threads = 0;
  std::uint32_t near = 0;
  std::size_t errors = 1;
  std::uint64_t seed = 1, cases = 0;
  std::optional<double> timeout;
  std::vector<std::uint32_t> devices;
  std::optional<std::string> entry;
  bool quiet = false, details = false, time = false, no_mutants = false, no_companions = false;
  std::string shard, journal;
  std::optional<std::string> source, function, one_case, format;
  std::vector<std::string> flags;
  std::optional<double> budget;
  std::string certificates, second_solver;
};

Request request(const ProveOptions& options, std::vector<RunsOn>& runs_on) {
  Request r;
  r.tier = options.tier == "long" ? Tier::long_run : Tier::fast;
  r.laws = parse_laws(options.laws, r.tier);
  std::vector<std::string> called;
  for (const std::string& name : options.subjects) {
    std::vector<std::optional<std::uint32_t>> devices(options.devices.begin(), options.devices.end());
    if (devices.empty()) devices.emplace_back();
    for (const auto& device : devices) {
      const std::string on_device = with_device(name, device, options.entry);
      // A library, or a shader that names its device, is used once and not for each device.
      if (std::find(called.begin(), called.end(), on_device) == called.end()) called.push_back(on_device);
    }
  }
  for (const std::string& name : called)
    for (const SubjectPtr& subject : parse_subject(name, timeout_of(name, options.timeout), &runs_on))
      if (std::find(r.subjects.begin(), r.subjects.end(), subject) == r.subjects.end())
        r.subjects.push_back(subject);
  if (options.levels) r.levels = parse_levels(*options.levels);
  r.dialect = options.dialect;
  r.by_id = options.laws;
  r.companions = !options.no_companions;
  return r;
}

std::optional<Shard> parse_shard(const std::string& text) {
  if (text.empty()) return std::nullopt;
  Shard shard{0, 0};
  if (const Groups parts = groups_of(text, "([0-9]{1,6})/([0-9]{1,6})"))
    shard = {static_cast<std::uint32_t>(std::stoul((*parts)[1])),
             static_cast<std::uint32_t>(std::stoul((*parts)[2]))};
  if (shard.number < 1 || shard.number > shard.of)
    throw UsageError(fmt::format("--shard {}: write K/N with K from 1 to N, for example 2/7", text));
  return shard;
}

/// Prints where the subjects run, and warnings. The first line about each names its device.
void say_where(const std::vector<RunsOn>& runs_on, RunText& text) {
  for (const RunsOn& one : runs_on) {
    for (std::size_t k = 0; k < one.about.size(); ++k) {
      const std::string line =
          fmt::format("{}: {}: {}", one.subject, one.about[k].first, one.about[k].second);
      if (k == 0)
        text.note(line);
      else
        text.detail(line);
    }
    for (const std::string& warning : one.warnings) text.note("warning: " + warning);
  }
}

/// Names the laws that run in addition to the one requested.
void announce_companions(const std::vector<Job>& jobs, RunText& text) {
  std::vector<std::string> said;
  for (const Job& job : jobs) {
    if (job.brought_by == nullptr || !job.unfit.empty()) continue;
    const std::string line = fmt::format(
        "{} runs as well, because the cases of {} exercise only a few distinct floats; --no-companions "
        "leaves it out",
        job.law->id, job.brought_by->id);
    if (std::find(said.begin(), said.end(), line) == said.end()) said.push_back(line);
  }
  for (const std::string& line : said) text.detail(line);
}

/// Names the laws that --no-companions left out: without them a verdict covers few numbers.
std::vector<std::string> left_out_companions(Request request, const std::vector<Job>& jobs) {
  if (request.companions) return {};
  request.companions = true;
  std::vector<std::string> said;
  for (const Job& job : plan(request))
    if (job.unfit.empty() && std::find(said.begin(), said.end(), job.law->id) == said.end() &&
        std::none_of(jobs.begin(), jobs.end(), [&](const Job& ran) { return ran.law == job.law; }))
      said.push_back(job.law->id);
  if (said.empty()) return {};
  return {fmt::format("left out by --no-companions: {}; the verdict then covers only a few distinct floats",
                      fmt::join(said, ", "))};
}

/// The lines that bound the verdict: companions and levels that were not run.
std::vector<std::string> left_out_lines(const Request& asked, const std::vector<Job>& jobs,
                                        const Report& report, bool levels_named) {
  std::vector<std::string> lines = left_out_companions(asked, jobs);
  if (levels_named)
    for (const std::string& line : levels_left(jobs, report)) lines.push_back(line);
  return lines;
}

/// The laws of a codec's source.
int prove_codec_of(const ProveOptions& options) {
  if (!options.subjects.empty())
    throw UsageError("--source and --subject: give one of them; the source is the subject that is judged");
  if (!options.shard.empty() || !options.journal.empty())
    throw UsageError("--shard, --journal: a codec's proof has no parts; leave them out");
  if (options.time)
    throw UsageError("--time: a codec's proof says each law's seconds by itself; leave it out");
  CodecOptions codec;
  codec.file = *options.source;
  codec.flags = options.flags;
  codec.laws = options.laws;
  if (options.levels) codec.levels = parse_levels(*options.levels);
  codec.format = options.format;
  codec.one_case = options.one_case;
  refuse_no_folder("--certificates", options.certificates);
  codec.certificates = options.certificates;
  codec.second_solver = options.second_solver;
  codec.tier = options.tier == "long" ? Tier::long_run : Tier::fast;
  if (options.budget) codec.budget = *options.budget;
  codec.timeout = timeout_of("", options.timeout);
  codec.seed = options.seed;
  codec.quiet = options.quiet;
  codec.details = options.details;
  codec.json = options.json;
  codec.junit = options.junit;
  return prove_codec(codec);
}

/// The job of proving index.floats of a function in a source, the only law for functions.
Job job_of_source(const ProveOptions& options) {
  if (options.laws != std::vector<std::string>{"index.floats"})
    throw UsageError(
        "--source: index.floats is proved of a function, and nothing else; write mmverify prove "
        "index.floats");
  if (options.format || options.budget || !options.certificates.empty() || !options.second_solver.empty())
    throw UsageError(
        "--format, --budget, --certificates, --second-solver: they are for a codec's laws; leave them out");
  if (!options.subjects.empty())
    throw UsageError("--source and --subject: give one of them; the source is the subject that is judged");
  SourceOptions of{*options.source, "index_of", options.flags, options.dialect == "published"};
  if (options.function) of.function = *options.function;
  const std::optional<Levels> levels =
      options.levels ? std::optional(parse_levels(*options.levels)) : std::nullopt;
  return source_job(of, levels, options.tier == "long" ? Tier::long_run : Tier::fast,
                    timeout_of("", options.timeout));
}

/// Replays a counterexample, LEVEL@CASE.
int replay_of_source(const Job& job, const std::string& text) {
  const Groups parts = groups_of(text, "([0-9]{1,2})@(.+)");
  if (!parts)
    throw UsageError(fmt::format("--case {}: write LEVEL@CASE, as a counterexample's line does", text));
  const Level level = parse_level((*parts)[1]);
  const auto why = job.unfit.empty() ? job.law->unfit(*job.subject, level) : std::optional(job.unfit);
  if (why) {
    say(stdout, "n/a {} level {} subject {} {}\n", job.law->id, level, job.subject->name(), *why);
    return ExitCode::usage;
  }
  try {
    const Replayed r = job.law->replay(*job.subject, level, (*parts)[2]);
    say(stdout, "{} {} level {} case {} subject {} expected {} got {}\n", r.holds ? "holds" : "refuted",
        job.law->id, level, (*parts)[2], job.subject->name(), r.expected, r.got);
    return r.holds ? ExitCode::complete : ExitCode::failed;
  } catch (const BadCase& error) {
    throw UsageError(fmt::format("--case {}", error.what()));
  }
}

int prove_laws(const ProveOptions& options) {
  if ((!options.devices.empty() || options.entry) &&
      std::none_of(options.subjects.begin(), options.subjects.end(), is_shader))
    throw UsageError("--device, --entry: no --subject is a shader; leave them out");
  // Loading a library may take long, so interrupts are handled from here on.
  const InterruptGuard guard;
  std::vector<RunsOn> runs_on;
  const Request asked = options.source ? Request{} : request(options, runs_on);
  const std::vector<Job> jobs = options.source ? std::vector<Job>{job_of_source(options)} : plan(asked);
  if (options.one_case) return replay_of_source(jobs.front(), *options.one_case);
  if (options.cells == "interior" && std::none_of(jobs.begin(), jobs.end(), [](const Job& job) {
        return has(job.law->heeds, index::interiors_only);
      }))
    throw UsageError("--cells interior: none of these laws is about points on cells; leave it out");
  if (options.near != 0 &&
      std::none_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.law->knows_near; }))
    throw UsageError("--near: none of these laws compares indices at points; leave it out");
  JsonOutput json(options.json);
  std::optional<OutputFile> junit;
  // An old shard's file must not be merged in place of this one if this run fails.
  if (!options.shard.empty()) json.remove_old();
  if (!options.junit.empty()) junit.emplace(options.junit);

  RunText text(json.text(), options.details, !options.laws.empty(),
               options.source ? std::vector{jobs.front().subject} : asked.subjects);
  RunOptions run{options.threads,
                 options.errors,
                 options.seed,
                 options.tier == "long" ? Tier::long_run : Tier::fast,
                 options.cases,
                 options.cells == "interior" ? Options{&index::interiors_only} : Options{},
                 options.near,
                 !options.quiet,
                 parse_shard(options.shard)};
  const Identity identity = identity_of(jobs, run);
  const std::unique_ptr<Journal> journal = open_journal(options.journal, identity, run.shard);
  run.journal = journal.get();
  run.mutants = !options.no_mutants;
  run.side_by_side = options.subjects.empty() && !options.source;
  run.change_of = change_of;
  say_where(runs_on, text);
  announce_companions(jobs, text);
  const Report report = run_jobs(jobs, run, [&](const Result& r) { text.add(r); });
  text.finish(report, !options.subjects.empty() || options.source,
              left_out_lines(asked, jobs, report, options.levels.has_value()));
  if (options.time)
    for (const std::string& line : time_table(report, processor_seconds())) say(json.text(), "{}\n", line);
  if (report.interrupted && journal)
    say(stderr, "stopped; the same command goes on from {}\n", options.journal);
  json.write([&] { return to_json(report, options.seed, run.shard, identity, {}, runs_on); });
  if (junit) junit->commit(to_junit(report, runs_on));

  if (!report.gave_up.empty()) throw EnvironmentError(report.gave_up);
  refuse_nothing(report);
  const int code = exit_code(report);
  if (code == ExitCode::complete && !options.source)
    refuse_what_was_left_out({options.levels, options.laws, options.subjects}, jobs, report);
  return code;
}

int prove(ProveOptions options) {
  // One law of index is proved from a source.
  if (options.source)
    std::replace(options.laws.begin(), options.laws.end(), std::string("index"), std::string("index.floats"));
  if (options.junit == "-") throw UsageError("--junit -: only --json can go to standard output; name a file");
  refuse_same_file({{"--json", options.json}, {"--junit", options.junit}, {"--journal", options.journal}});
  const bool codec = options.source && asks_for_codec(options.laws, options.function.has_value());
  return codec ? prove_codec_of(options) : prove_laws(options);
}

/// The options about how strictly, and on which cases.
void add_judging(CLI::App& command, ProveOptions& options) {
  command.add_option("--tier", options.tier, "fast or long")->check(CLI::IsMember({"fast", "long"}));
  command.add_option("--cells", options.cells, "all, or interior: leave out points on grid lines")
      ->check(CLI::IsMember({"all", "interior"}));
  command
      .add_option("--dialect", options.dialect,
                  "what binary32 answers are held against: exact arithmetic, the published code, or either")
      ->check(CLI::IsMember({"exact", "published", "either"}));
  command
      .add_option(
          "--near", options.near,
          "let a point that misses an edge by so many units in the last place have a neighbour's index")
      ->type_name("ULPS")
      ->check(whole_within(0, 1 << 20));
  command.add_flag("--no-companions", options.no_companions,
                   "leave out the laws on floats that run with a law whose cases exercise few floats");
  command.add_option("--errors", options.errors, "how many counterexamples each result keeps")
      ->check(whole_within(1, 10'000));
  command
      .add_option("--cases", options.cases,
                  "draw at least so many cases of each sampled law of bakers, over its four lowest levels")
      ->check(whole_within(1, 10'000'000));
}

/// The options of shaders.
void add_shaders(CLI::App& command, ProveOptions& options) {
  command
      .add_option("--device", options.devices,
                  "the Vulkan devices that run a shader, each by itself, by number; 0 where not given")
      ->type_name("N[,N...]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(whole_within(0, 9999));
  command
      .add_option("--entry", options.entry,
                  "what a shader with a main of its own answers, index_f32 where not given; of a file of "
                  "functions, the one that is asked")
      ->type_name("NAME");
}

/// The options that name files.
void add_outputs(CLI::App& command, ProveOptions& options) {
  command.add_option("--json", options.json, "write the results as JSON; - is stdout")->type_name("FILE|-");
  command.add_option("--junit", options.junit, "write the results as JUnit XML")->type_name("FILE");
  command.add_option("--shard", options.shard, "run part K of N of each law's domain; see merge")
      ->type_name("K/N");
  command
      .add_option("--journal", options.journal,
                  "keep finished work in this file as it comes; the same run started again goes on from it")
      ->type_name("FILE");
}

/// --source, and the options that need it.
void add_source(CLI::App& command, ProveOptions& options) {
  auto* const source =
      command
          .add_option(
              "--source", options.source,
              "a codec in C, C++, Rust or LLVM's bitcode: prove its laws for every map; or, with "
              "index.floats, a function in these or in GLSL, HLSL or SPIR-V, for every pair of floats")
          ->type_name("FILE.c|.cpp|.rs|.bc|.ll|.glsl|.comp|.hlsl|.spv");
  command.add_option("--function", options.function, "its name in the source; index_of where not given")
      ->type_name("NAME")
      ->needs(source);
  command.add_option("--flag", options.flags, "one more flag of clang, as --flag=-DFAST; may be given again")
      ->type_name("FLAG")
      ->allow_extra_args(false)
      ->needs(source);
  command.add_option("--format", options.format, "the format of a codec's maps; both where not given")
      ->check(CLI::IsMember({"2-state", "4-state"}))
      ->needs(source);
  command
      .add_option("--budget", options.budget,
                  "seconds for one law of a codec at one level in one format, 60 where not given; then its "
                  "sample runs")
      ->type_name("SECONDS")
      ->check(finite_within(0.1, 1e6))
      ->needs(source);
  command
      .add_option("--certificates", options.certificates,
                  "an existing folder: each proof of a codec leaves its steps there")
      ->type_name("FOLDER")
      ->needs(source);
  command
      .add_option(
          "--second-solver", options.second_solver,
          "a SAT solver, as minisat: a program that takes DIMACS and exits with 10 or 20; it is asked again "
          "what a codec's proofs rest on")
      ->type_name("PROGRAM")
      ->needs(source);
  command.add_option("--case", options.one_case, "run the source on one counterexample again")
      ->type_name("LEVEL@CASE")
      ->needs(source);
}

}  // namespace

Action add_prove(CLI::App& program) {
  auto* command = program.add_subcommand(
      "prove", "run laws; with no arguments the fast tier of all, on the built-in subjects");
  auto options = std::make_shared<ProveOptions>();
  command->add_option("law", options->laws, "laws or topics")->type_name("LAW|TOPIC");
  command->add_option("--levels", options->levels, "levels A..B, both included; the tier's where not given")
      ->type_name("A..B");
  command->add_option("--subject", options->subjects, "the subject to judge; may be given again")
      ->type_name("NAME|FILE.so|SHADER")
      ->allow_extra_args(false);
  command
      ->add_option("--threads", options->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  add_judging(*command, *options);
  command->add_option("--seed", options->seed, "seed of every sample")->check(fits_64_bits);
  command
      ->add_option("--timeout", options->timeout,
                   "seconds that a library may take for a batch; 10 where not given, 60 of a shader")
      ->check(finite_within(0.01, 86400));
  add_shaders(*command, *options);
  add_outputs(*command, *options);
  add_source(*command, *options);
  command->add_flag("--no-mutants", options->no_mutants,
                    "leave out the wrong subjects by which each law shows that it can fail");
  add_details(*command, options->details);
  command->add_flag("--time", options->time,
                    "print each law's seconds and processor seconds, and the longest task; not of a codec");
  command->add_flag("--quiet", options->quiet, "no progress on stderr");
  return [options] { return prove(*options); };
}

}  // namespace mmverify::cli
