#include "proofs/attribute/bake/support.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <vector>

#include "proofs/attribute/bake/names.hpp"

namespace mmverify::proofs::attribute {
namespace {

/// The value, or where it is not in the set one that is.  Domain: the set has one below `values`.
template <class Value>
Value in_set(Set set, Value value, std::size_t values, std::uint32_t salt) {
  if (set.has(value)) return value;
  std::vector<Value> all;
  for (std::size_t k = 0; k < values; ++k)
    if (set.has(k)) all.push_back(static_cast<Value>(k));
  return all.at((salt + static_cast<std::size_t>(value)) % all.size());
}

template <std::size_t count>
void say_set(std::vector<std::string>& said, Set set, const std::array<const char*, count>& names) {
  std::vector<std::string> some;
  for (std::size_t k = 0; k < count; ++k)
    if (set.has(k)) some.emplace_back(names[k]);
  if (some.size() < count) said.push_back(fmt::format("{}", fmt::join(some, " and ")));
}

}  // namespace

bool covers(const BakingSupport& s, const BakeCase& one) {
  const Picture& p = one.picture;
  return s.meanings.has(p.meaning) && s.filters.has(p.filter) && s.wraps.has(p.wrap_u) &&
         s.wraps.has(p.wrap_v) && (!s.same_wraps || p.wrap_u == p.wrap_v);
}

BakeCase fitted(const BakingSupport& s, BakeCase one) {
  if (covers(s, one)) return one;
  Picture& p = one.picture;
  // Half a mantissa: what a small change of a coordinate changes.
  const std::uint32_t salt = std::bit_cast<std::uint32_t>(one.uv[0] + one.uv[3]) >> 12;
  p.meaning = in_set(s.meanings, p.meaning, meaning_names.size(), salt);
  p.filter = in_set(s.filters, p.filter, filter_names.size(), salt);
  p.wrap_u = in_set(s.wraps, p.wrap_u, wrap_names.size(), salt);
  p.wrap_v = s.same_wraps ? p.wrap_u : in_set(s.wraps, p.wrap_v, wrap_names.size(), salt);
  return one;
}

std::string text_of(const BakingSupport& s) {
  std::vector<std::string> said;
  say_set(said, s.meanings, meaning_names);
  say_set(said, s.filters, filter_names);
  say_set(said, s.wraps, wrap_names);
  if (s.same_wraps) said.emplace_back("one addressing mode for u and v");
  if (s.tolerance != 0)
    said.push_back(fmt::format("within {} code{}", s.tolerance, s.tolerance == 1 ? "" : "s"));
  return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace mmverify::proofs::attribute
