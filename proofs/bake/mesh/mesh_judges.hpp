// Checks of a mesh's array: each asks a subject for one mesh, or for it in several ways.
#pragma once

#include "proofs/bake/law_parts.hpp"
#include "proofs/bake/truth/denial.hpp"

namespace mmverify::proofs::bake {

using MeshCheck = Finding (*)(const BakeSubject&, const MeshCase&);

Finding mesh_is_conservative(const BakeSubject&, const MeshCase&);
Finding mesh_is_tight(const BakeSubject&, const MeshCase&);
Finding mesh_is_as_alone(const BakeSubject&,
                         const MeshCase&);  ///< each triangle beside a mesh of itself alone
Finding mesh_in_both_formats(const BakeSubject&, const MeshCase&);
Finding mesh_has_records(const BakeSubject&, const MeshCase&);  ///< their formats, levels, bytes and users
Finding mesh_has_counts(const BakeSubject&, const MeshCase&);

/// The first triangle with a denied state, as picture() of proofs/bake/diagnosis/diagnosis.hpp draws it, or the first one.
std::string drawn_mesh(const BakeSubject&, const MeshCase&, Denies denies);

}  // namespace mmverify::proofs::bake
