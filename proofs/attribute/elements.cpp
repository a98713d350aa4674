#include "proofs/attribute/elements.hpp"

#include <charconv>

#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::side;

/// Groups 1 and 2 of what fits, as numbers.
std::array<std::uint32_t, 2> numbers_of(const std::vector<std::string>& groups, const std::string& text) {
  std::array<std::uint32_t, 2> found{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string& digits = groups[k + 1];
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), found[k]);
    if (error != std::errc{} || end != digits.data() + digits.size())
      throw BadCase(fmt::format("'{:.60}': a number beyond 32 bits", text));
  }
  return found;
}

}  // namespace

void fill(Level n, std::uint64_t first, std::span<Vertex> out) {
  if (out.empty()) return;
  // Column i has N+1-i vertices.  Counted one by one: the laws hold closed forms against these numbers.
  Vertex at{0, 0};
  for (; first >= side(n) + 1 - at.i; ++at.i) first -= side(n) + 1 - at.i;
  at.j = static_cast<std::uint32_t>(first);
  for (Vertex& v : out) {
    v = at;
    at = at.i + at.j == side(n) ? Vertex{at.i + 1, 0} : Vertex{at.i, at.j + 1};
  }
}

void fill(Level n, std::uint64_t first, std::span<MicroTriangle> out) {
  if (out.empty()) return;
  // Strip iu has 2(N-iu) - 1 faces.
  MicroTriangle at{0, 0, false};
  for (; first >= 2 * (side(n) - at.iu) - 1; ++at.iu) first -= 2 * (side(n) - at.iu) - 1;
  at.iv = static_cast<std::uint32_t>(first / 2);
  at.upper = first % 2 != 0;
  for (MicroTriangle& t : out) {
    t = at;
    const bool last = at.iu + at.iv == side(n) - 1;
    if (last)
      at = {at.iu + 1, 0, false};
    else if (at.upper)
      at = {at.iu, at.iv + 1, false};
    else
      at.upper = true;
  }
}

std::string text_of(const Vertex& at) { return fmt::format("i={},j={}", at.i, at.j); }
std::string text_of(const MicroTriangle& at) {
  return fmt::format("iu={},iv={},{}", at.iu, at.iv, at.upper ? "upper" : "lower");
}

void read(Level n, const std::string& text, Vertex& at) {
  const Groups groups = groups_of(text, "i=(\\d+),j=(\\d+)");
  if (!groups) throw BadCase(fmt::format("'{:.60}': write a vertex as i=1,j=2", text));
  const auto [i, j] = numbers_of(*groups, text);
  if (std::uint64_t{i} + j > side(n))
    throw BadCase(fmt::format("'{:.60}': i+j is at most {} at level {}", text, side(n), n));
  at = {i, j};
}

void read(Level n, const std::string& text, MicroTriangle& at) {
  const Groups groups = groups_of(text, "iu=(\\d+),iv=(\\d+),(lower|upper)");
  if (!groups) throw BadCase(fmt::format("'{:.60}': write a face as iu=1,iv=2,lower or upper", text));
  const auto [iu, iv] = numbers_of(*groups, text);
  const bool upper = (*groups)[3] == "upper";
  if (std::uint64_t{iu} + iv + (upper ? 1 : 0) >= side(n))
    throw BadCase(fmt::format("'{:.60}': no face of level {}", text, n));
  at = {iu, iv, upper};
}

const char* name_of(VertexOrder order) {
  switch (order) {
    case VertexOrder::w_minor: return "w-minor";
    case VertexOrder::u_major: return "u-major";
    case VertexOrder::bird: break;
  }
  return "bird";
}

const char* name_of(FaceOrder order) {
  switch (order) {
    case FaceOrder::curve: return "curve";
    case FaceOrder::rows: return "rows";
    case FaceOrder::u_major: break;
  }
  return "u-major";
}

}  // namespace mmverify::proofs::attribute
