#include "proofs/scene/repair/relinks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "proofs/scene/repair/fitting.hpp"

namespace mmverify::proofs::scene {
namespace {

using mmverify::scene::BakedTriangle;
using mmverify::scene::MapLink;

/// Triangles of a primitive that links are tried on.
constexpr std::size_t most_links_tried = 16;
/// The most places by which a base triangle is tried to be off.
constexpr std::int64_t most_shift = 1024;

/// A link's array and record; no record for a special index.
struct LinkPlace {
  std::size_t array;
  std::optional<std::uint64_t> record;
};
using LinkRule = std::function<std::optional<LinkPlace>(const MapLink&)>;

class RelinkSearch {
 public:
  explicit RelinkSearch(const Judged& judged) : judged_(judged), maps_(judged.maps), fitting_(judged) {
    for (std::size_t k = 0; k < maps_.links.size(); ++k) {
      auto& of = links_[maps_.links[k].primitive];
      of.resize(std::max(of.size(), maps_.links[k].triangle + 1), k);
      of[maps_.links[k].triangle] = k;
    }
  }

  std::vector<Relink> all() {
    std::vector<Relink> found;
    for (const auto& [primitive, links] : links_)
      if (const std::optional<Relink> relink = of_primitive(primitive, links)) found.push_back(*relink);
    return found;
  }

 private:
  /// Some links with different maps, or triangles, that a wrong link would spoil.
  std::vector<std::size_t> sample(const std::vector<std::size_t>& links) {
    std::vector<std::size_t> some;
    std::set<std::size_t> planned;
    const std::size_t step = std::max<std::size_t>(1, links.size() / (4 * most_links_tried));
    for (std::size_t k = 0; k < links.size() && some.size() < most_links_tried; k += step) {
      const MapLink& link = maps_.links[links[k]];
      if (!link.record || !planned.insert(link.planned).second) continue;
      const States& right = fitting_.right(link.planned, fitting_.map(link.array, *link.record).level);
      if (std::adjacent_find(right.begin(), right.end(), std::not_equal_to<>()) == right.end()) continue;
      some.push_back(links[k]);
    }
    return some;
  }

  /// The links of a sample that fit by a rule; stops where fewer than `least` can.
  std::size_t score(const std::vector<std::size_t>& tried, const LinkRule& rule, std::size_t least) {
    std::size_t fitting = 0;
    for (std::size_t k = 0; k < tried.size() && fitting + tried.size() - k >= least; ++k) {
      const MapLink& link = maps_.links[tried[k]];
      const std::optional<LinkPlace> place = rule(link);
      if (!place || !place->record || *place->record >= maps_.arrays[place->array]->records.size()) continue;
      fitting += fitting_.turn(link.planned, fitting_.map(place->array, *place->record)) ? 1 : 0;
    }
    return fitting;
  }

  std::optional<Relink> of_primitive(std::size_t primitive, const std::vector<std::size_t>& links) {
    const std::vector<std::size_t> tried = sample(links);
    if (tried.empty()) return {};
    std::size_t best = score(
        tried,
        [](const MapLink& link) {
          return LinkPlace{link.array, link.record};
        },
        0);
    if (best == tried.size()) return {};
    best = std::max(best, (3 * tried.size() + 3) / 4 - 1);  // at least three of four
    std::optional<Relink> found;
    const MapLink& own = maps_.links[links[0]];
    const auto attempt = [&](const Relink& relink, const LinkRule& rule) {
      const std::size_t here = score(tried, rule, best + 1);
      if (here <= best) return;
      best = here;
      found = relink;
    };
    for (std::size_t a = 0; a < maps_.arrays.size(); ++a)
      if (a != own.array)
        attempt({primitive, a, own.base, {}, fmt::format("linked to micromap {}", a)},
                [a](const MapLink& link) {
                  return LinkPlace{a, link.record};
                });
    for (const auto& [other, its] : links_)
      if (other != primitive && its.size() == links.size()) {
        const MapLink& first = maps_.links[its[0]];
        const auto& p = judged_.scene.primitives[other];
        attempt({primitive, first.array, first.base, other,
                 fmt::format("linked as mesh {} primitive {} was", p.mesh, p.number)},
                [&of_other = links_.at(other), this](const MapLink& link) {
                  const MapLink& at = maps_.links[of_other[link.triangle]];
                  return LinkPlace{at.array, at.record};
                });
      }
    bases(primitive, own, attempt);
    return found;
  }

  template <class Attempt>
  void bases(std::size_t primitive, const MapLink& own, const Attempt& attempt) {
    const auto records = static_cast<std::int64_t>(maps_.arrays[own.array]->records.size());
    const std::int64_t most = std::min(records - 1, most_shift), base = static_cast<std::int64_t>(own.base);
    for (std::int64_t by = std::max(-most, -base); by <= most; ++by) {
      if (by == 0) continue;
      attempt({primitive,
               own.array,
               static_cast<std::uint64_t>(base + by),
               {},
               fmt::format("its base triangle is {} now; it was {}", base + by, base)},
              [by](const MapLink& link) -> std::optional<LinkPlace> {
                if (!link.record) return LinkPlace{link.array, {}};
                return LinkPlace{link.array, *link.record + static_cast<std::uint64_t>(by)};
              });
    }
  }

  const Judged& judged_;
  const mmverify::scene::StoredMaps& maps_;
  Fitting fitting_;
  std::map<std::size_t, std::vector<std::size_t>> links_;  ///< by primitive, then triangle
};

}  // namespace

std::vector<Relink> relinks(const Judged& judged) { return RelinkSearch(judged).all(); }

}  // namespace mmverify::proofs::scene
