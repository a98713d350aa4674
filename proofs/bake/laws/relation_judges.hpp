// How the maps of one texture fit together: each function bakes one case in several ways and compares.
#pragma once

#include "proofs/bake/law_parts.hpp"

namespace mmverify::proofs::bake {

/// The subject declined one of the cases.
struct Declined {};
/// The bits after the last state are not all zero.
struct Unpadded {};

/// The map, or an end of the check.  Throws Declined and Unpadded.
std::vector<State> map_of(const BakeSubject& s, const Case& one, Level n, Format format = Format::four_state);

/// The law on cases of which `holds` compares whole maps; it may throw Declined and Unpadded.
Law on_maps(Law law, const Cases& cases, Finding (*holds)(const BakeSubject&, const Case&, Level),
            const Lacks& lacks);

// All throw Declined and Unpadded.
Finding keeps_shifts(const BakeSubject&, const Case&, Level);    ///< by whole repeats
Finding keeps_lengths(const BakeSubject&, const Case&, Level);   ///< legs longer by whole repeats
Finding keeps_orders(const BakeSubject&, const Case&, Level);    ///< of the vertices
Finding keeps_formats(const BakeSubject&, const Case&, Level);   ///< 2-state beside 4-state
Finding keeps_levels(const BakeSubject&, const Case&, Level);    ///< children beside parents
Finding keeps_cutoffs(const BakeSubject&, const Case&, Level);   ///< rising ones
Finding keeps_margins(const BakeSubject&, const Case&, Level);   ///< wider ones
Finding keeps_no_other(const BakeSubject&, const Case&, Level);  ///< question in mind, one thing apart
Finding keeps_mips(const BakeSubject&, const Case&, Level);      ///< all together beside each alone

/// One for each thing that a question has besides its texels.
std::vector<Mutant> forgetful_mutants();

}  // namespace mmverify::proofs::bake
