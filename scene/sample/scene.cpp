#include "scene/sample/scene.hpp"

#include "scene/sample/meshes.hpp"
#include "scene/sample/textures.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr int repeat = 10497, mirrored_repeat = 33648, clamp_to_edge = 33071, linear = 9729;
constexpr int strip = 5, fan = 6, lines = 1;

class Sample {
 public:
  Bytes built() {
    file_.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing", "KHR_animation_pointer",
                                    "KHR_materials_variants", "KHR_texture_transform"};
    add_materials();
    add_plants();
    add_fence();
    add_ground();
    add_what_is_left_out();
    return file_.finished();
  }

 private:
  std::size_t texture(const Picture& picture, int wrap_u, int wrap_v) {
    const std::size_t sampler = file_.add(
        "samplers", {{"magFilter", linear}, {"minFilter", linear}, {"wrapS", wrap_u}, {"wrapT", wrap_v}});
    const std::size_t image = file_.add_image(picture.name, png(picture));
    return file_.add("textures", {{"sampler", sampler}, {"source", image}});
  }

  /// A material, opaque without `mode`; other materials have two sides.
  std::size_t material(const char* name, const char* mode, Json base_color, double cutoff = 0.5) {
    Json made = {{"name", name}, {"pbrMetallicRoughness", std::move(base_color)}};
    made["pbrMetallicRoughness"]["metallicFactor"] = 0;
    if (mode != nullptr) {
      made["alphaMode"] = mode;
      made["doubleSided"] = true;
    }
    if (cutoff != 0.5) made["alphaCutoff"] = cutoff;
    return file_.add("materials", std::move(made));
  }

  static Json textured(std::size_t texture) { return {{"baseColorTexture", {{"index", texture}}}}; }
  static Json coloured(double r, double g, double b, double alpha = 1) {
    return {{"baseColorFactor", {r, g, b, alpha}}};
  }

  void add_materials() {
    const std::size_t leaves_texture = texture(leaves(), clamp_to_edge, clamp_to_edge);
    leaf_ = material("leaf", "MASK", textured(leaves_texture));
    autumn_leaf_ = material("autumn leaf", "MASK", textured(leaves_texture), 0.75);
    rustling_leaf_ = material("rustling leaf", "MASK", textured(leaves_texture));
    file_.json["materials"][rustling_leaf_]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
              ["KHR_texture_transform"] = {{"offset", {0, 0}}};
    const std::size_t wire_texture = texture(wire(), repeat, mirrored_repeat);
    fence_ = material("fence", "MASK", textured(wire_texture));
    file_.json["materials"][fence_]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
              ["KHR_texture_transform"] = {{"offset", {0.125, 0}}, {"scale", {4, 6}}};
    // With the factor 0.8, the cutoff 0.4 is one half of the texture's alpha.
    flower_ = material("flower", "MASK", textured(texture(flower(), clamp_to_edge, clamp_to_edge)), 0.4);
    file_.json["materials"][flower_]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.8};
    grass_ = material("grass", "MASK", textured(texture(blades(), repeat, clamp_to_edge)), 0.35);
    pond_ = material("pond", "BLEND", textured(texture(pond(), clamp_to_edge, clamp_to_edge)));
    glass_ = material("glass", "BLEND", coloured(0.7, 0.8, 0.8, 0.25));
    wood_ = material("wood", nullptr, coloured(0.36, 0.25, 0.16));
    earth_ = material("earth", nullptr, coloured(0.30, 0.24, 0.17));
  }

  std::size_t mesh(const char* name, Json primitives) {
    return file_.add("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
  }

  void add_plants() {
    const std::size_t plant = mesh(
        "plant", Json::array({file_.primitive(stalk(), wood_, true), file_.primitive(leaf_cards(), leaf_)}));
    file_.place(plant, "plant", {0, 0, 0});
    file_.place(plant, "smaller plant", {-0.9f, 0, 0.4f}, 0.75f);
    file_.place(plant, "smallest plant", {0.8f, 0, 0.5f}, 0.5f);

    Json blossom = file_.primitive(flower_fan(), flower_);
    blossom["mode"] = fan;
    const std::size_t head = mesh("flower", Json::array({std::move(blossom)}));
    file_.place(head, "flower", {0, 1.2f, 0});
    file_.place(head, "smaller flower", {-0.9f, 0.9f, 0.4f}, 0.75f);

    Json tuft = file_.primitive(tuft_strip(), grass_, true);
    tuft["mode"] = strip;
    const std::size_t grass = mesh("grass", Json::array({std::move(tuft)}));
    std::vector<Position> places;
    for (int k = 0; k < 30; ++k)
      places.push_back({0.5f * static_cast<float>(k % 6) - 1.3f, 0,
                        0.35f * static_cast<float>(k / 6) - 0.6f + 0.07f * static_cast<float>(k % 3)});
    const std::size_t node = file_.place(grass, "grass", {0, 0, 0});
    file_.json["nodes"][node]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        file_.add_vectors(places, false, false);
  }

  void add_fence() {
    const std::size_t panel =
        mesh("fence panel", Json::array({file_.primitive(fence_panel(), fence_, true)}));
    const std::size_t post =
        mesh("post", Json::array({file_.primitive(box({0.08f, 1.15f, 0.08f}), wood_, true)}));
    for (int k = 0; k < 3; ++k) {
      const float x = 2 * static_cast<float>(k) - 2;
      file_.place(panel, "panel", {x, 0.05f, -1.5f});
      file_.place(post, "post", {x - 1, 0, -1.5f});
    }
    file_.place(post, "post", {3, 0, -1.5f});
  }

  void add_ground() {
    SampleMesh bed = lying_square(3, 0);
    file_.place(mesh("bed", Json::array({file_.primitive(bed, earth_, true)})), "bed", {0, 0, 0});
    file_.place(mesh("pond", Json::array({file_.primitive(lying_square(0.5f, 0.01f, 3), pond_, true)})),
                "pond", {1.6f, 0, 0.9f});
  }

  /// A leaf card on the ground.
  SampleMesh fallen() const {
    SampleMesh card = lying_square(0.2f, 0.02f);
    for (Uv& uv : card.uvs) uv[0] *= 0.5f;
    return card;
  }

  void add_what_is_left_out() {
    SampleMesh cord;
    cord.positions = {{-3, 1.1f, -1.5f}, {3, 1.1f, -1.5f}};
    Json drawn = file_.primitive(cord, wood_);
    drawn["mode"] = lines;
    file_.place(mesh("cord", Json::array({std::move(drawn)})), "cord", {0, 0, 0});

    mesh("spare leaf", Json::array({file_.primitive(fallen(), leaf_)}));

    file_.place(mesh("pane", Json::array({file_.primitive(lying_square(0.4f, 0.3f), glass_)})), "pane",
                {-1.8f, 0, 0.9f});

    Json withering = file_.primitive(fallen(), leaf_);
    using Colors = std::vector<std::array<float, 4>>;
    withering["attributes"]["COLOR_0"] = file_.add_vectors(Colors(4, {1, 1, 1, 1}));
    const std::size_t brown = file_.add_vectors(
        Colors{{0, 0, 0, 0}, {0, -0.1f, -0.3f, 0}, {0, -0.2f, -0.5f, -0.5f}, {0, -0.2f, -0.5f, -0.5f}});
    withering["targets"] = Json::array({{{"COLOR_0", brown}}});
    file_.place(mesh("withering leaf", Json::array({std::move(withering)})), "withering leaf",
                {0.3f, 0, 1.2f});

    Json turning = file_.primitive(fallen(), leaf_);
    turning["extensions"]["KHR_materials_variants"]["mappings"] =
        Json::array({{{"material", autumn_leaf_}, {"variants", {1}}}});
    file_.json["extensions"]["KHR_materials_variants"]["variants"] =
        Json::array({{{"name", "summer"}}, {{"name", "autumn"}}});
    file_.place(mesh("turning leaf", Json::array({std::move(turning)})), "turning leaf", {-0.3f, 0, 1.2f});

    file_.place(mesh("rustling leaf", Json::array({file_.primitive(fallen(), rustling_leaf_)})),
                "rustling leaf", {-0.6f, 0, 1.5f});
    const std::size_t times = file_.add_numbers({0, 1, 2}, true);
    const std::size_t offsets =
        file_.add_vectors(std::vector<std::array<float, 2>>{{0, 0}, {0.25f, 0}, {0, 0}}, false, false);
    const std::string pointer =
        "/materials/" + std::to_string(rustling_leaf_) +
        "/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset";
    file_.add("animations",
              {{"name", "wind"},
               {"samplers", Json::array({{{"input", times}, {"output", offsets}}})},
               {"channels",
                Json::array({{{"sampler", 0},
                              {"target",
                               {{"path", "pointer"},
                                {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}}})}});

    Json opening = file_.primitive(fallen(), leaf_);
    const std::size_t shift = file_.add_vectors(std::vector<Uv>(4, Uv{0.5f, 0}));
    opening["targets"] = Json::array({{{"TEXCOORD_0", shift}}});
    file_.place(mesh("opening leaf", Json::array({std::move(opening)})), "opening leaf", {0.6f, 0, 1.5f});
  }

  SampleFile file_;
  std::size_t leaf_ = 0, autumn_leaf_ = 0, rustling_leaf_ = 0, fence_ = 0, flower_ = 0, grass_ = 0, pond_ = 0,
              glass_ = 0, wood_ = 0, earth_ = 0;
};

}  // namespace

Bytes sample_scene() { return Sample().built(); }

}  // namespace mmverify::scene
