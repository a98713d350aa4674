// A baker on a pipe: its questions and answers as lines of text.
#pragma once

#include "proofs/pipe/questions.hpp"

namespace mmverify::proofs::bake {

/// "LEVEL FORMAT CASE" is answered by the map, packed as subjects/sdk/mmverify_subject.h has it, or - where the case is not
/// supported; FORMAT is the bits of a state, 1 or 2; CASE is a text as text_of of case.hpp writes it, its texels all
/// there.
extern const pipe::Dialogue dialogue;

}  // namespace mmverify::proofs::bake
