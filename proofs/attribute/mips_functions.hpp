// What a subject of topic attribute may have of mip chains and levels of detail.
#pragma once

namespace mmverify::proofs::attribute {

struct Mips {};

}  // namespace mmverify::proofs::attribute
