// Arrays of micromaps: two validators on arbitrary fields, builders on maps from the bytes, and a breach
// planted in the built array.
//
// Input: a byte.  If it is even, a Reader's numbers are the fields of an Input, and its bytes the buffers; if
// odd, they are maps and options to build, then the breach and its place.  Missing bytes are zeros.
//
// Covers: impl/micromap/append.* impl/micromap/array.* impl/micromap/histogram.hpp impl/micromap/rules.hpp impl/micromap/validate.*
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "fuzz/micromap_both.hpp"
#include "impl/micromap/append.hpp"

namespace {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;
using mmverify::fuzz::micromap::to_slow;
using mmverify::fuzz::micromap::validate_fast;
using slow::Bytes;
using slow::Rule;

class Reader {
 public:
  Reader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  /// One byte for a small number; 255 announces eight bytes with any number.
  std::uint64_t number() {
    const std::uint8_t first = byte();
    if (first != 255) return first;
    std::uint64_t value = 0;
    for (unsigned k = 0; k < 8; ++k) value |= std::uint64_t{byte()} << 8 * k;
    return value;
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(number()); }
  Bytes bytes(std::size_t count) {
    Bytes out;
    while (out.size() < count && left_ > 0) out.push_back(byte());
    return out;
  }
  bool empty() const { return left_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "micromap_array: %s\n", what.c_str());
  std::abort();
}

std::string described(const slow::Violation& v) {
  return fast::describe(
      {static_cast<fast::Rule>(v.rule), static_cast<fast::Place>(v.place), v.where, v.found, v.other});
}

std::string text(const std::vector<slow::Violation>& found) {
  std::string lines;
  for (const slow::Violation& v : found) lines += "\n  " + described(v);
  return lines.empty() ? "\n  nothing" : lines;
}

// Checks that both validators list the same violations, and returns them.
std::vector<slow::Violation> validated(const slow::Input& in) {
  const auto expected = slow::validate(in), got = to_slow(validate_fast(in));
  if (got != expected) fail("the specification lists" + text(expected) + "\nand impl" + text(got));
  for (const slow::Violation& v : got) {
    const std::string line = described(v);
    if (!line.starts_with(slow::text(v.rule).id) || line.ends_with(": ") ||
        line.find('\n') != std::string::npos)
      fail("a violation is described as " + line);
  }
  return expected;
}

std::vector<slow::UsageCount> counts(Reader& reader) {
  std::vector<slow::UsageCount> out;
  for (unsigned left = reader.byte() % 8; left > 0; --left) {
    const std::uint32_t count = reader.word(), level = reader.word(), format = reader.word();
    out.push_back({count, level, format});
  }
  return out;
}

void raw(Reader& reader) {
  slow::Input in;
  in.sets = reader.byte() % 16;
  const std::uint8_t flags = reader.byte();
  in.lossy = (flags & 1) != 0;
  in.indexed = (flags & 2) != 0;
  in.encoding = slow::encodings[reader.byte() % 5];
  if ((flags & 4) != 0) in.limits = {reader.word(), reader.word(), reader.word(), reader.number()};
  in.record_count = reader.number();
  in.record_stride = reader.number();
  in.triangles = reader.number();
  in.index_stride = reader.number();
  in.base_triangle = reader.word();
  if ((flags & 8) != 0) {
    in.data_address = reader.number();
    in.records_address = reader.number();
    in.indices_address = reader.number();
  }
  const auto array_counts = counts(reader), geometry_counts = counts(reader);
  if ((flags & 16) != 0) in.array_counts = array_counts;
  if ((flags & 32) != 0) in.geometry_counts = geometry_counts;
  const std::size_t data_bytes = reader.byte();
  const Bytes records = reader.bytes(reader.byte()), data = Bytes(data_bytes), indices = reader.bytes(255);
  in.records = records;
  in.data = data;
  in.indices = indices;
  validated(in);
}

struct BuiltArray {
  std::vector<slow::Map> maps;
  slow::Options options;
  slow::Array array;
  slow::Geometry geometry;
  Bytes records;
  std::vector<slow::UsageCount> array_counts;
};

// Builds the same maps twice; false if the encoding cannot represent an index.
bool build(Reader& reader, BuiltArray& b) {
  const std::uint8_t flags = reader.byte();
  b.options = {slow::encodings[reader.byte() % 5], 0, (flags & 1) != 0, (flags & 2) != 0};
  std::vector<Bytes> packed;
  for (unsigned left = reader.byte(); left > 0 && !reader.empty(); --left) {
    const std::uint8_t head = reader.byte();
    const mmverify::spec::Level level = head % 4;
    const slow::Format f = (head & 4) != 0 ? slow::Format::four_state : slow::Format::two_state;
    const std::uint64_t count = slow::micro_triangles(level);
    Bytes bytes =
        (head & 8) != 0 ? Bytes{} : reader.bytes(static_cast<std::size_t>(slow::packed_bytes(count, f)));
    bytes.resize(static_cast<std::size_t>(slow::packed_bytes(count, f)), (head & 8) != 0 ? reader.byte() : 0);
    b.maps.push_back({level, f, slow::unpack(bytes, f, count)});
    packed.push_back(bytes);  // its padding as given
  }
  std::vector<fast::PackedMap> views;
  for (std::size_t t = 0; t < packed.size(); ++t)
    views.push_back({b.maps[t].level, static_cast<fast::Format>(b.maps[t].format), packed[t]});
  fast::Array array;
  std::optional<fast::Geometry> geometry;
  const fast::Options options{static_cast<fast::Encoding>(b.options.encoding), 0, b.options.deduplicate,
                              b.options.special};
  try {
    geometry = fast::append(array, views, options);
  } catch (const std::length_error&) {
  }
  try {
    b.geometry = slow::append(b.array, b.maps, b.options);
  } catch (const std::length_error&) {
    if (geometry) fail("impl builds what the encoding cannot hold");
    return false;
  }
  b.records = slow::record_buffer(b.array.records);
  b.array_counts = slow::usage_counts(slow::array_histogram(b.array.records));
  const auto same = [](const std::vector<fast::UsageCount>& x, const std::vector<slow::UsageCount>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& p, const auto& q) {
      return p.count == q.count && p.level == q.level && p.format == q.format;
    });
  };
  if (!geometry || geometry->indices != b.geometry.indices || !same(geometry->counts, b.geometry.counts) ||
      array.data != b.array.data || fast::record_buffer(array.records) != b.records ||
      !same(fast::usage_counts(array.records), b.array_counts))
    fail("impl builds another array");
  return true;
}

slow::Input handed(const BuiltArray& b) {
  slow::Input in;
  in.sets = slow::glTF;
  in.records = b.records;
  in.record_count = b.array.records.size();
  in.data = b.array.data;
  in.array_counts = b.array_counts;
  in.triangles = b.maps.size();
  in.indexed = true;
  in.indices = b.geometry.indices;
  in.encoding = b.options.encoding;
  in.index_stride = slow::width(in.encoding) / 8;
  in.geometry_counts = b.geometry.counts;
  return in;
}

// Breaks a rule of one record, of which there is one at least; none if that takes two records.
std::optional<Rule> plant_in_record(BuiltArray& b, slow::Input& in, unsigned kind, std::size_t r) {
  std::vector<slow::Record>& records = b.array.records;
  slow::Record record = records[r];
  Rule rule = Rule::record_region;
  switch (kind) {
    case 0: record.offset += static_cast<std::uint32_t>(b.array.data.size()); break;
    case 1:
      if (records.size() < 2) return std::nullopt;
      record.offset = records[(r + 1) % records.size()].offset;
      rule = Rule::record_overlap;
      break;
    case 2:
      record.format = 3;
      rule = Rule::record_format;
      break;
    default: record.level = 13; rule = Rule::record_level_12;
  }
  records[r] = record;
  b.records = slow::record_buffer(records);
  in.records = b.records;
  return rule;
}

void set_index(BuiltArray& b, slow::Input& in, std::size_t t, std::uint32_t code) {
  const std::size_t size = slow::width(in.encoding) / 8;
  for (std::size_t j = 0; j < size; ++j)
    b.geometry.indices[t * size + j] = static_cast<std::uint8_t>(code >> 8 * j);
  in.indices = b.geometry.indices;
}

// Breaks one rule, if that is possible, and returns the rule.
std::optional<Rule> plant(BuiltArray& b, slow::Input& in, std::uint8_t breach, std::uint8_t where) {
  const std::size_t records = b.array.records.size(), maps = b.maps.size();
  switch (const unsigned kind = breach % 12) {
    case 0:
    case 1:
    case 2:
    case 3: return records == 0 ? std::nullopt : plant_in_record(b, in, kind, where % records);
    case 4:
      if (b.array_counts.empty()) return std::nullopt;
      ++b.array_counts[where % b.array_counts.size()].count;
      in.array_counts = b.array_counts;
      return Rule::counts_array;
    case 5:
      if (maps == 0 || records >= slow::index_limit(in.encoding)) return std::nullopt;
      set_index(b, in, where % maps, static_cast<std::uint32_t>(records));
      return Rule::index_range;
    case 6:
      if (maps == 0 || !slow::is_signed(in.encoding)) return std::nullopt;
      set_index(b, in, where % maps, 0xfffffffb);
      return Rule::index_special;
    case 7: in.record_stride = where % 8; return Rule::stride_least;
    case 8:
      if (records == 0) return std::nullopt;
      b.array.data.pop_back();
      in.data = b.array.data;
      return Rule::record_region;
    case 9:
      in.sets = slow::KHR;
      in.lossy = true;
      return records != 0 && b.array.records[where % records].format == 1
                 ? std::optional(Rule::record_lossy_format)
                 : std::nullopt;
    case 10:
      if (b.geometry.counts.empty()) return std::nullopt;
      in.sets = slow::EXT;
      ++b.geometry.counts[where % b.geometry.counts.size()].count;
      in.geometry_counts = b.geometry.counts;
      return Rule::counts_geometry;
    default: ++in.record_count; return Rule::records_size;
  }
}

void built(Reader& reader) {
  const std::uint8_t breach = reader.byte(), where = reader.byte();
  BuiltArray b;
  if (!build(reader, b)) return;
  slow::Input in = handed(b);
  for (const slow::Sets sets : {slow::glTF, slow::KHR, slow::DXR, slow::EXT}) {
    in.sets = sets;
    for (const slow::Violation& v : validated(in))
      if (v.rule != Rule::index_encoding) fail("what was built is not clean:" + text({v}));
  }
  // Two states of each map are fetched, since fetching walks all states before them.
  for (std::size_t t = 0; t < b.maps.size(); ++t)
    for (const std::size_t i : {where % b.maps[t].states.size(), b.maps[t].states.size() - 1})
      if (slow::fetch(b.array, b.geometry, b.options.encoding, 0, t, i) != b.maps[t].states[i])
        fail("a state is not given back");

  in.sets = slow::glTF;
  const std::optional<Rule> rule = plant(b, in, breach, where);
  const auto found = validated(in);
  if (rule && std::none_of(found.begin(), found.end(), [&](const auto& v) { return v.rule == *rule; }))
    fail(std::string("a breach of ") + slow::text(*rule).id + " is not listed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Reader reader(data, size);
  if (reader.byte() % 2 == 0)
    raw(reader);
  else
    built(reader);
  return 0;
}
