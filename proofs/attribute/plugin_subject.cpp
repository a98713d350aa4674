#include <cstring>

#include "proofs/attribute/elements.hpp"
#include "proofs/attribute/subject_parts.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/dock/elements.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::attribute {
namespace {

using dock::Call;
using dock::LibraryPtr;
using Column = std::vector<std::uint32_t>;
using Numbers = std::span<const std::uint32_t>;

static_assert(static_cast<std::uint32_t>(VertexOrder::bird) == MMVERIFY_VERTICES_BIRD);
static_assert(static_cast<std::uint32_t>(FaceOrder::u_major) == MMVERIFY_FACES_U_MAJOR);
static_assert(static_cast<std::uint32_t>(Rounding::halves_up) == MMVERIFY_ROUND_HALVES_UP);

template <class Setting>
std::uint32_t format_of(Setting setting) {
  return static_cast<std::uint32_t>(setting);
}

/// Member `of` of each, in an array of its own.
template <class Element, class Member>
Column apart(std::span<const Element> at, Member Element::*of) {
  Column words;
  words.reserve(at.size());
  for (const Element& e : at) words.push_back(static_cast<std::uint32_t>(e.*of));
  return words;
}

/// Indices below `count`; in the place of others, which are asked of nobody, 0.
class IndicesInRange {
 public:
  IndicesInRange(Numbers index, std::uint64_t count) : count_(count), index_(index.begin(), index.end()) {
    for (std::size_t k = 0; k < index_.size(); ++k)
      if (index_[k] >= count_) beyond_.push_back(k), index_[k] = 0;
  }
  Numbers index() const { return index_; }
  /// Answers to the others are `nothing`.
  template <class To>
  void leave_out(std::span<To> out, const To& nothing) const {
    for (const std::size_t k : beyond_) out[k] = nothing;
  }

 private:
  std::uint64_t count_;
  Column index_;
  std::vector<std::size_t> beyond_ = {};
};

constexpr std::uint32_t none = ~0u;

/// Names elements for messages, as cases name them.
template <class Element>
auto naming(std::span<const Element> at) {
  return [at](std::size_t k) { return text_of(at[k]); };
}
auto naming(Numbers index) {
  return [index](std::size_t k) { return fmt::format("k={}", index[k]); };
}
auto naming(FloatPoints p) {
  return [p](std::size_t k) { return fmt::format("u={:a},v={:a}", p.u[k], p.v[k]); };
}

Triplet triplet_of(VertexOrder order, Level n, const MicroTriangle& t) {
  const auto x = spec::attribute::triplet(order, t, n);
  return {static_cast<std::uint32_t>(x[0]), static_cast<std::uint32_t>(x[1]),
          static_cast<std::uint32_t>(x[2])};
}

bool is_of_a_face(VertexOrder order, Level n, const Triplet& t) {
  for (const std::uint32_t x : t)
    if (x >= spec::attribute::vertex_count(n)) return false;
  const Vertex a = spec::attribute::vertex_at(order, t[0], n), b = spec::attribute::vertex_at(order, t[1], n);
  if (a.j != b.j) return false;
  const bool upper = b.i + 1 == a.i;
  if (upper ? a.j == 0 : b.i != a.i + 1) return false;
  const MicroTriangle face{std::min(a.i, b.i), upper ? a.j - 1 : a.j, upper};
  return face.iu + face.iv + (upper ? 1 : 0) < spec::side(n) && triplet_of(order, n, face) == t;
}

Column corner(std::span<const Triplet> of, std::size_t which) {
  Column words;
  for (const Triplet& t : of) words.push_back(t[which]);
  return words;
}

void ask_vertices(const LibraryPtr& library, Orders& f) {
  if (library->offers(Call::attribute_vertex_index))
    f.vertex_index = [=](VertexOrder order, Level n, std::span<const Vertex> at,
                         std::span<std::uint32_t> out) {
      const Column i = apart(at, &Vertex::i), j = apart(at, &Vertex::j);
      dock::ask_all(*library,
                    {Call::attribute_vertex_index, n, format_of(order), {i.data(), j.data()}, naming(at)},
                    out.size(), out.data());
    };
  if (library->offers(Call::attribute_vertex_place))
    f.vertex_at = [=](VertexOrder order, Level n, Numbers index, std::span<Vertex> out) {
      static_assert(sizeof(Vertex) == dock::entry_point(Call::attribute_vertex_place).answer_bytes);
      const IndicesInRange asked(index, spec::attribute::vertex_count(n));
      dock::ask_all(
          *library,
          {Call::attribute_vertex_place, n, format_of(order), {asked.index().data()}, naming(asked.index())},
          out.size(), out.data());
      asked.leave_out(out, Vertex{none, none});
    };
}

void ask_faces(const LibraryPtr& library, Orders& f) {
  if (library->offers(Call::attribute_face_index))
    f.face_index = [=](FaceOrder order, Level n, std::span<const MicroTriangle> at,
                       std::span<std::uint32_t> out) {
      const Column iu = apart(at, &MicroTriangle::iu), iv = apart(at, &MicroTriangle::iv),
                   upper = apart(at, &MicroTriangle::upper);
      dock::ask_all(
          *library,
          {Call::attribute_face_index, n, format_of(order), {iu.data(), iv.data(), upper.data()}, naming(at)},
          out.size(), out.data());
    };
  if (library->offers(Call::attribute_face_place))
    f.face_at = [=](FaceOrder order, Level n, Numbers index, std::span<MicroTriangle> out) {
      const IndicesInRange asked(index, spec::attribute::face_count(n));
      std::vector<std::array<std::uint32_t, 3>> places(out.size());
      dock::ask_all(
          *library,
          {Call::attribute_face_place, n, format_of(order), {asked.index().data()}, naming(asked.index())},
          out.size(), places.data());
      // A half that is neither 0 nor 1 makes a place that no level has.
      constexpr MicroTriangle nowhere{none, none, true};
      for (std::size_t k = 0; k < out.size(); ++k) {
        const auto& [iu, iv, upper] = places[k];
        out[k] = upper <= 1 ? MicroTriangle{iu, iv, upper != 0} : nowhere;
      }
      asked.leave_out(out, nowhere);
    };
}

void ask_triplets(const LibraryPtr& library, Orders& f) {
  if (library->offers(Call::attribute_triplet))
    f.triplet = [=](FaceOrder faces, VertexOrder vertices, Level n, Numbers face, std::span<Triplet> out) {
      const IndicesInRange asked(face, spec::attribute::face_count(n));
      dock::ask_all(*library,
                    {Call::attribute_triplet,
                     n,
                     dock::two_formats(format_of(vertices), format_of(faces)),
                     {asked.index().data()},
                     naming(asked.index())},
                    out.size(), out.data());
      asked.leave_out(out, Triplet{none, none, none});
    };
  if (library->offers(Call::attribute_face_of))
    f.face_of = [=](FaceOrder faces, VertexOrder vertices, Level n, std::span<const Triplet> of,
                    std::span<std::uint32_t> out) {
      // A triplet of no face, which a wrong index makes, is asked of nobody: face 0's stands in its place.
      std::vector<Triplet> asked(of.begin(), of.end());
      std::vector<std::size_t> beyond;
      for (std::size_t k = 0; k < asked.size(); ++k)
        if (!is_of_a_face(vertices, n, asked[k])) {
          beyond.push_back(k);
          asked[k] = triplet_of(vertices, n, spec::attribute::triangle_at(faces, 0, n));
        }
      const Column first = corner(asked, 0), second = corner(asked, 1), third = corner(asked, 2);
      dock::ask_all(*library,
                    {Call::attribute_face_of,
                     n,
                     dock::two_formats(format_of(vertices), format_of(faces)),
                     {first.data(), second.data(), third.data()},
                     [&](std::size_t k) {
                       return fmt::format("triplet {} {} {}", asked[k][0], asked[k][1], asked[k][2]);
                     }},
                    out.size(), out.data());
      for (const std::size_t k : beyond) out[k] = none;
    };
}

Orders orders_of(const LibraryPtr& library) {
  Orders f;
  ask_vertices(library, f);
  ask_faces(library, f);
  ask_triplets(library, f);
  return f;
}

Lookup lookup_of(const LibraryPtr& library) {
  Lookup f;
  if (library->offers(Call::attribute_triplet_f32))
    f.triplet_of_floats = [=](VertexOrder order, Level n, FloatPoints p, std::span<Triplet> out) {
      dock::ask_all(*library,
                    {Call::attribute_triplet_f32, n, format_of(order), {p.u.data(), p.v.data()}, naming(p)},
                    out.size(), out.data());
    };
  if (library->offers(Call::attribute_weights_f32))
    f.weights_of_floats = [=](Level n, FloatPoints p, std::span<FloatWeights> out) {
      dock::ask_all(*library, {Call::attribute_weights_f32, n, 0, {p.u.data(), p.v.data()}, naming(p)},
                    out.size(), out.data());
    };
  answer_points_by_floats(f);
  return f;
}

Decimation decimation_of(const LibraryPtr& library) {
  Decimation f;
  if (library->offers(Call::attribute_decimate))
    f.snapped = [=](Level n, EdgeFlags flags, std::span<const Vertex> at, std::span<Vertex> out) {
      const Column i = apart(at, &Vertex::i), j = apart(at, &Vertex::j);
      dock::ask_all(*library, {Call::attribute_decimate, n, flags, {i.data(), j.data()}, naming(at)},
                    out.size(), out.data());
    };
  return f;
}

Mips mips_of(const LibraryPtr& library) {
  Mips f;
  if (library->offers(Call::attribute_face_mip))
    f.face_mip = [=](Rounding rounding, Numbers children, std::span<std::uint32_t> parents) {
      // A code is a byte of a word, whichever: so memory's order will do.
      std::vector<std::uint8_t> bytes(children.size_bytes());
      std::memcpy(bytes.data(), children.data(), bytes.size());
      const dock::Answer answer = dock::ask(
          *library,
          dock::Question{Call::attribute_face_mip, 0, format_of(rounding), bytes, parents.size_bytes()},
          [&] { return fmt::format("averaging {} faces", children.size()); });
      std::memcpy(parents.data(), answer.bytes.data(), parents.size_bytes());
    };
  return f;
}

}  // namespace

AttributeSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::attribute)) return nullptr;
  Functions functions;
  functions.exact = false;
  functions.max_level = library->description().max_level;
  functions.orders = orders_of(library);
  functions.lookup = lookup_of(library);
  functions.decimation = decimation_of(library);
  functions.mips = mips_of(library);
  functions.baking = baking_of(library);
  return std::make_shared<AttributeSubject>(name, library->about(), std::move(functions),
                                            library->fingerprint());
}

}  // namespace mmverify::proofs::attribute
