// Our FLIP beside the authors' FLIP.h (github.com/NVlabs/flip): see scripts/flip-peer.
#include <FLIP.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "scene/flip/flip.hpp"

namespace {

using Rgb = std::vector<std::uint8_t>;

float light(std::uint8_t code) {
  const float c = code / 255.0f;
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

std::vector<float> lights(const Rgb& rgb) {
  std::vector<float> all;
  for (const std::uint8_t code : rgb) all.push_back(light(code));
  return all;
}

/// Whether both means are within 1e-4; theirs is summed in binary64 of their own map.
bool close(const char* name, std::uint32_t width, std::uint32_t height, const Rgb& a, const Rgb& b) {
  const std::vector<float> ours =
      mmverify::flip::error_map({width, height, a}, {width, height, b}, {.threads = 1});
  const std::vector<float> reference = lights(a), test = lights(b);
  FLIP::Parameters parameters;
  float printed = 0;
  float* theirs = nullptr;
  FLIP::evaluate(reference.data(), test.data(), int(width), int(height), false, parameters, false, true,
                 printed, &theirs);
  double sum = 0, apart = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    sum += theirs[k];
    apart = std::fmax(apart, std::fabs(double(theirs[k]) - ours[k]));
  }
  delete[] theirs;
  const double their_mean = sum / double(ours.size()), our_mean = mmverify::flip::mean(ours);
  const bool within = std::fabs(their_mean - our_mean) <= 1e-4;
  std::printf("%s %-28s %4ux%-4u theirs %.7f ours %.7f means apart %.1e, texels %.1e\n",
              within ? "close" : "APART", name, width, height, their_mean, our_mean,
              std::fabs(their_mean - our_mean), apart);
  return within;
}

Rgb noise(std::size_t texels, unsigned seed) {
  std::mt19937 random(seed);
  Rgb rgb(3 * texels);
  for (std::uint8_t& code : rgb) code = std::uint8_t(random() >> 24);
  return rgb;
}

}  // namespace

int main() {
  bool all = true;
  const auto flat = [](std::size_t texels, int code) { return Rgb(3 * texels, std::uint8_t(code)); };
  all &= close("grey 100, grey 101", 64, 48, flat(64 * 48, 100), flat(64 * 48, 101));
  all &= close("black, white", 64, 48, flat(64 * 48, 0), flat(64 * 48, 255));
  all &= close("random, random", 300, 200, noise(60000, 1), noise(60000, 2));
  Rgb wave(3 * 512 * 512), coarse = wave, shifted = wave;
  for (std::size_t y = 0; y < 512; ++y)
    for (std::size_t x = 0; x < 512; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto code = [&](double s) {
          return std::uint8_t(128 + 90 * std::sin(0.05 * s + 0.03 * double(c * y)) +
                              30 * std::sin(0.7 * double(y)));
        };
        wave[3 * (x + 512 * y) + c] = code(double(x));
        shifted[3 * (x + 512 * y) + c] = code(double(x) + 0.5);
        coarse[3 * (x + 512 * y) + c] = std::uint8_t(code(double(x)) & 0xf0);
      }
  all &= close("waves, moved by half a texel", 512, 512, wave, shifted);
  all &= close("waves, in 4 bits", 512, 512, wave, coarse);
  return all ? 0 : 1;
}
