// Graphs: a container from raw bytes, and maps that are added.
//
// Input: a byte that names the form of the rest.
//   even  a container, also with its checksum corrected first, so that the reader reaches the bytes behind it: an
//         error with its place, or a graph that saves to the very same bytes; if the maps are of level 6 or less, the
//         specification must accept the same containers
//   odd   maps: bit 1 means four states; then for each map a byte of level (remainder by 7), and a byte with the share
//         of the rest that is its words, in 1/16; other words are zero.  The container must be the specification's, and
//         each state, alone and in a batch
//
// Covers: impl/dag/* impl/common/crc32c.hpp
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "impl/dag/container.hpp"
#include "impl/dag/dag.hpp"
#include "spec/dag/words.hpp"

namespace {

namespace dag = mmverify::impl::dag;
namespace spec = mmverify::spec;
using Bytes = std::vector<std::uint8_t>;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "dag_container: %s\n", what);
  std::abort();
}

bool quick_for_the_specification(const Bytes& bytes) {
  const std::size_t records =
      bytes[8] | std::size_t{bytes[9]} << 8 | std::size_t{bytes[10]} << 16 | std::size_t{bytes[11]} << 24;
  if (records > 8 || bytes.size() < spec::dag::header_bytes + 8 * records) return false;
  for (std::size_t k = 0; k < records; ++k)
    if (bytes[spec::dag::header_bytes + 8 * k] > 6 && bytes[spec::dag::header_bytes + 8 * k] <= 12)
      return false;
  return true;
}

void container(const Bytes& bytes) {
  bool taken = false;
  try {
    const dag::Dag graph = dag::load(bytes);
    require(dag::save(graph) == bytes, "a second container of the same maps");
    taken = true;
    for (std::uint32_t m = 0; m < graph.maps(); ++m)
      for (std::uint64_t k = 0; k < 4; ++k) graph.at(m, k * 0x9E3779B97F4A7C15u);
  } catch (const dag::BadContainer& bad) {
    require(bad.byte() <= bytes.size(), "the place named lies in the input");
  }
  if (bytes.size() >= spec::dag::header_bytes && quick_for_the_specification(bytes))
    require(spec::dag::from_container(bytes).has_value() == taken, "what the specification takes");
}

void maps(bool four_states, const std::uint8_t* data, std::size_t size) {
  const std::uint32_t b = four_states ? 2 : 1;
  const spec::dag::Format f = four_states ? spec::dag::Format::four_state : spec::dag::Format::two_state;
  dag::Dag graph{dag::Format{b}};
  spec::dag::Builder builder(f);
  std::vector<Bytes> all;
  while (size > 2 && all.size() < 6) {
    const dag::Level n = data[0] % 7;
    Bytes map(spec::micromap::packed_bytes(spec::micromap::micro_triangles(n), f));
    const std::size_t given = std::min({map.size(), size - 2, (size - 2) * (data[1] % 16 + 1) / 16});
    std::memcpy(map.data(), data + 2, given);
    data += 2 + given;
    size -= 2 + given;
    const spec::dag::States states = spec::micromap::unpack(map, f, spec::micromap::micro_triangles(n));
    require(graph.add(n, map) == all.size(), "maps are numbered in their order");
    builder.add(n, states);
    all.push_back(spec::micromap::pack(states, f));
  }
  const Bytes bytes = dag::save(graph);
  require(bytes == spec::dag::container(builder.dag()), "the specification's container");
  require(graph.bits() <= spec::dag::most_bits(builder.dag()), "no more than flat");
  const dag::Dag again = dag::load(bytes);
  for (std::uint32_t m = 0; m < all.size(); ++m) {
    Bytes decoded(all[m].size(), 0xFF);
    again.decode(m, decoded);
    require(decoded == all[m], "the map that was added");
    std::vector<std::uint32_t> index(std::size_t{1} << (2 * graph.level(m)));
    for (std::uint32_t k = 0; k < index.size(); ++k) index[k] = k;
    Bytes states(index.size(), 0xFF);
    graph.lookup(std::vector<std::uint32_t>(index.size(), m), index, states);
    for (std::uint32_t k = 0; k < index.size(); ++k) {
      require(states[k] == (all[m][k * b / 8] >> k * b % 8 & (b == 1 ? 1 : 3)), "the state at an index");
      require(again.at(m, k) == states[k], "the same alone");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] % 2 == 1) {
    maps((data[0] & 2) != 0, data + 1, size - 1);
    return 0;
  }
  Bytes bytes(data + 1, data + size);
  container(bytes);
  if (bytes.size() >= spec::dag::header_bytes) {
    const std::uint32_t crc = spec::dag::checksum(bytes);
    std::memcpy(bytes.data() + spec::dag::crc_at, &crc, sizeof crc);
    container(bytes);
  }
  return 0;
}
