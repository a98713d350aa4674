#include "command_line.hpp"

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace rays {

static_assert(most_level == 12);  // as the help says
const char* const help =
    "usage: device_rays VECTORS [--device N] [--levels A..B] [--error E] [--validate]\n"
    "\n"
    "  VECTORS       mmverify_vectors.bin of mmverify vectors --family index,corners\n"
    "  --device N    the loader's device N, counted from 0; else the first that has VK_EXT_opacity_micromap\n"
    "  --levels A..B levels from 0..12, as far as the device goes; else all of them\n"
    "  --error E     the most by which a hit's u or v may differ from the ray's; else 0x1p-20\n"
    "  --validate    loads the Khronos validation layer; a message of its makes the exit code 4\n"
    "\n"
    "Exit codes:\n"
    "  0  every judged hit has the exact state\n"
    "  1  a judged hit has another state\n"
    "  2  wrong usage\n"
    "  3  u or v of a judged opaque hit is further from the ray's than --error\n"
    "  4  a file that cannot be read, a call of Vulkan that fails, a message of the validation layer, or no "
    "hit "
    "to judge\n"
    "  5  no device, or not the one that --device names, has VK_EXT_opacity_micromap and ray queries\n";

namespace {

/// The number that the whole text is; none where it is none or above `most`.
std::optional<std::uint32_t> number(std::string_view text, std::uint32_t most) {
  std::uint32_t found = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, found);
  if (error != std::errc{} || end != last || found > most) return std::nullopt;
  return found;
}

void set_levels(Options& options, const std::string& text) {
  const std::size_t dots = text.find("..");
  const auto first = number(text.substr(0, dots), most_level),
             last = dots == text.npos ? first : number(text.substr(dots + 2), most_level);
  if (!first || !last)
    throw Usage("--levels " + text + ": neither A..B nor A, whole numbers from 0 to " +
                std::to_string(most_level));
  if (*last < *first) throw Usage("--levels " + text + ": the last level is below the first");
  options.first = *first;
  options.last = *last;
}

void set(Options& options, const std::string& name, const char* text) {
  constexpr std::uint32_t most_device = 1000;
  if (name == "--levels") return set_levels(options, text);
  if (name == "--device") {
    options.device = number(text, most_device);
    if (!options.device)
      throw Usage("--device " + std::string(text) + ": not a whole number from 0 to " +
                  std::to_string(most_device));
    return;
  }
  char* end = nullptr;
  options.error = std::strtod(text, &end);
  if (end == text || *end != '\0' || !(options.error >= 0 && options.error < 0.5))
    throw Usage("--error " + std::string(text) + ": not a number from 0 up to 0.5");
}

}  // namespace

std::optional<Options> options_of(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    if (word == "--help" || word == "-h") return std::nullopt;
    if (word == "--validate") {
      options.validate = true;
    } else if (word == "--device" || word == "--levels" || word == "--error") {
      if (k + 1 == count) throw Usage(word + ": its value is missing");
      set(options, word, words[++k]);
    } else if (word.starts_with("-")) {
      throw Usage(word + ": no such option");
    } else if (options.vectors.empty()) {
      options.vectors = word;
    } else {
      throw Usage(word + ": one file of vectors is enough");
    }
  }
  if (options.vectors.empty()) throw Usage("the file of vectors is missing");
  return options;
}

}  // namespace rays
