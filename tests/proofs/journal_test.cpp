// proofs/engine/journal: a run that is cut short anywhere ends as one that was not.
#include "proofs/engine/journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/kinds.hpp"
#include "tests/complaint.hpp"
#include "tests/folder.hpp"
#include "tests/proofs/counting_law.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
using testing::AnyOf;
using testing::HasSubstr;

const Identity identity{{"program", "1"}, {"spec", "abc"}, {"seed", "1"}};

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

std::string refusal(const fs::path& file, const Identity& ours = identity) {
  return complaint_of<BadJournal>([&] { const Journal journal(file, ours); }, "");
}

Report journaled(const Law& law, const SubjectPtr& subject, const fs::path& file, unsigned threads = 2) {
  Journal journal(file, identity);
  RunOptions options = silent(threads);
  options.journal = &journal;
  return run_it(law, subject, options);
}

class Journals : public testing::Test {
 protected:
  Folder folder;
  fs::path file = folder / "journal";
  Law law = counting_law();
  std::shared_ptr<Squares> subject = std::make_shared<Squares>(9);
  std::string plain = essence(run_it(law, subject, silent()));
};

TEST_F(Journals, ChangeNothingInTheResult) { EXPECT_EQ(essence(journaled(law, subject, file)), plain); }

TEST_F(Journals, SpareTheWorkThatIsDone) {
  journaled(law, subject, file);
  subject->asked = 0;
  const Report again = journaled(law, subject, file);
  EXPECT_EQ(subject->asked, 0u);
  EXPECT_EQ(again.results.front().resumed, numbers);
  EXPECT_EQ(essence(again), plain);
}

TEST_F(Journals, MayBeCutAtEveryByte) {
  journaled(law, subject, file);
  const std::string whole = text_of(file);
  ASSERT_GT(whole.size(), 1000u);
  for (std::size_t length = 0; length <= whole.size(); length += sanitized ? 7 : 1) {
    write(file, whole.substr(0, length));
    ASSERT_EQ(essence(journaled(law, subject, file, 1)), plain) << "cut to " << length;
    ASSERT_EQ(refusal(file), "");
  }
}

TEST_F(Journals, DoTheWorkOfADamagedLineAgain) {
  journaled(law, subject, file);
  std::string text = text_of(file);
  const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
  text[third + 40] ^= 1;
  write(file, text);
  subject->asked = 0;
  EXPECT_EQ(essence(journaled(law, subject, file)), plain);
  EXPECT_GT(subject->asked, 0u);
  EXPECT_LT(subject->asked, numbers / 2);  // the pieces before and behind it count
}

TEST_F(Journals, AreTakenUpAfterCtrlC) {
  const auto stops = std::make_shared<Squares>(9);
  Law interrupted_law = counting_law();
  const auto judge = interrupted_law.judge;
  interrupted_law.judge = [&](const Subject& s, Level n, const auto& run) {
    return sweep(run, numbers, numbers_per_chunk, [&](Chunk chunk, Tally& tally) {
      if (chunk.begin == 500) std::raise(SIGINT);
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        tally.count(Kind::edge, 1);
        tally.digest(k, k * k + n);
        if (!dynamic_cast<const Squares&>(s).right(k))
          tally.mismatch(Kind::edge, {k % 7, k, 0}, [&] {
            return Counterexample{{k % 7, k, 0}, n, "k=" + std::to_string(k), {}, "right", "wrong"};
          });
      }
    });
  };
  const Report cut = journaled(interrupted_law, stops, file, 1);
  EXPECT_TRUE(cut.interrupted);
  EXPECT_LT(cut.results.front().cases_run(), numbers);
  const Report rest = journaled(law, subject, file);
  EXPECT_GT(rest.results.front().resumed, 0u);
  EXPECT_EQ(essence(rest), plain);
}

// A law that cannot be divided is kept as a whole.
TEST_F(Journals, KeepWholeLaws) {
  law.divisible = false;
  journaled(law, subject, file);
  subject->asked = 0;
  EXPECT_EQ(essence(journaled(law, subject, file)), plain);
  EXPECT_EQ(subject->asked, 0u);
}

// Names and messages may be any bytes, as a library's path is.
TEST_F(Journals, OfNamesThatAreNoUtf8GoOn) {
  Identity bytes = identity;
  bytes[1].second = "path\xff\xc3";
  const auto run = [&] {
    Journal journal(file, bytes);
    RunOptions options = silent(2);
    options.journal = &journal;
    return essence(run_it(law, subject, options));
  };
  EXPECT_EQ(run(), plain);
  subject->asked = 0;
  EXPECT_EQ(run(), plain);
  EXPECT_EQ(subject->asked, 0u);
}

TEST_F(Journals, OfAnotherRunAreRefusedAndLeftAlone) {
  journaled(law, subject, file);
  const std::string before = text_of(file);
  Identity other = identity;
  other[1].second = "abd";
  EXPECT_THAT(refusal(file, other), HasSubstr("journal of another run (spec: abc there, abd here)"));
  other = identity;
  other.pop_back();
  EXPECT_THAT(refusal(file, other), HasSubstr("another version of the program"));
  EXPECT_EQ(text_of(file), before);
  // Cut before the end of its first line, it is still somebody else's.
  write(file, before.substr(0, before.find('\n') - 3));
  other[1].second = "abd";
  EXPECT_THAT(refusal(file, other), HasSubstr("not a journal"));
}

TEST_F(Journals, AreNotMadeOfOtherFiles) {
  for (const std::string text : {"a letter", "a letter\nof two lines\n", "{}\n", "\n", "00000000 {}\n"}) {
    write(file, text);
    EXPECT_THAT(refusal(file), AnyOf(HasSubstr("not a journal"), HasSubstr("line 1"))) << text;
    EXPECT_EQ(text_of(file), text);
  }
  EXPECT_THAT(refusal(folder.path()), HasSubstr("cannot be opened"));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("regular file"));
  EXPECT_THAT(refusal(folder / "no" / "such"), HasSubstr("cannot be opened"));
}

TEST_F(Journals, BelongToOneRunAtATime) {
  const Journal first(file, identity);
  EXPECT_THAT(refusal(file), HasSubstr("another run is writing"));
}

/// No file grows beyond `bytes` while it lives.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

TEST_F(Journals, SurviveAFullDisk) {
  {
    const SmallDisk disk(1500);
    EXPECT_THROW(journaled(law, subject, file), BadJournal);
  }
  const std::string kept = text_of(file);
  EXPECT_LE(kept.size(), 1500u);
  EXPECT_EQ(kept.back(), '\n');
  EXPECT_GT(std::count(kept.begin(), kept.end(), '\n'), 2);
  const Report rest = journaled(law, subject, file);
  EXPECT_GT(rest.results.front().resumed, 0u);
  EXPECT_EQ(essence(rest), plain);
}

TEST_F(Journals, SayWhenNotEvenTheFirstLineFits) {
  const SmallDisk disk(20);
  EXPECT_THAT(refusal(file), HasSubstr("cannot be written: File too large"));
  EXPECT_EQ(text_of(file), "");
}

}  // namespace
