#include "proofs/attribute/bake/truth.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

/// The codes of a map from the shares of its elements, in numbers of any size.
template <class Q>
std::vector<Rgba> from_shares(const BakeCase& one, Filter filter,
                              const std::vector<slow::Shares<Q>>& shares) {
  std::vector<Rgba> map;
  for (const slow::Shares<Q>& s : shares)
    map.push_back(
        true_codes(one.picture, filter, [&](const auto& texture) { return slow::mean(texture, s); }));
  return map;
}

}  // namespace

template <class Q>
std::vector<slow::Shares<Q>> vertex_shares(const BakeCase& one, Level n) {
  const auto uv = base_triangle<Q>(one.uv);
  std::vector<slow::Shares<Q>> all;
  for (std::uint64_t k = 0; k < slow::vertex_count(n); ++k)
    all.push_back(slow::shares_at(slow::micro_vertex(uv, n, slow::vertex_at(slow::VertexOrder::w_minor, k, n),
                                                     one.picture.width, one.picture.height),
                                  one.picture.filter));
  return all;
}

template <class Q>
std::vector<slow::Shares<Q>> face_shares(const BakeCase& one, Level n) {
  const auto uv = base_triangle<Q>(one.uv);
  std::vector<slow::Shares<Q>> all;
  for (std::uint32_t k = 0; k < slow::face_count(n); ++k)
    all.push_back(slow::shares_on(spec::bake::micro_triangle(uv, n, k, one.picture.width, one.picture.height),
                                  Filter::nearest));
  return all;
}

template std::vector<slow::Shares<Rational>> vertex_shares(const BakeCase&, Level);
template std::vector<slow::Shares<Rational>> face_shares(const BakeCase&, Level);
template std::vector<slow::Shares<spec::Rational128>> vertex_shares(const BakeCase&, Level);
template std::vector<slow::Shares<spec::Rational128>> face_shares(const BakeCase&, Level);

std::vector<Rgba> true_vertices(const BakeCase& one, Level n) {
  return in_few_bits(
      [&]<class Q>() { return from_shares(one, one.picture.filter, vertex_shares<Q>(one, n)); });
}

std::vector<Rgba> true_faces(const BakeCase& one, Level n) {
  return in_few_bits([&]<class Q>() { return from_shares(one, Filter::nearest, face_shares<Q>(one, n)); });
}

template <class Channel>
std::vector<RgbaOf<Channel>> true_map(MapForm form, const BakeCaseOf<Channel>& one, Level n) {
  std::vector<RgbaOf<Channel>> map;
  for (std::uint32_t k = 0; k < map_size(form, n); ++k) map.push_back(exact_at(form, one, n, k));
  return map;
}
template std::vector<RgbaOf<std::uint16_t>> true_map(MapForm, const BakeCaseOf<std::uint16_t>&, Level);
template std::vector<RgbaOf<float>> true_map(MapForm, const BakeCaseOf<float>&, Level);

}  // namespace mmverify::proofs::attribute
