#include "impl/attribute/plan.hpp"

#include <algorithm>
#include <stdexcept>

namespace mmverify::impl::attribute {
namespace {

class Planner {
 public:
  explicit Planner(const PlanRequest& request)
      : of_(request), plans_(request.neighbours.size()), queued_(plans_.size(), true) {
    check();
    for (std::size_t t = 0; t < plans_.size(); ++t) {
      queue_.push_back(t);
      TrianglePlan& p = plans_[t];
      p.special = of_.special && of_.special(t);
      if (p.special) continue;
      while (p.level < of_.highest && !of_.keeps(t, p.level, 0)) ++p.level;
    }
  }

  std::vector<TrianglePlan> planned() {
    // The highest level comes first (from the back), so that neighbours raise each triangle once.
    std::stable_sort(queue_.begin(), queue_.end(),
                     [&](std::size_t a, std::size_t b) { return plans_[a].level < plans_[b].level; });
    grade();
    // A raised level changes the decimated edges around it: all triangles are judged again until nothing moves.
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t t = 0; t < plans_.size(); ++t) moved = judged(t) || moved;
    }
    return std::move(plans_);
  }

 private:
  void check() const {
    if (!of_.keeps) throw std::invalid_argument("attribute: a plan without an error to keep");
    if (of_.highest > max_attribute_level) throw std::invalid_argument("attribute: a level above 12");
    const auto count = static_cast<std::int64_t>(of_.neighbours.size());
    for (std::size_t t = 0; t < of_.neighbours.size(); ++t)
      for (const std::int32_t s : of_.neighbours[t]) {
        if (s == no_neighbour) continue;
        if (s < 0 || s >= count) throw std::invalid_argument("attribute: a neighbour that is no triangle");
        const Neighbours& back = of_.neighbours[static_cast<std::size_t>(s)];
        if (std::find(back.begin(), back.end(), static_cast<std::int32_t>(t)) == back.end())
          throw std::invalid_argument("attribute: a neighbour of a triangle that is not its neighbour");
      }
  }

  template <class Visit>
  void each_neighbour(std::size_t t, Visit visit) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t s = of_.neighbours[t][k];
      if (s != no_neighbour && !plans_[static_cast<std::size_t>(s)].special)
        visit(k, static_cast<std::size_t>(s));
    }
  }

  void raise(std::size_t t, std::uint32_t level) {
    if (plans_[t].level >= level) return;
    plans_[t].level = level;
    if (queued_[t]) return;
    queued_[t] = true;
    queue_.push_back(t);
  }

  /// Raises each triangle that lies more than one level below a neighbour.
  void grade() {
    while (!queue_.empty()) {
      const std::size_t t = queue_.back();
      queue_.pop_back();
      queued_[t] = false;
      if (plans_[t].special) continue;
      each_neighbour(t, [&](std::size_t, std::size_t s) {
        if (plans_[t].level > 0) raise(s, plans_[t].level - 1);
      });
    }
  }

  std::uint8_t decimated(std::size_t t) const {
    std::uint8_t flags = 0;
    each_neighbour(t, [&](std::size_t k, std::size_t s) {
      if (plans_[s].level < plans_[t].level) flags = static_cast<std::uint8_t>(flags | 1u << k);
    });
    return flags;
  }

  /// Judges t's map with its decimated edges; true if it raised a triangle.
  bool judged(std::size_t t) {
    TrianglePlan& p = plans_[t];
    if (p.special) return false;
    p.decimated = decimated(t);
    p.kept = of_.keeps(t, p.level, p.decimated);
    if (p.kept) return false;
    if (p.decimated != 0 && of_.keeps(t, p.level, 0)) {
      each_neighbour(t, [&](std::size_t k, std::size_t s) {
        if ((p.decimated >> k & 1) != 0) raise(s, p.level);
      });
    } else if (p.level < of_.highest) {
      raise(t, p.level + 1);
    } else {
      return false;
    }
    grade();
    return true;
  }

  const PlanRequest& of_;
  std::vector<TrianglePlan> plans_;
  std::vector<std::size_t> queue_;
  std::vector<bool> queued_;
};

}  // namespace

std::vector<Neighbours> neighbours_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::size_t, std::size_t>>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edges[std::minmax(triangles[t][k], triangles[t][(k + 1) % 3])].push_back({t, k});
  std::vector<Neighbours> found(triangles.size(), {no_neighbour, no_neighbour, no_neighbour});
  for (const auto& [edge, sides] : edges) {
    if (sides.size() != 2 || sides[0].first == sides[1].first) continue;
    found[sides[0].first][sides[0].second] = static_cast<std::int32_t>(sides[1].first);
    found[sides[1].first][sides[1].second] = static_cast<std::int32_t>(sides[0].first);
  }
  return found;
}

std::vector<TrianglePlan> plan(const PlanRequest& request) { return Planner(request).planned(); }

std::uint32_t Shared::add(std::span<const std::uint8_t> bytes) {
  const auto [at, fresh] =
      numbers_.emplace(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), size_);
  if (fresh) {
    ++size_;
    bytes_ += bytes.size();
  }
  return at->second;
}

}  // namespace mmverify::impl::attribute
