#include "impl/attribute/container.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "impl/common/crc32c.hpp"

namespace mmverify::impl::attribute {
namespace {

// ---- The bytes: docs/ATTRIBUTE_FORMAT.md

constexpr std::array<std::uint8_t, 4> file_magic{'m', 'm', 'a', 't'};
constexpr std::uint8_t file_version = 1;
/// The offset of each field of the header.
enum At : std::size_t {
  at_version = 4,
  at_kind = 5,
  at_order = 6,
  at_level = 7,
  at_components = 8,
  at_meaning = 9,
  at_tie = 10,
  at_decimation = 11,
  at_mips = 12,
  at_payload = 13,
  at_reserved = 14,
  at_error = 16,
  at_maps = 20,
  at_triangles = 24,
  at_payload_bytes = 28,
  at_header_reserved = 36,
  at_crc = 40,
};

std::string told(std::uint64_t x) { return std::to_string(x); }

/// CRC-32C of all bytes but its own four.  Domain: a header or more.
std::uint32_t file_checksum(std::span<const std::uint8_t> bytes) {
  return crc32c(bytes.subspan(attribute_header), crc32c(bytes.first(at_crc)));
}

std::uint64_t number_at(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t width) {
  std::uint64_t x = 0;
  for (std::size_t k = width; k-- > 0;) x = x << 8 | bytes[at + k];
  return x;
}

void put_number(std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t width, std::uint64_t x) {
  for (std::size_t k = 0; k < width; ++k, x >>= 8) bytes[at + k] = static_cast<std::uint8_t>(x);
}

std::uint64_t flag_bytes(const AttributeMaps& maps, std::uint64_t triangles) {
  return maps.decimation == DecimationRule::none ? 0 : (3 * triangles + 7) / 8;
}

// ---- Members that go together

/// A fault of the header's members, and its byte.
struct Complaint {
  std::size_t byte;
  std::string found, would_do;
};

std::optional<Complaint> header_complaint(const AttributeMaps& m) {
  using C = Complaint;
  const bool faces = m.at == MapAt::faces;
  if (!faces && m.at != MapAt::vertices)
    return C{at_kind, "stored at " + told(static_cast<std::uint32_t>(m.at)), "0 (faces) or 1 (vertices)"};
  const auto order =
      faces ? static_cast<std::uint32_t>(m.face_order) : static_cast<std::uint32_t>(m.vertex_order);
  if (order > 2)
    return C{at_order, "order " + told(order),
             faces ? "0 (curve), 1 (rows) or 2 (U-major)" : "0 (W-minor), 1 (U-major) or 2 (Bird)"};
  if (m.level > max_packed_level) return C{at_level, "level " + told(m.level), "0 to 12"};
  if (m.components < 1 || m.components > 15)
    return C{at_components, "components " + told(m.components), "1 to 15"};
  const auto meaning = static_cast<std::uint32_t>(m.meaning);
  if (meaning > 3)
    return C{at_meaning, "meaning " + told(meaning),
             "0 (linear), 1 (sRGB), 2 (direction) or 3 (direction and length)"};
  const bool whole = m.meaning == Meaning::normal_and_length;
  if (meaning != 0 && m.components != 15 && (whole || m.components != 7))
    return C{at_components, "components " + told(m.components) + " of meaning " + told(meaning),
             whole ? "15" : "7 or 15"};
  const auto tie = static_cast<std::uint32_t>(m.tie);
  if (tie > 2 || faces == (tie == 0))
    return C{at_tie, "tie rule " + told(tie), faces ? "1 (Vulkan) or 2 (figure 4)" : "0, vertices need none"};
  const auto decimation = static_cast<std::uint32_t>(m.decimation);
  if (decimation > 2)
    return C{at_decimation, "decimation " + told(decimation), "0, 1 (snapping) or 2 (means)"};
  if (decimation != 0 && (faces || m.level == 0))
    return C{at_decimation, "decimation of " + std::string(faces ? "faces" : "level 0"), "0"};
  if (m.mips && (!faces || m.face_order != FaceOrder::curve || m.payload != Payload::plain))
    return C{at_mips, "mips", "0: only of faces on the curve, plain"};
  const auto payload = static_cast<std::uint32_t>(m.payload);
  if (payload > 1) return C{at_payload, "payload " + told(payload), "0 (plain) or 1 (packed)"};
  if (payload == 1 && order != (faces ? 0u : 2u))
    return C{at_order, "order " + told(order) + " of packed maps", faces ? "0 (curve)" : "2 (Bird)"};
  for (std::size_t c = 0; c < 4; ++c)
    if (const std::uint32_t most = payload == 1 && c < channels_of(m) ? max_packed_error : 0;
        m.error[c] > most)
      return C{at_error + c, "error " + told(m.error[c]), "0 to " + told(most)};
  if (m.maps > (std::uint64_t{1} << 31) / (values_of_entry(m) * channels_of(m)))
    return C{at_maps, told(m.maps) + " maps", "at most 2^31 codes"};
  return std::nullopt;
}

std::optional<Complaint> use_complaint(const AttributeMaps& m, std::size_t t, const MapUse& use) {
  if (use.map >= m.maps)
    return Complaint{attribute_header + 4 * t, "triangle " + told(t) + " has map " + told(use.map),
                     "less than " + told(m.maps)};
  return std::nullopt;
}

}  // namespace

std::uint32_t channels_of(const AttributeMaps& maps) noexcept {
  return static_cast<std::uint32_t>(std::popcount(maps.components));
}

PackedShape shape_of(const AttributeMaps& maps) noexcept {
  return {maps.at, maps.level, channels_of(maps), maps.maps, maps.error};
}

std::uint64_t values_of_entry(const AttributeMaps& maps) noexcept {
  const std::uint64_t values = values_of_map(maps.at, maps.level);
  return maps.mips && maps.at == MapAt::faces ? (4 * values - 1) / 3 : values;
}

BadAttributeFile::BadAttributeFile(std::uint64_t byte, const std::string& found, const std::string& would_do)
    : std::runtime_error("byte " + told(byte) + ": " + found + "; " + would_do + " would do"), byte_(byte) {}

namespace {

void check_writable(const AttributeMaps& maps) {
  const auto refuse = [](const std::string& found, const std::string& would_do) {
    throw std::invalid_argument("attribute::write_attributes: " + found + "; " + would_do + " would do");
  };
  if (const auto c = header_complaint(maps)) refuse(c->found, c->would_do);
  const std::uint64_t codes = maps.maps * values_of_entry(maps) * channels_of(maps);
  if (maps.codes.size() != codes) refuse(told(maps.codes.size()) + " codes", told(codes));
  if (maps.triangles.size() >> 32 != 0) refuse(told(maps.triangles.size()) + " triangles", "below 2^32");
  for (std::size_t t = 0; t < maps.triangles.size(); ++t) {
    if (const auto c = use_complaint(maps, t, maps.triangles[t])) refuse(c->found, c->would_do);
    if (maps.triangles[t].decimated > (maps.decimation == DecimationRule::none ? 0 : 7))
      refuse("flags " + told(maps.triangles[t].decimated) + " of triangle " + told(t),
             maps.decimation == DecimationRule::none ? "0" : "0 to 7");
  }
}

/// Domain: check_writable(maps).
std::vector<std::uint8_t> file_of(const AttributeMaps& maps, std::span<const std::uint8_t> payload) {
  std::vector<std::uint8_t> bytes(attribute_header + 4 * maps.triangles.size() +
                                  static_cast<std::size_t>(flag_bytes(maps, maps.triangles.size())));
  std::copy(file_magic.begin(), file_magic.end(), bytes.begin());
  bytes[at_version] = file_version;
  bytes[at_kind] = static_cast<std::uint8_t>(maps.at);
  bytes[at_order] =
      static_cast<std::uint8_t>(maps.at == MapAt::faces ? static_cast<std::uint32_t>(maps.face_order)
                                                        : static_cast<std::uint32_t>(maps.vertex_order));
  bytes[at_level] = static_cast<std::uint8_t>(maps.level);
  bytes[at_components] = maps.components;
  bytes[at_meaning] = static_cast<std::uint8_t>(maps.meaning);
  bytes[at_tie] = static_cast<std::uint8_t>(maps.tie);
  bytes[at_decimation] = static_cast<std::uint8_t>(maps.decimation);
  bytes[at_mips] = maps.mips ? 1 : 0;
  bytes[at_payload] = static_cast<std::uint8_t>(maps.payload);
  std::copy(maps.error.begin(), maps.error.end(), bytes.begin() + at_error);
  put_number(bytes, at_maps, 4, maps.maps);
  put_number(bytes, at_triangles, 4, maps.triangles.size());
  put_number(bytes, at_payload_bytes, 8, payload.size());
  const std::size_t flags = attribute_header + 4 * maps.triangles.size();
  for (std::size_t t = 0; t < maps.triangles.size(); ++t) {
    put_number(bytes, attribute_header + 4 * t, 4, maps.triangles[t].map);
    for (std::size_t k = 0; k < 3; ++k)
      if ((maps.triangles[t].decimated >> k & 1) != 0)
        bytes[flags + (3 * t + k) / 8] =
            static_cast<std::uint8_t>(bytes[flags + (3 * t + k) / 8] | 1u << (3 * t + k) % 8);
  }
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  put_number(bytes, at_crc, 4, file_checksum(bytes));
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> write_attributes(const AttributeMaps& maps) {
  check_writable(maps);
  return maps.payload == Payload::packed ? file_of(maps, pack(shape_of(maps), maps.codes))
                                         : file_of(maps, maps.codes);
}

std::vector<std::uint8_t> write_attributes(const AttributeMaps& maps, std::span<const std::uint8_t> packed) {
  check_writable(maps);
  return file_of(maps, packed);
}

namespace {

[[noreturn]] void refuse_file(std::uint64_t byte, const std::string& found, const std::string& would_do) {
  throw BadAttributeFile(byte, found, would_do);
}

/// The members that the header says.
AttributeMaps header_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < attribute_header)
    refuse_file(bytes.size(), "the end of the file", "a header of " + told(attribute_header) + " bytes");
  for (std::size_t k = 0; k < file_magic.size(); ++k)
    if (bytes[k] != file_magic[k]) refuse_file(k, "byte " + told(bytes[k]) + " of the magic", "\"mmat\"");
  if (bytes[at_version] != file_version) refuse_file(at_version, "version " + told(bytes[at_version]), "1");
  AttributeMaps maps;
  maps.at = static_cast<MapAt>(bytes[at_kind]);
  if (maps.at == MapAt::faces)
    maps.face_order = static_cast<FaceOrder>(bytes[at_order]);
  else
    maps.vertex_order = static_cast<VertexOrder>(bytes[at_order]);
  maps.level = bytes[at_level];
  maps.components = bytes[at_components];
  maps.meaning = static_cast<Meaning>(bytes[at_meaning]);
  maps.tie = static_cast<TieRule>(bytes[at_tie]);
  maps.decimation = static_cast<DecimationRule>(bytes[at_decimation]);
  if (bytes[at_mips] > 1) refuse_file(at_mips, "mips " + told(bytes[at_mips]), "0 or 1");
  maps.mips = bytes[at_mips] == 1;
  maps.payload = static_cast<Payload>(bytes[at_payload]);
  for (std::size_t k = 0; k < 2; ++k)
    if (bytes[at_reserved + k] != 0)
      refuse_file(at_reserved + k, told(bytes[at_reserved + k]), "0, reserved,");
  std::copy_n(bytes.begin() + at_error, 4, maps.error.begin());
  maps.maps = static_cast<std::uint32_t>(number_at(bytes, at_maps, 4));
  for (std::size_t k = 0; k < 4; ++k)
    if (bytes[at_header_reserved + k] != 0)
      refuse_file(at_header_reserved + k, told(bytes[at_header_reserved + k]), "0, reserved,");
  if (const auto c = header_complaint(maps)) refuse_file(c->byte, c->found, c->would_do);
  return maps;
}

/// The number of triangles, and where the file's parts begin.
struct ContainerParts {
  std::uint64_t triangles, flags, payload;
};

ContainerParts parts_of(std::span<const std::uint8_t> bytes, const AttributeMaps& maps) {
  const std::uint64_t triangles = number_at(bytes, at_triangles, 4);
  const std::uint64_t announced = number_at(bytes, at_payload_bytes, 8);
  const std::uint64_t flags_at = attribute_header + 4 * triangles;
  const std::uint64_t payload_at = flags_at + flag_bytes(maps, triangles);
  const std::uint64_t codes = maps.maps * values_of_entry(maps) * channels_of(maps);
  if (maps.payload == Payload::plain && announced != codes)
    refuse_file(at_payload_bytes, told(announced) + " bytes of payload", told(codes));
  if (bytes.size() < payload_at)
    refuse_file(bytes.size(), "the end of the file",
                told(triangles) + " triangles, up to byte " + told(payload_at) + ",");
  if (bytes.size() - payload_at != announced)
    refuse_file(
        std::min<std::uint64_t>(bytes.size(), payload_at + std::min(announced, bytes.size() - payload_at)),
        bytes.size() - payload_at < announced ? "the end of the file" : "bytes after the end",
        "a payload of " + told(announced) + " bytes");
  if (const std::uint32_t crc = file_checksum(bytes); number_at(bytes, at_crc, 4) != crc)
    refuse_file(at_crc, "checksum " + told(number_at(bytes, at_crc, 4)), "for these bytes " + told(crc));
  return {triangles, flags_at, payload_at};
}

void read_uses(std::span<const std::uint8_t> bytes, const ContainerParts& at, AttributeMaps& maps) {
  const auto flag = [&](std::uint64_t bit) {
    return bytes[static_cast<std::size_t>(at.flags + bit / 8)] >> bit % 8 & 1u;
  };
  maps.triangles.resize(static_cast<std::size_t>(at.triangles));
  for (std::size_t t = 0; t < at.triangles; ++t) {
    MapUse& use = maps.triangles[t];
    use.map = static_cast<std::uint32_t>(number_at(bytes, attribute_header + 4 * t, 4));
    for (std::uint64_t k = 0; k < 3 && maps.decimation != DecimationRule::none; ++k)
      use.decimated = static_cast<std::uint8_t>(use.decimated | flag(3 * t + k) << k);
    if (const auto c = use_complaint(maps, t, use)) refuse_file(c->byte, c->found, c->would_do);
  }
  for (std::uint64_t bit = 3 * at.triangles; maps.decimation != DecimationRule::none && bit % 8 != 0; ++bit)
    if (flag(bit) != 0) refuse_file(at.flags + bit / 8, "a flag of no triangle", "0");
}

}  // namespace

AttributeMaps read_attributes(std::span<const std::uint8_t> bytes) {
  AttributeMaps maps = header_of(bytes);
  const ContainerParts at = parts_of(bytes, maps);
  read_uses(bytes, at, maps);
  const auto payload = bytes.subspan(static_cast<std::size_t>(at.payload));
  if (maps.payload == Payload::plain) {
    maps.codes.assign(payload.begin(), payload.end());
    return maps;
  }
  try {
    maps.codes = PackedMaps(shape_of(maps), payload).codes();
  } catch (const BadPacked& bad) {
    throw BadAttributeFile(at.payload + bad.byte(), bad.found(), bad.would_do());
  }
  return maps;
}

}  // namespace mmverify::impl::attribute
