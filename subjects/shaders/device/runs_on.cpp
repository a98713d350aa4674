// Describes a device and its guarantees on floats, a line each.
#include <sstream>

#include "subjects/shaders/device/device.hpp"

namespace mmverify::shaders {
namespace {

std::string version(std::uint32_t v) {
  return std::to_string(VK_API_VERSION_MAJOR(v)) + "." + std::to_string(VK_API_VERSION_MINOR(v)) + "." +
         std::to_string(VK_API_VERSION_PATCH(v));
}

/// The modes of two that a shader may request; the device guarantees neither without a request.
std::string on_request(const char* first, VkBool32 has_first, const char* second, VkBool32 has_second) {
  if (has_first == VK_FALSE && has_second == VK_FALSE) return "nothing promised";
  std::string text;
  if (has_first == VK_TRUE) text = first;
  if (has_second == VK_TRUE) text += (text.empty() ? "" : " or ") + std::string(second);
  return text + " where a shader asks for it";
}

}  // namespace

std::string runs_on(const Properties& p, bool validation) {
  std::ostringstream out;
  out << "device: " << p.name << '\n'
      << "device number: " << p.number << " of " << p.of << '\n'
      << "driver: " << (p.driver.empty() ? "unnamed" : p.driver)
      << (p.driver_info.empty() ? "" : ", " + p.driver_info) << '\n'
      << "driver version: " << version(p.driver_version) << '\n'
      << "Vulkan: " << version(p.api_version) << '\n';
  if (p.float_controls_known) {
    const auto& f = p.float_controls;
    out << "binary32 denormals: "
        << on_request("kept", f.shaderDenormPreserveFloat32, "flushed", f.shaderDenormFlushToZeroFloat32)
        << '\n'
        << "binary32 rounding: "
        << on_request("to nearest", f.shaderRoundingModeRTEFloat32, "to zero", f.shaderRoundingModeRTZFloat32)
        << '\n'
        << "binary32 signed zero, infinity, NaN: "
        << on_request("kept", f.shaderSignedZeroInfNanPreserveFloat32, "", VK_FALSE) << '\n';
  } else {
    out << "float controls: the driver does not say\n";
  }
  if (validation) out << "validation layer: on\n";
  return out.str();
}

}  // namespace mmverify::shaders
