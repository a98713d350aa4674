// The laws of topic array, and its subjects.
#pragma once

#include "proofs/array/subject.hpp"

namespace mmverify::proofs::array {

/// Every law of the topic, in the order in which `list` and `prove` have them.
std::vector<Law> laws();

/// Builders: what triangles resolve to, formats, special indices, both histograms, sharing.
std::vector<Law> build_laws();
/// Builders on maps with one state that differs, which shows the order of the states.
std::vector<Law> order_laws();
/// Near-duplicate merging.
std::vector<Law> merge_laws();
/// Codes: special indices, base triangle, range.
std::vector<Law> index_laws();
/// Changes: compact, reorder, concatenate.
std::vector<Law> change_laws();
/// Files.
std::vector<Law> file_laws();
/// Devices: emulated levels, DGF's palettes.
std::vector<Law> device_laws();

}  // namespace mmverify::proofs::array
