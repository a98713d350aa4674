#include "impl/bake/mesh.hpp"

#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>

namespace mmverify::impl::bake {
namespace {

std::invalid_argument at_triangle(std::size_t t, const std::string& fault) {
  return std::invalid_argument("bake: triangle " + std::to_string(t) + ": " + fault);
}

/// The sums of all jobs, and the error of the first triangle at fault, in whichever order the jobs end.
class Outcome {
 public:
  void add(const BakeCounts& more) {
    const std::lock_guard lock(mutex_);
    counts_.micro_triangles += more.micro_triangles;
    counts_.leaves += more.leaves;
    counts_.exact += more.exact;
  }
  void fail(std::size_t triangle, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ && first_ < triangle) return;
    first_ = triangle;
    error_ = std::move(error);
  }
  /// The sums; else throws.
  BakeCounts counts() const {
    try {
      if (error_) std::rethrow_exception(error_);
    } catch (const std::invalid_argument& error) {
      const std::string what = error.what();
      throw at_triangle(first_, what.substr(what.find(' ') + 1));
    }
    return counts_;
  }

 private:
  std::mutex mutex_;
  std::size_t first_ = 0;
  std::exception_ptr error_;
  BakeCounts counts_;
};

/// The end of each map in one block.
std::vector<std::size_t> ends_of(std::span<const std::uint32_t> levels) {
  std::vector<std::size_t> ends;
  ends.reserve(levels.size());
  std::size_t size = 0;
  for (const std::uint32_t level : levels) {
    if (level > max_bake_level) throw at_triangle(ends.size(), "a level above 12");
    size += static_cast<std::size_t>(
        micromap::packed_bytes(micromap::micro_triangles(level), micromap::Format::four_state));
    ends.push_back(size);
  }
  return ends;
}

}  // namespace

MeshMaps bake_mesh(const TriangleBaker& baker, std::span<const BaseTriangle> triangles,
                   std::span<const std::uint32_t> levels, const Parallel& parallel) {
  if (levels.size() != triangles.size())
    throw std::invalid_argument("bake: " + std::to_string(levels.size()) + " levels for " +
                                std::to_string(triangles.size()) + " triangles");
  const std::vector<std::size_t> ends = ends_of(levels);
  MeshMaps mesh;
  mesh.bytes.resize(ends.empty() ? 0 : ends.back());
  const auto map_of = [&](std::size_t t) {
    const std::size_t begin = t == 0 ? 0 : ends[t - 1];
    return std::span(mesh.bytes).subspan(begin, ends[t] - begin);
  };
  mesh.maps.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.maps.push_back({levels[t], micromap::Format::four_state, map_of(t)});
  Outcome outcome;
  const std::function<void(std::size_t)> job = [&](std::size_t t) {
    try {
      outcome.add(baker.bake(triangles[t], levels[t], map_of(t)));
    } catch (...) {
      outcome.fail(t, std::current_exception());
    }
  };
  if (parallel)
    parallel(triangles.size(), job);
  else
    for (std::size_t t = 0; t < triangles.size(); ++t) job(t);
  mesh.counts = outcome.counts();
  return mesh;
}

}  // namespace mmverify::impl::bake
