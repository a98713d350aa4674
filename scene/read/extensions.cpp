#include "scene/read/extensions.hpp"

#include <algorithm>
#include <string_view>

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

constexpr std::string_view known_extensions[] = {
    // Read here.
    "KHR_texture_transform", "KHR_mesh_quantization", "KHR_animation_pointer", "EXT_mesh_gpu_instancing",
    "EXT_mesh_opacity_micromap", "KHR_mesh_opacity_micromap", "EXT_meshopt_compression",
    "KHR_meshopt_compression", "KHR_draco_mesh_compression", "EXT_texture_webp", "EXT_texture_avif",
    "MSFT_texture_dds", "KHR_texture_basisu",
    // Without effect on triangles, UVs and alpha.
    "KHR_lights_punctual", "EXT_lights_image_based", "EXT_lights_ies", "KHR_xmp", "KHR_xmp_json_ld",
    "KHR_node_visibility", "KHR_node_selectability", "KHR_node_hoverability", "KHR_interactivity",
    "KHR_audio_emitter", "KHR_physics_rigid_bodies", "KHR_implicit_shapes", "MSFT_lod",
    "MSFT_packing_normalRoughnessMetallic", "MSFT_packing_occlusionRoughnessMetallic",
    "EXT_structural_metadata", "EXT_feature_metadata", "EXT_mesh_features", "EXT_instance_features",
    "EXT_mesh_manifold", "CESIUM_primitive_outline", "CESIUM_RTC", "AGI_articulations", "AGI_stk_metadata"};

/// Prefixes of whole families_of_extensions that change shading or behaviour alone.
constexpr std::string_view families_of_extensions[] = {
    "KHR_materials_", "ADOBE_materials_", "EXT_materials_", "VRMC_", "MSFT_audio_", "MPEG_", "OMI_", "FB_",
    "GODOT_"};

}  // namespace

bool is_read_or_harmless(std::string_view extension) {
  return std::find(std::begin(known_extensions), std::end(known_extensions), extension) !=
             std::end(known_extensions) ||
         std::any_of(std::begin(families_of_extensions), std::end(families_of_extensions),
                     [extension](std::string_view family) { return extension.starts_with(family); });
}

void check_extensions(const Document& document, const nlohmann::json& object, const std::string& at) {
  const nlohmann::json& its = member(object, "extensions");
  if (its.empty()) return;
  for (const nlohmann::json& required : member(document.json, "extensionsRequired")) {
    const std::string& name = required.get_ref<const std::string&>();
    if (its.contains(name) && !is_read_or_harmless(name))
      throw UnreadExtension(document.file, at,
                            "it has " + shown(name) +
                                ", which the file requires and which "
                                "is not read here");
  }
}

}  // namespace mmverify::scene
