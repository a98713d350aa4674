// A codec of the paper's trees on a pipe: its questions and answers as lines of text.
#pragma once

#include "proofs/pipe/questions.hpp"

namespace mmverify::proofs::tree {

/// "encode LEVEL FORMAT MAP" is answered by the code, "decode LEVEL FORMAT CODE" by the map, or - where nobody encodes
/// a map so; FORMAT is the bits of a state, 1 or 2; maps and codes are packed as subjects/sdk/mmverify_subject.h has them, the
/// codes with MMVERIFY_TREE_STREAM.
extern const pipe::Dialogue dialogue;

}  // namespace mmverify::proofs::tree
