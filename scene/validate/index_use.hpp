// The rules of Vulkan for the use of an index buffer, beside those of arrays: the rules of devices and of pipelines.
#pragma once

#include <string>

#include "impl/micromap/validate.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {

/// Reports indices of 8 bits where the device lacks the feature (index.uint8), and an index buffer that has both
/// special indices and records: an error where the pipelines forbid it (index.mixed), else an advice (index.mixed_khr).
/// Domain: a geometry; `in.sets` are the APIs whose rules apply, of which KHR alone has these.  Time: O(triangles).
void validate_index_use(const impl::micromap::Input& in, const Device& device, const std::string& at,
                        Report& report);

}  // namespace mmverify::scene
