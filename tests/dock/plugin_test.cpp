// [first] Shared-library subjects and programs on a pipe: right, wrong and misbehaving ones, judged by the built
// program.
#include "tests/dock/plugin.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome judge_on(const std::string& threads, const std::string& name, const std::string& more) {
  // Only what hangs is to be found to: on a busy machine a second is soon over.
  const std::string timeout = name == "hang" || name == "forks" || name == "takes_its_time" ? "1" : "30";
  return shell("MMVERIFY_WORKER_MEMORY=200 mmverify prove --details --quiet --no-mutants --timeout " +
               timeout + " --threads " + threads + " --subject " + library(name) + " " + more);
}

Outcome judge(const std::string& name,
              const std::string& more = "index.equals_reference --levels 6..8 --no-companions") {
  return judge_on("1", name, more);
}

/// That of ./run test --every.
bool long_tier() { return std::getenv("MMVERIFY_LONG_TESTS") != nullptr; }

TEST(Subject, the_example_in_c_is_proved_on_all_cells) {
  expect_said(judge("example", "index.equals_reference --levels 0.." + std::string(long_tier() ? "8" : "7")),
              0,
              {"the 3N^2+3N+1 representatives, as binary32 numbers", "checked    index.exact_or_published",
               "example.so: checked, the weakest of its verdicts"});
}

TEST(Subject, entry_points_that_are_missing_are_not_applicable) {
  expect_said(judge("example", "index.corners index.in_range --levels 0..3"), 2,
              {"n/a        index.corners"});
  EXPECT_EQ(judge("example", "index.corners").exit_code, 2);
}

TEST(Subject, every_entry_point_is_judged_and_binary64_apart) {
  const Outcome o = judge("batched", "--levels 0.." + std::string(long_tier() ? "5" : "3"));
  expect_said(o, 0,
              each_of("proved     ", {"index.corners", "index.inverse", "index.row_order",
                                      "index.row_corners", "index.bijective"}));
  expect_said(o, 0, {"batched.so:f64: checked"});
}

// The tie was planted at u = 3/8, v = 1/4 of level 7: the answer is to name that vertex and no other.
TEST(Subject, one_wrong_tie_is_found_and_replayed) {
  const Outcome o = judge("tie");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("level 7: 1 of 49,537 cases wrong (vertices 1, edges 0, interiors 0)"));
  EXPECT_THAT(o.out,
              HasSubstr("refuted index.equals_reference level 7 case v:u=3/8,v=1/4 (0x1.8p-2,0x1p-2) "));
  EXPECT_THAT(o.out, HasSubstr("right at level 6, first wrong at level 7"));
  EXPECT_THAT(
      o.out,
      HasSubstr("wrong on ties only: 1 vertex of level 7; every interior of the levels that ran is right"));
  expect_said(replayed(o), 1, {"refuted index.equals_reference level 7 case v:u=3/8,v=1/4"});
}

#ifdef MMVERIFY_SANITIZED_SUBJECTS
TEST(Subject, a_sanitizers_report_is_named_with_the_case) {
  const Outcome past = judge("address_sanitized");
  EXPECT_EQ(past.exit_code, 1) << past.out << past.err;
  EXPECT_THAT(past.out, HasSubstr("AddressSanitizer: heap-buffer-overflow"));
  EXPECT_THAT(past.out, HasSubstr("at level 6 on case u=0x0p+0,v=0x0p+0"));
  EXPECT_THAT(past.err, HasSubstr("READ of size 1"));
  const Outcome sum = judge("undefined_sanitized");
  EXPECT_EQ(sum.exit_code, 1) << sum.out << sum.err;
  // Its summary, where its runtime writes one; else its first line.
  EXPECT_THAT(sum.out, testing::AnyOf(HasSubstr("UndefinedBehaviorSanitizer: undefined-behavior"),
                                      HasSubstr("runtime error: signed integer overflow")));
  EXPECT_THAT(sum.err, HasSubstr("signed integer overflow"));
}

TEST(Subject, a_sanitized_library_is_not_timed) {
  const Outcome o = shell("mmverify bench index --levels 4 --subject " + library("address_sanitized"));
  EXPECT_EQ(o.exit_code, 4) << o.out;
  EXPECT_THAT(o.err, HasSubstr("it needs libasan.so"));
}
#endif

TEST(Subject, one_wrong_tie_passes_where_only_interiors_count) {
  expect_said(judge("tie", "index.equals_reference --levels 6..8 --cells interior --no-companions"), 0,
              {"those inside micro-triangles only",
               "left out by --no-companions: index.exact_or_published; the verdict then covers only a few "
               "distinct floats\n"});
}

TEST(Subject, children_swapped_from_level_2_are_named) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_said(judge("swapped_from_level_2", "index.equals_reference --levels 0..4 --no-companions"), 1,
              {"the curve, but children 0 and 2 change places from digit 2 on"});
}

TEST(Subject, row_order_is_named) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  EXPECT_THAT(judge("rows", "index.equals_reference --levels 0..4 --no-companions").out,
              HasSubstr("row order (w-minor), not the curve"));
}

TEST(Subject, exchanged_barycentrics_are_named) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  EXPECT_THAT(judge("u_and_v_exchanged", "index.equals_reference --levels 0..4 --no-companions").out,
              HasSubstr("the curve, with (w, u, v) taken as (w, v, u)"));
}

struct Misbehaviour {
  friend void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.name; }
  const char *name, *said;
  bool one_case;
  bool every_time = true;  ///< a worker asks a level's first cases again, once: not in every law
};

class Misbehaving : public testing::TestWithParam<Misbehaviour> {};

TEST_P(Misbehaving, is_broken_and_the_run_goes_on) {
  const auto& [name, said, one_case, every_time] = GetParam();
  // A sanitized tool takes seconds for a level.
  const std::string levels = sanitized ? "7" : "6..8";
  const Outcome o = judge(name, "index.equals_reference index.in_range --no-companions --levels " + levels);
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_THAT(o.out, HasSubstr("broken     index.equals_reference"));
  EXPECT_THAT(o.out, HasSubstr(every_time ? "broken     index.in_range" : " index.in_range"))
      << "the next law is judged";
  EXPECT_THAT(o.out, HasSubstr(said));
  EXPECT_THAT(o.out, HasSubstr(one_case ? "at level 7 on case u=0x1.8p-2,v=0x1p-2"
                                        : "at level 7 in the batch of 4096 cases"));
}

// A crash at one vertex leaves the other cases of its level, and the levels above, to be judged.
TEST(Subject, a_crash_in_a_batch_is_not_declined_and_the_others_judged) {
  const Outcome o =
      judge("crash", "index.equals_reference index.bijective --levels 7..8 --no-companions --json -");
  EXPECT_EQ(o.exit_code, 1) << o.err;
  const auto results = nlohmann::json::parse(o.out).at("results");
  ASSERT_EQ(results.size(), 4u) << o.out;
  const auto& level_7 = results[0];
  EXPECT_EQ(level_7.at("verdict"), "broken");
  EXPECT_EQ(level_7.at("cases_run"), 49537);
  EXPECT_FALSE(level_7.at("by_kind").at("vertex").contains("declined")) << "it does not say that it declines";
  EXPECT_EQ(level_7.at("cases_broken"), 1);
  EXPECT_THAT(level_7.at("fingerprint").get<std::string>(), testing::ContainsRegex("[0-9]+ bytes, crc "));
  EXPECT_THAT(level_7.at("breaks")[0].get<std::string>(),
              HasSubstr("at level 7 on case u=0x1.8p-2,v=0x1p-2"));
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(results[k].at("verdict"), "proved") << results[k];
}

TEST(Subject, a_crash_hides_no_wrong_answer) {
  for (const char* threads : {"1", "4"}) {
    const Outcome o = judge_on(threads, "crash_and_tie", "index.equals_reference --levels 7 --no-companions");
    EXPECT_EQ(o.exit_code, 1) << o.err;
    EXPECT_THAT(o.out, HasSubstr("refuted index.equals_reference level 7 case v:u=1/4,v=1/4"));
    EXPECT_THAT(o.out, HasSubstr("at level 7 on case u=0x1.8p-2,v=0x1p-2"));
  }
}

// Before anything is answered, eight are enough.
TEST(Subject, a_crash_on_every_case_ends_the_law_with_the_first) {
  for (const char* threads : {"1", "4"}) {
    const Outcome o = judge_on(threads, "crash_on_all", "index.equals_reference --levels 9 --no-companions");
    EXPECT_EQ(o.exit_code, 1) << o.err;
    EXPECT_THAT(o.out, HasSubstr("at level 9 on case u=0x0p+0,v=0x0p+0"));
  }
}

// tests/subjects/misbehaving.cpp says how each one misbehaves, at u = 3/8, v = 1/4 of level 7.
INSTANTIATE_TEST_SUITE_P(
    Subject, Misbehaving,
    testing::Values(Misbehaviour{"crash", "crashed (signal ", true},
                    Misbehaviour{"hang", "hung: no answer within 1 s", true},
                    Misbehaviour{"overrun", "it touched memory outside its output", false},
                    Misbehaviour{"underrun", "wrote before the start of its output", false},
                    Misbehaviour{"exits", "called exit(0)", true},
                    Misbehaviour{"throws", "threw an exception: no such triangle", true},
                    Misbehaviour{"rounds", "left the rounding or flush mode changed", true},
                    Misbehaviour{"counts_calls", "non-deterministic, asked", true, false},
                    Misbehaviour{"sees_batch", "non-deterministic, asked in batches of 7", true, false},
                    Misbehaviour{"sees_threads", "non-deterministic, asked from two threads at once", true,
                                 false},
                    Misbehaviour{"forks", "hung: no answer within 1 s", true},
                    Misbehaviour{"fills_memory", "took more than 200 MiB of memory", true},
                    Misbehaviour{"writes_a_file", "File size limit exceeded", true},
                    Misbehaviour{"prints_on", "printed more than 1024 KiB", true},
                    Misbehaviour{"starts_threads", "had more than 512 threads", true},
                    Misbehaviour{"unwritten", "left its output unwritten", true},
                    Misbehaviour{"writes_input", "it wrote to its input or read past its end", true}),
    [](const auto& info) { return std::string(info.param.name); });

// Answers that depend on more than the element and the level.
TEST(Subject, what_it_keeps_between_questions_is_seen) {
  const std::pair<const char*, const char*> all[] = {
      {"keeps_the_last", "asked after level 15: "},
      {"counts_in_16_bits", "left its output unwritten"},
      {"sees_order", "asked in another order: "},
      {"sees_addresses", "asked with its arrays at other addresses: "},
      {"shares_a_buffer", "asked in another order, from two threads at once: "},
      {"shares_a_large_buffer", "asked in a batch of 65543 from two threads at once: "},
      {"publishes_early", "two threads at once, the first time at this level"},
      {"fills_level_16_last", "two threads at once, the first time at this level"},
      {"fills_its_end_last", "two threads at once, the first time at this level"}};
  for (const auto& [name, said] : all) {
    const Outcome o = judge(name, "index.equals_reference --levels 0..9 --no-companions");
    EXPECT_EQ(o.exit_code, 1) << name << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr(said)) << name;
  }
}

TEST(Subject, a_parent_that_is_kept_without_its_level_is_seen) {
  expect_said(judge("keeps_parents", "index.on_samples --levels 16 --no-companions"), 1,
              {"asked after level 1: "});
}

// Five large batches of 0.4 s each: one call may take a second, all of them may not but do.
TEST(Subject, what_hangs_is_one_call) {
  expect_said(judge("takes_its_time", "index.in_range --levels 0 --no-companions"), 0,
              {"proved     index.in_range"});
}

// Levels are asked in turns, to see what is kept between them: a crash is that of its own level all the same.
TEST(Subject, a_crash_is_of_the_level_that_crashes) {
  const Outcome o = judge("crash_at_5", "index.equals_reference --levels 4..5 --no-companions");
  EXPECT_THAT(o.out, testing::ContainsRegex("proved     index.equals_reference [^\n]* level 4 "));
  EXPECT_THAT(o.out, HasSubstr("at level 5 on case u=0x1p-2,v=0x1p-2"));
}

// The rest of the machine, this process among it, goes on.
TEST(Subject, what_it_does_to_others_has_no_effect) {
  for (const std::string name : {"kills_parent", "opens_files"}) {
    // UBSan opens files of its own to look at an object's type.
    if (sanitized && name == "opens_files") continue;
    const Outcome o = judge(name, "index.equals_reference --levels 7 --no-companions");
    EXPECT_EQ(o.exit_code, 0) << name << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr("proved     index.equals_reference")) << name;
  }
}

// Some limit on open files is enough to load the library and too low for a second worker.
TEST(Subject, a_machine_without_room_is_no_fault_of_its) {
  if (sanitized) GTEST_SKIP() << "a sanitizer needs more files than a second worker";
  for (int files = 5; files < 40; ++files) {
    const Outcome o = shell("ulimit -n " + std::to_string(files) +
                            "; mmverify prove index.equals_reference --levels 9..10 --threads 2 --quiet "
                            "--no-mutants --no-companions --json - --subject " +
                            library("example"));
    if (o.exit_code != 4 || o.out.find("\"verdict\": \"incomplete\"") == std::string::npos) continue;
    EXPECT_THAT(o.err, HasSubstr("for a worker: Too many open files"));
    EXPECT_THAT(o.out, Not(HasSubstr("broken")));
    return;
  }
  FAIL() << "no number of files was too few after the first worker";
}

TEST(Subject, what_it_prints_stays_out_of_the_results) {
  const Outcome o = judge("prints", "index.in_range --levels 7 --json -");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(o.out.front(), '{');
  EXPECT_THAT(o.out, HasSubstr("\"mmverify.result/1\""));
  EXPECT_THAT(o.out, Not(HasSubstr("{}")));
}

TEST(Subject, same_digest_for_any_number_of_threads) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto digest = [](const Outcome& o) { return o.out.substr(o.out.find("digest "), 23); };
  const std::string at = "prove index.equals_reference --details --quiet --no-mutants --levels 9 --subject " +
                         library("batched");
  const Outcome one = shell("mmverify " + at + " --threads 1"),
                two = shell("mmverify " + at + " --threads 2");
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(digest(one), digest(two));
  EXPECT_EQ(
      digest(one),
      digest(shell(
          "mmverify prove index.equals_reference --details --quiet --no-mutants --levels 9 --subject step")));
}

TEST(Subject, a_file_that_is_no_subject_is_exit_4) {
  expect_complaint(judge("fault_0"), 4, "it does not export mmverify_subject_v1");
  expect_complaint(judge("fault_1"), 4, "it was built for version 2 of the interface, this is version 1");
  expect_complaint(judge("fault_2"), 4, "all its entry points are null");
  expect_complaint(judge("no/such"), 4, "no such file");
  expect_complaint(shell("mmverify prove --quiet --subject /etc/passwd"), 4, "/etc/passwd: invalid ELF");
}

TEST(Subject, a_replay_line_is_one_for_a_shell_whatever_the_file_is_called) {
  const Folder folder;
  const fs::path odd = folder / "a b'$(exit 9);.so";
  fs::copy_file(library("tie"), odd);
  const Outcome o =
      program({"prove", "index.equals_reference", "--quiet", "--levels", "7", "--subject", odd});
  const auto at = o.out.find("replay: ");
  ASSERT_NE(at, std::string::npos) << o.out << o.err;
  expect_said(shell(o.out.substr(at + 8, o.out.find('\n', at) - at - 8)), 1, {"case v:u=3/8,v=1/4"});
}

TEST(Subject, an_interrupt_does_not_wait_for_a_subject_that_hangs) {
  Process run(program_with({"prove", "index.equals_reference", "--details", "--levels", "6..7", "--timeout",
                            "500", "--subject", library("hang")}));
  ASSERT_TRUE(run.says("level 6"));
  run.send(SIGINT);
  expect_said(run.wait(), 3, {"incomplete index.equals_reference"});
}

// Wherever the run is: while it loads, in a search for the case that crashed, in threads, between calls that end.
TEST(Subject, an_interrupt_ends_the_run_within_a_second_wherever_it_is) {
  for (const auto& [name, law] : {std::pair{"hostile_hangs_while_loaded", "index.in_range"},
                                  std::pair{"hostile_crashes_then_hangs", "index.in_range"},
                                  std::pair{"hostile_is_slow", "index.equals_reference"}})
    for (const int signal : {SIGINT, SIGTERM}) {
      Process run(program_with({"prove", law, "--levels", "6..7", "--timeout", "500", "--threads", "2",
                                "--subject", library(name)}));
      // Until the worker is there and has begun to do what it does.
      while (children_of(run.pid()).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      const auto start = std::chrono::steady_clock::now();
      run.send(signal);
      const Outcome o = run.wait();
      // A second, and what a busy machine takes to wake it.
      EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << name;
      EXPECT_EQ(o.exit_code, 3) << name << o.out << o.err;
    }
}

TEST(Subject, that_is_killed_from_outside_has_no_verdict) {
  Process run(program_with({"prove", "index.in_range", "--levels", "6..7", "--timeout", "500", "--no-mutants",
                            "--no-companions", "--subject", library("hostile_sleeps")}));
  ASSERT_TRUE(run.says("level 6"));
  while (children_of(run.pid()).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  for (const int worker : children_of(run.pid())) kill(worker, SIGKILL);
  const Outcome o = run.wait();
  EXPECT_EQ(o.exit_code, 4) << o.out << o.err;
  EXPECT_THAT(o.err, HasSubstr("killed from outside; out of memory?"));
  EXPECT_THAT(o.out, HasSubstr("incomplete index.in_range"));
  EXPECT_THAT(o.out, Not(HasSubstr("broken")));
}

// Verdicts given before the change are withdrawn too: nobody knows which of the two libraries they are about.
TEST(Subject, that_is_rebuilt_during_the_run_has_no_verdict) {
  const Folder folder;
  const fs::path file = folder / "mine.so";
  for (int round = 0; round < 2; ++round) {
    fs::remove(file);
    fs::copy_file(library("hostile_rewrites_itself"), file);
    const Outcome o =
        program({"prove", "index.in_range", "--levels", "0..1", "--quiet", "--no-mutants", "--no-companions",
                 "--json", "-", "--journal", folder / "journal", "--subject", file});
    EXPECT_EQ(o.exit_code, 4) << o.out << o.err;
    EXPECT_THAT(o.err, HasSubstr("mine.so was changed during the run, from ("));
    for (const auto& r : nlohmann::json::parse(o.out).at("results")) {
      EXPECT_EQ(r.at("verdict"), "incomplete");
      EXPECT_EQ(r.at("cases_run"), 0) << "in round " << round << ", by the journal or not";
    }
  }
}

TEST(Subject, whose_mode_changes_at_load_is_broken) {
  expect_said(judge("hostile_rounds_when_loaded", "index.in_range --levels 0"), 1,
              {"left the rounding or flush mode changed since it was loaded"});
}

TEST(Subject, that_cannot_be_loaded_in_time_is_exit_4) {
  const Outcome o = shell("mmverify prove index --details --quiet --timeout 0.1 --subject " +
                          library("hostile_never_describes_itself"));
  expect_complaint(o, 4, "hung: not done within 1 s while it was loaded");
}

TEST(Subject, that_does_not_answer_ends_its_bench) {
  expect_complaint(shell("mmverify bench index --quiet --levels 7 --subject " + library("crash_on_all")), 4,
                   "crashed (signal 11");
}

// Bytes that are no UTF-8 lost the whole run's JSON, and a line in an exception's text was a line of the report.
TEST(Subject, its_texts_are_words_in_a_line_and_in_json) {
  const Folder folder;
  const Outcome o = judge("hostile_throws_escapes", "index.in_range --levels 0 --no-companions --json " +
                                                        (folder / "out.json").string() + " --junit " +
                                                        (folder / "out.xml").string());
  EXPECT_EQ(o.exit_code, 1) << o.err;
  for (const std::string& text : {o.out, o.err, text_of(folder / "out.json"), text_of(folder / "out.xml")}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_THAT(text, Not(HasSubstr("\nproved     everything")));
  }
  const auto result = nlohmann::json::parse(text_of(folder / "out.json")).at("results")[0];
  EXPECT_THAT(result.at("reason").get<std::string>(), HasSubstr("\\x9b0m\\xff"));
}

// Python's complaint about a reader that stopped is discarded.
const std::string python = std::string("python3 2>/dev/null ") + MMVERIFY_EXAMPLES + "/pipe/index.py";

Outcome piped(const std::string& filter, int level = 5, const std::string& more = "") {
  const std::string n = std::to_string(level);
  return shell("mmverify gen index --level " + n + more + " | " + filter +
               " | mmverify check index --details --level " + n + more);
}

TEST(Pipe, the_example_in_python_is_proved) {
  for (const int level : {0, 1, 5}) {
    const Outcome o = piped(python, level);
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr("proved     index.equals_reference"));
  }
  EXPECT_EQ(piped(python, 4, " --cells interior").exit_code, 0);
}

TEST(Pipe, a_level_has_as_many_cases_as_cells) {
  const Outcome o = shell("mmverify gen index --level 3 | grep -vc '#'");
  EXPECT_EQ(o.out, "217\n");  // 3 64 + 3 8 + 1
}

// Case 5 of level 2 is the vertex (1/2 + 1/8, 0) of the first row: 0 1/8 1/4 3/8 1/2 5/8, an edge's middle,
// in fact.
TEST(Pipe, a_wrong_answer_is_refuted_and_replayed) {
  const Outcome o = piped(python + " | sed 's/^5 .*/5 0/'", 2);
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("refuted index.equals_reference level 2 case e:u=5/8,v=0 "));
  EXPECT_THAT(o.out, HasSubstr("wrong on ties only"));
  const auto at = o.out.find("replay: ");
  const Outcome again = shell(o.out.substr(at + 8, o.out.find('\n', at) - at - 8));
  EXPECT_EQ(again.exit_code, 1) << again.err;
}

TEST(Pipe, a_planted_tie_at_a_vertex_of_level_7_is_that_vertex) {
  const Outcome o =
      shell("mmverify gen index --level 7 | awk '$2==\"0x1.8p-2\" && $3==\"0x1p-2\" {print $1}'");
  const std::string number = o.out.substr(0, o.out.find('\n'));
  expect_said(piped(python + " | sed 's/^" + number + " .*/" + number + " 1/'", 7), 1,
              {"case v:u=3/8,v=1/4 (0x1.8p-2,0x1p-2) expected ", "(vertices 1, edges 0, interiors 0)"});
}

TEST(Pipe, short_long_and_garbled_answers_name_the_line) {
  expect_complaint(piped(python + " | head -n 100"), 4,
                   "standard input ended after line 100, with 100 of 3169 cases answered");
  expect_complaint(piped("cat >/dev/null; true"), 4, "standard input ended after line 0");
  expect_complaint(piped("(" + python + "; echo 3169 0)"), 4, "line 3170: more than the 3169 cases asked");
  expect_complaint(piped(python + " | sed 's/^50 .*/50 x/'"), 4, "line 51: '50 x' is not an answer");
  expect_complaint(piped(python + " | sed 's/^50 .*/50 -1/'"), 4, "line 51: ");
  expect_complaint(piped(python + " | sed 's/^50 .*/50 4294967296/'"), 4, "line 51: ");
  expect_complaint(piped(python + " | sed '51d'"), 4, "line 51: case 51 where case 50 is due");
}

TEST(Pipe, comments_empty_lines_and_hexadecimal_pass) {
  EXPECT_EQ(piped("(echo '# hello'; echo; " + python +
                  R"() | awk '{if (NF==2 && $1 ~ /^[0-9]/) printf "%d 0x%x\r\n", $1, $2; else print}')")
                .exit_code,
            0);
}

}  // namespace
}  // namespace mmverify::tests
