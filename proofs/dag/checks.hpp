// How one scene is judged.
#pragma once

#include "proofs/dag/subject.hpp"

namespace mmverify::proofs::dag {

using Check = std::function<Finding(const DagSubject&, const Scene&)>;

/// decode(encode(scene)) is the scene, padding bits zero.
Finding round_trip(const DagSubject& s, const Scene& scene);

/// Lookups give the maps' states, in one batch and again in another order and other batches; at most `most` of them where
/// there are more, of which two thirds lie where the state changes.
Finding lookups(const DagSubject& s, const Scene& scene, std::uint64_t most);

/// Lookups by barycentrics give the state at the reference's index for those very numbers: multiples of 1/4N, all such of
/// maps up to level 2 and `most` of a larger one's, and a quarter as many pairs near what breaks index functions.
Finding points(const DagSubject& s, const Scene& scene, std::uint64_t most);

/// The bytes are the specification's container.
Finding is_specified(const DagSubject& s, const Scene& scene);

/// With each map that is added every array of the container grows at its end alone.
Finding appends(const DagSubject& s, const Scene& scene);

/// The arrays take at most 64 bits a map and, from level 3 on, the map's own; and a map that is there 64 bits alone.
Finding is_bounded(const DagSubject& s, const Scene& scene);

/// Maps that are the same have the same record, and others do not.  Domain: pairs.
Finding same_records(const DagSubject& s, const Scene& scene);

/// Each string made of the scene's container, cut, longer or changed, its checksum put right, is taken exactly where the
/// specification takes it, and as the same maps.  `every`: every cut and every flip of a bit; else `most` of many kinds.
/// Strings that announce maps of levels 9 to 12 are left out.  Domain: levels up to 8.
Finding damage(const DagSubject& s, const Scene& scene, bool every, std::uint64_t most);

}  // namespace mmverify::proofs::dag
