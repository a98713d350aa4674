// The maps that somebody else's baker makes of a scene's triangles, held against this project's.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "proofs/bake/subject.hpp"
#include "proofs/scene/subject.hpp"

namespace mmverify::proofs::scene {

/// What is wrong of one triangle's map: micro-triangles that are O or T and should not be, and that are unknown and
/// could be known, by the baker's own rules.
struct WrongStates {
  std::vector<std::uint32_t> known, unknown;
};

/// Sums over the triangles of a scene.
struct SubjectTotals {
  std::uint64_t triangles = 0, outside = 0, declined = 0;                    ///< outside: not asked
  std::uint64_t micro_triangles = 0, wrong_known = 0, needless_unknown = 0;  ///< of the rest
  double ns = 0,
         our_ns = 0;  ///< a micro-triangle: the baker's in its worker, question and answer included; ours
};

class SubjectMaps {
 public:
  /// Domain: data of 4-state maps that outlives this.
  SubjectMaps(const Data& data, bake::BakeSubjectPtr subject);

  /// Whether the baker declares what a planned triangle asks for, and a case says it: the texture fits into the memory
  /// that a worker shares, the cutoff is a fraction of 32 bits.
  bool asks(std::size_t triangle) const;
  /// Baked at the first question, from any thread; none where the baker declined it.  Domain: one that it is asked.
  /// Throws SubjectBroken.
  const WrongStates* wrong(std::size_t triangle) const;
  /// What it is asked.  Domain: one that it is asked.
  bake::Case case_of(std::size_t triangle) const;
  /// Of all triangles, those that were asked so far.
  SubjectTotals totals() const;

  const Data& data() const { return data_; }
  const bake::BakeSubject& subject() const { return *subject_; }

 private:
  enum class Answer : std::uint8_t { none, declined, baked };
  struct Asked {
    std::once_flag once;
    std::atomic<Answer> answer{Answer::none};
    WrongStates wrong;
    double ns = 0, our_ns = 0;
  };
  void ask(std::size_t triangle, Asked& asked) const;
  std::optional<bake::Case> case_without_texels(std::size_t triangle) const;

  Data data_;
  bake::BakeSubjectPtr subject_;
  std::unique_ptr<Asked[]> asked_;
};

}  // namespace mmverify::proofs::scene
