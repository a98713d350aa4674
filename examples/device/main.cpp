// Rays at opacity micromaps on a device, against the exact micro-triangle of each point; docs/DEVICE.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "verdict.hpp"

namespace {

enum Exit { agrees, differs, usage, environment = 4, no_device };

constexpr const char* help =
    "usage: device_rays VECTORS [--device N] [--levels A..B] [--error E] [--validate]\n"
    "\n"
    "  VECTORS       mmverify_vectors.bin of mmverify vectors --family index,corners\n"
    "  --device N    the loader's device N, counted from 0; else the first that has VK_EXT_opacity_micromap\n"
    "  --levels A..B levels from 0..16; else 0..12, as far as the device goes\n"
    "  --error E     the most by which a hit's u or v may differ from the ray's; else 0x1p-20\n"
    "  --validate    loads the Khronos validation layer; a message of its makes the exit code 4\n"
    "\n"
    "Exit codes: 0 every judged hit has the exact state; 1 one has not; 2 usage; 4 a bad file, or a call of "
    "Vulkan that\n"
    "fails; 5 no device has VK_EXT_opacity_micromap and ray queries.\n";

struct Options {
  std::string vectors;
  std::optional<std::uint32_t> device;
  std::uint32_t first = 0, last = 12;
  double error = 0x1p-20;
  bool validate = false;
};

struct Usage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A whole number up to `most`, and what follows it.
std::uint32_t number(const char* text, std::uint32_t most, const char** rest) {
  char* end = nullptr;
  const unsigned long found = *text >= '0' && *text <= '9' ? std::strtoul(text, &end, 10) : most + 1ul;
  if (end == nullptr || found > most)
    throw Usage(std::string(text) + ": not a whole number from 0 to " + std::to_string(most));
  *rest = end;
  return static_cast<std::uint32_t>(found);
}

void need_end(const char* rest, const char* text) {
  if (*rest != '\0') throw Usage(std::string(text) + ": not understood");
}

void set(Options& options, const std::string& name, const char* text) {
  const char* rest = text;
  if (name == "--device") {
    options.device = number(text, 1000, &rest);
  } else if (name == "--levels") {
    options.first = options.last = number(text, 16, &rest);
    if (std::strncmp(rest, "..", 2) == 0) options.last = number(rest + 2, 16, &rest);
    if (options.last < options.first) throw Usage(std::string(text) + ": the last level is below the first");
  } else if (name == "--error") {
    char* end = nullptr;
    options.error = std::strtod(text, &end);
    if (end == text || !(options.error >= 0 && options.error < 0.5))
      throw Usage(std::string(text) + ": not a number from 0 up to 0.5");
    rest = end;
  } else {
    throw Usage(name + ": no such option");
  }
  need_end(rest, text);
}

Options options_of(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--validate") {
      options.validate = true;
    } else if (word.starts_with("--")) {
      if (k + 1 == count) throw Usage(word + ": its value is missing");
      set(options, word, words[++k]);
    } else if (options.vectors.empty()) {
      options.vectors = word;
    } else {
      throw Usage(word + ": one file of vectors is enough");
    }
  }
  if (options.vectors.empty()) throw Usage("the file of vectors is missing");
  return options;
}

void print(const rays::Verdict& verdict, const rays::Device& device, const std::string& levels,
           double error) {
  const rays::Counts& c = verdict.counts();
  const auto n = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  if (c.wrong != 0)
    std::printf("differs %llu of %llu hits\n", n(c.wrong), n(c.judged));
  else if (!verdict.agrees())
    std::printf("differs in barycentrics alone; the states of all %llu hits agree\n", n(c.judged));
  else
    std::printf("agrees  all of %llu hits\n", n(c.judged));
  if (!verdict.first().empty()) std::printf("first   %s\n", verdict.first().c_str());
  std::printf("device  %s\nlevels  %s\n", device.about().name.c_str(), levels.c_str());
  std::printf("u, v    of hits differ from the ray's by at most %.3g; %.3g is allowed\n", verdict.farthest(),
              error);
  std::printf(
      "apart   %llu hits too near a grid line; %llu on one: %llu have the exact triangle's state, %llu a "
      "neighbour's, %llu "
      "neither\n",
      n(c.near), n(c.tie_exact + c.tie_touched + c.tie_other), n(c.tie_exact), n(c.tie_touched),
      n(c.tie_other));
}

int run(const Options& options) {
  const std::vector<rays::Point> points = rays::read_points(options.vectors);
  const rays::Device device(options.device, options.validate);
  rays::Verdict verdict(options.error);
  std::string levels;
  {
    rays::Shooter shooter(device);
    for (const std::uint32_t format :
         {VK_OPACITY_MICROMAP_FORMAT_2_STATE_EXT, VK_OPACITY_MICROMAP_FORMAT_4_STATE_EXT}) {
      const bool two = format == VK_OPACITY_MICROMAP_FORMAT_2_STATE_EXT;
      const std::uint32_t last =
          std::min(options.last, two ? device.about().most_2_state : device.about().most_4_state);
      for (std::uint32_t level = options.first; level <= last; ++level) {
        std::vector<rays::Point> of_level;
        std::copy_if(points.begin(), points.end(), std::back_inserter(of_level),
                     [&](const rays::Point& point) { return point.level == level; });
        const rays::Job job = rays::make_job(level, format);
        verdict.add(job, of_level, shooter.shoot(job, of_level));
      }
      if (last < options.first) continue;
      levels += (levels.empty() ? "" : ", ") + std::string(two ? "2-state " : "4-state ") +
                std::to_string(options.first) + ".." + std::to_string(last);
    }
  }
  if (verdict.counts().judged == 0)
    throw std::runtime_error(
        "no hit was judged: the levels are beyond the device's, or --error is too large");
  print(verdict, device, levels, options.error);
  if (device.messages() != 0)
    throw std::runtime_error("the validation layer has " + std::to_string(device.messages()) + " messages");
  return verdict.agrees() ? agrees : differs;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && (std::strcmp(words[1], "--help") == 0 || std::strcmp(words[1], "-h") == 0))
    return std::fputs(help, stdout) < 0 ? environment : agrees;
  try {
    return run(options_of(count, words));
  } catch (const Usage& error) {
    std::fprintf(stderr, "device_rays: %s\n%s", error.what(), help);
    return usage;
  } catch (const rays::NoDevice& error) {
    std::fprintf(stderr, "device_rays: %s\n", error.what());
    return no_device;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "device_rays: %s\n", error.what());
    return environment;
  }
}
