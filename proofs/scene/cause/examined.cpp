#include "proofs/scene/cause/examined.hpp"

#include <algorithm>

namespace mmverify::proofs::scene {
namespace {

/// A change is tried on so many triangles; the best one is then judged by all.
constexpr std::size_t most_tried = 64;

std::vector<States> picked(const std::map<std::size_t, States>& from,
                           const std::vector<std::size_t>& triangles) {
  std::vector<States> some;
  for (const std::size_t k : triangles) some.push_back(from.at(k));
  return some;
}

}  // namespace

Examined::Examined(const Judged& judged, std::uint64_t most) : judged_(judged), inputs_(inputs_of(judged)) {
  choose_all(most);
  const std::vector<States> right = expected(judged, inputs_, all_);
  for (std::size_t k = 0; k < all_.size(); ++k) {
    stored_[all_[k]] = states_of(judged.maps.baked.triangles[all_[k]]);
    right_[all_[k]] = right[k];
    const Fit here = fits_[all_[k]] = scene::fit(stored_[all_[k]], right[k]);
    as_stored_ += here;
    wrong_ += here.wrong + here.needless != 0 ? times(all_[k]) : 0;
  }
  choose_tried();
}

const States& Examined::right_at(std::size_t triangle, Level n) const {
  if (n == level(triangle)) return right(triangle);
  States& states = at_level_[{triangle, n}];
  if (states.empty()) states = expected_at(judged_, inputs_, triangle, n);
  return states;
}

std::vector<States> Examined::stored(const std::vector<std::size_t>& triangles) const {
  return picked(stored_, triangles);
}
std::vector<States> Examined::right(const std::vector<std::size_t>& triangles) const {
  return picked(right_, triangles);
}

Fit Examined::fit(const std::vector<std::size_t>& triangles) const {
  Fit all;
  for (const std::size_t k : triangles) all += fit(k);
  return all;
}

void Examined::choose_all(std::uint64_t most) {
  const std::size_t count = judged_.maps.plan.triangles.size();
  std::uint64_t micro_triangles = 1;
  for (std::size_t k = 0; k < count; ++k) micro_triangles += impl::micromap::micro_triangles(level(k));
  const std::uint64_t step = 1 + (micro_triangles - 1) / most;
  for (std::size_t k = 0; k < count; k += step) all_.push_back(k);
}

void Examined::choose_tried() {
  std::vector<std::size_t> wrong, right;
  for (const std::size_t k : all_)
    (fit(k).wrong + fit(k).needless + fit(k).side != 0 ? wrong : right).push_back(k);
  std::uint64_t micro_triangles = 0;
  const auto take = [&](const std::vector<std::size_t>& from, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(1, from.size() / most);
    for (std::size_t k = 0; k < from.size() && most-- != 0; k += step) {
      micro_triangles += stored(from[k]).size();
      if (!tried_.empty() && micro_triangles > most_tried_micro_triangles) return;
      tried_.push_back(from[k]);
    }
  };
  take(wrong, most_tried - most_tried / 4);
  take(right, most_tried - tried_.size());
}

}  // namespace mmverify::proofs::scene
