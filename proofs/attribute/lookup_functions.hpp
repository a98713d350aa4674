// What a subject of topic attribute may have of lookups: a point's triplet and weights, and values between vertices.
#pragma once

namespace mmverify::proofs::attribute {

struct Lookup {};

}  // namespace mmverify::proofs::attribute
