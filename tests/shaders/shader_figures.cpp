// The figures of docs/SHADERS.md: what a device makes of floats, and how fast it looks up.
// usage: shader_figures [DEVICE]
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "impl/index/index.hpp"
#include "proofs/points/stiff_floats.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/device/program.hpp"

namespace {

using namespace mmverify;

constexpr std::size_t batch = 1 << 16, points = std::size_t{1} << 22;
const std::string shaders_folder = std::string(MMVERIFY_ROOT) + "/subjects/shaders/";

/// A snippet's index function, on a device.
class OnDevice {
 public:
  OnDevice(const shaders::Device& device, const std::string& file)
      : compiled_(shaders::compile({shaders_folder + file})),
        program_(device, compiled_.manifest.modules.front()) {}
  const std::uint32_t* operator()(std::uint32_t level, const float* u, const float* v, std::size_t count) {
    return program_.run({.level = level, .arrays = {u, v}, .count = count});
  }

 private:
  shaders::Compiled compiled_;
  shaders::Program program_;
};

struct Points {
  std::vector<float> u, v;
};
Points stiff_points(std::uint32_t level) {
  Points p;
  for (std::uint64_t k = 0; k < points; ++k) {
    const auto [u, v] = proofs::points::stiff_floats(level, 1, k);
    p.u.push_back(u);
    p.v.push_back(v);
  }
  return p;
}

/// How many answers are not the expected ones.
std::size_t differ(OnDevice& shader, std::uint32_t level, const Points& p,
                   const std::function<std::uint32_t(float, float)>& expected) {
  std::size_t found = 0;
  for (std::size_t from = 0; from < points; from += batch) {
    const std::uint32_t* answers = shader(level, &p.u[from], &p.v[from], batch);
    for (std::size_t k = 0; k < batch; ++k)
      found += answers[k] != expected(p.u[from + k], p.v[from + k]) ? 1 : 0;
  }
  return found;
}

/// Strict binary32, as this program is compiled: no contraction, no rearrangement.
std::uint32_t figure_4(std::uint32_t level, float u, float v) {
  const std::uint32_t last = (1u << level) - 1;
  const float N = static_cast<float>(1u << level);
  const auto whole = [](float x) { return x > 0 ? static_cast<std::uint32_t>(x) : 0u; };
  const float w = 1.0f - (u + v);
  const std::uint32_t row = std::min(last, whole((1.0f - w) * N)), column = std::min(row, whole(v * N));
  return row * row + column + (std::min(last, whole((1.0f - u) * N)) - (last - row));
}

void print_differences(const shaders::Device& device) {
  const struct {
    const char *name, *file;
    bool rows;
  } all[] = {{"exact, precise", "subjects/index.glsl", false},
             {"exact, plain", "subjects/index_plain.glsl", false},
             {"published, precise", "subjects/index_published.glsl", false},
             {"published, plain", "figures/index_published_plain.glsl", false},
             {"figure 4, precise", "figures/figure_4_precise.glsl", true},
             {"figure 4, plain", "figures/figure_4_plain.glsl", true}};
  fmt::print("| of {} stiff points, answers unlike | level 1 | 4 | 8 | 12 |\n|---|---|---|---|---|\n",
             points);
  std::vector<Points> hard;
  constexpr std::uint32_t levels[] = {1, 4, 8, 12};
  for (const std::uint32_t level : levels) hard.push_back(stiff_points(level));
  for (const auto& [name, file, rows] : all) {
    OnDevice shader(device, file);
    fmt::print("| {}: {} |", name, rows ? "strict binary32" : "exact arithmetic");
    for (std::size_t k = 0; k < std::size(levels); ++k)
      fmt::print(" {} |",
                 differ(shader, levels[k], hard[k], [&, level = levels[k], by_row = rows](float u, float v) {
                   return by_row ? figure_4(level, u, v) : impl::index::from_barycentrics(u, v, level);
                 }));
    fmt::print("\n");
  }
}

void print_denormals(const shaders::Device& device) {
  OnDevice shader(device, "figures/denormals.glsl");
  std::vector<float> u(batch), v(batch);
  for (std::size_t k = 0; k < batch; ++k) {
    u[k] = std::ldexp(1.0f + static_cast<float>(k) / static_cast<float>(batch), -70);
    v[k] = std::ldexp(1.0f, -60 - static_cast<int>(k % 12));
  }
  const std::uint32_t* answers = shader(0, u.data(), v.data(), batch);
  std::size_t kept = 0, flushed = 0;
  for (std::size_t k = 0; k < batch; ++k) {
    kept += answers[k] == std::bit_cast<std::uint32_t>(u[k] * v[k]) ? 1 : 0;
    flushed += answers[k] == 0 ? 1 : 0;
  }
  fmt::print("denormal products: {} of {} kept, {} flushed\n", kept, batch, flushed);
}

void print_speeds(const shaders::Device& device) {
  OnDevice shader(device, "subjects/index.glsl");
  const Points p = stiff_points(8);
  for (const std::size_t count : {std::size_t{1}, std::size_t{4096}, batch, std::size_t{1} << 19}) {
    std::size_t calls = 0;
    const auto begin = std::chrono::steady_clock::now();
    double seconds = 0;
    for (; seconds < 1;
         ++calls, seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count())
      shader(8, p.u.data(), p.v.data(), count);
    fmt::print("batch {:6}: {:8.1f} us a call, {:6.2f} M lookups/s\n", count,
               1e6 * seconds / static_cast<double>(calls),
               static_cast<double>(calls * count) / seconds / 1e6);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const shaders::Device device(argc > 1 ? static_cast<std::uint32_t>(std::atoi(argv[1])) : 0, false);
  fmt::print("{}", shaders::runs_on(device.properties(), false));
  print_denormals(device);
  print_speeds(device);
  print_differences(device);
  return 0;
} catch (const std::exception& why) {
  fmt::print(stderr, "shader_figures: {}\n", why.what());
  return 4;
}
