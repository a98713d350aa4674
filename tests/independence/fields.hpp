// Fields: the parts of a question that a wrong function may leave unread, or that a law may never vary alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/independence/regions.hpp"

namespace mmverify::independence {

/// The bytes of a field, or one bit of one byte.
struct Target {
  std::uint8_t* at = nullptr;
  std::size_t bytes = 0;
  std::uint8_t mask = 0xFF;
};

/// A part of a region: "all", "bN" a byte, "bN.K" its bit K, "wN" a word. N counts from the end where it is negative, and
/// is "mid" for the one in the middle. Null where the region is too short.
inline Target target_of(const Region& r, std::string_view part) {
  if (part == "all") return {r.at, r.bytes};
  const std::size_t width = part[0] == 'w' ? 4 : 1, count = r.bytes / width;
  std::string number(part.substr(1));
  std::uint8_t mask = 0xFF;
  if (const auto dot = number.find('.'); dot != std::string::npos) {
    mask = static_cast<std::uint8_t>(1u << std::stoul(number.substr(dot + 1)));
    number.resize(dot);
  }
  long n = number == "mid" ? static_cast<long>(count / 2) : std::stol(number);
  if (n < 0) n += static_cast<long>(count);
  if (n < 0 || static_cast<std::size_t>(n) >= count) return {};
  return {r.at + static_cast<std::size_t>(n) * width, width, mask};
}

/// The parts of a region that a field may be, by what the region is.
inline std::vector<std::string> parts_of(const Region& r, dock::Call entry) {
  const auto begins = [&](std::string_view with) { return r.parameter.substr(0, with.size()) == with; };
  std::vector<std::string> of_a_face_each;
  for (const char* child :
       {"b0", "b4", "b8", "b12", "b1", "b5", "b9", "b13", "b2", "b6", "b10", "b14", "b3", "b7", "b11", "b15"})
    of_a_face_each.emplace_back(child);
  if (entry == dock::Call::attribute_face_mip && begins("blob")) return of_a_face_each;
  if (r.member == "hits")
    return {"w0", "w1", "b8", "b9", "b10", "b11", "w-3", "w-2", "b-4", "b-3", "b-2", "b-1"};
  if (r.member == "indices" || r.member == "uvs") return {"w0", "w1", "w2", "wmid", "w-3", "w-2", "w-1"};
  if (r.member == "levels") return {"w0", "w1", "w-1"};
  if (r.member == "triangles") return {"w0", "w1", "w2", "w-3", "w-2", "w-1"};
  if (begins("blob") || r.member == "texels" || r.member == "maps")
    return {"b0", "b1", "bmid", "b-1", "b0.0", "b0.1", "b0.7", "bmid.3", "b-1.6", "b-1.7"};
  if (begins("words")) return {"all", "b0", "b1", "b2", "b3", "b0.0", "b0.1", "b0.2", "b0.3", "b0.7"};
  if (begins("floats")) return {"all", "b0", "b1", "b2", "b3", "b3.7"};
  if (begins("doubles")) return {"all", "b0", "b3", "b4", "b6", "b7"};
  if (r.member == "payload") return {"all", "b0", "b1", "b2", "b3"};
  return {"all"};
}

/// FNV-1a, stirred at the end of each part.
inline std::uint64_t hash(const Regions& all) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const Region& r : all) {
    for (std::size_t k = 0; k < r.bytes; ++k) h = (h ^ r.at[k]) * 0x100000001b3;
    h = (h ^ r.bytes) * 0x9E3779B97F4A7C15;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace mmverify::independence
