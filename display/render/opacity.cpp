#include "display/render/opacity.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "impl/index/index.hpp"
#include "impl/tree/tree.hpp"

namespace mmverify::render {
namespace {

using impl::micromap::Encoding;
using impl::micromap::Format;
using impl::micromap::Record;
using impl::micromap::State;
namespace micromap = impl::micromap;

constexpr std::array<std::string_view, 8> names{"texture", "special", "flat", "tree",
                                                "ranked",  "vq2",     "vq4",  "bitmask"};

/// The packed bytes of a record's map.
std::span<const std::uint8_t> map_of(const micromap::Array& array, const Record& record) {
  const auto size =
      micromap::packed_bytes(micromap::micro_triangles(record.level), static_cast<Format>(record.format));
  return std::span(array.data).subspan(record.offset, static_cast<std::size_t>(size));
}

/// The base of all forms of an array.  It answers special indices itself, and leaves records to the derived
/// class.
class OfArray : public Opacity {
 public:
  explicit OfArray(const Micromaps& micromaps) : micromaps_(micromaps) {
    for (const auto& codes : micromaps.codes) index_bytes_ += codes.size() * micromaps.index_bytes;
  }

  std::optional<State> at(std::uint32_t geometry, std::uint32_t triangle, const Barycentrics& b) const final {
    const auto& codes = micromaps_.codes[geometry];
    if (codes.empty()) return std::nullopt;
    const std::uint32_t code = codes[triangle];
    if (const auto special = micromap::special_state(code, Encoding::u32)) return special;
    return of_record(code, b);
  }

 protected:
  virtual std::optional<State> of_record(std::uint32_t number, const Barycentrics& b) const = 0;
  std::uint64_t records_and_indices() const {
    return micromap::record_bytes * micromaps_.array.records.size() + index_bytes_;
  }
  const micromap::Array& array() const { return micromaps_.array; }
  std::uint64_t index_bytes() const { return index_bytes_; }

 private:
  const Micromaps& micromaps_;
  std::uint64_t index_bytes_ = 0;
};

class Special final : public OfArray {
 public:
  using OfArray::OfArray;
  std::uint64_t bytes() const override { return index_bytes(); }

 protected:
  std::optional<State> of_record(std::uint32_t, const Barycentrics&) const override { return std::nullopt; }
};

class Flat final : public OfArray {
 public:
  using OfArray::OfArray;
  std::uint64_t bytes() const override { return array().data.size() + records_and_indices(); }

 protected:
  std::optional<State> of_record(std::uint32_t number, const Barycentrics& b) const override {
    const Record& record = array().records[number];
    const std::uint32_t index = impl::index::from_barycentrics(b.u, b.v, record.level);
    const std::uint8_t* const map = array().data.data() + record.offset;
    if (record.format == static_cast<std::uint16_t>(Format::two_state))
      return static_cast<State>(map[index / 8] >> (index % 8) & 1);
    return static_cast<State>(map[index / 4] >> (2 * (index % 4)) & 3);
  }
};

class Streams final : public OfArray {
 public:
  explicit Streams(const Micromaps& micromaps) : OfArray(micromaps) {
    for (const Record& record : array().records)
      streams_.push_back(impl::tree::encode_stream(record.level, static_cast<Format>(record.format),
                                                   map_of(array(), record)));
  }
  std::uint64_t bytes() const override {
    std::uint64_t sum = records_and_indices();
    for (const auto& stream : streams_) sum += stream.tree.size() + stream.data.size();
    return sum;
  }

 protected:
  std::optional<State> of_record(std::uint32_t number, const Barycentrics& b) const override {
    const Record& record = array().records[number];
    return static_cast<State>(
        impl::tree::lookup_stream(record.level, static_cast<Format>(record.format), streams_[number],
                                  impl::index::from_barycentrics(b.u, b.v, record.level)));
  }

 private:
  std::vector<impl::tree::Stream> streams_;
};

class Ranked final : public OfArray {
 public:
  explicit Ranked(const Micromaps& micromaps) : OfArray(micromaps) {
    for (const Record& record : array().records)
      trees_.push_back(impl::tree::Tree::encode(record.level, static_cast<Format>(record.format),
                                                map_of(array(), record)));
  }
  std::uint64_t bytes() const override {
    std::uint64_t sum = records_and_indices();
    for (const auto& tree : trees_) sum += (tree.bits() + 7) / 8;
    return sum;
  }

 protected:
  std::optional<State> of_record(std::uint32_t number, const Barycentrics& b) const override {
    return static_cast<State>(trees_[number].at(b.u, b.v));
  }

 private:
  std::vector<impl::tree::Tree> trees_;
};

/// T, O, or the one unknown state of square maps.
State state_of(impl::vq::State s) {
  return s == impl::vq::State::T ? State::T : s == impl::vq::State::O ? State::O : State::UT;
}

/// Square maps of N x N regions, N = 2^level, as blocks.  A map of one state has no block.
template <unsigned level, class Block>
class OfSquares final : public Opacity {
 public:
  template <class Maps, class Encode>
  OfSquares(const Squares& squares, const Maps& maps, Encode encode) : squares_(squares) {
    for (const auto& map : maps) {
      const bool uniform = std::all_of(map.begin(), map.end(), [&](auto s) { return s == map[0]; });
      uniform_.push_back(uniform ? std::optional(state_of(map[0])) : std::nullopt);
      block_of_.push_back(blocks_.size());
      if (!uniform) blocks_.push_back(encode(map));
    }
    for (const auto& places : squares.places) places_ += places.size();
  }

  std::optional<State> at(std::uint32_t geometry, std::uint32_t triangle,
                          const Barycentrics& b) const override {
    const auto& places = squares_.places[geometry];
    if (places.empty() || places[triangle].map == SquarePlace::none) return std::nullopt;
    const SquarePlace& place = places[triangle];
    if (uniform_[place.map]) return uniform_[place.map];
    // x and y are in the half's order of vertices; the upper half is turned by 180 degrees.
    const GridPlace x = grid_place(b, place.order[1], level), y = grid_place(b, place.order[2], level);
    constexpr std::uint32_t last = (1u << level) - 1;
    const bool upper = place.half == impl::vq::Half::upper;
    return state_of(impl::vq::region(blocks_[block_of_[place.map]], upper ? last - x.below : x.floor,
                                     upper ? last - y.below : y.floor));
  }
  /// The blocks, and a reference of 32 bits a triangle: map, half, order.
  std::uint64_t bytes() const override { return blocks_.size() * sizeof(Block) + 4 * places_; }

 private:
  const Squares& squares_;
  std::vector<std::optional<State>> uniform_;
  std::vector<std::size_t> block_of_;
  std::vector<Block> blocks_;
  std::uint64_t places_ = 0;
};

}  // namespace

std::string_view name_of(Method method) { return names[static_cast<std::size_t>(method)]; }

std::optional<Method> method_of(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Method>(found - names.begin());
}

bool has_levels(Method method) {
  return method != Method::texture && method != Method::vq2 && method != Method::vq4 &&
         method != Method::bitmask;
}

std::unique_ptr<Opacity> opacity_of(Method method, const Micromaps& micromaps) {
  switch (method) {
    case Method::special: return std::make_unique<Special>(micromaps);
    case Method::flat: return std::make_unique<Flat>(micromaps);
    case Method::tree: return std::make_unique<Streams>(micromaps);
    case Method::ranked: return std::make_unique<Ranked>(micromaps);
    case Method::texture:
    case Method::vq2:
    case Method::vq4:
    case Method::bitmask: break;
  }
  throw std::invalid_argument("opacity_of: no method of micromaps");
}

std::unique_ptr<Opacity> opacity_of(Method method, const Squares& squares) {
  if (method == Method::vq2)
    return std::make_unique<OfSquares<4, impl::vq::Block2>>(
        squares, squares.vq2, [](const impl::vq::Map2& map) { return impl::vq::encode_optimal(map).block; });
  if (method == Method::vq4)
    return std::make_unique<OfSquares<5, impl::vq::Block4>>(
        squares, squares.vq4, [](const impl::vq::Map4& map) { return impl::vq::encode(map).block; });
  throw std::invalid_argument("opacity_of: no method of square maps");
}

}  // namespace mmverify::render
