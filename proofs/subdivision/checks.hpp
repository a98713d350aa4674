// The checks of topic subdivision, of one case each.
#pragma once

#include "proofs/subdivision/cases.hpp"

namespace mmverify::proofs::subdivision {

/// The index is the specification's.
Finding index_is_specified(const SubdivisionSubject& s, const Placed& at);
/// One cell of the level alone, as the specification has them, has the point by the tie rule: the one with this index.
Finding in_one_cell(const SubdivisionSubject& s, const Placed& at);
/// The index on the level before is this one without its last digit.
Finding nested(const SubdivisionSubject& s, const Placed& at);
/// The index on the curve of opacity micromaps, in rationals, and the corners of that index.  Domain: triangle_4.
Finding is_micromaps(const SubdivisionSubject& s, const Placed& at);

/// The corners are the specification's.
Finding corners_are_specified(const SubdivisionSubject& s, const Indexed& at);
/// Points inside the cell with these corners have its index: so no two indices are of one cell.
Finding inverse(const SubdivisionSubject& s, const Indexed& at);
/// The cell shares a facet with the next one, or, after the digits that break, a point alone.
Finding contiguous(const SubdivisionSubject& s, const Indexed& at);

/// The children's own order breaks as often as the best order of them.
Finding fewest_breaks(const SubdivisionSubject& s, Scheme scheme);
/// Just dimension + 1 cells of a simplex have one neighbour beyond a facet.
Finding dead_ends(const SubdivisionSubject& s, Scheme scheme, Level n);

/// The steps of the induction over the orientations of a scheme.
Finding all_levels(const SubdivisionSubject& s, Scheme scheme);
/// The edges 01, 12, 23 of each orientation are the unit tetrahedron's, in some order: six, in pairs of mirror images.
Finding three_shapes(const SubdivisionSubject& s);

}  // namespace mmverify::proofs::subdivision
