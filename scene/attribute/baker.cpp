#include "scene/attribute/baker.hpp"

#include "scene/bake/wrap.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {
namespace {

impl::attribute::AttributeSampling sampling_of(const AttributeTexture& texture, Averaging averaging) {
  impl::attribute::AttributeSampling sampling;
  sampling.u = wrap_of(texture.sampler.wrap_u);
  sampling.v = wrap_of(texture.sampler.wrap_v);
  sampling.filter = filter_of(texture.sampler) == Filter::nearest ? impl::bake::Filter::nearest
                                                                  : impl::bake::Filter::bilinear;
  sampling.meaning = meaning_of(texture.set, averaging);
  return sampling;
}

}  // namespace

MapBaker::MapBaker(const ColourImage& image, const AttributeTexture& texture, Averaging averaging)
    : meaning_(texture.set, averaging),
      channels_(channels_of(texture.set)),
      baker_({image.rgba.data(), image.width, image.height, image.width}, sampling_of(texture, averaging)) {}

void MapBaker::bake(const UvTriangle& uvs, MapKind kind, unsigned level, std::span<MapValue> out) const {
  const impl::bake::BaseTriangle base{
      {{uvs[0][0], uvs[0][1]}, {uvs[1][0], uvs[1][1]}, {uvs[2][0], uvs[2][1]}}};
  if (kind == MapKind::faces)
    baker_.faces(base, level, out);
  else
    baker_.vertices(base, level, out);
  for (MapValue& value : out) {
    for (std::size_t c = 0; c < 3; ++c)
      if ((channels_ >> c & 1) == 0) value[c] = 0;
    value[3] = 0;
  }
}

}  // namespace mmverify::scene
