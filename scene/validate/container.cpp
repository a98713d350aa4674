#include "scene/validate/container.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "impl/array/container.hpp"
#include "impl/attribute/container.hpp"
#include "impl/dag/container.hpp"
#include "impl/tree/container.hpp"
#include "scene/validate/sidecar.hpp"

namespace mmverify::scene {
namespace {

/// The positions in the header of a kind of container.
struct Layout {
  FileKind kind;
  std::string_view magic;
  std::size_t version_at, checksum_at, header;
};
constexpr std::array<Layout, 3> layouts{
    {{FileKind::tree, "mmtr", 4, 12, impl::tree::container_header},
     {FileKind::dag, "mmdg", 4, 28, impl::dag::container_header},
     {FileKind::attributes, "mmat", 4, 40, impl::attribute::attribute_header}}};

bool says(std::string_view what, std::string_view part) { return what.find(part) != std::string_view::npos; }

/// Adds a reader's message, "byte N: found; would do", split at the colon.
void add(Report& report, const char* code, std::uint64_t byte, const std::string& what) {
  const auto colon = what.find(": ");
  report.add(code, "byte " + std::to_string(byte),
             colon == std::string::npos ? what : what.substr(colon + 2));
}

/// The readers check in the same order: magic, version, fields, size, checksum, content.  All of them report
/// a wrong size in the same words, which the tests enforce.
void add(Report& report, const Layout& layout, std::uint64_t byte, const std::string& what) {
  const char* code = "container.content";
  if (says(what, "the end of the input") || says(what, "the end of the file") ||
      says(what, "bytes after the end"))
    code = "container.size";
  else if (byte == layout.version_at)
    code = "container.version";
  else if (byte == layout.checksum_at)
    code = "container.checksum";
  else if (byte < layout.header && !says(what, "whose tree is smaller"))
    code = "container.header";
  add(report, code, byte, what);
}

void read(const Layout& layout, std::span<const unsigned char> bytes, Report& report) {
  try {
    switch (layout.kind) {
      case FileKind::tree: impl::tree::read(bytes); break;
      case FileKind::dag: impl::dag::load(bytes); break;
      default: impl::attribute::read_attributes(bytes);
    }
  } catch (const impl::tree::BadContainer& bad) {
    add(report, layout, bad.byte(), bad.what());
  } catch (const impl::dag::BadContainer& bad) {
    add(report, layout, bad.byte(), bad.what());
  } catch (const impl::attribute::BadAttributeFile& bad) {
    add(report, layout, bad.byte(), bad.what());
  }
}

void validate_array(std::span<const unsigned char> bytes, Report& report) {
  impl::array::Bundle bundle;
  try {
    bundle = impl::array::read(bytes);
  } catch (const std::invalid_argument& bad) {
    const std::string what = bad.what();
    const char* code = says(what, "checksum is another")                         ? "container.checksum"
                       : says(what, "cut short") || says(what, "bytes too many") ? "container.size"
                       : says(what, "byte 8: version")                           ? "container.version"
                                                                                 : "container.header";
    add(report, code, std::stoull(what.substr(what.find_first_of("0123456789"))), what);
    return;
  }
  namespace micromap = impl::micromap;
  micromap::Input array;
  const Device device = report.target().device.value_or(Device{});
  array.sets = static_cast<micromap::Sets>(micromap::glTF | report.target().apis);
  array.limits = device.limits;
  std::vector<std::uint8_t> records(bundle.array.records.size() * micromap::record_bytes);
  for (std::size_t r = 0; r < bundle.array.records.size(); ++r) {
    const micromap::Record& record = bundle.array.records[r];
    static_assert(sizeof record == micromap::record_bytes);
    std::copy_n(reinterpret_cast<const std::uint8_t*>(&record), sizeof record,
                records.begin() + static_cast<std::ptrdiff_t>(r * sizeof record));
  }
  array.records = records;
  array.record_count = bundle.array.records.size();
  array.data = bundle.array.data;
  std::vector<micromap::Input> geometries;
  for (const impl::array::Part& part : bundle.parts) {
    micromap::Input& in = geometries.emplace_back();
    in.indexed = true;
    in.encoding = part.encoding;
    in.index_stride = micromap::width(part.encoding) / 8;
    in.indices = part.indices;
    in.triangles = part.indices.size() / in.index_stride;
    in.base_triangle = part.base;
  }
  validate_build(array, geometries, device, report);
}

}  // namespace

std::optional<FileKind> container_kind(std::span<const unsigned char> bytes) {
  if (impl::array::is_container(bytes)) return FileKind::array;
  for (const Layout& layout : layouts)
    if (bytes.size() >= layout.magic.size() &&
        std::equal(layout.magic.begin(), layout.magic.end(), bytes.begin()))
      return layout.kind;
  return {};
}

void validate_container(FileKind kind, std::span<const unsigned char> bytes, Report& report) {
  if (kind == FileKind::array) return validate_array(bytes, report);
  for (const Layout& layout : layouts)
    if (layout.kind == kind) read(layout, bytes, report);
}

}  // namespace mmverify::scene
