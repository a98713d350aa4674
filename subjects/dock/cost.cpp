#include "subjects/dock/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <random>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/trusted.hpp"

namespace mmverify::dock {
namespace {

constexpr int rounds = 21;

double nanoseconds_each(const std::chrono::steady_clock::duration& time) {
  return std::chrono::duration<double, std::nano>(time).count() / static_cast<double>(capacity);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

Cost measure_cost(const std::string& library, std::uint32_t level, const Options& options) {
  const mmverify_subject_t& subject = load_trusted(library, options);
  if (subject.index_f32 == nullptr)
    throw std::runtime_error(
        fmt::format("{}: no entry point {}", library, entry_point(Call::index_f32).name));
  Worker worker(library, options);

  std::vector<float> u(capacity), v(capacity);
  std::vector<std::uint32_t> index(capacity);
  std::mt19937 random;
  for (std::size_t t = 0; t < capacity; ++t) {
    const double a = static_cast<double>(random() >> 8) / (1u << 24);
    const double b = static_cast<double>(random() >> 8) / (1u << 24);
    u[t] = static_cast<float>(a + b <= 1 ? a : 1 - a);
    v[t] = static_cast<float>(a + b <= 1 ? b : 1 - b);
    std::memcpy(worker.input(Call::index_f32, 0, capacity, t), &u[t], sizeof(float));
    std::memcpy(worker.input(Call::index_f32, 1, capacity, t), &v[t], sizeof(float));
  }
  const auto ask = [&](std::uint32_t n) {
    try {
      worker.ask(Call::index_f32, n, capacity);
    } catch (const Misbehaved& found) {
      throw SubjectBroken(fmt::format("{}: {} at level {}", library, found.what, n));
    }
  };
  // The first command of a level repeats every question in every way; this cost is not measured.
  ask(level);

  using Clock = std::chrono::steady_clock;
  std::vector<double> bare, isolated, ratio;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    for (std::size_t from = 0; from < capacity; from += batch_size) {
      options.stop_if_asked();
      subject.index_f32(level, u.data() + from, v.data() + from, index.data() + from, batch_size);
    }
    const auto middle = Clock::now();
    ask(level);
    const auto end = Clock::now();
    bare.push_back(nanoseconds_each(middle - start));
    isolated.push_back(nanoseconds_each(end - middle));
    ratio.push_back(isolated.back() / bare.back());
  }
  return {median(bare), median(isolated), median(ratio)};
}

}  // namespace mmverify::dock
