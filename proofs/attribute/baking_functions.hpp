// What a subject of topic attribute may have of baking from textures.
#pragma once

namespace mmverify::proofs::attribute {

struct Baking {};

}  // namespace mmverify::proofs::attribute
