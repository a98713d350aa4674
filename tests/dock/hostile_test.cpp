// [first] Libraries that mean harm: what they may not do is refused, what they write where they may not is theirs, and what the
// machine does to them is not.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/dock/elements.hpp"
#include "subjects/dock/library.hpp"
#include "tests/folder.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using namespace mmverify::dock;
using testing::HasSubstr;
using testing::Not;

std::string file_of(const std::string& name) { return std::string(MMVERIFY_SUBJECTS) + "/" + name + ".so"; }

Options options(double timeout_seconds = 5) {
  setenv("MMVERIFY_WORKER", MMVERIFY_WORKER_PROGRAM, 1);
  Options all;
  all.timeout_seconds = timeout_seconds;
  return all;
}

/// The answers to four points, or what came in their place.
struct Said {
  std::vector<std::uint32_t> answers{9, 9, 9, 9};
  std::string broken, machine, not_loaded;
};

Said ask(const Library& library) {
  const std::vector<float> u{0, 0.25, 0.5, 0.25}, v{0, 0.25, 0.25, 0.5};
  const Elements points{Call::index_f32, 3, 0, {u.data(), v.data()}, [](std::size_t t) {
                          return "point " + std::to_string(t);
                        }};
  Said said;
  try {
    ask_all(library, points, said.answers.size(), said.answers.data());
  } catch (const SubjectBroken& broken) {
    said.broken = broken.what();
  } catch (const NoResources& none) {
    said.machine = none.what();
  }
  return said;
}

Said ask(const std::string& name, const Options& with = options()) {
  try {
    return ask(Library(file_of(name), with));
  } catch (const CannotLoad& fault) {
    return {{}, {}, {}, fault.what()};
  } catch (const NoResources& none) {
    return {{}, {}, none.what(), {}};
  }
}

TEST(Hostile, WhatItMayNotDoIsRefused) {
  // This descriptor stands for one inherited from a parent process: no library may find it.
  const int inherited = fcntl(STDERR_FILENO, F_DUPFD, 20);
  for (const char* name :
       {"ends_itself", "signals_the_tool", "leaves_its_group", "reaches_the_tool", "looks_for_descriptors",
        "shrinks_the_memory", "hides_memory", "unlocks_its_input"}) {
    // A sanitizer's runtime opens files of its own.
    if (sanitized && std::string(name) == "looks_for_descriptors") continue;
    const Said said = ask(std::string("hostile_") + name);
    EXPECT_EQ(said.answers, std::vector<std::uint32_t>(4, 0)) << name << said.broken << said.machine;
  }
  close(inherited);
}

TEST(Hostile, WritesToNoTerminal) {
  if (syscall(444, nullptr, 0, 1) < 1) GTEST_SKIP() << "the kernel has no Landlock";
  EXPECT_EQ(ask("hostile_writes_to_terminals").answers, std::vector<std::uint32_t>(4, 0));
}

TEST(Hostile, WhatItWritesIntoTheMailboxIsItsFault) {
  for (const char* name :
       {"reports_no_such_outcome", "reports_without_end", "takes_no_such_turn", "fills_the_mailbox"}) {
    const Said said = ask(std::string("hostile_") + name);
    EXPECT_THAT(said.broken, HasSubstr("wrote into the tool's own memory")) << name << said.machine;
  }
  for (const char* name : {"begins_nowhere", "is_at_another_level"})
    EXPECT_THAT(ask(std::string("hostile_") + name).broken, HasSubstr("crashed (signal 11")) << name;
  EXPECT_THAT(ask("hostile_reports_no_such_element").broken,
              HasSubstr("in the batch of 4 cases from point 0"));
  // It may say that it is the machine: then nothing is said of it, and nothing for it.
  EXPECT_THAT(ask("hostile_reports_the_machine").machine, HasSubstr("cannot be asked"));
}

TEST(Hostile, AnswersOfSizesThatCannotBeAreItsFault) {
  const Library library(file_of("hostile_answers_without_bounds"), options());
  const std::vector<std::uint8_t> map(8);
  for (const Call call : {Call::tree_encode, Call::tree_decode}) try {
      dock::ask(library, {call, 3, MMVERIFY_2_STATE, map, 64}, [] { return std::string("asking"); });
      FAIL();
    } catch (const CaseBroken& broken) {
      EXPECT_THAT(broken.what(), HasSubstr("wrote into the tool's own memory"));
    }
}

TEST(Hostile, ADescriptionThatCannotBeIsNotLoaded) {
  for (const char* name : {"describes_without_end", "is_ready_before_it_is"})
    EXPECT_THAT(ask(std::string("hostile_") + name).not_loaded,
                HasSubstr("wrote into the tool's own memory while it was loaded"))
        << name;
}

TEST(Hostile, LoadingHasALimit) {
  for (const char* name : {"hangs_while_loaded", "never_describes_itself"}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(ask(std::string("hostile_") + name, options(0.3)).not_loaded,
                HasSubstr("hung: not done within 1 s while it was loaded"))
        << name;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << name;
    int status = 0;
    EXPECT_EQ(waitpid(-1, &status, WNOHANG), -1) << "no worker is left behind";
  }
}

// One worker dies of a crash, the next one is to name the case.
TEST(Hostile, WhatLoadsOnceIsBrokenWhereItDoesNotAgain) {
  for (const auto& [name, said] :
       {std::pair{"hangs_when_loaded_again", "hung: not done within 1 s while it was loaded, though it was"},
        std::pair{"crashes_when_loaded_again", "while it was loaded, though it was loaded before"}}) {
    const Folder folder;
    Options with = options(0.3);
    with.environment = {"MMVERIFY_TEST_LOADS=" + (folder / "loads").string()};
    const Library library(file_of(std::string("hostile_") + name), with);
    const Borrowed first(library.pool());
    EXPECT_THAT(ask(library).broken, HasSubstr(said)) << name;
  }
}

/// Kills the one worker there is, with the signal that a test sets.
int signal_from_outside = 0;
void send_from_outside() {
  if (signal_from_outside == 0) return;
  std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
  for (int child = 0; children >> child;) kill(child, signal_from_outside);
}

TEST(TheMachine, IsNotTheSubject) {
  Options with = options(0.3);
  with.stop_if_asked = send_from_outside;
  const Library library(file_of("hostile_sleeps"), with);
  for (const auto& [signal, words] : {std::pair{SIGKILL, "killed from outside; out of memory?"},
                                      std::pair{SIGSTOP, "stopped from outside"}}) {
    signal_from_outside = signal;
    const Said said = ask(library);
    signal_from_outside = 0;
    EXPECT_THAT(said.machine, HasSubstr(words)) << said.broken;
  }
}

TEST(TheMachine, MayHaveNoThreadLeft) {
  if (sanitized) GTEST_SKIP() << "a sanitizer's runtime has to be the first that is preloaded";
  Options with = options();
  with.environment = {"LD_PRELOAD=" + file_of("no_threads")};
  const Said said = ask("example", with);
  EXPECT_THAT(said.machine, HasSubstr("cannot start a thread")) << said.broken << said.not_loaded;
}

TEST(TheMachine, MayHaveAnotherLibraryByNow) {
  const Folder folder;
  const fs::path file = folder / "mine.so";
  fs::copy_file(file_of("example"), file);
  const Library library(file, options());
  EXPECT_EQ(ask(library).broken, "");
  fs::last_write_time(file, fs::file_time_type::clock::now());
  EXPECT_EQ(library.change(), "") << "the same contents are the same library";
  const Borrowed first(library.pool());
  fs::rename(file, folder / "old.so");
  fs::copy_file(file_of("tie"), file);
  EXPECT_THAT(ask(library).machine, HasSubstr("mine.so was changed during the run"));
  EXPECT_THAT(library.change(), HasSubstr("was changed during the run"));
}

TEST(Modes, AreThoseFromBeforeTheLibraryWasLoaded) {
  for (const auto& [name, how] : {std::pair{"flushes_when_loaded", "mode changed since it was loaded"},
                                  std::pair{"rounds_when_loaded", "mode changed since it was loaded"},
                                  std::pair{"rounds_in_its_first_call", "mode changed in a thread"},
                                  std::pair{"rounds_in_threads", "mode changed in a thread"},
                                  std::pair{"halves_x87_precision", "mode changed"}}) {
#if !defined(__x86_64__)
    if (std::string(name) == "flushes_when_loaded" || std::string(name) == "halves_x87_precision") continue;
#endif
    EXPECT_THAT(ask(std::string("hostile_") + name).broken, HasSubstr(how)) << name;
  }
}

TEST(Texts, OfASubjectAreOneLineThatNobodyObeys) {
  const Library library(file_of("hostile_names_itself_badly"), options());
  EXPECT_THAT(library.about(), HasSubstr("\\x0d\\x1b[2K\\x1b[32mproved"));
  EXPECT_THAT(library.about(), Not(HasSubstr("\n")));
  EXPECT_THAT(library.about(), HasSubstr("#\\x23[error]"));
  const std::string thrown = ask("hostile_throws_escapes").broken;
  EXPECT_THAT(thrown, HasSubstr("threw an exception: \\x0d\\x1b[2K"));
  EXPECT_THAT(thrown, HasSubstr("\\x0aproved     everything\\x9b0m\\xff\\xe2\\x80\\xae"));
  const std::string half = ask("hostile_throws_half_a_character").broken;
  EXPECT_THAT(half, HasSubstr("x\\xe2\\x82"));
}

TEST(Texts, ThatItPrintsAreMarked) {
  testing::internal::CaptureStderr();
  ask("hostile_prints_commands");
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_THAT(printed, HasSubstr("subject| \\x3a:error::forged\nsubject| proved     everything\n"));
  EXPECT_THAT(printed, HasSubstr("subject| no end of line\n"));
  for (std::size_t at = 0; at < printed.size(); at = printed.find('\n', at) + 1)
    EXPECT_EQ(printed.compare(at, 9, "subject| "), 0) << printed.substr(at, 40);
  EXPECT_EQ(printed.find('\x1b'), std::string::npos);
}

TEST(Bounds, AreOfFilesInAllToo) {
  setenv("MMVERIFY_WORKER_MEMORY", "200", 1);
  EXPECT_THAT(ask("hostile_fills_a_folder").broken, HasSubstr("wrote more than 200 MiB to files"));
  unsetenv("MMVERIFY_WORKER_MEMORY");
}

}  // namespace
}  // namespace mmverify::tests
