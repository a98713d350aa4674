// The span functions of impl/attribute/order.hpp, compiled once for each SIMD target and chosen at run time.
#include "impl/attribute/order.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/attribute/order.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "impl/attribute/order-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::attribute {
namespace HWY_NAMESPACE {

// Calls `run(inputs, outputs)`, which reads a vector from each input and writes one to each output.  The rest goes
// through buffers, since a vector must not touch memory beyond the spans.
template <std::size_t ins, std::size_t outs, class Run>
HWY_INLINE void each(const std::array<const std::uint32_t*, ins>& in,
                     const std::array<std::uint32_t*, outs>& out, std::size_t count, Run run) {
  const Words dw;
  const std::size_t lanes = hn::Lanes(dw);
  std::size_t k = 0;
  for (; count - k >= lanes; k += lanes) {
    std::array<const std::uint32_t*, ins> from = in;
    std::array<std::uint32_t*, outs> to = out;
    for (auto& p : from) p += k;
    for (auto& p : to) p += k;
    run(from, to);
  }
  if (k == count) return;
  const std::size_t bytes = (count - k) * sizeof(std::uint32_t);
  std::uint32_t in_left[ins][hn::MaxLanes(dw)] = {}, out_left[outs][hn::MaxLanes(dw)];
  std::array<const std::uint32_t*, ins> from;
  std::array<std::uint32_t*, outs> to;
  for (std::size_t a = 0; a < ins; ++a) {
    std::memcpy(in_left[a], in[a] + k, bytes);
    from[a] = in_left[a];
  }
  for (std::size_t a = 0; a < outs; ++a) to[a] = out_left[a];
  run(from, to);
  for (std::size_t a = 0; a < outs; ++a) std::memcpy(out[a] + k, out_left[a], bytes);
}

template <class Kernel>
void index_of_vertices(const std::uint32_t* i, const std::uint32_t* j, std::uint32_t* out, std::size_t count,
                       Level n) {
  const Words dw;
  const Kernel kernel(n);
  each<2, 1>({i, j}, {out}, count, [&](const auto& from, const auto& to) HWY_ATTR {
    hn::StoreU(kernel(hn::LoadU(dw, from[0]), hn::LoadU(dw, from[1])), dw, to[0]);
  });
}

template <class Kernel>
void vertices_of_index(const std::uint32_t* index, std::uint32_t* i, std::uint32_t* j, std::size_t count,
                       Level n) {
  const Words dw;
  const Kernel kernel(n);
  each<1, 2>({index}, {i, j}, count, [&](const auto& from, const auto& to) HWY_ATTR {
    const VertexVecs v = kernel(hn::LoadU(dw, from[0]));
    hn::StoreU(v.i, dw, to[0]);
    hn::StoreU(v.j, dw, to[1]);
  });
}

template <class Kernel>
void index_of_faces(const std::uint32_t* iu, const std::uint32_t* iv_, const std::uint32_t* upper,
                    std::uint32_t* out, std::size_t count, Level n) {
  const Words dw;
  const Kernel kernel(n);
  each<3, 1>({iu, iv_, upper}, {out}, count, [&](const auto& from, const auto& to) HWY_ATTR {
    hn::StoreU(kernel(hn::LoadU(dw, from[0]), hn::LoadU(dw, from[1]), hn::LoadU(dw, from[2])), dw, to[0]);
  });
}

template <class Kernel>
void faces_of_index(const std::uint32_t* index, std::uint32_t* iu, std::uint32_t* iv_, std::uint32_t* upper,
                    std::size_t count, Level n) {
  const Words dw;
  const Kernel kernel(n);
  each<1, 3>({index}, {iu, iv_, upper}, count, [&](const auto& from, const auto& to) HWY_ATTR {
    const FaceVecs t = kernel(hn::LoadU(dw, from[0]));
    hn::StoreU(t.iu, dw, to[0]);
    hn::StoreU(t.iv, dw, to[1]);
    hn::StoreU(t.upper, dw, to[2]);
  });
}

void run_vertex_index(VertexOrder order, const std::uint32_t* i, const std::uint32_t* j, std::uint32_t* out,
                      std::size_t count, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return index_of_vertices<WMinorIndex>(i, j, out, count, n);
    case VertexOrder::u_major: return index_of_vertices<UMajorIndex>(i, j, out, count, n);
    default: return index_of_vertices<BirdIndex>(i, j, out, count, n);
  }
}

void run_vertex_at(VertexOrder order, const std::uint32_t* index, std::uint32_t* i, std::uint32_t* j,
                   std::size_t count, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return vertices_of_index<WMinorVertex>(index, i, j, count, n);
    case VertexOrder::u_major: return vertices_of_index<UMajorVertex>(index, i, j, count, n);
    default: return vertices_of_index<BirdVertex>(index, i, j, count, n);
  }
}

void run_face_index(FaceOrder order, const std::uint32_t* iu, const std::uint32_t* iv_,
                    const std::uint32_t* upper, std::uint32_t* out, std::size_t count, Level n) {
  switch (order) {
    case FaceOrder::curve: return index_of_faces<CurveFaceIndex>(iu, iv_, upper, out, count, n);
    case FaceOrder::rows: return index_of_faces<RowFaceIndex>(iu, iv_, upper, out, count, n);
    default: return index_of_faces<UMajorFaceIndex>(iu, iv_, upper, out, count, n);
  }
}

void run_face_at(FaceOrder order, const std::uint32_t* index, std::uint32_t* iu, std::uint32_t* iv_,
                 std::uint32_t* upper, std::size_t count, Level n) {
  switch (order) {
    case FaceOrder::curve: return faces_of_index<CurveFace>(index, iu, iv_, upper, count, n);
    case FaceOrder::rows: return faces_of_index<RowFace>(index, iu, iv_, upper, count, n);
    default: return faces_of_index<UMajorFace>(index, iu, iv_, upper, count, n);
  }
}

// The corners of micro-triangles: (i, j), (i1, j), (i, j2), one step up from (iu, iv), or down from (iu+1, iv+1).
void run_corners(const std::uint32_t* iu, const std::uint32_t* iv_, const std::uint32_t* upper,
                 std::uint32_t* i0, std::uint32_t* j0, std::uint32_t* i1, std::uint32_t* j2,
                 std::size_t count) {
  const Words dw;
  each<3, 4>({iu, iv_, upper}, {i0, j0, i1, j2}, count, [&](const auto& from, const auto& to) HWY_ATTR {
    const auto up = hn::LoadU(dw, from[2]);
    const auto i = hn::Add(hn::LoadU(dw, from[0]), up), j = hn::Add(hn::LoadU(dw, from[1]), up);
    const auto step = hn::Sub(word(1), hn::Add(up, up));
    hn::StoreU(i, dw, to[0]);
    hn::StoreU(j, dw, to[1]);
    hn::StoreU(hn::Add(i, step), dw, to[2]);
    hn::StoreU(hn::Add(j, step), dw, to[3]);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::attribute
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::attribute {
namespace {

HWY_EXPORT(run_vertex_index);
HWY_EXPORT(run_vertex_at);
HWY_EXPORT(run_face_index);
HWY_EXPORT(run_face_at);
HWY_EXPORT(run_corners);

void require_one_length(const char* message, std::size_t length, std::initializer_list<std::size_t> others) {
  for (const std::size_t other : others)
    if (other != length) throw std::invalid_argument(message);
}

Level within(Level level) { return std::min(level, max_level); }

// Length of a piece: two-step conversions keep their middle values in the first-level cache.
constexpr std::size_t piece = 512;
using Piece = std::array<std::uint32_t, piece>;

/// Calls run(from, count) for each piece of `length` elements.
template <class Run>
void in_pieces(std::size_t length, Run run) {
  for (std::size_t from = 0; from < length; from += piece) run(from, std::min(piece, length - from));
}

}  // namespace

void vertex_index(VertexOrder order, std::span<const std::uint32_t> i, std::span<const std::uint32_t> j,
                  Level level, std::span<std::uint32_t> out) {
  require_one_length("attribute::vertex_index: i, j and out differ in length", out.size(),
                     {i.size(), j.size()});
  HWY_DYNAMIC_DISPATCH(run_vertex_index)(order, i.data(), j.data(), out.data(), out.size(), within(level));
}

void vertex_at(VertexOrder order, std::span<const std::uint32_t> index, Level level, const VertexSpans& out) {
  require_one_length("attribute::vertex_at: index and the spans of out differ in length", index.size(),
                     {out.i.size(), out.j.size()});
  HWY_DYNAMIC_DISPATCH(run_vertex_at)
  (order, index.data(), out.i.data(), out.j.data(), index.size(), within(level));
}

void convert(VertexOrder from, VertexOrder to, std::span<const std::uint32_t> index, Level level,
             std::span<std::uint32_t> out) {
  require_one_length("attribute::convert: index and out differ in length", index.size(), {out.size()});
  in_pieces(index.size(), [&](std::size_t first, std::size_t count) {
    Piece i, j;
    HWY_DYNAMIC_DISPATCH(run_vertex_at)(from, index.data() + first, i.data(), j.data(), count, within(level));
    HWY_DYNAMIC_DISPATCH(run_vertex_index)(to, i.data(), j.data(), out.data() + first, count, within(level));
  });
}

void face_index(FaceOrder order, std::span<const std::uint32_t> iu, std::span<const std::uint32_t> iv,
                std::span<const std::uint32_t> upper, Level level, std::span<std::uint32_t> out) {
  require_one_length("attribute::face_index: iu, iv, upper and out differ in length", out.size(),
                     {iu.size(), iv.size(), upper.size()});
  HWY_DYNAMIC_DISPATCH(run_face_index)
  (order, iu.data(), iv.data(), upper.data(), out.data(), out.size(), within(level));
}

void face_at(FaceOrder order, std::span<const std::uint32_t> index, Level level, const FaceSpans& out) {
  require_one_length("attribute::face_at: index and the spans of out differ in length", index.size(),
                     {out.iu.size(), out.iv.size(), out.upper.size()});
  HWY_DYNAMIC_DISPATCH(run_face_at)
  (order, index.data(), out.iu.data(), out.iv.data(), out.upper.data(), index.size(), within(level));
}

void convert(FaceOrder from, FaceOrder to, std::span<const std::uint32_t> index, Level level,
             std::span<std::uint32_t> out) {
  require_one_length("attribute::convert: index and out differ in length", index.size(), {out.size()});
  in_pieces(index.size(), [&](std::size_t first, std::size_t count) {
    Piece iu, iv, upper;
    HWY_DYNAMIC_DISPATCH(run_face_at)
    (from, index.data() + first, iu.data(), iv.data(), upper.data(), count, within(level));
    HWY_DYNAMIC_DISPATCH(run_face_index)
    (to, iu.data(), iv.data(), upper.data(), out.data() + first, count, within(level));
  });
}

void triplets(FaceOrder faces, VertexOrder vertices, std::span<const std::uint32_t> face, Level level,
              const TripletSpans& out) {
  require_one_length("attribute::triplets: face and the spans of out differ in length", face.size(),
                     {out.x0.size(), out.x1.size(), out.x2.size()});
  in_pieces(face.size(), [&](std::size_t first, std::size_t count) {
    Piece iu, iv, upper, i0, j0, i1, j2;
    HWY_DYNAMIC_DISPATCH(run_face_at)
    (faces, face.data() + first, iu.data(), iv.data(), upper.data(), count, within(level));
    HWY_DYNAMIC_DISPATCH(run_corners)
    (iu.data(), iv.data(), upper.data(), i0.data(), j0.data(), i1.data(), j2.data(), count);
    const auto index = [&](const Piece& i, const Piece& j, std::span<std::uint32_t> x) {
      HWY_DYNAMIC_DISPATCH(run_vertex_index)
      (vertices, i.data(), j.data(), x.data() + first, count, within(level));
    };
    index(i0, j0, out.x0);
    index(i1, j0, out.x1);
    index(i0, j2, out.x2);
  });
}

void faces_of(FaceOrder faces, VertexOrder vertices, std::span<const std::uint32_t> x0,
              std::span<const std::uint32_t> x1, Level level, std::span<std::uint32_t> out) {
  require_one_length("attribute::faces_of: x0, x1 and out differ in length", out.size(),
                     {x0.size(), x1.size()});
  in_pieces(out.size(), [&](std::size_t first, std::size_t count) {
    Piece i0, j0, i1, j1, upper;
    HWY_DYNAMIC_DISPATCH(run_vertex_at)
    (vertices, x0.data() + first, i0.data(), j0.data(), count, within(level));
    HWY_DYNAMIC_DISPATCH(run_vertex_at)
    (vertices, x1.data() + first, i1.data(), j1.data(), count, within(level));
    // The second corner of a lower micro-triangle lies to the right of the first, that of an upper one to the left.
    for (std::size_t k = 0; k < count; ++k) {
      upper[k] = i1[k] > i0[k] ? 0 : 1;
      i0[k] -= upper[k];
      j0[k] -= upper[k];
    }
    HWY_DYNAMIC_DISPATCH(run_face_index)
    (faces, i0.data(), j0.data(), upper.data(), out.data() + first, count, within(level));
  });
}

}  // namespace mmverify::impl::attribute
#endif  // HWY_ONCE
