// [release] proofs/scene/repair/: faults of files are put right, and nothing else changes.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "impl/micromap/reorder.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/scene/repair/file_repair.hpp"
#include "scene/pipeline.hpp"
#include "scene/read/load.hpp"
#include "scene/record/bake_record.hpp"
#include "scene/sample/scene.hpp"
#include "scene/validate/file.hpp"
#include "tests/folder.hpp"
#include "tests/scene/gltf_file.hpp"

namespace mmverify::tests {
namespace {

using namespace mmverify::scene;
using impl::micromap::Format;
using impl::micromap::Record;
using impl::micromap::State;
using proofs::scene::FileRepair;
using proofs::scene::RepairRequest;

constexpr const char* extension_name = "EXT_mesh_opacity_micromap";
constexpr unsigned level = 4;

/// The sample scene with its micromaps, all of them right.
const GltfFile& right_file() {
  static const GltfFile file = [] {
    const Bytes bytes = sample_scene();
    const Scene scene = load("sample.glb", bytes);
    PipelineOptions options;
    options.levels.level = level;
    const SceneMicromaps made = make_micromaps(scene, options);
    return taken_apart(with_micromaps("sample.glb", bytes, scene, made.plan, made.arrays, "sample.glb"));
  }();
  return file;
}

/// A file to plant faults in.
struct Planted {
  GltfFile file = right_file();

  Json& micromap(std::size_t k = 0) { return file.json["extensions"][extension_name]["micromaps"][k]; }
  Json& view(const Json& number) { return file.json["bufferViews"][number.get<std::size_t>()]; }
  std::size_t begin(const Json& number) { return view(number).value("byteOffset", std::size_t{0}); }

  std::vector<Record> records() {
    const std::string bytes = file.bytes.substr(
        begin(micromap()["triangles"]), view(micromap()["triangles"])["byteLength"].get<std::size_t>());
    std::vector<Record> all;
    const std::vector<unsigned char> of = as_bytes(bytes);
    for (std::uint64_t at = 0; at < of.size(); at += 8) all.push_back(impl::micromap::record_at(of, at));
    return all;
  }

  /// Changes the states of a record's map.
  void change(const Record& r, const std::function<std::vector<State>(const std::vector<State>&)>& by) {
    const std::uint64_t count = impl::micromap::micro_triangles(r.level);
    const auto format = static_cast<Format>(r.format);
    const std::size_t at = begin(micromap()["data"]) + r.offset,
                      size = impl::micromap::packed_bytes(count, format);
    std::vector<State> states(count);
    impl::micromap::unpack(as_bytes(file.bytes.substr(at, size)), format, states);
    std::vector<unsigned char> out(size);
    impl::micromap::pack(by(states), format, out);
    std::copy(out.begin(), out.end(), file.bytes.begin() + static_cast<std::ptrdiff_t>(at));
  }
  void change_all(const std::function<std::vector<State>(const std::vector<State>&)>& by) {
    for (const Record& r : records()) change(r, by);
  }
  void turn(const Record& r, const std::array<std::uint8_t, 3>& order) {
    const auto format = static_cast<Format>(r.format);
    const std::size_t at = begin(micromap()["data"]) + r.offset,
                      size = impl::micromap::packed_bytes(impl::micromap::micro_triangles(r.level), format);
    std::vector<unsigned char> out(size);
    impl::micromap::reorder(as_bytes(file.bytes.substr(at, size)), r.level, format, order, out);
    std::copy(out.begin(), out.end(), file.bytes.begin() + static_cast<std::ptrdiff_t>(at));
  }

  /// The primitives with micromaps.
  std::vector<Json*> primitives() {
    std::vector<Json*> all;
    for (Json& mesh : file.json["meshes"])
      for (Json& primitive : mesh["primitives"])
        if (primitive.contains("extensions") && primitive["extensions"].contains(extension_name))
          all.push_back(&primitive);
    return all;
  }
  Json& link(Json* primitive) { return (*primitive)["extensions"][extension_name]; }

  /// The place of an element of an accessor, of 8 or 16 bits.
  std::size_t place(const Json& number, std::size_t element) {
    const Json& accessor = file.json["accessors"][number.get<std::size_t>()];
    return begin(accessor["bufferView"]) + accessor.value("byteOffset", std::size_t{0}) +
           element * (accessor["componentType"] == 5121 ? 1 : 2);
  }
  std::size_t count(const Json& accessor) {
    return file.json["accessors"][accessor.get<std::size_t>()]["count"].get<std::size_t>();
  }
  std::size_t width(const Json& accessor) {
    return file.json["accessors"][accessor.get<std::size_t>()]["componentType"] == 5121 ? 1 : 2;
  }
};

/// A repaired file.
struct Repaired {
  std::vector<std::string> did;
  bool is_whole = false, is_right = false;
  Bytes bytes;
  GltfFile file;
};

Repaired repaired(const std::string& bytes, const RepairRequest& request = {false, false, 0, 300}) {
  const Folder folder;
  const std::string path = (folder / "f.glb").string();
  GltfFile::write(path, bytes);
  FileRepair repair(path, request);
  repair.run();
  Repaired all;
  all.is_whole = repair.report().is_whole();
  all.is_right = repair.report().is_right();
  for (const auto& one : repair.report().rules) all.did.push_back(one.rule + ": " + one.did);
  for (const auto& one : repair.report().primitives) all.did.push_back(one.did);
  for (const auto& one : repair.report().triangles) all.did.push_back(one.did);
  if (!all.is_whole) return all;
  const WrittenFile written = repair.file().written();
  EXPECT_EQ(repair.broken_law(written), "");
  all.bytes = written.bytes;
  all.file = taken_apart(written.bytes);
  return all;
}

/// Repairs the planted file, and expects the right one.
std::vector<std::string> back_to_right(Planted& planted) {
  EXPECT_TRUE(planted.file.bytes != right_file().bytes || planted.file.json != right_file().json);
  const Repaired after = repaired(planted.file.glb());
  EXPECT_TRUE(after.is_whole);
  if (!after.is_whole) return {"nothing"};
  EXPECT_EQ(after.file.json, right_file().json);
  EXPECT_TRUE(after.file.bytes == right_file().bytes) << "the bytes are not those before the fault";
  return after.did;
}

std::size_t number_of(const std::vector<std::string>& did, const std::string& what) {
  return static_cast<std::size_t>(std::count(did.begin(), did.end(), what));
}

std::vector<State> recoded(const std::vector<State>& states, std::array<State, 4> to) {
  std::vector<State> all = states;
  for (State& s : all) s = to[static_cast<std::size_t>(s)];
  return all;
}

/// Meshes without the records of their bakes, which repair refreshes; any other list as it is.
Json without_records(Json list) {
  for (Json& mesh : list)
    if (mesh.contains("primitives"))
      for (Json& primitive : mesh["primitives"])
        if (primitive.contains("extensions") && primitive["extensions"].contains(extension_name))
          primitive["extensions"][extension_name].erase("extras");
  return list;
}

TEST(FileRepair, LeavesARightFileAsItIs) {
  const Repaired after = repaired(right_file().glb());
  EXPECT_TRUE(after.is_right);
  EXPECT_EQ(after.bytes, as_bytes(right_file().glb()));
}

TEST(FileRepair, TurnsMapsBack) {
  Planted planted;
  const std::array<std::uint8_t, 3> orders[] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {0, 1, 2}};
  std::size_t k = 0;
  for (const Record& r : planted.records()) planted.turn(r, orders[k++ % 4]);
  const std::vector<std::string> did = back_to_right(planted);
  EXPECT_GT(number_of(did, "turned by 1 corner"), 3u);
  EXPECT_GT(number_of(did, "turned by 2 corners"), 3u);
  EXPECT_GT(number_of(did, "wound the other way"), 3u);
}

TEST(FileRepair, ExchangesStatesBack) {
  for (const std::array<State, 4>& to : {std::array{State::O, State::T, State::UT, State::UO},
                                         std::array{State::O, State::T, State::UO, State::UT}}) {
    Planted planted;
    planted.change_all([&](const std::vector<State>& states) { return recoded(states, to); });
    const std::vector<std::string> did = back_to_right(planted);
    EXPECT_FALSE(did.empty());
    for (const std::string& one : did) EXPECT_NE(one.find("exchanged"), std::string::npos) << one;
  }
}

TEST(FileRepair, FlipsTheUnknownSideBack) {
  Planted planted;
  planted.change_all([](const std::vector<State>& states) {
    return recoded(states, {State::T, State::O, State::UO, State::UT});
  });
  const std::vector<std::string> did = back_to_right(planted);
  EXPECT_EQ(number_of(did, "recoded: UT and UO are exchanged"), did.size());
}

TEST(FileRepair, LeavesAChoiceOfSidesAlone) {
  Planted planted;
  planted.change_all([](const std::vector<State>& states) {
    return recoded(states, {State::T, State::O, State::UO, State::UO});
  });
  EXPECT_TRUE(repaired(planted.file.glb()).is_right);
}

TEST(FileRepair, PutsStatesInTheCurvesOrder) {
  Planted planted;
  planted.change_all([](const std::vector<State>& states) {
    std::vector<State> moved = states;  // children 0 and 3 change places in every digit
    for (std::uint32_t k = 0; k < states.size(); ++k) {
      std::uint32_t to = 0;
      for (unsigned digit = 0; digit < level; ++digit) {
        const std::uint32_t d = k >> 2 * digit & 3;
        to |= (d == 0 ? 3 : d == 3 ? 0 : d) << 2 * digit;
      }
      moved[to] = states[k];
    }
    return moved;
  });
  EXPECT_FALSE(back_to_right(planted).empty());
}

TEST(FileRepair, TakesTwoFaultsBack) {
  Planted planted;
  std::size_t k = 0;
  for (const Record& r : planted.records())
    if (k++ % 2 == 0) planted.turn(r, {1, 2, 0});
  planted.change_all([](const std::vector<State>& states) {
    return recoded(states, {State::O, State::T, State::UT, State::UO});
  });
  const std::vector<std::string> did = back_to_right(planted);
  EXPECT_GT(number_of(did, "recoded: T and O are exchanged; turned by 2 corners"), 3u);
}

TEST(FileRepair, ShiftsTheBaseBack) {
  Planted planted;
  // One more record, so that all indices are below the number of records.
  const std::string records = planted.file.bytes.substr(
      planted.begin(planted.micromap()["triangles"]),
      planted.view(planted.micromap()["triangles"])["byteLength"].get<std::size_t>());
  const std::string data =
      planted.file.bytes.substr(planted.begin(planted.micromap()["data"]),
                                planted.view(planted.micromap()["data"])["byteLength"].get<std::size_t>());
  planted.micromap()["triangles"] = planted.file.add_view(
      records + little_endian(static_cast<std::uint32_t>(data.size())) + std::string("\0\0\2\0", 4));
  planted.micromap()["data"] = planted.file.add_view(data + std::string(1, '\0'));
  planted.micromap()["usageCounts"].push_back(1);
  planted.micromap()["usageLevels"].push_back(0);
  planted.micromap()["usageFormats"].push_back(2);
  planted.file.set_buffer_length();
  const GltfFile right = planted.file;
  ASSERT_TRUE(repaired(right.glb()).is_right);
  for (Json* primitive : planted.primitives()) planted.link(primitive)["micromapBaseTriangle"] = 1;
  const Repaired after = repaired(planted.file.glb());
  ASSERT_TRUE(after.is_whole);
  EXPECT_EQ(after.file.json, right.json);
  EXPECT_EQ(after.file.bytes.substr(0, right.bytes.size()), right.bytes);
}

/// A second micromap, of the same records, with the states of all maps changed.
void add_micromap(Planted& planted) {
  const std::string data =
      planted.file.bytes.substr(planted.begin(planted.micromap()["data"]),
                                planted.view(planted.micromap()["data"])["byteLength"].get<std::size_t>());
  std::string other = data;
  std::rotate(other.begin(), other.begin() + 101, other.end());
  Json second = planted.micromap();
  second["data"] = planted.file.add_view(other);
  planted.file.json["extensions"][extension_name]["micromaps"].push_back(second);
  planted.file.set_buffer_length();
}

TEST(FileRepair, LinksPrimitivesToAnotherMicromap) {
  Planted planted;
  add_micromap(planted);
  const GltfFile right = planted.file;
  for (Json* primitive : planted.primitives()) planted.link(primitive)["micromap"] = 1;
  const Repaired after = repaired(planted.file.glb());
  ASSERT_TRUE(after.is_whole);
  EXPECT_EQ(after.file.json, right.json);
  EXPECT_EQ(after.file.bytes.substr(0, right.bytes.size()), right.bytes);
  EXPECT_GT(number_of(after.did, "linked to micromap 0"), 1u);
}

TEST(FileRepair, ExchangesIndicesOfPrimitivesBack) {
  Planted planted;
  std::vector<Json*> some = planted.primitives();
  for (std::size_t a = 0; a < some.size(); ++a)
    for (std::size_t b = a + 1; b < some.size(); ++b) {
      Json &one = planted.link(some[a])["micromapIndices"], &two = planted.link(some[b])["micromapIndices"];
      if (planted.count(one) != planted.count(two)) continue;
      Planted spoilt = planted;
      std::swap(spoilt.link(spoilt.primitives()[a])["micromapIndices"],
                spoilt.link(spoilt.primitives()[b])["micromapIndices"]);
      const Repaired after = repaired(spoilt.file.glb());
      EXPECT_TRUE(after.is_whole);
      return;
    }
  GTEST_SKIP() << "no two primitives have as many triangles";
}

TEST(FileRepair, CorrectsIndices) {
  Planted planted;
  for (Json* primitive : planted.primitives()) {
    const Json indices = planted.link(primitive)["micromapIndices"];
    if (planted.count(indices) < 4) continue;
    ASSERT_EQ(planted.width(indices), 2u);
    std::swap_ranges(planted.file.bytes.begin() + static_cast<std::ptrdiff_t>(planted.place(indices, 0)),
                     planted.file.bytes.begin() + static_cast<std::ptrdiff_t>(planted.place(indices, 1)),
                     planted.file.bytes.begin() + static_cast<std::ptrdiff_t>(planted.place(indices, 1)));
  }
  back_to_right(planted);
}

TEST(FileRepair, ReplacesSpecialIndicesAndThoseOutOfRange) {
  for (const std::uint16_t code : std::initializer_list<std::uint16_t>{0xffff, 0xfffe, 0xfffc, 0x4000}) {
    SCOPED_TRACE(code);
    Planted planted;
    const Json indices = planted.link(planted.primitives()[0])["micromapIndices"];
    ASSERT_EQ(planted.width(indices), 2u);
    const std::string before = planted.file.bytes.substr(planted.place(indices, 0), 2);
    planted.file.bytes.replace(planted.place(indices, 0), 2, bytes_of(std::vector<std::uint16_t>{code}));
    const Repaired after = repaired(planted.file.glb());
    ASSERT_TRUE(after.is_whole);
    if (code == 0xfffc) continue;  // unknown is right where the triangle is neither T nor O
    EXPECT_TRUE(after.file.bytes == right_file().bytes);
  }
}

// Triangles that were ordered anew: a uniform one has a record, of which it needs none.
TEST(FileRepair, GivesAUniformTriangleWithARecordItsSpecialIndex) {
  std::size_t tried = 0;
  for (std::size_t p = 0; p < Planted().primitives().size(); ++p) {
    Planted planted;
    const Json& link = planted.link(planted.primitives()[p]);
    if (!link.contains("micromapIndices")) continue;
    const Json indices = link["micromapIndices"];
    for (std::size_t t = 0; t < planted.count(indices); ++t) {
      Planted with = planted;
      const std::size_t width = with.width(indices), at = with.place(indices, t);
      const auto low = static_cast<unsigned char>(with.file.bytes[at]);
      if (low != 0xff && low != 0xfe) continue;  // T and O
      with.file.bytes.replace(at, width, std::string(width, '\0'));
      const std::vector<std::string> did = back_to_right(with);
      EXPECT_EQ(number_of(did, low == 0xff ? "linked to the special index T, being transparent all over"
                                           : "linked to the special index O, being opaque all over"),
                1u);
      ++tried;
      break;
    }
  }
  EXPECT_GT(tried, 0u);
}

/// Turns the vertices of every second triangle, as a tool that compresses indices does.
void turn_vertices(Planted& planted) {
  for (Json* primitive : planted.primitives()) {
    if (!primitive->contains("indices")) continue;
    const Json indices = (*primitive)["indices"];
    for (std::size_t t = 0; t + 1 < planted.count(indices) / 3; t += 2) {
      const auto first =
          planted.file.bytes.begin() + static_cast<std::ptrdiff_t>(planted.place(indices, 3 * t));
      const auto width = static_cast<std::ptrdiff_t>(planted.width(indices));
      std::rotate(first, first + width, first + 3 * width);
    }
  }
}

TEST(FileRepair, GivesASharedRecordThatNeedsTwoTurnsASecondOne) {
  Planted planted;
  turn_vertices(planted);
  const GltfFile before = planted.file;
  const Repaired after = repaired(before.glb());
  ASSERT_TRUE(after.is_whole);
  EXPECT_GT(number_of(after.did, "turned by 1 corner") + number_of(after.did, "turned by 2 corners"), 20u);
  // Bytes that are no micromap's are as they were.
  std::set<std::size_t> touched{planted.micromap()["data"], planted.micromap()["triangles"]};
  for (Json* primitive : planted.primitives())
    touched.insert(
        before.json["accessors"][planted.link(primitive)["micromapIndices"].get<std::size_t>()]["bufferView"]
            .get<std::size_t>());
  for (std::size_t v = 0; v < before.json["bufferViews"].size(); ++v) {
    const Json &was = before.json["bufferViews"][v], &is = after.file.json["bufferViews"][v];
    if (touched.contains(v)) continue;
    EXPECT_EQ(was, is);
    const auto at = was.value("byteOffset", std::size_t{0}), size = was["byteLength"].get<std::size_t>();
    EXPECT_EQ(before.bytes.substr(at, size), after.file.bytes.substr(at, size));
  }
  for (const char* same : {"meshes", "materials", "nodes", "images", "textures"})
    EXPECT_EQ(without_records(before.json[same]), without_records(after.file.json[same])) << same;
}

// A record tells the state of its file: if the corners have changed, it does.
TEST(FileRepair, WritesTheRecordsOfBakesAnew) {
  Planted planted;
  for (Json* const primitive : planted.primitives())
    (*primitive)["extensions"][extension_name]["extras"][bake_record_name]["alphaCutoff"] = 0.0625;
  const Repaired after = repaired(planted.file.glb());
  ASSERT_TRUE(after.is_whole);
  std::size_t masks = 0;
  for (const Json& mesh : after.file.json["meshes"])
    for (const Json& primitive : mesh["primitives"]) {
      if (!primitive.contains("extensions") || !primitive["extensions"].contains(extension_name)) continue;
      const Json& record = primitive["extensions"][extension_name]["extras"][bake_record_name];
      const Json& material = after.file.json["materials"][primitive["material"].get<std::size_t>()];
      if (material["alphaMode"] != "MASK") continue;
      ++masks;
      EXPECT_EQ(record["alphaCutoff"], material.value("alphaCutoff", 0.5));
    }
  EXPECT_GT(masks, 2u);
}

// A material that became opaque, or lost its texture, has no maps: their T would be holes.
TEST(FileRepair, TakesTheMapsOfABakeFromWhatCanHaveNoneNow) {
  for (const bool is_opaque : {true, false}) {
    SCOPED_TRACE(is_opaque);
    Planted planted;
    const std::size_t number = (*planted.primitives()[0])["material"].get<std::size_t>();
    Json& material = planted.file.json["materials"][number];
    std::size_t of_it = 0, others = 0;
    for (Json* const primitive : planted.primitives())
      ++((*primitive)["material"] == number ? of_it : others);
    if (is_opaque)
      material["alphaMode"] = "OPAQUE";
    else
      material["pbrMetallicRoughness"].erase("baseColorTexture");
    const Repaired after = repaired(planted.file.glb());
    ASSERT_TRUE(after.is_whole);
    EXPECT_EQ(
        number_of(after.did, is_opaque ? "its maps were taken away: alphaMode is OPAQUE now"
                                       : "its maps were taken away: the alpha texture, or its UVs, are gone"),
        of_it);
    EXPECT_TRUE(after.file.bytes == planted.file.bytes);
    std::size_t linked = 0;
    for (const Json& mesh : after.file.json["meshes"])
      for (const Json& primitive : mesh["primitives"]) {
        const bool has_maps =
            primitive.contains("extensions") && primitive["extensions"].contains(extension_name);
        linked += has_maps ? 1 : 0;
        EXPECT_FALSE(has_maps && primitive["material"] == number);
      }
    EXPECT_EQ(linked, others);
    const Judged judged = validate_file("f.glb", after.bytes, {}, {});
    EXPECT_EQ(judged.count(Severity::warning), 0u);
  }
}

TEST(FileRepair, PrimitivesThatShareIndicesButNotCornersGetTheirOwn) {
  Planted planted;
  // The same triangles once more, their corners turned by one.
  Json* const first = planted.primitives()[0];
  Json copy = *first;
  const Json indices = copy["indices"];
  const std::size_t size = planted.width(indices) * planted.count(indices);
  std::string turned = planted.file.bytes.substr(planted.place(indices, 0), size);
  const auto corner = static_cast<std::ptrdiff_t>(planted.width(indices));
  for (auto at = turned.begin(); at != turned.end(); at += 3 * corner)
    std::rotate(at, at + corner, at + 3 * corner);
  Json accessor = planted.file.json["accessors"][indices.get<std::size_t>()];
  accessor["bufferView"] = planted.file.add_view(turned);
  accessor.erase("byteOffset");
  copy["indices"] = planted.file.add("accessors", accessor);
  planted.file.json["meshes"][0]["primitives"].push_back(copy);
  planted.file.set_buffer_length();
  const GltfFile before = planted.file;
  const Repaired after = repaired(before.glb());
  ASSERT_TRUE(after.is_whole);
  EXPECT_GT(number_of(after.did, "turned by 1 corner"), 3u);
  Json wanted = before.json["meshes"];
  wanted[0]["primitives"].back()["extensions"][extension_name]["micromapIndices"] =
      before.json["accessors"].size();
  EXPECT_EQ(without_records(after.file.json["meshes"]), without_records(wanted));
  EXPECT_EQ(after.file.bytes.substr(0, before.bytes.size()), before.bytes)
      << "all bytes before are others' too";
}

TEST(FileRepair, RandomMapsNeedTheBaker) {
  Planted planted;
  proofs::Random random(5, 0, 0);
  std::size_t k = 0;
  for (const Record& r : planted.records())
    if (k++ % 3 == 0)
      planted.change(r, [&](const std::vector<State>& states) {
        std::vector<State> all = states;
        const unsigned codes = r.format == 1 ? 2 : 4;
        for (State& s : all) s = static_cast<State>(random.below(codes));
        return all;
      });
  EXPECT_FALSE(repaired(planted.file.glb()).is_whole);
  const Repaired baked = repaired(planted.file.glb(), {true, false, 0, 300});
  ASSERT_TRUE(baked.is_whole);
  const auto of_another_record =
      static_cast<std::size_t>(std::count_if(baked.did.begin(), baked.did.end(), [](const std::string& did) {
        return did.starts_with("linked to the map of record ");
      }));
  EXPECT_GT(number_of(baked.did, "baked anew"), 5u);
  EXPECT_EQ(number_of(baked.did, "baked anew") + of_another_record, baked.did.size())
      << "the scene has cards whose maps are each other's, turned";
}

TEST(FileRepair, CountsAreCountedAnewAndMapsTurned) {
  Planted planted;
  planted.micromap()["usageCounts"][0] = 1;
  planted.turn(planted.records()[0], {1, 2, 0});
  const std::vector<std::string> did = back_to_right(planted);
  EXPECT_EQ(did[0], "counts.array: counted the records anew");
}

TEST(FileRepair, AWrongLevelOrFormatOfARecordIsThatOfItsBytes) {
  for (const auto& [byte, value] : {std::pair{4, 6}, {4, 3}, {4, 200}, {6, 1}, {6, 0}, {7, 1}}) {
    SCOPED_TRACE(byte * 1000 + value);
    Planted planted;
    const std::size_t record = planted.records().size() / 2;
    planted.file
        .bytes[planted.begin(planted.micromap()["triangles"]) + 8 * record + static_cast<std::size_t>(byte)] =
        static_cast<char>(value);
    const std::vector<std::string> did = back_to_right(planted);
    EXPECT_NE(
        did[0].find("gave record " + std::to_string(record) + " the level and format that fill its bytes"),
        std::string::npos)
        << did[0];
  }
}

TEST(FileRepair, ALevelThatLeavesAGapIsWrongOnlyIfTheCountsSaySo) {
  Planted planted;
  const std::size_t record = planted.records().size() / 2;
  planted.file.bytes[planted.begin(planted.micromap()["triangles"]) + 8 * record + 4] = 3;
  planted.micromap()["usageCounts"][0] = 7;
  for (const std::string& did : repaired(planted.file.glb()).did)
    EXPECT_EQ(did.find("gave record"), std::string::npos) << did;
}

TEST(FileRepair, CasesOfTheField) {
  const fs::path folder = fs::path(MMVERIFY_CASES) / "maps";
  if (!fs::exists(folder)) GTEST_SKIP() << "no cases of the field: " << folder;
  for (const char* name :
       {"meshopt_rotated.glb", "merged.glb", "remix_order.glb", "wound.glb", "omm_special.glb"}) {
    SCOPED_TRACE(name);
    const std::string before = text_of(folder / name);
    const Repaired after = repaired(before);
    ASSERT_TRUE(after.is_whole);
    EXPECT_FALSE(after.is_right);
    ASSERT_EQ(after.bytes.size(), before.size());
  }
  for (const char* name : {"remix_factor.glb", "remix_sampler.glb"}) {
    SCOPED_TRACE(name);
    EXPECT_FALSE(repaired(text_of(folder / name)).is_whole);
    EXPECT_TRUE(repaired(text_of(folder / name), {true, false, 0, 300}).is_whole);
  }
}

}  // namespace
}  // namespace mmverify::tests
