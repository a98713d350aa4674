// [release] The cause of wrong maps: each single fault of a baker or a tool is named, and no other one.
#include "proofs/scene/cause/cause.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "impl/micromap/reorder.hpp"
#include "proofs/engine/random.hpp"
#include "scene/bake/bake.hpp"

namespace mmverify::tests {
namespace {

using namespace mmverify::scene;
using impl::micromap::Array;
using impl::micromap::Format;
using impl::micromap::State;
using proofs::scene::Cause;
using proofs::scene::Judged;

constexpr unsigned level = 4;
constexpr std::size_t triangles_each = 6;

/// Spots of alpha, with soft rims, nowhere symmetric.
Image spots(std::uint32_t side, std::uint64_t seed) {
  Image image{"spots", side, side, std::vector<std::uint8_t>(std::size_t{side} * side)};
  proofs::Random random(seed, 0, 0);
  std::vector<std::array<double, 3>> all(6);
  for (auto& spot : all)
    for (double& x : spot) x = static_cast<double>(random.below(1000)) / 1000;
  const double size = static_cast<double>(side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      double most = 0;
      for (const auto& [cx, cy, r] : all)
        most = std::max(most, (0.06 + 0.2 * r) - std::hypot(x / size - cx, y / size - cy));
      std::get<0>(image.alpha)[x + std::size_t{side} * y] =
          static_cast<std::uint8_t>(std::clamp(255 * (0.35 + 9 * most), 0.0, 255.0));
    }
  return image;
}

/// Primitives of one material, with triangles of all sizes, some of them beyond the texture's edge.
Scene leaves(std::size_t primitives = 2) {
  Scene s;
  s.file = "leaves.gltf";
  s.images = {spots(32, 1), spots(32, 2)};
  Material material;
  material.mode = AlphaMode::mask;
  material.cutoff = 0.4f;
  material.base_color_alpha = 0.75f;
  material.texture = BaseColorTexture{0, 0, {Wrap::mirrored_repeat, Wrap::clamp_to_edge, {}, {}, {}}, {}};
  s.materials = {material};
  s.meshes = {{"leaves", 1, {1, {}}}};
  proofs::Random random(7, 0, 0);
  for (std::size_t number = 0; number < primitives; ++number) {
    Primitive p;
    p.number = number;
    p.material = 0;
    p.vertex_alpha = VertexAlpha{0.875f, 0.875f};
    for (std::uint32_t k = 0; k < triangles_each; ++k) {
      const auto at = [&] { return static_cast<float>(random.below(1 << 12)) / (1 << 12); };
      const Uv corner{at() * 0.9f, at() * 0.7f};
      p.uvs.insert(p.uvs.end(), {corner,
                                 {corner[0] + 0.3f + 0.4f * at(), corner[1] + 0.2f * at()},
                                 {corner[0] + 0.2f * at(), corner[1] + 0.3f + 0.4f * at()}});
      p.positions.resize(p.uvs.size());
      p.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    s.primitives.push_back(p);
  }
  return s;
}

/// The maps of a scene, each triangle's in the array of its primitive.
StoredMaps stored(const Scene& scene, unsigned n = level) {
  StoredMaps maps;
  maps.plan = plan(scene);
  const std::vector<unsigned> levels(maps.plan.triangles.size(), n);
  maps.baked = bake(scene, maps.plan, levels);
  for (std::size_t p = 0; p < scene.primitives.size(); ++p) {
    Array array;
    for (std::size_t t = 0; t < scene.primitives[p].triangles.size(); ++t) {
      BakedTriangle& map = maps.baked.triangles[maps.links.size()];
      const std::uint64_t count = impl::micromap::micro_triangles(n);
      std::vector<State> states(count);
      if (map.uniform)
        states.assign(count, *map.uniform);
      else
        impl::micromap::unpack(map.map, map.format, states);
      impl::micromap::Bytes packed(impl::micromap::packed_bytes(count, Format::four_state));
      impl::micromap::pack(states, Format::four_state, packed);
      map = BakedTriangle{n, Format::four_state, map.states, {}, std::move(packed)};
      array.records.push_back(
          {static_cast<std::uint32_t>(array.data.size()), static_cast<std::uint16_t>(n), 2});
      array.data.insert(array.data.end(), map.map.begin(), map.map.end());
      maps.first.push_back(maps.links.size());
      maps.links.push_back({p, t, p, 0, t, maps.links.size()});
    }
    maps.arrays.push_back(std::make_shared<const Array>(array));
  }
  return maps;
}

/// The maps that a baker with a fault makes of the scene, beside the true plan.
StoredMaps baked_from(const Scene& scene, const std::function<void(Scene&)>& fault) {
  Scene other = scene;
  fault(other);
  StoredMaps maps = stored(other);
  maps.plan = plan(scene);
  return maps;
}

std::optional<Cause> cause(const Scene& scene, const StoredMaps& maps) {
  return proofs::scene::cause_of(Judged{scene, maps});
}

std::string code(const Scene& scene, const StoredMaps& maps) {
  const std::optional<Cause> found = cause(scene, maps);
  return found ? found->code : "none";
}

void change(StoredArray& stored, const std::function<void(Array&)>& by) {
  Array array = *stored;
  by(array);
  stored = std::make_shared<const Array>(std::move(array));
}

/// Puts other states in the place of a triangle's.
void set(StoredMaps& maps, std::size_t k, const std::vector<State>& states) {
  impl::micromap::Bytes packed(maps.baked.triangles[k].map.size());
  impl::micromap::pack(states, Format::four_state, packed);
  change(maps.arrays[maps.links[k].array], [&](Array& array) {
    std::copy(packed.begin(), packed.end(), array.data.begin() + array.records[*maps.links[k].record].offset);
  });
  maps.baked.triangles[k].map = std::move(packed);
}

std::vector<State> states(const StoredMaps& maps, std::size_t k) {
  std::vector<State> all(impl::micromap::micro_triangles(maps.baked.triangles[k].level));
  impl::micromap::unpack(maps.baked.triangles[k].map, Format::four_state, all);
  return all;
}

/// Reads triangle k from another record.
void link(StoredMaps& maps, std::size_t k, std::size_t array, std::uint64_t record) {
  maps.links[k].array = array;
  maps.links[k].record = record;
  maps.baked.triangles[k] = stored_map(maps.arrays[array], record);
}

TEST(Cause, TexturesTakenAtRest) {
  Scene moving = leaves();
  moving.materials[0].animated = {"/materials/0/pbrMetallicRoughness/baseColorTexture"};
  moving.materials[0].moving = TransformRange{{{-0.0625f, 0}}, {{0.0625f, 0}}};
  for (Primitive& primitive : moving.primitives)
    primitive.moving_uvs = MovingUvs{primitive.uvs, {0.0625f, 0}};
  const auto plan_of = [&] {
    return plan(moving, finest_level, VaryingAlpha::left_out, MovingTextures::planned);
  };
  StoredMaps maps = stored(leaves());
  maps.plan = plan_of();
  EXPECT_EQ(code(moving, maps), "animation_left_out");
  maps.baked = bake(moving, maps.plan, std::vector<unsigned>(maps.plan.triangles.size(), level));
  EXPECT_EQ(code(moving, maps), "none");
}

TEST(Cause, RightMapsHaveNone) {
  const Scene scene = leaves();
  EXPECT_EQ(code(scene, stored(scene)), "none");
}

TEST(Cause, NamesOtherInputs) {
  struct Fault {
    const char* code;
    std::function<void(Scene&)> make;
  };
  const auto uvs = [](Uv (*change)(const Uv&)) {
    return [change](Scene& s) {
      for (Primitive& p : s.primitives)
        for (Uv& uv : p.uvs) uv = change(uv);
    };
  };
  const Fault faults[] = {
      {"v_flipped", uvs([](const Uv& uv) {
         return Uv{uv[0], 1 - uv[1]};
       })},
      {"u_flipped", uvs([](const Uv& uv) {
         return Uv{1 - uv[0], uv[1]};
       })},
      {"uv_exchanged", uvs([](const Uv& uv) {
         return Uv{uv[1], uv[0]};
       })},
      {"factor_left_out", [](Scene& s) { s.materials[0].base_color_alpha = 1; }},
      {"vertex_alpha_left_out",
       [](Scene& s) {
         for (Primitive& p : s.primitives) p.vertex_alpha = {};
       }},
      {"wrap", [](Scene& s) { s.materials[0].texture->sampler.wrap_u = Wrap::repeat; }},
      {"wrap", [](Scene& s) { s.materials[0].texture->sampler.wrap_v = Wrap::mirrored_repeat; }},
      {"filter", [](Scene& s) { s.materials[0].texture->sampler.magnification = Filter::nearest; }},
      {"texture", [](Scene& s) { s.materials[0].texture->image = 1; }},
      {"cutoff", [](Scene& s) { s.materials[0].cutoff = 0.45f; }},
      {"cutoff", [](Scene& s) { s.materials[0].cutoff = 0.33f; }},
  };
  const Scene scene = leaves();
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.code);
    const std::optional<Cause> found = cause(scene, baked_from(scene, fault.make));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->code, fault.code) << found->says;
    EXPECT_EQ(found->explained, found->wrong);
  }
}

TEST(Cause, NamesTheCutoffsUnderWhichAllIsRight) {
  const Scene scene = leaves();
  const std::optional<Cause> found =
      cause(scene, baked_from(scene, [](Scene& s) { s.materials[0].cutoff = 0.45f; }));
  ASSERT_TRUE(found);
  double least = 0, greatest = 0;
  ASSERT_EQ(std::sscanf(found->says.substr(found->says.find("from ")).c_str(), "from %lf to %lf", &least,
                        &greatest),
            2)
      << found->says;
  EXPECT_LE(least, 0.4501);
  EXPECT_GE(greatest, 0.4499);
  EXPECT_LT(greatest - least, 0.05);
}

TEST(Cause, NamesBlendBakedByACutoff) {
  Scene scene = leaves();
  scene.materials[0].mode = AlphaMode::blend;
  EXPECT_EQ(code(scene, baked_from(scene, [](Scene& s) { s.materials[0].mode = AlphaMode::mask; })),
            "blend_by_cutoff");
}

TEST(Cause, NamesMaskBakedAsBlend) {
  Scene scene = leaves();
  scene.materials[0].base_color_alpha = 1;
  for (Primitive& p : scene.primitives) p.vertex_alpha = {};
  for (std::uint8_t& alpha : std::get<0>(scene.images[0].alpha)) alpha = alpha < 96 ? 0 : alpha;
  EXPECT_EQ(code(scene, baked_from(scene, [](Scene& s) { s.materials[0].mode = AlphaMode::blend; })),
            "mask_as_blend");
}

TEST(Cause, NamesTransformsAndSets) {
  Scene scene = leaves();
  const Scene raw = scene;
  const TextureTransform transform{{0.125f, 0.0625f}, {0.5f, 0.75f}, 0.5f};
  scene.materials[0].texture->transform = transform;
  const auto of = [&](const TextureTransform& t) {
    return [t, &raw](Scene& s) {
      for (std::size_t p = 0; p < s.primitives.size(); ++p)
        for (std::size_t k = 0; k < raw.primitives[p].uvs.size(); ++k)
          s.primitives[p].uvs[k] = transformed(t, raw.primitives[p].uvs[k]);
    };
  };
  of(transform)(scene);
  const auto read = [&](const Primitive& p, const BaseColorTexture& texture) {
    std::vector<Uv> uvs;
    if (texture.uv_set > 1) return uvs;
    for (Uv uv : raw.primitives[p.number].uvs) {
      if (texture.uv_set == 1) uv = {uv[1], 0.5f * uv[0]};
      uvs.push_back(transformed(texture.transform, uv));
    }
    return uvs;
  };
  const auto named = [&](const std::function<void(Scene&)>& fault) {
    const StoredMaps maps = baked_from(scene, fault);
    const std::optional<Cause> found = proofs::scene::cause_of(Judged{scene, maps, 0, false, read});
    return found ? found->code : std::string("none");
  };
  EXPECT_EQ(named(of({})), "transform_left_out");
  EXPECT_EQ(named(of({{0, 0}, transform.scale, transform.rotation})), "transform_offset_left_out");
  EXPECT_EQ(named(of({transform.offset, {1, 1}, transform.rotation})), "transform_scale_left_out");
  EXPECT_EQ(named(of({transform.offset, transform.scale, 0})), "transform_rotation_left_out");
  EXPECT_EQ(named(of({transform.offset, transform.scale, -transform.rotation})),
            "transform_rotation_reversed");
  EXPECT_EQ(named([&](Scene& s) {
              for (Primitive& p : s.primitives) {
                BaseColorTexture texture = *scene.materials[0].texture;
                texture.uv_set = 1;
                p.uvs = read(p, texture);
              }
            }),
            "uv_set");
  EXPECT_EQ(named([&](Scene& s) {
              for (std::size_t p = 0; p < s.primitives.size(); ++p)
                for (std::size_t k = 0; k < raw.primitives[p].uvs.size(); ++k) {
                  const Uv& uv = raw.primitives[p].uvs[k];
                  s.primitives[p].uvs[k] = transformed(transform, {uv[0], 1 - uv[1]});
                }
            }),
            "v_flipped")
      << "before the transform";
}

TEST(Cause, NamesTurnedCorners) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  const std::array<std::uint8_t, 3> orders[] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {0, 1, 2}};
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    impl::micromap::Bytes out(maps.baked.triangles[k].map.size());
    impl::micromap::reorder(maps.baked.triangles[k].map, level, Format::four_state, orders[k % 4], out);
    maps.baked.triangles[k].map = out;
  }
  const std::optional<Cause> found = cause(scene, maps);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->code, "corners");
  EXPECT_THAT(found->says,
              testing::ContainsRegex("[23] turned by 1, [23] turned by 2, [123] wound the other way"));
}

// A tool that compresses meshes turns corners, orders triangles anew, and may change UVs by little.
TEST(Cause, NamesARewrittenIndexBuffer) {
  Scene scene = leaves();
  const StoredMaps right = stored(scene);
  StoredMaps maps = right;
  for (std::size_t k = 0; k < triangles_each; ++k) {
    Primitive& p = scene.primitives[0];
    const std::size_t from = (k + 2) % triangles_each;
    p.triangles[k] = leaves().primitives[0].triangles[from];
    std::rotate(p.triangles[k].begin(), p.triangles[k].begin() + std::ptrdiff_t(k % 3), p.triangles[k].end());
  }
  maps.plan = plan(scene);
  const std::optional<Cause> found = cause(scene, maps);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->code, "corners+other_triangles");
  EXPECT_THAT(found->says,
              testing::EndsWith(" triangles have the maps of others, 2 turned by 1, 2 turned by 2"));
  EXPECT_EQ(found->explained, found->wrong);

  scene.primitives[0].uvs[0][0] += 0.02f;
  maps.plan = plan(scene);
  const std::optional<Cause> nearly = cause(scene, maps);
  ASSERT_TRUE(nearly);
  EXPECT_EQ(nearly->code, "corners+other_triangles");
  EXPECT_THAT(nearly->says, testing::EndsWith("; 1 fit nearly, as if their UVs had changed by little"));
  EXPECT_EQ(nearly->explained + 1, nearly->wrong);
}

/// States whose children 0 and 3 change places in every digit.
std::vector<State> with_exchanged_children(const std::vector<State>& all) {
  std::vector<State> moved = all;
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    std::uint32_t to = 0;
    for (unsigned digit = 0; digit < level; ++digit) {
      const std::uint32_t d = k >> 2 * digit & 3;
      to |= (d == 0 ? 3 : d == 3 ? 0 : d) << 2 * digit;
    }
    moved[to] = all[k];
  }
  return moved;
}

TEST(Cause, NamesStatesAndOrders) {
  const Scene scene = leaves();
  const auto named = [&](const std::function<std::vector<State>(const std::vector<State>&)>& change) {
    StoredMaps maps = stored(scene);
    for (std::size_t k = 0; k < maps.links.size(); ++k) set(maps, k, change(states(maps, k)));
    const std::optional<Cause> found = cause(scene, maps);
    return found ? found->code + ": " + found->says : std::string("none");
  };
  const auto recode = [](std::array<State, 4> to) {
    return [to](std::vector<State> all) {
      for (State& s : all) s = to[static_cast<std::size_t>(s)];
      return all;
    };
  };
  EXPECT_THAT(named(recode({State::O, State::T, State::UT, State::UO})),
              testing::StartsWith("states: T and O are"));
  EXPECT_THAT(named(recode({State::T, State::O, State::UO, State::UT})), testing::StartsWith("unknown_side"));
  EXPECT_THAT(named(recode({State::T, State::UT, State::O, State::UO})),
              testing::StartsWith("states: the two bits"));
  EXPECT_THAT(named(with_exchanged_children),
              testing::HasSubstr("children 0 and 3 change places in every digit"));
}

TEST(Cause, NamesLinks) {
  const Scene scene = leaves();
  const auto named = [&](const std::function<void(StoredMaps&)>& fault) {
    StoredMaps maps = stored(scene);
    fault(maps);
    return code(scene, maps);
  };
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (std::size_t k = 0; k < maps.links.size(); ++k) link(maps, k, maps.links[k].array, 0);
            }),
            "indices_equal");
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (StoredArray& stored : maps.arrays)
                change(stored, [](Array& array) {
                  for (auto& record : array.records) record.offset = 0;
                });
              for (std::size_t k = 0; k < maps.links.size(); ++k)
                link(maps, k, maps.links[k].array, *maps.links[k].record);
            }),
            "offsets_equal");
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (std::size_t k = 0; k < maps.links.size(); ++k)
                link(maps, k, 1 - maps.links[k].array, *maps.links[k].record);
            }),
            "micromaps_exchanged");
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (std::size_t k = triangles_each; k < maps.links.size(); ++k)
                link(maps, k, 0, *maps.links[k].record);
            }),
            "other_micromap");
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (std::size_t k = 0; k < maps.links.size(); ++k)
                link(maps, k, maps.links[k].array, triangles_each - 1 - *maps.links[k].record);
            }),
            "triangles_reversed");
  EXPECT_EQ(named([](StoredMaps& maps) {
              link(maps, 1, 0, 3);
              link(maps, 3, 0, 1);
            }),
            "other_triangles");
  EXPECT_EQ(named([](StoredMaps& maps) {
              for (StoredArray& stored : maps.arrays)  // a record that nobody has is before the others
                change(stored,
                       [](Array& array) { array.records.insert(array.records.begin(), array.records[2]); });
              for (std::size_t k = 0; k < maps.links.size(); ++k)
                link(maps, k, maps.links[k].array, *maps.links[k].record);
            }),
            "base_triangle");
  EXPECT_EQ(named([](StoredMaps& maps) {
              maps.links[2].record = {};
              maps.baked.triangles[2] = BakedTriangle{0, Format::four_state, {0, 1, 0, 0}, State::O, {}};
            }),
            "special_index");
}

/// A triangle whose map is uniform has that special index.
void use_special_indices(StoredMaps& maps) {
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    const std::vector<State> all = states(maps, k);
    const State first = all.front();
    if (std::any_of(all.begin(), all.end(), [first](State s) { return s != first; })) continue;
    maps.links[k].record = {};
    maps.baked.triangles[k] = BakedTriangle{0, Format::four_state, {}, first, {}};
    ++maps.baked.triangles[k].states[static_cast<std::size_t>(first)];
  }
}

TEST(Cause, NamesLinksOfTrianglesWithSpecialIndices) {
  Scene scene = leaves();
  // Triangle 4 of primitive 0 shows the texture's edge alone, which is transparent.
  auto& alpha = std::get<0>(scene.images[0].alpha);
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 4; ++x) alpha[x + 32 * y] = 0;
  for (std::size_t k = 0; k < 3; ++k)
    scene.primitives[0].uvs[12 + k] = {0.01f + 0.01f * float(k & 1), 0.5f + 0.2f * float(k / 2)};
  StoredMaps right = stored(scene);
  use_special_indices(right);
  ASSERT_FALSE(right.links[4].record);
  EXPECT_EQ(code(scene, right), "none");

  StoredMaps reversed = right;
  for (std::size_t k = 0; k < triangles_each; ++k) {
    const std::size_t from = triangles_each - 1 - k;
    reversed.links[k].record = right.links[from].record;
    reversed.baked.triangles[k] = right.baked.triangles[from];
  }
  EXPECT_EQ(code(scene, reversed), "triangles_reversed");

  StoredMaps equal = right;
  for (std::size_t k = 0; k < equal.links.size(); ++k) link(equal, k, equal.links[k].array, 0);
  EXPECT_EQ(code(scene, equal), "indices_equal");
}

// Triangle 1 of either primitive is opaque, and 2 transparent, or the other way round.
TEST(Cause, NamesThePrimitiveWhoseSpecialIndicesAnotherHas) {
  Scene scene = leaves();
  auto& alpha = std::get<0>(scene.images[0].alpha);
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 8; ++x) alpha[x + 32 * y] = x < 4 ? 0 : 255;
  for (Primitive& p : scene.primitives)
    for (std::size_t k = 0; k < 6; ++k)
      p.uvs[3 + k] = {(k / 3 == p.number ? 0.17f : 0.02f) + 0.03f * float(k & 1),
                      0.3f + 0.2f * float(k % 3 / 2) + 0.1f * float(p.number)};
  StoredMaps maps = stored(scene);
  use_special_indices(maps);
  ASSERT_NE(maps.baked.triangles[1].uniform, maps.baked.triangles[triangles_each + 1].uniform);
  EXPECT_EQ(code(scene, maps), "none");
  change(maps.arrays[0], [&](Array& array) {
    for (auto record : maps.arrays[1]->records) {
      record.offset += static_cast<std::uint32_t>(array.data.size());
      array.records.push_back(record);
    }
    array.data.insert(array.data.end(), maps.arrays[1]->data.begin(), maps.arrays[1]->data.end());
    for (const std::size_t uniform : {1u, 2u, 7u, 8u})  // records that nobody has fit nobody
      std::fill_n(array.data.begin() + array.records[uniform].offset, 64, std::uint8_t{0xaa});
  });
  maps.arrays.resize(1);
  for (std::size_t k = 0; k < triangles_each; ++k) {
    const std::size_t from = triangles_each + k;
    maps.links[from].array = 0;
    if (maps.links[from].record) link(maps, from, 0, from);
    maps.links[k].record = maps.links[from].record;
    maps.baked.triangles[k] = maps.baked.triangles[from];
  }
  EXPECT_EQ(code(scene, maps), "other_primitive");
}

TEST(Cause, NamesThePrimitiveWhoseRecordsAnotherHas) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  // One array holds the maps of both.
  change(maps.arrays[0], [&](Array& array) {
    for (auto record : maps.arrays[1]->records) {
      record.offset += static_cast<std::uint32_t>(array.data.size());
      array.records.push_back(record);
    }
    array.data.insert(array.data.end(), maps.arrays[1]->data.begin(), maps.arrays[1]->data.end());
  });
  for (std::size_t k = 0; k < maps.links.size(); ++k) link(maps, k, 0, triangles_each + k % triangles_each);
  const std::optional<Cause> found = cause(scene, maps);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->code, "other_primitive");
  EXPECT_THAT(found->says, testing::StartsWith("mesh 0 primitive 0 has the maps of mesh 0 primitive 1; "));
}

// A file that sets primitives apart by bases: a base that is left out is one, all of another's links are no base.
TEST(Cause, TellsAnotherPrimitivesLinksFromABaseThatIsLeftOut) {
  const Scene scene = leaves(3);
  StoredMaps right = stored(scene);
  change(right.arrays[0], [&](Array& array) {
    for (std::size_t a = 1; a < 3; ++a) {
      for (auto record : right.arrays[a]->records) {
        record.offset += static_cast<std::uint32_t>(array.data.size());
        array.records.push_back(record);
      }
      array.data.insert(array.data.end(), right.arrays[a]->data.begin(), right.arrays[a]->data.end());
    }
  });
  right.arrays.resize(1);
  for (std::size_t k = 0; k < right.links.size(); ++k) {
    link(right, k, 0, k);
    if (k >= 2 * triangles_each) right.links[k].base = 2 * triangles_each;
  }
  EXPECT_EQ(code(scene, right), "none");
  // Primitive `one` reads the records from `record` on, with a base.
  const auto named = [&](std::size_t one, std::size_t record, std::uint64_t base) {
    StoredMaps maps = right;
    for (std::size_t k = 0; k < triangles_each; ++k) {
      link(maps, one * triangles_each + k, 0, record + k);
      maps.links[one * triangles_each + k].base = base;
    }
    return code(scene, maps);
  };
  EXPECT_EQ(named(1, 0, 0), "base_triangle");
  EXPECT_EQ(named(0, triangles_each, 0), "other_primitive");
  EXPECT_EQ(named(0, 2 * triangles_each, 2 * triangles_each), "other_primitive");
}

/// A large texture that is opaque but for three holes, so that maps are nearly alike; UVs within it.
Scene pierced() {
  constexpr std::size_t side = 128;
  Scene scene = leaves();
  for (Primitive& p : scene.primitives)
    for (Uv& uv : p.uvs) uv = {0.55f * uv[0], 0.6f * uv[1]};
  std::vector<std::uint8_t> alpha(side * side, 255);
  for (const std::array<std::size_t, 2>& at : {std::array<std::size_t, 2>{36, 28}, {60, 42}, {40, 66}})
    for (std::size_t y = 0; y < 3; ++y)
      for (std::size_t x = 0; x < 3; ++x) alpha[at[0] + x + side * (at[1] + y)] = 0;
  scene.images[0] = Image{"pierced", side, side, alpha};
  return scene;
}

TEST(Cause, NamesAnExchangeOfMapsThatAreNearlyAlike) {
  const Scene scene = pierced();
  const StoredMaps right = stored(scene, 5);
  std::size_t tried = 0;
  for (std::size_t a = 0; a < triangles_each; ++a)
    for (std::size_t b = a + 1; b < triangles_each; ++b) {
      const std::vector<State> one = states(right, a), two = states(right, b);
      std::size_t different = 0, wrong_in_one = 0, wrong_in_two = 0;
      for (std::size_t k = 0; k < one.size(); ++k) {
        if (one[k] == two[k]) continue;
        ++different;
        wrong_in_one += two[k] < State::UT ? 1 : 0;
        wrong_in_two += one[k] < State::UT ? 1 : 0;
      }
      if (wrong_in_one == 0 || wrong_in_two == 0 || 16 * different >= one.size()) continue;
      ++tried;
      StoredMaps maps = right;
      link(maps, a, 0, b);
      link(maps, b, 0, a);
      EXPECT_EQ(code(scene, maps), "other_triangles") << a << " and " << b;
    }
  EXPECT_GT(tried, 0u);
}

// Triangle 2 has a special index and no record: map k is not triangle k's.
TEST(Cause, NamesEqualIndicesOfMapsThatAreNearlyAlike) {
  Scene scene = pierced();
  scene.primitives.resize(1);
  for (std::size_t k = 0; k < 3; ++k)
    scene.primitives[0].uvs[6 + k] = {0.01f + 0.01f * float(k & 1), 0.5f + 0.2f * float(k / 2)};
  StoredMaps maps = stored(scene, 5);
  use_special_indices(maps);
  ASSERT_FALSE(maps.links[2].record);
  change(maps.arrays[0], [](Array& array) { array.records.erase(array.records.begin() + 2); });
  for (std::size_t k = 3; k < triangles_each; ++k) link(maps, k, 0, k - 1);
  EXPECT_EQ(code(scene, maps), "none");
  for (std::size_t k = 0; k < triangles_each; ++k) link(maps, k, 0, 0);
  EXPECT_EQ(code(scene, maps), "indices_equal");
}

TEST(Cause, NamesEqualOffsetsWhereTheFirstMapIsUniform) {
  Scene scene = leaves();
  auto& alpha = std::get<0>(scene.images[0].alpha);
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 4; ++x) alpha[x + 32 * y] = 0;
  for (Primitive& p : scene.primitives)
    for (std::size_t k = 0; k < 3; ++k)
      p.uvs[k] = {0.01f + 0.01f * float(k & 1), 0.5f + 0.2f * float(k / 2) + 0.01f * float(p.number)};
  StoredMaps maps = stored(scene);
  for (StoredArray& stored : maps.arrays)
    change(stored, [](Array& array) {
      for (auto& record : array.records) record.offset = 0;
    });
  for (std::size_t k = 0; k < maps.links.size(); ++k)
    link(maps, k, maps.links[k].array, *maps.links[k].record);
  EXPECT_EQ(code(scene, maps), "offsets_equal");
}

// No state is known, but 64 unknown states on their right sides are no chance.
TEST(Cause, NamesAChangeUnderWhichEachUnknownStateIsOnItsSide) {
  Scene scene = leaves();
  scene.primitives.resize(1);
  scene.images[0] = Image{"noise", 32, 32, std::vector<std::uint8_t>(32 * 32)};
  proofs::Random random(11, 0, 0);
  for (std::uint8_t& alpha : std::get<0>(scene.images[0].alpha)) alpha = random.below(2) != 0 ? 255 : 0;
  for (Uv& uv : scene.primitives[0].uvs) uv = {12 * uv[0], 12 * uv[1]};
  const StoredMaps maps = baked_from(scene, [](Scene& s) {
    for (Primitive& p : s.primitives)
      for (Uv& uv : p.uvs) uv[0] = 1 - uv[0];
  });
  std::uint64_t known = 0;
  for (std::size_t k = 0; k < maps.links.size(); ++k)
    for (const State s : states(maps, k)) known += s == State::T || s == State::O ? 1 : 0;
  EXPECT_LT(known, 8u) << "of 1,536";
  EXPECT_EQ(code(scene, maps), "u_flipped");
}

// The baker had the right cutoff of the other material.
TEST(Cause, NamesTheCutoffOfOneMaterial) {
  Scene scene = leaves();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].cutoff = 0.6f;
  scene.primitives[1].material = 1;
  EXPECT_EQ(code(scene, baked_from(scene, [](Scene& s) { s.materials[0].cutoff = 0.33f; })), "cutoff");
}

// T alone bounds the cutoff from below: a high one fits any map that is T and unknown.
TEST(Cause, NamesNoCutoffThatIsBoundedOnOneSideAlone) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    std::vector<State> all = states(maps, k);
    for (std::size_t at = 0; at < all.size(); ++at) all[at] = at % 3 == 0 ? State::UT : State::T;
    set(maps, k, all);
  }
  EXPECT_EQ(code(scene, maps), "none");
}

TEST(Cause, NamesAChangedTextureUnderAWholeTriangle) {
  Scene scene = leaves();
  scene.primitives.resize(1);
  // Four by four squares of two triangles, which share their edges.
  Primitive& p = scene.primitives[0];
  p.uvs.clear(), p.triangles.clear();
  for (std::uint32_t y = 0; y < 5; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) p.uvs.push_back({float(x) / 4, float(y) / 4});
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) {
      const std::uint32_t a = 5 * y + x;
      p.triangles.push_back({a, a + 1, a + 5});
      p.triangles.push_back({a + 1, a + 6, a + 5});
    }
  p.positions.resize(p.uvs.size());
  const StoredMaps maps = baked_from(scene, [](Scene& s) {
    auto& alpha = std::get<0>(s.images[0].alpha);
    for (std::size_t y = 8; y < 17; ++y)
      for (std::size_t x = 8; x < 17; ++x)
        alpha[x + 32 * y] = static_cast<std::uint8_t>(255 - alpha[x + 32 * y]);
  });
  EXPECT_EQ(code(scene, maps), "texture_changed");
}

TEST(Cause, NamesAChangedTexture) {
  const Scene scene = leaves();
  const StoredMaps maps = baked_from(scene, [](Scene& s) {
    auto& alpha = std::get<0>(s.images[0].alpha);
    for (std::size_t y = 8; y < 14; ++y)
      for (std::size_t x = 8; x < 14; ++x) alpha[x + 32 * y] = alpha[x + 32 * y] < 128 ? 255 : 0;
  });
  EXPECT_EQ(code(scene, maps), "texture_changed");
}

/// Texels of a square that were opaque, or transparent, before.
std::function<void(Scene&)> with_square(std::size_t from, std::size_t side, std::uint8_t alpha_before) {
  return [=](Scene& s) {
    for (std::size_t y = from; y < from + side; ++y)
      for (std::size_t x = from; x < from + side; ++x)
        std::get<0>(s.images[0].alpha)[x + 32 * y] = alpha_before;
  };
}

// A triangle that is transparent now fits a special index, and its map is no other triangle's.
TEST(Cause, NamesATextureOfWhichAPartWasErased) {
  Scene scene = leaves();
  auto& alpha = std::get<0>(scene.images[0].alpha);
  std::fill(alpha.begin(), alpha.end(), std::uint8_t{0});
  alpha[3 + 32 * 3] = 255;
  EXPECT_EQ(code(scene, baked_from(scene, with_square(18, 5, 255))), "texture_changed");
}

// The part that has changed shows at several places of a mirrored texture.
TEST(Cause, NamesAChangedTextureThatIsRepeated) {
  Scene scene = leaves();
  scene.materials[0].texture->sampler.wrap_v = Wrap::mirrored_repeat;
  for (Primitive& p : scene.primitives)
    for (Uv& uv : p.uvs) uv = {3 * uv[0] - 0.35f, 3 * uv[1] - 0.35f};
  EXPECT_EQ(code(scene, baked_from(scene, with_square(8, 6, 0))), "texture_changed");
}

// Triangles that lie in the changed part alone, and have no neighbours, are wrong all over.
TEST(Cause, NamesAChangedTextureUnderSmallTriangles) {
  Scene scene = leaves();
  for (std::size_t number = 0; number < 2; ++number)
    for (std::size_t k = 0; k < 3; ++k)
      scene.primitives[number].uvs[k] = {0.3f + 0.1f * float(k & 1) + 0.02f * float(number),
                                         0.3f + 0.1f * float(k / 2) + 0.01f * float(number)};
  const bool was_opaque = std::get<0>(scene.images[0].alpha)[11 + 32 * 11] < 128;
  EXPECT_EQ(code(scene, baked_from(scene, with_square(8, 8, was_opaque ? 255 : 0))), "texture_changed");
}

TEST(Cause, AMapOfAnotherPlaceIsNoOlderTexture) {
  const Scene scene = leaves();
  const StoredMaps others = baked_from(scene, [](Scene& s) {
    for (Primitive& p : s.primitives)
      for (Uv& uv : p.uvs) uv = {1 - uv[1], uv[0] + 0.31f};
  });
  std::size_t tried = 0;
  for (std::size_t k = 0; k < 2 * triangles_each; ++k) {
    StoredMaps maps = stored(scene);
    if (states(others, k) == states(maps, k)) continue;
    set(maps, k, states(others, k));
    ++tried;
    EXPECT_NE(code(scene, maps), "texture_changed") << k;
  }
  EXPECT_GT(tried, 6u);
}

TEST(Cause, NamesExchangedStatesBesideASpecialIndex) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    std::vector<State> all = states(maps, k);
    for (State& s : all) s = s == State::T ? State::O : s == State::O ? State::T : s;
    set(maps, k, all);
  }
  // Unknown at level 0: nothing contradicts it.
  maps.links[2].record = {};
  maps.baked.triangles[2] = BakedTriangle{0, Format::four_state, {0, 0, 1, 0}, State::UT, {}};
  EXPECT_EQ(code(scene, maps), "states");
}

TEST(Cause, NamesNoneOfRandomMaps) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  proofs::Random random(3, 0, 0);
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    std::vector<State> all(impl::micromap::micro_triangles(level));
    for (State& s : all) s = static_cast<State>(random.below(4));
    set(maps, k, all);
  }
  EXPECT_EQ(code(scene, maps), "none");
}

// Bytes that nobody wrote are T everywhere.
TEST(Cause, NamesNoneOfMapsOfOneState) {
  const Scene scene = leaves();
  for (const State state : {State::T, State::O, State::UT}) {
    StoredMaps maps = stored(scene);
    for (std::size_t k = 0; k < maps.links.size(); ++k)
      set(maps, k, std::vector<State>(impl::micromap::micro_triangles(level), state));
    EXPECT_EQ(code(scene, maps), "none");
  }
}

TEST(Cause, NamesNoneOfOneWrongState) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    std::vector<State> all = states(maps, k);
    const auto found = std::find(all.begin(), all.end(), State::UT);
    if (found == all.end()) continue;
    *found = State::O;
    set(maps, k, all);
    EXPECT_EQ(code(scene, maps), "none");
    return;
  }
  FAIL() << "no map has a UT";
}

/// The processor's time that a call takes.
double time_of(const std::function<void()>& call) {
  const std::clock_t start = std::clock();
  call();
  return static_cast<double>(std::clock() - start);
}

// Most changes leave the one wrong map wrong, so the others are not looked at.
TEST(Cause, OneWrongStateEndsMostTrialsAtOnce) {
  const Scene scene = leaves();
  constexpr unsigned fine = 8;
  StoredMaps maps = stored(scene, fine);
  std::vector<State> all = states(maps, 3);
  const auto found = std::find(all.begin(), all.end(), State::UT);
  ASSERT_NE(found, all.end());
  *found = State::O;
  set(maps, 3, all);
  const std::vector<unsigned> levels(maps.plan.triangles.size(), fine);
  const double of_bake = time_of([&] { bake(scene, maps.plan, levels); });
  std::string named;
  const double of_search = time_of([&] { named = code(scene, maps); });
  EXPECT_EQ(named, "none");
  EXPECT_LT(of_search, 200 * of_bake) << "some 50 bakes' time; 600 if each trial looks at all maps";
}

TEST(Cause, ASearchEndsWhenItsTimeIsOver) {
  const Scene scene = leaves();
  const StoredMaps maps =
      baked_from(scene, [](Scene& s) { s.materials[0].texture->sampler.wrap_u = Wrap::repeat; });
  Judged judged{scene, maps};
  judged.until = std::chrono::steady_clock::now() + std::chrono::hours(1);
  EXPECT_EQ(proofs::scene::cause_of(judged)->code, "wrap");
  judged.until = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  EXPECT_THROW(proofs::scene::cause_of(judged), proofs::scene::OutOfTime);
}

TEST(Cause, NamesNoneOfAStateThatABakerTookForKnown) {
  const Scene scene = leaves();
  const StoredMaps right = stored(scene);
  std::size_t tried = 0;
  for (std::size_t k = 0; k < right.links.size(); ++k) {
    const std::vector<State> all = states(right, k);
    for (std::size_t at = 0; at < all.size() && tried < 80; ++at) {
      if (all[at] != State::UO) continue;
      ++tried;
      StoredMaps maps = right;
      std::vector<State> changed = all;
      changed[at] = State::O;
      set(maps, k, changed);
      EXPECT_EQ(code(scene, maps), "none") << "triangle " << k << " micro-triangle " << at;
    }
  }
  EXPECT_GT(tried, 20u);
}

TEST(Cause, NamesNoneOfOppositeStatesAmongOthers) {
  const Scene scene = leaves();
  StoredMaps maps = stored(scene);
  std::vector<State> all = states(maps, 0);
  std::size_t left = 3;
  for (State& s : all)
    if (s == State::T && left != 0) s = State::O, --left;
  ASSERT_EQ(left, 0u);
  set(maps, 0, all);
  EXPECT_EQ(code(scene, maps), "none");
}

TEST(Cause, NamesNoneOfFewStates) {
  Scene scene = leaves();
  scene.primitives.resize(1);
  scene.materials[0].cutoff = 0;  // all is O
  StoredMaps maps = stored(scene, 0);
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    const std::vector<State> transparent{State::T};
    set(maps, k, transparent);
  }
  EXPECT_EQ(code(scene, maps), "none") << "six states fit an exchange by chance";
}

TEST(Cause, NamesNoneOfMapsThatAreUnknownAlmostEverywhere) {
  const Scene scene = leaves();
  StoredMaps maps = baked_from(scene, [](Scene& s) {
    for (Primitive& p : s.primitives)
      for (Uv& uv : p.uvs) uv[1] = 1 - uv[1];
  });
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    std::vector<State> all = states(maps, k);
    for (std::size_t at = 0; at < all.size(); ++at)
      if (at % 4 != 0 && all[at] < State::UT) all[at] = all[at] == State::T ? State::UT : State::UO;
    set(maps, k, all);
  }
  EXPECT_EQ(code(scene, maps), "none");
}

TEST(Cause, NamesNoneOfATextureThatChangedAllOver) {
  const Scene scene = leaves();
  const StoredMaps maps = baked_from(scene, [](Scene& s) {
    auto& alpha = std::get<0>(s.images[0].alpha);
    for (std::size_t y = 0; y < 32; ++y)
      for (std::size_t x = 0; x < 32; ++x)
        if ((x % 28 < 4 && y % 28 < 4) || (x / 4 == 4 && y / 4 == 4)) alpha[x + 32 * y] ^= 0xff;
  });
  EXPECT_EQ(code(scene, maps), "none");
}

TEST(Cause, NamesTwoFaultsAtOnce) {
  const Scene scene = leaves();
  const StoredMaps maps = baked_from(scene, [](Scene& s) {
    s.materials[0].texture->sampler.magnification = Filter::nearest;
    for (Primitive& p : s.primitives)
      for (Uv& uv : p.uvs) uv[1] = 1 - uv[1];
  });
  EXPECT_EQ(code(scene, maps), "v_flipped+filter");
}

/// A fault of a baker's inputs, or one that a tool makes of the maps.
struct PlantedFault {
  const char* code;
  std::function<void(Scene&)> input = [](Scene&) {};
  std::function<void(StoredMaps&)> maps = [](StoredMaps&) {};
};

std::vector<PlantedFault> faults_of_bakers() {
  const auto each_uv = [](Uv (*change)(const Uv&)) {
    return [change](Scene& s) {
      for (Primitive& p : s.primitives)
        for (Uv& uv : p.uvs) uv = change(uv);
    };
  };
  return {
      {"v_flipped", each_uv([](const Uv& uv) {
         return Uv{uv[0], 1 - uv[1]};
       })},
      {"uv_exchanged", each_uv([](const Uv& uv) {
         return Uv{uv[1], uv[0]};
       })},
      {"factor_left_out", [](Scene& s) { s.materials[0].base_color_alpha = 1; }},
      {"filter", [](Scene& s) { s.materials[0].texture->sampler.magnification = Filter::nearest; }},
      {"wrap", [](Scene& s) { s.materials[0].texture->sampler.wrap_u = Wrap::repeat; }},
      {"cutoff", [](Scene& s) { s.materials[0].cutoff = 0.33f; }},
      {"texture", [](Scene& s) { s.materials[0].texture->image = 1; }},
  };
}

std::vector<PlantedFault> faults_of_tools() {
  const auto each_map = [](std::function<std::vector<State>(std::vector<State>)> change) {
    return [change](StoredMaps& maps) {
      for (std::size_t k = 0; k < maps.links.size(); ++k) set(maps, k, change(states(maps, k)));
    };
  };
  return {
      {"states", {}, each_map([](std::vector<State> all) {
         for (State& s : all) s = s == State::T ? State::O : s == State::O ? State::T : s;
         return all;
       })},
      {"order", {}, each_map(with_exchanged_children)},
      {"corners",
       {},
       [](StoredMaps& maps) {
         for (std::size_t k = 0; k < maps.links.size(); ++k) {
           impl::micromap::Bytes out(maps.baked.triangles[k].map.size());
           impl::micromap::reorder(maps.baked.triangles[k].map, level, Format::four_state,
                                   std::array<std::uint8_t, 3>{1, 2, 0}, out);
           std::vector<State> turned(impl::micromap::micro_triangles(level));
           impl::micromap::unpack(out, Format::four_state, turned);
           set(maps, k, turned);
         }
       }},
      {"micromaps_exchanged",
       {},
       [](StoredMaps& maps) {
         for (std::size_t k = 0; k < maps.links.size(); ++k)
           link(maps, k, 1 - maps.links[k].array, *maps.links[k].record);
       }},
      {"triangles_reversed",
       {},
       [](StoredMaps& maps) {
         for (std::size_t k = 0; k < maps.links.size(); ++k)
           link(maps, k, maps.links[k].array, triangles_each - 1 - *maps.links[k].record);
       }},
  };
}

/// All states of all maps.
std::vector<State> all_states(const StoredMaps& maps) {
  std::vector<State> all;
  for (std::size_t k = 0; k < maps.links.size(); ++k) {
    const std::vector<State> its = states(maps, k);
    all.insert(all.end(), its.begin(), its.end());
  }
  return all;
}

/// The one change that is the same as two: a cutoff of 0.33 of the texture alone is one of 0.2475 of three quarters of
/// it, and exchanges of triangles' maps make another exchange, whatever their corners are.
std::string same_as_both(const std::string& one, const std::string& two) {
  if (one == "factor_left_out" && two == "cutoff") return "cutoff";
  if (one == "micromaps_exchanged" && two == "triangles_reversed") return "other_triangles";
  if (one == "corners" && (two == "micromaps_exchanged" || two == "triangles_reversed"))
    return "corners+other_triangles";
  return "";
}

// Two faults of different kinds are both named or none, unless one of them changes nothing beside the other.
TEST(Cause, NamesBothOfTwoFaultsOrNone) {
  const Scene scene = leaves();
  std::vector<PlantedFault> faults = faults_of_bakers();
  for (const PlantedFault& one : faults_of_tools()) faults.push_back(one);
  const auto maps_of = [&](const PlantedFault& one, const PlantedFault& two) {
    StoredMaps maps = baked_from(scene, [&](Scene& s) {
      if (one.input) one.input(s);
      if (two.input) two.input(s);
    });
    if (one.maps) one.maps(maps);
    if (two.maps) two.maps(maps);
    return maps;
  };
  const PlantedFault nothing{"none"};
  std::size_t both = 0, pairs = 0;
  for (const PlantedFault& one : faults) EXPECT_EQ(code(scene, maps_of(one, nothing)), one.code);
  for (std::size_t a = 0; a < faults.size(); ++a)
    for (std::size_t b = a + 1; b < faults.size(); ++b) {
      const StoredMaps maps = maps_of(faults[a], faults[b]);
      const std::string named = code(scene, maps), one = faults[a].code, two = faults[b].code;
      ++pairs;
      both += named == one + "+" + two || named == two + "+" + one ? 1 : 0;
      if (named == "none" || named == one + "+" + two || named == two + "+" + one) continue;
      if (named == same_as_both(one, two)) continue;
      const bool is_alone = (named == one && all_states(maps) == all_states(maps_of(faults[a], nothing))) ||
                            (named == two && all_states(maps) == all_states(maps_of(faults[b], nothing)));
      EXPECT_TRUE(is_alone) << one << " and " << two << " are named " << named;
    }
  EXPECT_EQ(pairs, 66u);
  EXPECT_GT(both, 10u);
}

}  // namespace
}  // namespace mmverify::tests
