// Rays at opacity micromaps on a device, against the exact micro-triangle of each point; docs/DEVICE.md.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command_line.hpp"
#include "verdict.hpp"

namespace {

enum Exit { agrees, differs, usage, off, environment, no_device };

/// Says how far u or v is off, and what the user can do about it.
void print_off(const rays::Verdict& verdict, double error) {
  if (std::isfinite(verdict.farthest()))
    std::printf(
        "off     u or v of a judged opaque hit is off by up to %.3g, more than --error %.3g\n"
        "        Vulkan sets no bound on this: judge again with a larger --error before you call a state "
        "wrong\n",
        verdict.farthest(), error);
  else
    std::printf("off     u or v of a judged opaque hit is %g\n", verdict.farthest());
  std::printf("        first: %s\n", verdict.first_off().c_str());
}

void print(const rays::Verdict& verdict, const rays::Device& device, const std::string& levels,
           double error) {
  const rays::Counts& c = verdict.counts();
  const auto n = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  if (!verdict.near_enough()) print_off(verdict, error);
  if (c.wrong != 0)
    std::printf("differs %llu of %llu hits\n", n(c.wrong), n(c.judged));
  else
    std::printf("agrees  all of %llu hits\n", n(c.judged));
  if (!verdict.first().empty()) std::printf("first   %s\n", verdict.first().c_str());
  std::printf("device  %s\nlevels  %s\n", device.about().name.c_str(), levels.c_str());
  std::printf("u, v    of judged opaque hits differ from the ray's by at most %.3g; %.3g is allowed\n",
              verdict.farthest(), error);
  std::printf(
      "apart   %llu hits too near a grid line; %llu on one: %llu have the exact triangle's state, %llu a "
      "neighbour's, %llu "
      "neither\n",
      n(c.near), n(c.tie_exact + c.tie_touched + c.tie_other), n(c.tie_exact), n(c.tie_touched),
      n(c.tie_other));
}

int run(const rays::Options& options) {
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
  if (!verdict.near_enough()) return off;
  return verdict.counts().wrong == 0 ? agrees : differs;
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::optional<rays::Options> options = rays::options_of(count, words);
    if (options) return run(*options);
    return std::fputs(rays::help, stdout) < 0 ? environment : agrees;
  } catch (const rays::Usage& error) {
    std::fprintf(stderr, "device_rays: %s\n%s", error.what(), rays::help);
    return usage;
  } catch (const rays::NoDevice& error) {
    std::fprintf(stderr, "device_rays: %s\n", error.what());
    return no_device;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "device_rays: %s\n", error.what());
    return environment;
  }
}
