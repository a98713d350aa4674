// What a subject of topic attribute may have of edge decimation.
#pragma once

namespace mmverify::proofs::attribute {

struct Decimation {};

}  // namespace mmverify::proofs::attribute
