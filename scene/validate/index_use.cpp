#include "scene/validate/index_use.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "scene/validate/vuids.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;

/// The first triangle that names a record, and the first with a special index.
struct FirstOfEach {
  std::optional<std::uint64_t> record, special;
};

FirstOfEach first_of_each(const micromap::Input& in) {
  const std::uint64_t size = micromap::width(in.encoding) / 8;
  FirstOfEach first;
  if (in.indices.size() < size) return first;
  const std::uint64_t room = in.indices.size() - size;
  // A stride of 0 gives all triangles one index.
  const std::uint64_t end = in.index_stride == 0 ? std::min<std::uint64_t>(in.triangles, 1)
                                                 : std::min(in.triangles, room / in.index_stride + 1);
  for (std::uint64_t t = 0; t < end && !(first.record && first.special); ++t) {
    std::uint32_t code = 0;
    std::memcpy(&code, in.indices.data() + t * in.index_stride, static_cast<std::size_t>(size));
    if (micromap::is_index(code, in.encoding)) {
      if (!first.record) first.record = t;
    } else if (micromap::special_state(code, in.encoding) && !first.special) {
      first.special = t;
    }
  }
  return first;
}

}  // namespace

void validate_index_use(const micromap::Input& in, const Device& device, const std::string& at,
                        Report& report) {
  if (!in.indexed || (in.sets & micromap::KHR) == 0) return;
  const auto add = [&](const char* code, const std::string& found) {
    report.add(code, at, found, vuids_of(code, in.sets, cases::always));
  };
  if (in.encoding == micromap::Encoding::u8 && !device.index_uint8)
    add("index.uint8", "indices are u8, and indexTypeUint8 is off");
  if (in.record_count == 0) return;  // the null micromap: an index of a record is an error of its own
  const FirstOfEach first = first_of_each(in);
  if (!first.record || !first.special) return;
  add(device.disallow_mixed ? "index.mixed" : "index.mixed_khr",
      "triangle " + std::to_string(*first.record) + " has a record, triangle " +
          std::to_string(*first.special) + " a special index");
}

}  // namespace mmverify::scene
