// A subject of topic vq: functions on vectors, blocks and maps, built in or in the dock.
#pragma once

#include "proofs/engine/topic.hpp"
#include "spec/vq/block.hpp"

namespace mmverify::proofs::vq {

using spec::vq::BlockBytes;
using spec::vq::Code4;
using spec::vq::Map;
using spec::vq::State;
using spec::vq::Transform;
using spec::vq::Vector;
using spec::vq::Vq2;
using spec::vq::Vq4;

/// The level of the format's maps, which have 2^level regions along each side: 16 and 32.
template <class Format>
inline constexpr Level level_of = Format::side == 2 ? 4 : 5;

/// An encoder's result for a map.
template <class Format>
struct Encoded {
  BlockBytes<Format> block;
  std::optional<std::uint32_t> substitutions = {};  ///< the encoder's own count, if it counts
};

/// Vectors of side x side regions.
template <std::size_t side>
struct Vectors {
  std::function<bool(const Vector<side>&)> valid = {};
  std::function<Vector<side>(Transform, const Vector<side>&)> applied = {};
  /// Domain: the code fits its bits.  2x2 vectors have one kind of code, and `how` is ignored.
  std::function<Vector<side>(Code4 how, std::uint32_t code)> decode = {};
  std::function<std::optional<std::uint32_t>(Code4 how, const Vector<side>&)> encode = {};
};

/// The functions on blocks of one format.  Several threads may call at once.
template <class Format>
struct Codec {
  std::function<BlockBytes<Format>(const Format&)> bytes = {};
  std::function<Format(const BlockBytes<Format>&)> fields = {};
  std::function<Map<Format>(const BlockBytes<Format>&)> decode = {};
  /// Writes the state k of region (x[k], y[k]).
  std::function<void(const BlockBytes<Format>&, std::span<const std::uint32_t> x,
                     std::span<const std::uint32_t> y, std::span<State>)>
      regions = {};
  std::function<Encoded<Format>(const Map<Format>&)> encode = {};
  // The encoder's promises about its substitutions: none if a block can hold the map; no more than any block needs;
  // no more than another encoder's; and a bound that none can go below.
  bool keeps_what_fits = false, fewest = false;
  std::function<std::uint32_t(const Map<Format>&)> at_most = {}, at_least = {};
};

/// The entry points of a subject; an empty function is a missing entry point.
struct Functions {
  static constexpr char topic[] = "vq";
  Vectors<2> of2;
  Vectors<4> of4;
  std::function<Transform(Transform then, Transform first)> composed = {};
  Codec<Vq2> vq2;
  Codec<Vq4> vq4;

  template <std::size_t side>
  auto& vectors() {
    if constexpr (side == 2)
      return of2;
    else
      return of4;
  }
  template <class Format>
  auto& codec() {
    if constexpr (Format::side == 2)
      return vq2;
    else
      return vq4;
  }
  template <std::size_t side>
  const auto& vectors() const {
    return const_cast<Functions*>(this)->vectors<side>();
  }
  template <class Format>
  const auto& codec() const {
    return const_cast<Functions*>(this)->codec<Format>();
  }
  /// No values lie between regions.
  bool exact_answers() const { return true; }
};

using VqSubject = SubjectOf<Functions>;
using VqSubjectPtr = std::shared_ptr<const VqSubject>;

/// The specification vq-spec; this project's decoders, vq; and its encoders.
const std::vector<VqSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.
VqSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::vq
