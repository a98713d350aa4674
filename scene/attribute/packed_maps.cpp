#include "scene/attribute/packed_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "impl/attribute/compress.hpp"
#include "impl/attribute/order.hpp"
#include "scene/attribute/shared_maps.hpp"

namespace mmverify::scene {

MapPacker::MapPacker(MapKind kind, unsigned level, std::uint8_t channels, std::uint8_t error)
    : kind_(kind), level_(level), error_(error) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((channels >> c & 1) != 0) channels_.push_back(c);
  if (kind == MapKind::faces) return;
  rows_.resize(static_cast<std::size_t>(values_of_map(kind, level)));
  std::iota(rows_.begin(), rows_.end(), 0u);
  using impl::attribute::VertexOrder;
  impl::attribute::convert(VertexOrder::bird, VertexOrder::w_minor, rows_, level, rows_);
}

std::uint32_t MapPacker::add(std::span<const MapValue> map) {
  const std::size_t of_map = map.size() * channels_.size(), first = codes_.size();
  for (std::size_t x = 0; x < map.size(); ++x)
    for (const std::size_t c : channels_) codes_.push_back(map[kind_ == MapKind::faces ? x : rows_[x]][c]);
  const std::uint64_t hash = key_of(map).hash;
  const auto same = numbers_.equal_range(hash);
  for (auto it = same.first; it != same.second; ++it)
    if (std::equal(codes_.begin() + static_cast<std::ptrdiff_t>(first), codes_.end(),
                   codes_.begin() + static_cast<std::ptrdiff_t>(std::size_t{it->second} * of_map))) {
      codes_.resize(first);
      return it->second;
    }
  numbers_.emplace(hash, maps_);
  return maps_++;
}

void MapPacker::measure_decoded(std::span<const std::uint8_t> decoded, PackedBytes& bytes) const {
  std::uint64_t squares = 0;
  for (std::size_t k = 0; k < codes_.size(); ++k) {
    const int off = std::abs(decoded[k] - codes_[k]);
    bytes.worst_error = std::max(bytes.worst_error, static_cast<std::uint8_t>(off));
    squares += static_cast<std::uint64_t>(off) * static_cast<std::uint64_t>(off);
  }
  if (!codes_.empty())
    bytes.rms_error = std::sqrt(static_cast<double>(squares) / static_cast<double>(codes_.size()));
}

std::optional<PackedBytes> MapPacker::packed(const PeerCoder& peer) const {
  if (codes_.size() >> 31 != 0) return std::nullopt;
  impl::attribute::PackedShape shape;
  shape.at = kind_ == MapKind::faces ? impl::attribute::MapAt::faces : impl::attribute::MapAt::vertices;
  shape.level = level_;
  shape.channels = static_cast<std::uint32_t>(channels_.size());
  shape.maps = maps_;
  for (std::size_t c = 0; c < channels_.size(); ++c) shape.error[c] = error_;
  PackedBytes bytes;
  bytes.plain = codes_.size();
  const std::vector<std::uint8_t> packed = impl::attribute::pack(shape, codes_);
  bytes.packed = packed.size();
  measure_decoded(impl::attribute::PackedMaps(shape, packed).codes(), bytes);
  bytes.entropy = static_cast<std::uint64_t>(std::ceil(impl::attribute::residual_entropy(shape, codes_) / 8));
  if (peer) bytes.peer = peer(codes_);
  return bytes;
}

}  // namespace mmverify::scene
