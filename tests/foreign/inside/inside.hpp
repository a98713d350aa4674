// Subjects of another hand for laws that no shared library reaches: each is written from the law's statement,
// the papers and the interface header alone, and is right, or right but for one fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::tests::foreign {

/// A fault by its name, as a number: faults are asked for in inner loops.  A right subject has a name that no fault has.
enum class Fault : std::uint64_t { none };
/// The FNV-1a hash of a name.
constexpr Fault named(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return static_cast<Fault>(hash);
}
consteval Fault operator""_fault(const char* name, std::size_t length) { return named({name, length}); }

struct InsideFault {
  const char *law, *name, *wrong;  ///< id; an identifier; what is wrong in a sentence, empty for a right one
  proofs::SubjectPtr subject;
  proofs::Levels levels;  ///< refuted within these; a right one passes at all of them
};
using InsideRows = std::vector<InsideFault>;

// One pair a source.
InsideRows inside_faults_of_index();
InsideRows inside_right_of_index();
InsideRows inside_faults_of_provers();
InsideRows inside_right_of_provers();
InsideRows inside_faults_of_micromap();
InsideRows inside_right_of_micromap();
InsideRows inside_faults_of_tree();
InsideRows inside_right_of_tree();
InsideRows inside_faults_of_rays();
InsideRows inside_right_of_rays();
InsideRows inside_faults_of_vq();
InsideRows inside_right_of_vq();

}  // namespace mmverify::tests::foreign
