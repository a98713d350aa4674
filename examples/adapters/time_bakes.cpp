// Times a subject's bakes in one process, one thread: 128 triangles of a 128 x 128 texture, 4-state,
// bilinear, clamped, cutoff 1/2.  Prints a line LEVEL NANOSECONDS for each given level that it has: the time
// of one micro-triangle.
// usage: time_bakes SUBJECT.so LEVEL...
#include <dlfcn.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "mmverify_subject.h"

/// The processor time of this thread alone, on which other load of the machine has less effect.
static double nanoseconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

int main(int count, char** arguments) {
  void* const library = count > 2 ? dlopen(arguments[1], RTLD_NOW) : nullptr;
  void* const symbol = library != nullptr ? dlsym(library, "mmverify_subject_v1") : nullptr;
  if (symbol == nullptr)
    return std::fprintf(stderr, "time_bakes: %s\n", count > 2 ? dlerror() : "no subject"), 4;
  const auto* const subject = reinterpret_cast<const mmverify_subject_t* (*)()>(symbol)();
  constexpr uint32_t side = 128, cells = 8;
  std::vector<uint8_t> texels(size_t{side} * side);
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x)
      texels[x + size_t{side} * y] =
          static_cast<uint8_t>(std::lround(127.5 + 127.5 * std::sin(x * 0.2) * std::sin(y * 0.28)));
  mmverify_bake_case_t what = {};
  what.size = sizeof what, what.format = MMVERIFY_4_STATE, what.width = what.height = side, what.mips = 1;
  what.texel = MMVERIFY_UNORM8, what.texels = texels.data(),
  what.wrap_u = what.wrap_v = MMVERIFY_CLAMP_TO_EDGE;
  what.factor = what.vertex_factor = 1, what.cutoff_numerator = 1, what.cutoff_denominator = 2;
  for (int k = 2; k < count; ++k) {
    what.level = static_cast<uint32_t>(std::atoi(arguments[k]));
    if (subject->bake_support->max_level != 0 && what.level > subject->bake_support->max_level) continue;
    std::vector<uint8_t> map((size_t{2} << 2 * what.level) / 8 + 1);
    double best = 1e300;
    for (int run = 0; run < 5; ++run) {
      const double start = nanoseconds();
      for (uint32_t t = 0; t < 2 * cells * cells; ++t) {
        const float u = static_cast<float>(t / 2 % cells) / cells,
                    v = static_cast<float>(t / 2 / cells) / cells;
        const float step = 1.0F / cells, upper = static_cast<float>(t % 2) * step;
        const float uv[] = {u + upper, v + upper, u + step, v, u, v + step};
        for (int i = 0; i < 6; ++i) what.uv[i] = uv[i];
        if (subject->bake(&what, map.data()) == 0) return std::fprintf(stderr, "time_bakes: declined\n"), 4;
      }
      best = std::fmin(best, (nanoseconds() - start) /
                                 (2.0 * cells * cells * static_cast<double>(size_t{1} << 2 * what.level)));
    }
    std::printf("%u %.2f\n", what.level, best);
  }
}
