// Inputs of micromap builds: valid arrays, and arrays that break a rule, with the codes of the violations.
#include <functional>
#include <optional>
#include <utility>

#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/micromap/validate.hpp"

namespace mmverify::vectors::arrays {
namespace {

using namespace spec::micromap;
using Counts = std::vector<UsageCount>;

/// An array and a geometry; owns the memory that an Input points into.
struct Build {
  Sets sets = all_sets;
  Limits limits = {};
  bool lossy = false;
  std::vector<Record> records = {};
  Bytes record_bytes = {};
  std::uint64_t record_count = 0, record_stride = 8, records_address = 512;
  Bytes data = {};
  std::uint64_t data_address = 256;
  std::optional<Counts> counts = {};
  std::uint64_t triangles = 0;
  bool indexed = true;
  Bytes indices = {};
  Encoding encoding = Encoding::u16;
  std::uint64_t index_stride = 2, indices_address = 64;
  std::uint32_t base = 0;
  std::optional<Counts> geometry_counts = {};

  void set_records(std::vector<Record> all, std::uint64_t stride = 8) {
    records = std::move(all);
    record_count = records.size();
    record_stride = stride;
    const Bytes tight = record_buffer(records);
    record_bytes.assign(stride * records.size(), 0);
    for (std::size_t r = 0; r < records.size(); ++r)
      for (std::size_t k = 0; k < 8; ++k) record_bytes[r * stride + k] = tight[8 * r + k];
  }
  void set_indices(const std::vector<std::uint32_t>& codes, Encoding e, std::uint64_t stride) {
    encoding = e;
    index_stride = stride;
    triangles = codes.size();
    indices.assign(stride * codes.size(), 0);
    for (std::size_t t = 0; t < codes.size(); ++t)
      for (std::size_t k = 0; k < width(e) / 8; ++k)
        indices[t * stride + k] = static_cast<std::uint8_t>(codes[t] >> 8 * k);
  }
  void count_all() {
    counts = usage_counts(array_histogram(records));
    geometry_counts = usage_counts(geometry_histogram(records, indices, encoding, base));
  }
  Input input() const {
    Input in;
    in.sets = sets;
    in.limits = limits;
    in.lossy = lossy;
    in.records = record_bytes;
    in.record_count = record_count;
    in.record_stride = record_stride;
    in.records_address = records_address;
    in.data = data;
    in.data_address = data_address;
    if (counts) in.array_counts = *counts;
    in.triangles = triangles;
    in.indexed = indexed;
    in.indices = indices;
    in.encoding = encoding;
    in.index_stride = index_stride;
    in.indices_address = indices_address;
    in.base_triangle = base;
    if (geometry_counts) in.geometry_counts = *geometry_counts;
    return in;
  }
};

/// The code of the special index for opaque, in the encoding's width.
std::uint32_t opaque(Encoding e) { return special_code(State::O, e); }

/// A valid build of three records, 4-state of levels 2 and 1 and 2-state of level 1; the triangles use
/// records 0, 1, 2, the special index for opaque, and 0 again.
Build good(Sets sets) {
  Build b;
  b.sets = sets;
  b.data = {0xe4, 0x1b, 0x00, 0xff, 0x05, 0xb1};
  b.set_records({{0, 2, 2}, {4, 1, 1}, {5, 1, 2}});
  b.set_indices({0, 1, 2, opaque(Encoding::u16), 0}, Encoding::u16, 2);
  b.count_all();
  return b;
}

/// The same build in 4-state alone, for a lossy build.
Build good_lossy() {
  Build b = good(KHR);
  b.lossy = true;
  b.set_records({{0, 2, 2}, {4, 1, 2}, {5, 1, 2}});
  b.count_all();
  return b;
}

std::vector<std::uint32_t> triples(const std::optional<Counts>& counts) {
  std::vector<std::uint32_t> all;
  if (counts)
    for (const UsageCount& c : *counts) all.insert(all.end(), {c.count, c.level, c.format});
  return all;
}

/// The limit as a column's value; none if every 32-bit number is within it.
Optional limit(std::uint64_t triangles) {
  return std::in_range<std::uint32_t>(triangles) ? Optional(static_cast<std::uint32_t>(triangles)) : none;
}

void add(Builder& out, const std::string& about, const Build& b) {
  std::uint64_t codes = 0;
  for (const Violation& v : validate(b.input())) codes |= std::uint64_t{1} << static_cast<unsigned>(v.rule);
  out.add({about,
           std::uint64_t{b.sets},
           b.lossy ? 1u : 0u,
           b.limits.two_state_level,
           b.limits.four_state_level,
           b.limits.lossy_four_state_level,
           limit(b.limits.triangles),
           b.record_bytes,
           static_cast<std::uint32_t>(b.record_count),
           b.record_stride,
           b.records_address,
           b.data,
           b.data_address,
           b.counts ? 1u : 0u,
           triples(b.counts),
           static_cast<std::uint32_t>(b.triangles),
           b.indexed ? 1u : 0u,
           b.indices,
           static_cast<std::uint32_t>(b.encoding),
           b.index_stride,
           b.indices_address,
           b.base,
           b.geometry_counts ? 1u : 0u,
           triples(b.geometry_counts),
           codes});
}

void add_good(Builder& out) {
  for (const Sets sets : {EXT, KHR, DXR, glTF, all_sets}) add(out, "well", good(sets));
  add(out, "well: a lossy build of 4-state records", good_lossy());
  const auto changed = [&](const char* about, Sets sets, auto change) {
    Build b = good(sets);
    change(b);
    add(out, about, b);
  };
  changed("well: counts of one level and format add up", all_sets, [](Build& b) {
    b.counts->push_back({1, 1, 2});
    b.set_records({{0, 2, 2}, {4, 1, 1}, {5, 1, 2}, {6, 1, 2}});
    b.data.push_back(0x33);
  });
  changed("well: the base is added to plain indices alone", all_sets, [](Build& b) {
    b.base = 1;
    b.set_indices({0, 1, 1, opaque(Encoding::u16)}, Encoding::u16, 2);
    b.count_all();
  });
  changed("well: no index buffer, triangle t has index t", all_sets, [](Build& b) {
    b.indexed = false;
    b.indices.clear();
    b.triangles = 3;
    b.geometry_counts = b.counts;
  });
  changed("well: special indices alone, and no geometry counts", all_sets, [](Build& b) {
    b.set_indices({0xffff, 0xfffe, 0xfffd, 0xfffc}, Encoding::u16, 2);
    b.count_all();
  });
  changed("well: bits after the last state are set", all_sets, [](Build& b) { b.data[4] = 0xf5; });
  changed("well: records 16 bytes apart", EXT | KHR | DXR, [](Build& b) { b.set_records(b.records, 16); });
  changed("well: u32 indices 8 bytes apart", EXT | KHR | DXR, [](Build& b) {
    b.set_indices({0, 1, 2, opaque(Encoding::u32), 0}, Encoding::u32, 8);
  });
  changed("well: u8 indices", KHR | DXR | glTF, [](Build& b) {
    b.set_indices({0, 1, 2, opaque(Encoding::u8), 0}, Encoding::u8, 1);
  });
  for (const Encoding e : {Encoding::i16, Encoding::i32})
    changed("well: signed indices", glTF, [e](Build& b) {
      b.set_indices({0, 1, 2, opaque(e), 0}, e, width(e) / 8);
    });
  changed("well: the buffer of records is longer than they", EXT | KHR | DXR,
          [](Build& b) { b.record_bytes.resize(b.record_bytes.size() + 5); });
  changed("well: no counts handed over", all_sets,
          [](Build& b) { b.counts = b.geometry_counts = std::nullopt; });
  changed("well: an array without a geometry", all_sets, [](Build& b) {
    b.triangles = 0;
    b.indexed = false;
    b.indices.clear();
    b.geometry_counts.reset();
  });
}

/// One way to break a rule of a valid build.
struct Breach {
  Rule rule;
  std::function<void(Build&)> change;
  std::string more = {};  ///< names the way if a rule is broken in several ways
};

void set_tight(Build& b, const std::vector<std::uint32_t>& codes, Encoding e) {
  b.set_indices(codes, e, width(e) / 8);
}

const std::vector<Breach> breaches{
    {Rule::align_data_256, [](Build& b) { b.data_address = 128; }},
    {Rule::align_records_256, [](Build& b) { b.records_address = 128; }},
    {Rule::align_data_128, [](Build& b) { b.data_address = 64; }},
    {Rule::align_records_128, [](Build& b) { b.records_address = 64; }},
    {Rule::align_records_4, [](Build& b) { b.records_address = 2; }},
    {Rule::align_index, [](Build& b) { b.indices_address = 1; }},
    {Rule::stride_least, [](Build& b) { b.record_stride = 4; }},
    {Rule::stride_multiple, [](Build& b) { b.set_records(b.records, 10); }},
    {Rule::stride_tight, [](Build& b) { b.set_records(b.records, 12); }},
    {Rule::records_size, [](Build& b) { ++b.record_count; }},
    {Rule::records_whole, [](Build& b) { b.record_bytes.resize(b.record_bytes.size() + 3); }},
    {Rule::record_format,
     [](Build& b) {
       b.set_records({{0, 2, 2}, {4, 1, 3}, {5, 1, 2}});
     }},
    {Rule::record_format,
     [](Build& b) {
       b.set_records({{0, 2, 2}, {4, 1, 0}, {5, 1, 2}});
     },
     "0"},
    {Rule::record_level, [](Build& b) { b.limits.four_state_level = 1; }},
    {Rule::record_level, [](Build& b) { b.limits.two_state_level = 0; }, "2-state"},
    {Rule::record_level_lossy, [](Build& b) { b = good_lossy(), b.limits.lossy_four_state_level = 1; }},
    {Rule::record_level_12,
     [](Build& b) {
       b.set_records({{0, 13, 2}, {4, 1, 1}, {5, 1, 2}});
     }},
    {Rule::record_lossy_format, [](Build& b) { b.lossy = true; }},
    {Rule::record_region, [](Build& b) { b.data.pop_back(); }},
    {Rule::record_region,
     [](Build& b) {
       b.set_records({{0, 2, 2}, {0xffffffff, 1, 1}, {5, 1, 2}});
     },
     "offset 2^32 - 1"},
    {Rule::record_region,
     [](Build& b) {
       b.set_records({{0, 65535, 2}, {4, 1, 1}, {5, 1, 2}});
     },
     "level 65535"},
    {Rule::record_overlap,
     [](Build& b) {
       b.set_records({{0, 2, 2}, {3, 1, 1}, {5, 1, 2}});
     }},
    {Rule::record_overlap,
     [](Build& b) {
       b.set_records({{0, 2, 2}, {4, 1, 1}, {0, 1, 2}});
     },
     "the same begin"},
    {Rule::counts_format,
     [](Build& b) {
       b.counts->push_back({1, 1, 3});
     }},
    {Rule::counts_format,
     [](Build& b) {
       b.geometry_counts->push_back({1, 1, 0});
     },
     "the geometry's"},
    {Rule::counts_level,
     [](Build& b) {
       b.counts->push_back({1, 13, 2});
     }},
    {Rule::counts_level_lossy,
     [](Build& b) {
       b = good_lossy(), b.limits.lossy_four_state_level = 2, b.counts->push_back({1, 3, 2});
     }},
    {Rule::counts_level_12,
     [](Build& b) {
       b.counts->push_back({1, 13, 2});
     }},
    {Rule::counts_lossy_format,
     [](Build& b) {
       b = good_lossy(), b.counts->push_back({1, 1, 1});
     }},
    {Rule::counts_zero,
     [](Build& b) {
       b.counts->push_back({0, 3, 1});
     }},
    {Rule::counts_limit, [](Build& b) { b.limits.triangles = 2; }},
    {Rule::counts_array, [](Build& b) { ++b.counts->front().count; }},
    {Rule::counts_array, [](Build& b) { b.counts->pop_back(); }, "one left out"},
    {Rule::counts_array_is_geometry, [](Build& b) { b.counts = b.geometry_counts; }},
    {Rule::counts_geometry, [](Build& b) { ++b.geometry_counts->front().count; }},
    {Rule::counts_geometry,
     [](Build& b) {
       b.geometry_counts->front().count += 1, b.geometry_counts->push_back({1, 0, 2});
     },
     "special ones counted"},
    {Rule::counts_geometry_is_array, [](Build& b) { b.geometry_counts = b.counts; }},
    {Rule::index_encoding,
     [](Build& b) {
       set_tight(b, {0, 1, 2}, Encoding::i16);
     }},
    {Rule::index_encoding,
     [](Build& b) {
       b.sets = EXT, set_tight(b, {0, 1, 2}, Encoding::u8);
     },
     "u8 of EXT"},
    {Rule::index_stride,
     [](Build& b) {
       b.set_indices({0, 1, 2, 0xfffe, 0}, Encoding::u16, 3);
     }},
    {Rule::index_stride_most, [](Build& b) { b.index_stride = std::uint64_t{1} << 32; }},
    {Rule::index_tight,
     [](Build& b) {
       b.set_indices({0, 1, 2, 0xfffe, 0}, Encoding::u16, 4);
     }},
    {Rule::index_size, [](Build& b) { b.indices.pop_back(); }},
    {Rule::index_size, [](Build& b) { b.indices.clear(); }, "none"},
    {Rule::index_count, [](Build& b) { b.indices.resize(b.indices.size() + 2); }},
    {Rule::index_special,
     [](Build& b) {
       set_tight(b, {0, 1, 2, 0xfffb, 0}, Encoding::i16);
     }},
    {Rule::index_range,
     [](Build& b) {
       set_tight(b, {0, 1, 2, 3, 0}, Encoding::u16);
     },
     "one too many"},
    {Rule::index_range,
     [](Build& b) {
       set_tight(b, {0, 1, 2, 0xfffb, 0}, Encoding::u16);
     },
     "-5 without a sign"},
    {Rule::index_range, [](Build& b) { b.base = 1; }, "by the base"},
    {Rule::index_range, [](Build& b) { b.base = 0xffffffff; }, "a base that would wrap"},
    {Rule::index_range, [](Build& b) { b.indexed = false, b.triangles = 4, b.indices.clear(); },
     "no index buffer"},
};

void add_broken(Builder& out) {
  for (const Breach& breach : breaches) {
    Build b = good(text(breach.rule).sets);
    breach.change(b);
    add(out, std::string(text(breach.rule).id) + (breach.more.empty() ? "" : ": " + breach.more), b);
  }
}

std::vector<std::string> codes() {
  std::vector<std::string> all;
  for (const RuleText& rule : rules) all.emplace_back(rule.id);
  return all;
}

}  // namespace

Family family() {
  Builder out("arrays", 2, "what builds take: arrays that are well or not, and the codes of docs/ISSUES.md");
  out.table("builds",
            "An array and a geometry that refers to it; members are those of docs/array.schema.json.",
            {{"about", Kind::about, "why the vector is there: the code that it is for"},
             {"apis", Kind::set, "whose rules are asked", {"ext", "khr", "dxr", "gltf"}},
             {"lossy", Kind::number, "1: a lossy build, KHR"},
             {"limit_two", Kind::number, "the device's highest level of 2-state maps"},
             {"limit_four", Kind::number, "of 4-state maps"},
             {"limit_lossy", Kind::number, "of 4-state maps in lossy builds"},
             {"limit_maps", Kind::optional, "maxMicromapTriangles; none: no limit"},
             {"records", Kind::bytes, "the buffer: u32 offset, u16 level, u16 format each"},
             {"record_count", Kind::number, "records that there should be"},
             {"record_stride", Kind::wide, "bytes from one to the next"},
             {"records_address", Kind::wide, "of the buffer on the device"},
             {"data", Kind::bytes, "the packed maps"},
             {"data_address", Kind::wide, "of the buffer on the device"},
             {"counted", Kind::number, "1 where the array's usage counts are handed over"},
             {"counts", Kind::words, "count, level, format of each"},
             {"triangles", Kind::number, "of the geometry; 0: there is none"},
             {"indexed", Kind::number, "1: by the buffer; 0: triangle t has index t"},
             {"indices", Kind::bytes, "the buffer"},
             {"encoding", Kind::name, "of an index", {"u8", "u16", "u32", "i16", "i32"}},
             {"index_stride", Kind::wide, "bytes from one to the next"},
             {"indices_address", Kind::wide, "of the buffer on the device"},
             {"base", Kind::number, "baseTriangle"},
             {"geometry_counted", Kind::number, "1 where the geometry's usage counts are handed over"},
             {"geometry_counts", Kind::words, "count, level, format of each; EXT"},
             {"codes", Kind::set, "of all that is wrong; none: it is well", codes()}});
  add_good(out);
  add_broken(out);
  Build b = good(EXT);
  b.limits.triangles = 0xffffffff;
  add(out, "well: the greatest limit of maps, which is not none", b);
  return out.take();
}

}  // namespace mmverify::vectors::arrays
