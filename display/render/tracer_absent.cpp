// Takes the place of tracer.cpp if Embree is missing.
#include <stdexcept>

#include "display/render/tracer.hpp"

namespace mmverify::render {

bool has_embree() { return false; }
std::string embree_text() {
  return "built without Embree; install the Debian package libembree-dev (./run install) and build again";
}

struct Tracer::EmbreeScene {};
Tracer::Tracer(const World&) { throw std::runtime_error(embree_text()); }
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Frame Tracer::frame(const Camera&, const Opacity*, const TraceOptions&) const {
  throw std::runtime_error(embree_text());
}
Pixel Tracer::pixel(const Camera&, const Opacity*, const TraceOptions&, std::uint32_t, std::uint32_t) const {
  throw std::runtime_error(embree_text());
}
BlendFrame Tracer::blend_frame(const Camera&, const Opacity*, const Blending&, const TraceOptions&) const {
  throw std::runtime_error(embree_text());
}
BlendHits Tracer::blend_hits(const Camera&, const Opacity*, const Blending&, const TraceOptions&,
                             std::uint32_t, std::uint32_t) const {
  throw std::runtime_error(embree_text());
}
Counts Tracer::even_rays(const Opacity&, std::uint64_t, std::uint64_t, unsigned) const {
  throw std::runtime_error(embree_text());
}
Met Tracer::first_hit(const Ray&, const Opacity*, std::uint64_t, Counts&) const {
  throw std::runtime_error(embree_text());
}

}  // namespace mmverify::render
