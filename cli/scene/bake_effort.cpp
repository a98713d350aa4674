#include "cli/scene/bake_effort.hpp"

#include <fmt/format.h>

#include "cli/arguments/arguments.hpp"

namespace mmverify::cli {

void add_effort(CLI::App& command, BakeEffort& effort, const std::string& about) {
  auto* const samples = command
                            .add_option("--samples", effort.samples,
                                        about + "micro-triangles that each law of baking is checked on")
                            ->check(whole_within(1, std::uint64_t{1} << 40));
  auto* const exhaustive = command.add_flag("--exhaustive", effort.exhaustive, about + "all micro-triangles");
  command
      .add_option("--budget", effort.budget,
                  about +
                      "seconds that the laws of baking may take, about; without it as long as loading and "
                      "baking take")
      ->type_name("SECONDS")
      ->check(finite_within(0.001, 86400))
      ->excludes(samples)
      ->excludes(exhaustive);
  samples->excludes(exhaustive);
}

proofs::scene::BakeSample sample_of(const BakeEffort& effort, const proofs::scene::Data& data,
                                    unsigned threads, std::uint64_t whole) {
  if (effort.exhaustive) return {};
  if (effort.samples) return {.size = effort.samples};
  constexpr double laws = 2;
  if (effort.budget) return {.work = proofs::scene::work_of_seconds(data, *effort.budget / laws, threads)};
  return {.work = proofs::scene::usual_work(data), .whole = whole};
}

std::string word_of(const BakeEffort& effort) {
  if (effort.exhaustive) return "all";
  if (effort.samples) return fmt::format("{}", *effort.samples);
  return effort.budget ? fmt::format("{} s", *effort.budget) : "usual";
}

}  // namespace mmverify::cli
