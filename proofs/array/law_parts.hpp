// Common parts of the laws of topic array: sources, cases, checks, mutants.
#pragma once

#include "proofs/array/answers.hpp"
#include "proofs/engine/spoils.hpp"

namespace mmverify::proofs::array {

inline constexpr char array_source[] =
    "VkMicromapBuildInfoEXT, VkAccelerationStructureGeometryMicromapDataKHR; DXR, Opacity Micromaps; "
    "docs/ARRAYS.md";
inline constexpr char indices_source[] =
    "VkAccelerationStructureTrianglesOpacityMicromapEXT; EXT_mesh_opacity_micromap, Lookup; docs/ARRAYS.md";
inline constexpr char counts_source[] =
    "VkMicromapUsageEXT; DXR 1.28, OPACITY_MICROMAP_HISTOGRAM_ENTRY; OptiX, OptixOpacityMicromapUsageCount";
inline constexpr char here[] = "this project's definition, docs/ARRAYS.md";

using Cases = CasesOf<ArraySubject>;

/// The law on numbered cases, at levels `fast.first` to `long_run.last`.
Law on_cases(Law law, std::vector<Entry> entries, Cases cases);

/// A check of a builder's complete answer.
using Check = Finding (*)(const Answer&, const BuildCase&);

/// Calls the subject's builder and checks its answer, for maps in either order in memory if it gets their places.
Finding built(const ArraySubject& s, BuildCase c,
              const std::function<Finding(const Answer&, const BuildCase&)>& check);

/// The law on all small arrays.
Law on_small_arrays(Law law, Check check);

/// Cases that are arrays to build, by number; `check` judges what a builder answers.
Cases built_cases(CaseCount count, std::function<BuildCase(Level, std::uint64_t k)> number, Check check,
                  std::uint64_t chunk = 256);
/// Cases that are samples of a seed, by number; `check` draws them.
using SampleCheck = Finding (*)(const ArraySubject&, Level, std::uint64_t seed, std::uint64_t k);
Cases drawn_cases(CaseCount count, SampleCheck check, std::uint64_t chunk);

/// Mutants of a builder: `spoil` changes its answer, `change` its case.
std::function<void(Functions&)> answering(void (*spoil)(const BuildCase&, Answer&));
std::function<void(Functions&)> building(void (*change)(BuildCase&));

/// Reads and writes index t of an answer.
std::uint32_t code_of(const Answer& a, const BuildCase& c, std::size_t t);
void set_code(Answer& a, const BuildCase& c, std::size_t t, std::uint32_t code);

}  // namespace mmverify::proofs::array
