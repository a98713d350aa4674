// A subject that runs compute shaders on a Vulkan device; MMVERIFY_SHADER names the manifest.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>

#include "impl/dag/container.hpp"
#include "impl/dag/dag.hpp"
#include "impl/tree/tree.hpp"
#include "subjects/sdk/mmverify_subject.h"
#include "subjects/shaders/device/program.hpp"

namespace {

using namespace mmverify::shaders;

/// The state of all entry points: made once and never freed.
struct Running {
  std::unique_ptr<Device> device;
  std::map<std::string, std::unique_ptr<Program>> programs;  ///< by entry point
  std::string runs_on, name;
};
Running* running = nullptr;
std::string why_not_here;

const std::uint32_t* run(const char* entry_point, const ShaderInputs& asked) {
  return running->programs.at(entry_point)->run(asked);
}

template <class T>
void to_words(const char* entry_point, ShaderInputs asked, T* out) {
  static_assert(sizeof(T) == sizeof(std::uint32_t));
  asked.before = out;
  std::memcpy(out, run(entry_point, asked), asked.count * asked.values * sizeof(T));
}

/// Narrows the answers to bytes, states for example; a value above 255 becomes 255, a wrong answer.
void to_bytes(const char* entry_point, const ShaderInputs& asked, std::uint8_t* out) {
  const std::uint32_t* words = run(entry_point, asked);
  for (std::size_t k = 0; k < asked.count; ++k)
    out[k] = static_cast<std::uint8_t>(words[k] > 0xff ? 0xff : words[k]);
}

// The entry points; a pointer is null if the manifest has no shader for it.
using Words = const std::uint32_t*;
using Floats = const float*;
using Bytes = const std::uint8_t*;

/// Encodes a map as ranked_lookup reads it.
std::size_t encode_ranked(std::uint32_t level, std::uint32_t format, Bytes map, std::uint8_t* code,
                          std::size_t capacity) {
  using namespace mmverify::impl;
  const std::size_t map_bytes = ((std::size_t{format} << 2 * level) + 7) / 8;
  const auto form = tree::Tree::encode(level, static_cast<micromap::Format>(format), {map, map_bytes});
  const auto bytes = static_cast<std::size_t>((form.bits() + 7) / 8);
  if (bytes <= capacity) std::memcpy(code, form.memory(), bytes);
  return bytes;
}

/// Encodes a scene as the container that dag_lookup reads.
std::size_t encode_scene(std::uint32_t format, Bytes scene, std::size_t scene_size, std::uint8_t* code,
                         std::size_t capacity) {
  using namespace mmverify::impl;
  dag::Dag graph(dag::Format{format});
  for (std::size_t at = 0; at < scene_size;) {
    const std::uint32_t level = scene[at++];
    const std::size_t map_bytes = ((std::size_t{format} << 2 * level) + 7) / 8;
    graph.add(level, {scene + at, map_bytes});
    at += map_bytes;
  }
  const std::vector<std::uint8_t> bytes = dag::save(graph);
  if (bytes.size() <= capacity) std::memcpy(code, bytes.data(), bytes.size());
  return bytes.size();
}

/// An entry point's name, and the function that sets its pointer.
struct Entry {
  const char* name;
  void (*offer)(mmverify_subject_t&);
};

const Entry entries[] = {
    {"index_f32",
     [](mmverify_subject_t& s) {
       s.index_f32 = [](std::uint32_t level, Floats u, Floats v, std::uint32_t* out, std::size_t count) {
         to_words("index_f32", {.level = level, .arrays = {u, v}, .count = count}, out);
       };
     }},
    {"corners",
     [](mmverify_subject_t& s) {
       s.corners = [](std::uint32_t level, Words index, std::uint32_t* out, std::size_t count) {
         to_words("corners", {.level = level, .arrays = {index}, .count = count, .values = 6}, out);
       };
     }},
    {"row_index_f32",
     [](mmverify_subject_t& s) {
       s.row_index_f32 = [](std::uint32_t level, Floats u, Floats v, std::uint32_t* out, std::size_t count) {
         to_words("row_index_f32", {.level = level, .arrays = {u, v}, .count = count}, out);
       };
     }},
    {"row_corners",
     [](mmverify_subject_t& s) {
       s.row_corners = [](std::uint32_t level, Words index, std::uint32_t* out, std::size_t count) {
         to_words("row_corners", {.level = level, .arrays = {index}, .count = count, .values = 6}, out);
       };
     }},
    {"tree_lookup",
     [](mmverify_subject_t& s) {
       s.flags |= MMVERIFY_TREE_STREAM;
       s.tree_lookup = [](std::uint32_t level, std::uint32_t format, Bytes code, std::size_t size,
                          Words index, std::uint8_t* out, std::size_t count) {
         to_bytes("tree_lookup",
                  {.level = level,
                   .first = format,
                   .arrays = {index},
                   .bytes = code,
                   .byte_count = size,
                   .count = count},
                  out);
       };
     }},
    {"tree_lookup_f32",
     [](mmverify_subject_t& s) {
       s.flags |= MMVERIFY_TREE_STREAM;
       s.tree_lookup_f32 = [](std::uint32_t level, std::uint32_t format, Bytes code, std::size_t size,
                              Floats u, Floats v, std::uint8_t* out, std::size_t count) {
         to_bytes("tree_lookup_f32",
                  {.level = level,
                   .first = format,
                   .arrays = {u, v},
                   .bytes = code,
                   .byte_count = size,
                   .count = count},
                  out);
       };
     }},
    {"ranked_lookup",
     [](mmverify_subject_t& s) {
       if (s.tree_lookup != nullptr)
         throw std::runtime_error("tree_lookup and ranked_lookup: one form of codes at a time");
       s.tree_encode = encode_ranked;
       s.tree_lookup = [](std::uint32_t level, std::uint32_t format, Bytes code, std::size_t size,
                          Words index, std::uint8_t* out, std::size_t count) {
         to_bytes("ranked_lookup",
                  {.level = level,
                   .first = format,
                   .arrays = {index},
                   .bytes = code,
                   .byte_count = size,
                   .count = count},
                  out);
       };
     }},
    {"dag_lookup",
     [](mmverify_subject_t& s) {
       s.flags |= MMVERIFY_DAG_CONTAINER;
       s.dag_encode = encode_scene;
       s.dag_lookup = [](std::uint32_t format, Bytes code, std::size_t size, Words map, Words index,
                         std::uint8_t* out, std::size_t count) {
         to_bytes(
             "dag_lookup",
             {.first = format, .arrays = {map, index}, .bytes = code, .byte_count = size, .count = count},
             out);
       };
     }},
    {"dag_lookup_f32",
     [](mmverify_subject_t& s) {
       s.flags |= MMVERIFY_DAG_CONTAINER;
       s.dag_encode = encode_scene;
       s.dag_lookup_f32 = [](std::uint32_t format, Bytes code, std::size_t size, Words map, Floats u,
                             Floats v, std::uint8_t* out, std::size_t count) {
         to_bytes("dag_lookup_f32",
                  {.first = format, .arrays = {map, u, v}, .bytes = code, .byte_count = size, .count = count},
                  out);
       };
     }},
    {"vq2_region",
     [](mmverify_subject_t& s) {
       s.vq2_region = [](Bytes block, Words x, Words y, std::uint8_t* out, std::size_t count) {
         constexpr std::size_t block_bytes = 32;
         to_bytes("vq2_region", {.arrays = {x, y}, .bytes = block, .byte_count = block_bytes, .count = count},
                  out);
       };
     }},
    {"vq4_region",
     [](mmverify_subject_t& s) {
       s.vq4_region = [](Bytes block, Words x, Words y, std::uint8_t* out, std::size_t count) {
         constexpr std::size_t block_bytes = 64;
         to_bytes("vq4_region", {.arrays = {x, y}, .bytes = block, .byte_count = block_bytes, .count = count},
                  out);
       };
     }},
    {"attribute_vertex_index",
     [](mmverify_subject_t& s) {
       s.attribute_vertex_index = [](std::uint32_t level, std::uint32_t order, Words i, Words j,
                                     std::uint32_t* out, std::size_t count) {
         to_words("attribute_vertex_index",
                  {.level = level, .first = order, .arrays = {i, j}, .count = count}, out);
       };
     }},
    {"attribute_vertex_place",
     [](mmverify_subject_t& s) {
       s.attribute_vertex_place = [](std::uint32_t level, std::uint32_t order, Words index,
                                     std::uint32_t* out, std::size_t count) {
         to_words("attribute_vertex_place",
                  {.level = level, .first = order, .arrays = {index}, .count = count, .values = 2}, out);
       };
     }},
    {"attribute_face_index",
     [](mmverify_subject_t& s) {
       s.attribute_face_index = [](std::uint32_t level, std::uint32_t order, Words iu, Words iv, Words upper,
                                   std::uint32_t* out, std::size_t count) {
         to_words("attribute_face_index",
                  {.level = level, .first = order, .arrays = {iu, iv, upper}, .count = count}, out);
       };
     }},
    {"attribute_face_place",
     [](mmverify_subject_t& s) {
       s.attribute_face_place = [](std::uint32_t level, std::uint32_t order, Words index, std::uint32_t* out,
                                   std::size_t count) {
         to_words("attribute_face_place",
                  {.level = level, .first = order, .arrays = {index}, .count = count, .values = 3}, out);
       };
     }},
    {"attribute_triplet",
     [](mmverify_subject_t& s) {
       s.attribute_triplet = [](std::uint32_t level, std::uint32_t vertices, std::uint32_t faces, Words face,
                                std::uint32_t* out, std::size_t count) {
         to_words("attribute_triplet",
                  {.level = level,
                   .first = vertices,
                   .second = faces,
                   .arrays = {face},
                   .count = count,
                   .values = 3},
                  out);
       };
     }},
    {"attribute_face_of",
     [](mmverify_subject_t& s) {
       s.attribute_face_of = [](std::uint32_t level, std::uint32_t vertices, std::uint32_t faces, Words a,
                                Words b, Words c, std::uint32_t* out, std::size_t count) {
         to_words("attribute_face_of",
                  {.level = level, .first = vertices, .second = faces, .arrays = {a, b, c}, .count = count},
                  out);
       };
     }},
    {"attribute_triplet_f32",
     [](mmverify_subject_t& s) {
       s.attribute_triplet_f32 = [](std::uint32_t level, std::uint32_t order, Floats u, Floats v,
                                    std::uint32_t* out, std::size_t count) {
         to_words("attribute_triplet_f32",
                  {.level = level, .first = order, .arrays = {u, v}, .count = count, .values = 3}, out);
       };
     }},
    {"attribute_weights_f32",
     [](mmverify_subject_t& s) {
       s.attribute_weights_f32 = [](std::uint32_t level, Floats u, Floats v, float* out, std::size_t count) {
         to_words("attribute_weights_f32", {.level = level, .arrays = {u, v}, .count = count, .values = 3},
                  out);
       };
     }},
    {"attribute_decimate",
     [](mmverify_subject_t& s) {
       s.attribute_decimate = [](std::uint32_t level, std::uint32_t flags, Words i, Words j,
                                 std::uint32_t* out, std::size_t count) {
         to_words("attribute_decimate",
                  {.level = level, .first = flags, .arrays = {i, j}, .count = count, .values = 2}, out);
       };
     }},
    {"attribute_face_mip",
     [](mmverify_subject_t& s) {
       s.attribute_face_mip = [](std::uint32_t rounding, Bytes children, std::size_t parents,
                                 std::uint8_t* out) {
         constexpr std::size_t child_bytes = 16;
         const std::uint32_t* words = run(
             "attribute_face_mip",
             {.first = rounding, .bytes = children, .byte_count = parents * child_bytes, .count = parents});
         std::memcpy(out, words, parents * sizeof *words);
       };
     }},
    {"traverse_decide",
     [](mmverify_subject_t& s) {
       s.traverse_decide = [](std::uint32_t api, Words candidate, Words instance, Words ray,
                              std::uint8_t* out, std::size_t count) {
         to_bytes("traverse_decide", {.first = api, .arrays = {candidate, instance, ray}, .count = count},
                  out);
       };
     }},
    {"traverse_blend",
     [](mmverify_subject_t& s) {
       s.traverse_blend = [](std::uint32_t operation, Words payload, Words value, std::uint32_t* out,
                             std::size_t count) {
         to_words("traverse_blend", {.first = operation, .arrays = {payload, value}, .count = count}, out);
       };
     }},
    {"traverse_blend_hits",
     [](mmverify_subject_t& s) {
       s.traverse_blend_hits = [](const mmverify_blend_case_t* what, std::uint8_t* payload) {
         const std::uint32_t* words =
             run("traverse_blend_hits", {.first = what->operation,
                                         .second = what->payload,
                                         .bytes = what->hits,
                                         .byte_count = what->count * sizeof *what->hits,
                                         .count = 1});
         std::memcpy(payload, words, sizeof *words);
       };
     }},
};

/// Opens the shaders that the manifest names.
const mmverify_subject_t* open_subject() {
  static mmverify_subject_t subject{};
  const char* file = std::getenv(manifest_variable);
  if (running != nullptr) return &subject;
  if (file == nullptr) throw NoDevice(std::string(manifest_variable) + " names no shaders");
  const bool validation = std::getenv(validation_variable) != nullptr;
  const Manifest manifest = read_manifest(file);
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.max_level = 16;
  // Program is not thread-safe.
  subject.flags = MMVERIFY_SINGLE_THREADED | MMVERIFY_LARGE_BATCHES;
  auto made = std::make_unique<Running>();
  made->device = std::make_unique<Device>(manifest.device, validation);
  for (const Module& m : manifest.modules) {
    bool known = false;
    for (const Entry& e : entries)
      if (m.entry_point == e.name) e.offer(subject), known = true;
    if (!known) throw std::runtime_error(m.entry_point + ": no entry point of shaders");
    made->programs[m.entry_point] = std::make_unique<Program>(*made->device, m);
  }
  made->runs_on = runs_on(made->device->properties(), validation);
  made->name = "shaders on " + made->device->properties().name;
  running = made.release();
  subject.name = running->name.c_str();
  subject.runs_on = running->runs_on.c_str();
  return &subject;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) try {
  return open_subject();
} catch (const NoDevice& why) {
  why_not_here = why.what();
  return nullptr;
} catch (const std::exception& why) {
  std::fprintf(stderr, "%s\n", why.what());
  return nullptr;
}

extern "C" const char* mmverify_subject_v1_not_here(void) { return why_not_here.c_str(); }
