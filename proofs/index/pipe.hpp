// The cases of a level as text, for implementations in any language, and the judgement of their answers.
#pragma once

#include <cstdio>
#include <istream>

#include "proofs/engine/law.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Writes the representatives of a level's cells, one a line: "CASE U V", CASE counting from 0, U and V
/// hexadecimal floats that are exact in binary32.  The first line starts with # and says the level and the
/// number of cases. False where `out` no longer takes anything.
bool generate_cases(Level n, bool interiors_only, std::FILE* out);

/// Writes the indices of a level, one a line, "CASE INDEX", which are the same, for programs that give corners.
bool generate_indices(Level n, std::FILE* out);

/// What the answers of a level come to.
struct Answered {
  Result result;                       ///< law index.equals_reference, subject "standard input"
  std::vector<std::string> diagnosis;  ///< where refuted
};

/// Reads answers, one a line: "CASE INDEX", in the order of the cases, INDEX decimal or 0x hexadecimal.
/// Empty lines and lines that start with # are passed over.  Throws pipe::BadAnswers; the answers are judged as
/// they come, in memory that does not grow with the level, but for the diagnosis of levels up to 8.
Answered check_answers(Level n, bool interiors_only, std::size_t errors, std::istream& in);

/// The same of corners: "CASE I0 J0 I1 J1 I2 J2", in units of 1/2^n along u and v, in any order; law index.corners.  The
/// diagnosis names the order, right or wrong.  24 bytes of memory an index.
Answered check_corners(Level n, std::size_t errors, std::istream& in);

}  // namespace mmverify::proofs::index
