// The library's own arrays as a subject: the sources of indices, changes and files, word for word, in one file.
#include "impl/array/change.cpp"
#include "impl/array/container.cpp"
#include "impl/micromap/level.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::array;
namespace micromap = mmverify::impl::micromap;

constexpr std::uint32_t cluster_bit = MMVERIFY_INDEX_IN_CLUSTER;

/// Words and bytes of an array that follow each other.
struct From {
  const uint8_t* at;
  template <class Struct>
  Struct next() {
    Struct one;
    std::memcpy(&one, at, sizeof one);
    at += sizeof one;
    return one;
  }
  Bytes bytes(std::size_t count) {
    at += count;
    return Bytes(at - count, at);
  }
};

Bundle bundle_at(From& from) {
  const auto head = from.next<mmverify_array_parts_t>();
  Bundle b;
  std::vector<uint32_t> triangles;
  for (uint32_t p = 0; p < head.geometries; ++p) {
    const auto g = from.next<mmverify_array_geometry_t>();
    b.parts.push_back({static_cast<Encoding>(g.index_type), g.base_triangle, {}});
    triangles.push_back(g.triangles);
  }
  for (uint32_t r = 0; r < head.records; ++r) b.array.records.push_back(from.next<micromap::Record>());
  for (uint32_t p = 0; p < head.geometries; ++p)
    b.parts[p].indices = from.bytes(triangles[p] * (micromap::width(b.parts[p].encoding) / 8));
  b.array.data = from.bytes(head.data_bytes);
  return b;
}
Bundle bundle_of(const uint8_t* array) {
  From from{array};
  return bundle_at(from);
}

/// Writes behind each other, and counts what there is no room for.
struct To {
  uint8_t* at;
  std::size_t capacity, size = 0;
  void put(const void* bytes, std::size_t count) {
    if (count > 0 && size + count <= capacity) std::memcpy(at + size, bytes, count);
    size += count;
  }
};

size_t put(const Bundle& b, uint8_t* array, size_t capacity) {
  To to{array, capacity};
  const mmverify_array_parts_t head{static_cast<uint32_t>(b.array.records.size()),
                                    static_cast<uint32_t>(b.array.data.size()),
                                    static_cast<uint32_t>(b.parts.size())};
  to.put(&head, sizeof head);
  for (const Part& p : b.parts) {
    const mmverify_array_geometry_t g{
        static_cast<uint32_t>(p.encoding), p.base,
        static_cast<uint32_t>(p.indices.size() / (micromap::width(p.encoding) / 8))};
    to.put(&g, sizeof g);
  }
  to.put(b.array.records.data(), b.array.records.size() * sizeof(micromap::Record));
  for (const Part& p : b.parts) to.put(p.indices.data(), p.indices.size());
  to.put(b.array.data.data(), b.array.data.size());
  return to.size;
}
size_t put(const Bytes& bytes, uint8_t* out, size_t capacity) {
  To to{out, capacity};
  to.put(bytes.data(), bytes.size());
  return to.size;
}

void resolve(uint32_t index_type, const uint32_t* code, const uint32_t* base, const uint32_t* records,
             uint32_t* out, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    const Target to = target(code[k], static_cast<Encoding>(index_type & ~cluster_bit),
                             (index_type & cluster_bit) != 0, base[k], records[k]);
    out[2 * k] = static_cast<uint32_t>(to.kind);
    out[2 * k + 1] = to.kind == Target::Kind::special  ? static_cast<uint32_t>(to.state)
                     : to.kind == Target::Kind::record ? static_cast<uint32_t>(to.record)
                                                       : 0;
  }
}
size_t compact(const uint8_t* array, size_t, uint8_t* changed, size_t capacity) {
  return put(compacted(bundle_of(array)), changed, capacity);
}
size_t reorder(const uint8_t* array, size_t, uint8_t* changed, size_t capacity) {
  return put(reordered(bundle_of(array)), changed, capacity);
}
size_t concatenate(const uint8_t* arrays, size_t, uint8_t* changed, size_t capacity) {
  From from{arrays};
  const Bundle first = bundle_at(from), second = bundle_at(from);
  return put(concatenated(first, second), changed, capacity);
}
size_t save(uint32_t version, const uint8_t* array, size_t, uint8_t* file, size_t capacity) {
  const Bundle b = bundle_of(array);
  if (version == 1 && (b.parts.size() != 1 || b.parts[0].encoding != Encoding::u32)) return 0;
  return put(written(b, version), file, capacity);
}
size_t load(const uint8_t* file, size_t size, uint8_t* array, size_t capacity) {
  return put(read({file, size}), array, capacity);
}
size_t emulate(uint32_t level, uint32_t most, const uint8_t* map, uint8_t* out, size_t capacity) {
  const std::size_t bytes = micromap::packed_bytes(micromap::micro_triangles(level), Format::four_state);
  return put(emulated({map, bytes}, level, most), out, capacity);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own arrays";
  subject.max_level = 12;
  subject.array_resolve = resolve;
  subject.array_compact = compact;
  subject.array_reorder = reorder;
  subject.array_concatenate = concatenate;
  subject.array_save = save;
  subject.array_load = load;
  subject.array_emulate = emulate;
  return &subject;
}
