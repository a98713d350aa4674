#include "scene/attribute/code_meaning.hpp"

#include <algorithm>
#include <cmath>

namespace mmverify::scene {
namespace {

using impl::attribute::Meaning;

double light_of(double code) {
  const double c = code / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace

Meaning meaning_of(AttributeSet set, Averaging averaging) {
  if (averaging == Averaging::codes) return Meaning::linear;
  if (is_srgb(set)) return Meaning::srgb;
  return has(set, Attribute::normal) ? Meaning::normal : Meaning::linear;
}

CodeMeaning::CodeMeaning(AttributeSet set, Averaging averaging)
    : meaning_(meaning_of(set, averaging)), channels_(channels_of(set)) {
  const bool light = meaning_ == Meaning::srgb;
  for (std::size_t code = 0; code < 256; ++code) {
    const auto c = static_cast<double>(code);
    table_[code] = light ? light_of(c) : c / 255;
    thresholds_[code] = light ? light_of(c + 0.5) : (c + 0.5) / 255;
  }
}

CodeMeaning::Mean CodeMeaning::mean_of(const MapValue& value) const {
  Mean mean{};
  for (std::size_t c = 0; c < 3; ++c)
    if ((channels_ >> c & 1) != 0)
      mean[c] = meaning_ == Meaning::normal ? 2 * table_[value[c]] - 1 : table_[value[c]];
  return mean;
}

MapValue CodeMeaning::code_of(Mean mean) const {
  if (meaning_ == Meaning::normal) {
    const double length = std::hypot(mean[0], mean[1], mean[2]);
    if (length < 1e-9) mean = {0, 0, 1};
    for (double& c : mean) c = (length < 1e-9 ? c + 1 : c / length + 1) / 2;
  }
  MapValue value{};
  for (std::size_t c = 0; c < 3; ++c) {
    if ((channels_ >> c & 1) == 0) continue;
    // The last threshold is above 1.
    const auto above = std::upper_bound(thresholds_.begin(), thresholds_.end() - 1, mean[c] + 1e-12);
    value[c] = static_cast<std::uint8_t>(above - thresholds_.begin());
  }
  return value;
}

}  // namespace mmverify::scene
