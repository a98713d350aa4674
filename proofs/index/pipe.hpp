// The cases of a level as text, for implementations in any language, and the judgement of their answers.
#pragma once

#include <cstdio>
#include <istream>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Writes the representatives of a level's cells, one a line, "CASE U V".  CASE counts from 0; U and V are
/// hexadecimal floats that are exact in binary32.  The first line starts with # and has the level and the number of
/// cases.  False if `out` no longer accepts lines.
bool generate_cases(Level n, bool interiors_only, std::FILE* out);

/// Writes the indices of a level, one a line, "CASE INDEX" with equal numbers, for programs that give corners.
bool generate_indices(Level n, std::FILE* out);

/// The judgement of the answers of a level.
struct Answered {
  Result result;                       ///< law index.equals_reference, subject "standard input"
  std::vector<std::string> diagnosis;  ///< if refuted
};

/// Reads answers, one a line, "CASE INDEX", in the order of the cases, INDEX decimal or 0x hexadecimal.  Skips empty
/// lines and lines that start with #.  Throws pipe::BadAnswers.  Judges the answers as they arrive; memory does not
/// grow with the level, except for the diagnosis of levels up to 8.
Answered check_answers(Level n, bool interiors_only, std::size_t errors, std::istream& in);

/// Reads corners, "CASE I0 J0 I1 J1 I2 J2", in units of 1/2^n along u and v, in any order, and judges them by law
/// index.corners.  The diagnosis names the order, right or wrong.  Memory: 24 bytes an index.
Answered check_corners(Level n, std::size_t errors, std::istream& in);

}  // namespace mmverify::proofs::index
