#include "impl/attribute/bake.hpp"

#include <cmath>
#include <stdexcept>

#include "impl/attribute/bake/faces.hpp"
#include "impl/attribute/bake/frame.hpp"
#include "impl/attribute/bake/vertices.hpp"

namespace mmverify::impl::attribute {

namespace detail {

void check(const BaseTriangle& uv, std::uint32_t level, std::size_t room, std::size_t count) {
  if (room != count) throw std::invalid_argument("attribute: room for another number of values");
  if (level > max_attribute_level) throw std::invalid_argument("attribute: a level above 12");
  for (const TexturePoint& p : uv) {
    if (!std::isfinite(p.u) || !std::isfinite(p.v))
      throw std::invalid_argument("attribute: a texture coordinate that is not finite");
    if (std::fabs(p.u) >= 0x1p20f || std::fabs(p.v) >= 0x1p20f)
      throw std::invalid_argument("attribute: a texture coordinate of 2^20 or more");
  }
}

}  // namespace detail

template <class Channel>
AttributeBakerOf<Channel>::AttributeBakerOf(const RgbaViewOf<Channel>& texture,
                                            const AttributeSamplingOf<Channel>& sampling)
    : source_(std::make_unique<const detail::Source<Channel>>(texture, sampling)) {}
template <class Channel>
AttributeBakerOf<Channel>::~AttributeBakerOf() = default;
template <class Channel>
AttributeBakerOf<Channel>::AttributeBakerOf(AttributeBakerOf&&) noexcept = default;
template <class Channel>
AttributeBakerOf<Channel>& AttributeBakerOf<Channel>::operator=(AttributeBakerOf&&) noexcept = default;

template <class Channel>
AttributeCounts AttributeBakerOf<Channel>::faces(const BaseTriangle& uv, std::uint32_t level,
                                                 std::span<RgbaOf<Channel>> out) const {
  detail::check(uv, level, out.size(), level > max_attribute_level ? 0 : std::size_t{1} << 2 * level);
  return detail::bake_faces(*source_, uv, level, out);
}

template <class Channel>
AttributeCounts AttributeBakerOf<Channel>::vertices(const BaseTriangle& uv, std::uint32_t level,
                                                    std::span<RgbaOf<Channel>> out) const {
  const std::size_t side = level > max_attribute_level ? 0 : std::size_t{1} << level;
  detail::check(uv, level, out.size(), (side + 1) * (side + 2) / 2);
  return detail::bake_vertices(*source_, uv, level, out);
}

template class AttributeBakerOf<std::uint8_t>;
template class AttributeBakerOf<std::uint16_t>;
template class AttributeBakerOf<float>;

}  // namespace mmverify::impl::attribute
