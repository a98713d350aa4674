// Common parts of the laws of orders: settings, entry points, wrong orders.
#pragma once

#include "proofs/attribute/batches.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::face_count;
using spec::attribute::face_orders;
using spec::attribute::vertex_count;
using spec::attribute::vertex_orders;

namespace entry {
inline constexpr Entry vertex_index{"vertex -> index",
                                    [](const Functions& f) { return bool{f.orders.vertex_index}; }};
inline constexpr Entry vertex_at{"index -> vertex",
                                 [](const Functions& f) { return bool{f.orders.vertex_at}; }};
inline constexpr Entry face_index{"face -> index",
                                  [](const Functions& f) { return bool{f.orders.face_index}; }};
inline constexpr Entry face_at{"index -> face", [](const Functions& f) { return bool{f.orders.face_at}; }};
inline constexpr Entry convert_vertices{"vertex index -> vertex index",
                                        [](const Functions& f) { return bool{f.orders.convert_vertices}; }};
inline constexpr Entry convert_faces{"face index -> face index",
                                     [](const Functions& f) { return bool{f.orders.convert_faces}; }};
inline constexpr Entry triplet{"face -> triplet", [](const Functions& f) { return bool{f.orders.triplet}; }};
inline constexpr Entry face_of{"triplet -> face", [](const Functions& f) { return bool{f.orders.face_of}; }};
}  // namespace entry

/// The names of the three orders.
template <class Order>
std::vector<std::string> settings_of(const std::array<Order, 3>& orders) {
  return {name_of(orders[0]), name_of(orders[1]), name_of(orders[2])};
}

/// A pair of orders, named "from>to", of the nine pairs.
template <class A, class B>
struct Pair {
  A from;
  B to;
  std::string name() const { return fmt::format("{}>{}", name_of(from), name_of(to)); }
};
template <class A, class B>
std::vector<Pair<A, B>> pairs(const std::array<A, 3>& from, const std::array<B, 3>& to) {
  std::vector<Pair<A, B>> all;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) all.push_back({from[a], to[b]});
  return all;
}
template <class P>
std::vector<std::string> settings_of(const std::vector<P>& all) {
  std::vector<std::string> names;
  for (const P& p : all) names.push_back(p.name());
  return names;
}

inline std::vector<std::uint32_t> indices_of(const AttributeSubject& s, VertexOrder order, Level n,
                                             std::span<const Vertex> at) {
  std::vector<std::uint32_t> index(at.size());
  s.functions.orders.vertex_index(order, n, at, index);
  return index;
}
inline std::vector<std::uint32_t> indices_of(const AttributeSubject& s, FaceOrder order, Level n,
                                             std::span<const MicroTriangle> at) {
  std::vector<std::uint32_t> index(at.size());
  s.functions.orders.face_index(order, n, at, index);
  return index;
}

/// A mutant that changes an element's index in one order: `change(n, element, index)` gives the new index.
template <class Change>
auto on_vertex_index(VertexOrder of, Change change) {
  return spoils(
      &Functions::orders, &Orders::vertex_index,
      [of, change](VertexOrder order, Level n, std::span<const Vertex> at, std::span<std::uint32_t> out) {
        if (order != of) return;
        for (std::size_t k = 0; k < at.size(); ++k) out[k] = change(n, at[k], out[k]);
      });
}
template <class Change>
auto on_face_index(FaceOrder of, Change change) {
  return spoils(&Functions::orders, &Orders::face_index,
                [of, change](FaceOrder order, Level n, std::span<const MicroTriangle> at,
                             std::span<std::uint32_t> out) {
                  if (order != of) return;
                  for (std::size_t k = 0; k < at.size(); ++k) out[k] = change(n, at[k], out[k]);
                });
}

inline std::string vertices_in_orders(const Subject&, Level) { return "the V(n) vertices, in 3 orders"; }
inline std::string faces_in_orders(const Subject&, Level) { return "the 4^n faces, in 3 orders"; }

inline std::string text_of(const Triplet& x) { return fmt::format("{} {} {}", x[0], x[1], x[2]); }

}  // namespace mmverify::proofs::attribute
