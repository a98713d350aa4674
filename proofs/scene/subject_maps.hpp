// The maps of a scene's triangles by another program's baker, compared with this project's.
#pragma once

#include "proofs/bake/subject.hpp"
#include "proofs/scene/subject.hpp"

namespace mmverify::proofs::scene {

/// The wrong states of one triangle's map by the baker's own rules: micro-triangles that are O or T and should not
/// be, and needlessly unknown ones.
struct WrongStates {
  std::vector<std::uint32_t> known, unknown;
};

/// Sums over the triangles of a scene.
struct SubjectTotals {
  std::uint64_t triangles = 0, outside = 0, declined = 0;  ///< outside: not supported by the baker
  std::uint64_t micro_triangles = 0, wrong_known = 0,
                needless_unknown = 0;  ///< of the triangles that it baked
  double
      ns = 0,
      our_ns =
          0;  ///< a micro-triangle: the baker's in its worker, with the transfer of question and answer; ours
};

class SubjectMaps {
 public:
  /// Domain: data of 4-state maps; it outlives this object.
  SubjectMaps(const Data& data, bake::BakeSubjectPtr subject);

  /// Whether the baker supports a planned triangle, and a case can express it: the texture fits into the memory that
  /// a worker shares, and the cutoff is a fraction of 32 bits.
  bool asks(std::size_t triangle) const;
  /// The wrong states of a triangle, baked at the first call, from any thread; null if the baker declined it.
  /// Domain: asks(triangle).  Throws SubjectBroken.
  const WrongStates* wrong(std::size_t triangle) const;
  /// The case of a triangle.  Domain: asks(triangle).
  bake::Case case_of(std::size_t triangle) const;
  /// The sums over all triangles; states and times only of those baked so far.
  SubjectTotals totals() const;

  const Data& data() const { return data_; }
  const bake::BakeSubject& subject() const { return *subject_; }

 private:
  enum class Answer : std::uint8_t { none, declined, baked };
  struct TriangleAnswer {
    std::once_flag once;
    std::atomic<Answer> answer{Answer::none};
    WrongStates wrong;
    double ns = 0, our_ns = 0;
  };
  void ask(std::size_t triangle, TriangleAnswer& asked) const;
  std::optional<bake::Case> case_without_texels(std::size_t triangle) const;

  Data data_;
  bake::BakeSubjectPtr subject_;
  std::unique_ptr<TriangleAnswer[]> asked_;
};

}  // namespace mmverify::proofs::scene
