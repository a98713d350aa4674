#include "cli/bench/codec/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <random>
#include <thread>

#include "bench/codec/tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"

namespace mmverify::cli {
namespace {

struct CodecTopic {
  const char* name;
  const char* ours;
  proofs::Levels levels;  ///< where none are given
  proofs::Level highest;
  void (*cases)(const codec::Asked&);
};

constexpr CodecTopic codec_topics[] = {
    {"tree", "impl/tree's form", {3, 9}, 12, codec::of_tree::cases},
    {"dag", "impl/dag's graph", {3, 8}, 10, codec::of_dag::cases},
    {"vq", "impl/vq: the optimum for VQ2, balanced for VQ4", {0, 0}, 0, codec::of_vq::cases},
    {"array", "impl/array", {2, 6}, 8, codec::of_array::cases},
    {"attribute", "impl/attribute", {2, 8}, 12, codec::of_attribute::cases},
};

/// Ends the program once a codec has been at one row for too long: its calls here have no walls, and cannot be stopped.
class Watch {
 public:
  explicit Watch(std::string library)
      : library_(std::move(library)), thread_([this](const std::stop_token& stop) { wait(stop); }) {}

  void begin(const std::string& row) {
    const std::lock_guard hold(lock_);
    row_ = row;
    until_ = Clock::now() + longest;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds longest{120};

  void wait(const std::stop_token& stop) {
    std::unique_lock hold(lock_);
    while (!stop.stop_requested()) {
      changed_.wait_until(hold, stop, until_, [] { return false; });
      if (stop.stop_requested() || Clock::now() < until_) continue;
      say(stderr, "mmverify: {}: not done within {} s with {}; mmverify prove --subject says why it hangs\n",
          library_, longest.count(), row_);
      std::_Exit(ExitCode::environment);
    }
  }

  const std::string library_;
  std::mutex lock_;
  std::condition_variable_any changed_;
  std::string row_ = "loading";
  Clock::time_point until_ = Clock::now() + longest;
  std::jthread thread_;  ///< the last member: it uses the others
};

/// Whether a codec gave a wrong answer; blocks of square maps lose states, and have right answers all the same.
bool is_wrong(const std::string& topic, const std::vector<bench::CodecRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [&](const bench::CodecRow& row) {
    const bool changed = topic != "vq" && row.theirs.changed != 0;
    return changed || row.theirs.wrong_lookups.value_or(0) != 0;
  });
}

}  // namespace

bench::Result codec_result(const std::string& topic, const BenchOptions& options) {
  const CodecTopic* chosen = nullptr;
  for (const CodecTopic& t : codec_topics)
    if (topic == t.name) chosen = &t;
  if (chosen == nullptr) throw UsageError(fmt::format("--subject: bench {} compares no library", topic));
  proofs::Levels levels = chosen->levels;
  if (!options.levels.empty()) {
    levels = parse_levels(options.levels, "--levels");
    if (levels.last > chosen->highest)
      throw UsageError(
          fmt::format("--levels {}: the highest level here is {}", options.levels, chosen->highest));
  }
  constexpr std::size_t rounds = 5;
  dock::Options walls;
  walls.stop_if_asked = stop_if_asked;
  const auto progress = progress_of(chosen->name, options);
  std::vector<bench::CodecRow> rows;
  refuse_no_library(options.subject);
  try {
    const mmverify_subject_t& subject = dock::load_trusted(options.subject, walls);
    Watch watch(options.subject);
    chosen->cases({subject, options, levels, [&](const bench::CodecCase& of) {
                     const std::string row =
                         of.level ? fmt::format("{}, level {}, {} states", of.of, *of.level, of.states)
                                  : of.of;
                     progress(row);
                     watch.begin(row);
                     rows.push_back(bench::measured_codec(of, rounds));
                   }});
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  if (is_wrong(topic, rows))
    say(stderr,
        "bench: {}: the codec is wrong: see the columns `states changed` and `lookups wrong`; its times "
        "count "
        "once `mmverify prove {} --subject {}` refutes nothing\n",
        options.subject, topic, shell_quoted(options.subject));
  return bench::codec_tables(rows, {options.subject, chosen->ours, rounds});
}

namespace codec {

std::vector<std::uint32_t> random_below(std::uint32_t end, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> all(count);
  for (std::uint32_t& k : all) k = static_cast<std::uint32_t>(random() % end);
  return all;
}

std::uint64_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                        unsigned bits) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const unsigned apart = a[k] ^ b[k];
    count += static_cast<std::uint64_t>(std::popcount(bits == 1 ? apart : (apart | apart >> 1) & 0x55u));
  }
  return count;
}

}  // namespace codec
}  // namespace mmverify::cli
