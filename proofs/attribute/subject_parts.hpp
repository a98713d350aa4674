// What the built-in subjects have of each part of the topic: the specification's functions, and the library's.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

Orders specified_orders();

Baking specified_baking();
Baking library_baking();

}  // namespace mmverify::proofs::attribute
