// The three public drafts of the glTF extension of opacity micromaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace mmverify::scene {

/// The drafts in the order of their publication.
enum class Draft : std::uint8_t { khr, ext_1, ext_2 };
inline constexpr Draft newest_draft = Draft::ext_2;

struct DraftText {
  const char* name;       ///< the argument of --draft
  const char* extension;  ///< the extension's name in a file
  const char* source;
};

/// The texts in the order of Draft.  docs/GLTF.md, "Drafts", lists the differences.
inline constexpr std::array<DraftText, 3> drafts{{
    {"khr", "KHR_mesh_opacity_micromap", "KhronosGroup/glTF, pull request 2603, commit 9b3503ed (June 2026)"},
    {"ext-1", "EXT_mesh_opacity_micromap", "the same text under its new name, commit f1b1ec74 (July 2026)"},
    {"ext-2", "EXT_mesh_opacity_micromap", "KhronosGroup/glTF, pull request 2623, commit 4b95e4d3"},
}};
constexpr const DraftText& text(Draft draft) noexcept { return drafts[static_cast<std::size_t>(draft)]; }

constexpr std::optional<Draft> draft_named(std::string_view name) noexcept {
  for (std::size_t k = 0; k < drafts.size(); ++k)
    if (drafts[k].name == name) return static_cast<Draft>(k);
  return {};
}

}  // namespace mmverify::scene
