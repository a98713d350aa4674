#include "cli/attributes/check.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "impl/attribute/container.hpp"
#include "scene/read/file.hpp"
#include "scene/validate/file.hpp"

namespace mmverify::cli {
namespace {

using namespace impl::attribute;

std::string components_text(std::uint8_t components) {
  std::string text;
  for (unsigned c = 0; c < 4; ++c)
    if ((components >> c & 1) != 0) text += "RGBA"[c];
  return text;
}

void print_file(const std::string& file, std::size_t size, const AttributeMaps& m) {
  constexpr std::array face_orders{"along the curve", "in rows", "U-major"};
  constexpr std::array vertex_orders{"W-minor", "U-major", "in the Bird order"};
  constexpr std::array meanings{"linear", "sRGB", "a direction", "a direction and its length"};
  constexpr std::array ties{"none", "Vulkan's", "figure 4's"};
  constexpr std::array rules{"", "snapping", "means"};
  const bool faces = m.at == MapAt::faces;
  say(stdout, "{}: {} maps of {} {}, level {}, {} {}\n", file, grouped(m.maps), faces ? "faces" : "vertices",
      faces ? face_orders[static_cast<std::size_t>(m.face_order)]
            : vertex_orders[static_cast<std::size_t>(m.vertex_order)],
      m.level, components_text(m.components), meanings[static_cast<std::size_t>(m.meaning)]);
  if (faces) say(stdout, "  ties       {}\n", ties[static_cast<std::size_t>(m.tie)]);
  std::uint64_t decimated = 0;
  for (const MapUse& use : m.triangles) decimated += use.decimated != 0 ? 1 : 0;
  if (m.triangles.empty())
    say(stdout, "  triangles  each its map\n");
  else
    say(stdout, "  triangles  {}\n", grouped(m.triangles.size()));
  if (m.decimation != DecimationRule::none)
    say(stdout, "  decimated  {} of them, by {}\n", grouped(decimated),
        rules[static_cast<std::size_t>(m.decimation)]);
  if (m.mips) say(stdout, "  mips       the coarsest first\n");
  say(stdout, "  payload    {}, {} codes in a file of {} bytes\n",
      m.payload == Payload::plain ? "plain" : "packed", grouped(m.codes.size()), grouped(size));
  if (m.error != std::array<std::uint8_t, 4>{}) {
    std::string errors;
    for (std::size_t c = 0; c < channels_of(m); ++c)
      errors += fmt::format("{}{}", c == 0 ? "" : ", ", m.error[c]);
    say(stdout, "  errors     {} at most\n", errors);
  }
}

}  // namespace

int check_attributes(const std::string& file) {
  if (file.empty()) throw UsageError("check attributes: name the file");
  const scene::Bytes bytes = scene::read_file(file, file, "check attributes");
  if (scene::kind_of(bytes) != scene::FileKind::attributes)
    throw EnvironmentError(file +
                           ": no file of attribute maps, which begins with mmat; `mmverify validate` tells "
                           "other kinds apart");
  try {
    print_file(file, bytes.size(), read_attributes(bytes));
    return complete;
  } catch (const BadAttributeFile& bad) {
    say(stdout, "{}: {}\n", file, bad.what());
    return failed;
  }
}

}  // namespace mmverify::cli
