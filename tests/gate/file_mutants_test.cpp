// [first] Files that were changed by a script: whatever was done to a result, a baseline, a shard or a journal, none of them
// changes a verdict, a count or a digest without a word.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "delivery/gate/compare.hpp"
#include "delivery/gate/runs.hpp"
#include "delivery/gate/seal.hpp"
#include "proofs/engine/journal.hpp"
#include "tests/folder.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify;
using Json = nlohmann::ordered_json;

/// More in the long tier, that of ./run test --every.
const std::size_t mutants = sanitized ? 100 : std::getenv("MMVERIFY_LONG_TESTS") == nullptr ? 400 : 2'000;

std::string contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// Random damage to a file.
class Vandal {
 public:
  explicit Vandal(std::uint64_t seed) : random_(seed) {}

  /// One change in four is to the bytes, the others to the JSON.
  std::string changed(const std::string& text) {
    if (below(4) == 0) return with_other_bytes(text);
    Json json = Json::parse(text);
    change_somewhere(json);
    return json.dump(1);
  }

  std::string with_other_bytes(std::string text) {
    const std::size_t at = below(text.size());
    switch (below(4)) {
      case 0: text[at] = static_cast<char>(text[at] ^ (1 << below(7))); break;
      case 1: text.erase(at, 1 + below(40)); break;
      case 2: text.insert(at, text.substr(below(text.size()), 1 + below(40))); break;
      default: text.resize(at);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  void change_somewhere(Json& at) {
    if (at.is_structured() && !at.empty() && below(8) != 0) {
      const auto member = std::next(at.begin(), static_cast<std::ptrdiff_t>(below(at.size())));
      if (member->is_structured() && below(5) != 0) return change_somewhere(*member);
      if (below(4) == 0) {
        at.erase(member);
        return;
      }
      if (at.is_array() && below(3) == 0) {
        at.push_back(*member);
        return;
      }
      *member = another(*member);
      return;
    }
    at = another(at);
  }

  Json another(const Json& value) {
    if (value.is_number_unsigned() && below(3) != 0) {
      const auto n = value.get<std::uint64_t>();
      const std::uint64_t near[] = {n + 1, n - 1, 2 * n, n / 2, 0};
      return near[below(5)];
    }
    if (value.is_string() && below(3) != 0) {
      auto text = value.get<std::string>();
      if (text.empty()) return "x";
      text[below(text.size())] = "0123456789abcdef"[below(16)];
      return text;
    }
    const Json others[] = {nullptr,   true,          false,         -1, 0, 1.5, "", "proved",
                           "checked", Json::array(), Json::object()};
    return others[below(std::size(others))];
  }

  std::mt19937_64 random_;
};

/// The facts that must not change unseen: verdicts, counts, digests of proofs, and whether mutants died.
Json facts(const Json& run) {
  Json all = Json::array();
  for (const Json& r : run.at("results"))
    all.push_back({r.at("law"), r.at("subject"), r.at("level"), r.at("verdict"), r.at("cases_expected"),
                   r.at("cases_run"), r.at("mismatches"), r.at("by_kind"),
                   r.at("verdict") == "proved" ? r.at("digest") : Json()});
  for (const Json& m : run.value("mutants", Json::array()))
    all.push_back({m.at("law"), m.at("mutant"), m.at("killed")});
  return all;
}

/// Whether the gate is green; false, too, where it refuses a file.
bool green(const std::string& baseline, const std::string& result) {
  try {
    const Json before = Json::parse(baseline), after = Json::parse(result);
    for (const Json* file : {&before, &after}) gate::refuse_misfits(*file, "file");
    return !gate::compare(gate::baseline_of(before), gate::figures_of(after), 1.5).red();
  } catch (const gate::NoResult&) {
    return false;
  } catch (const Json::exception&) {
    return false;
  }
}

/// One run of the program, small and of several kinds of law, and its shards.
class Files : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string run = std::string(MMVERIFY_PROGRAM) +
                            " prove --quiet index.in_range index.cells_decide tree.round_trip " +
                            "--levels 0..1 --json " + home() + "/";
    ASSERT_EQ(std::system((run + "run.json >/dev/null").c_str()), 0);
    ASSERT_EQ(std::system((run + "shard.json --shard 1/2 >/dev/null").c_str()), 0);
  }
  static const std::string& home() {
    static const tests::Folder folder;
    static const std::string name = folder.path().string();
    return name;
  }
};

TEST_F(Files, AChangedResultIsNotGreen) {
  const std::string result = contents(home() + "/run.json");
  const std::string baseline = gate::to_json(gate::baseline_of(gate::figures_of(Json::parse(result))));
  ASSERT_TRUE(green(baseline, result));
  const Json right = facts(Json::parse(result));
  Vandal vandal(1);
  std::size_t harmless = 0;
  for (std::size_t k = 0; k < mutants; ++k) {
    const std::string other = vandal.changed(result);
    if (!green(baseline, other)) continue;
    ++harmless;
    ASSERT_EQ(facts(Json::parse(other)), right) << "mutant " << k;
  }
  // Times, machines, cases of mutants: else the test would say nothing of what is told apart.
  EXPECT_GT(harmless, 0u);
  EXPECT_LT(harmless, mutants / 2);
}

TEST_F(Files, AChangedBaselineIsNotGreen) {
  const std::string result = contents(home() + "/run.json");
  const std::string baseline = gate::to_json(gate::baseline_of(gate::figures_of(Json::parse(result))));
  const Json right = Json::parse(baseline);
  Vandal vandal(2);
  for (std::size_t k = 0; k < mutants; ++k) {
    const std::string other = vandal.changed(baseline);
    if (!green(other, result)) continue;
    const Json left = Json::parse(other);
    ASSERT_EQ(left.at("figures"), right.at("figures")) << "mutant " << k;
    ASSERT_EQ(left.at("settings"), right.at("settings")) << "mutant " << k;
  }
}

TEST_F(Files, AChangedShardHasAnotherSeal) {
  const std::string shard = contents(home() + "/shard.json");
  const Json right = Json::parse(shard);
  ASSERT_TRUE(gate::is_sealed(right));
  Vandal vandal(3);
  for (std::size_t k = 0; k < mutants; ++k) {
    const Json other = Json::parse(vandal.changed(shard), nullptr, false);
    if (other.is_discarded() || !gate::is_sealed(other)) continue;
    ASSERT_EQ(other, right) << "mutant " << k;
  }
}

TEST(FilesOfARun, AChangedJournalHasFewerPiecesAndNoOther) {
  using namespace proofs;
  const tests::Folder folder;
  const std::string path = (folder / "journal").string();
  const Identity identity{{"program", "test"}, {"laws", "index.in_range"}};
  const auto tally = [](std::uint64_t k) {
    return Tally::restored({Count{k, 0}, Count{7 * k, k % 3}, Count{k, 0, 1}}, 0x9E3779B97F4A7C15u * k, {});
  };
  constexpr std::uint64_t pieces = 20;
  {
    Journal journal(path, identity);
    for (std::uint64_t k = 0; k < pieces; ++k)
      journal.append({"law subject level 1", {10 * k, 10 * k + 10}, 10 * pieces, tally(k)});
  }
  const std::string text = contents(path);
  Vandal vandal(4);
  std::size_t lost = 0;
  for (std::size_t k = 0; k < mutants; ++k) {
    put(path, vandal.with_other_bytes(text));
    try {
      const Journal journal(path, identity);
      const auto left = journal.finished("law subject level 1", 10 * pieces);
      lost += left.size() < pieces ? 1 : 0;
      for (const Journal::Piece& piece : left) {
        const std::uint64_t number = piece.units.begin / 10;
        ASSERT_EQ(piece.units.begin % 10, 0u) << "mutant " << k;
        ASSERT_EQ(piece.units.end, piece.units.begin + 10) << "mutant " << k;
        ASSERT_EQ(piece.tally.digest(), tally(number).digest()) << "mutant " << k;
        ASSERT_EQ(piece.tally.by_kind(), tally(number).by_kind()) << "mutant " << k;
      }
    } catch (const BadJournal&) {
      ++lost;
    }
  }
  EXPECT_GT(lost, mutants / 2);
}

}  // namespace
