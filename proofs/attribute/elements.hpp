// The vertices and the faces of a level by number, and how cases name them.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Vertices are numbered column by column, i = 0 first, each from j = 0 on.  Writes those from `first` on.
/// Domain: first + out.size() <= V(n).
void fill(Level n, std::uint64_t first, std::span<Vertex> out);

/// Faces are numbered strip by strip, iu = 0 first, each from iv = 0 on, a square's lower one before its upper one.
/// Domain: first + out.size() <= 4^n.
void fill(Level n, std::uint64_t first, std::span<MicroTriangle> out);

/// "i=3,j=4", "iu=3,iv=4,lower".
std::string text_of(const Vertex& at);
std::string text_of(const MicroTriangle& at);

/// The element of a text.  Throws BadCase where it is none of the level.
void read(Level n, const std::string& text, Vertex& at);
void read(Level n, const std::string& text, MicroTriangle& at);

/// "w-minor", "u-major", "bird"; "curve", "rows", "u-major".
const char* name_of(VertexOrder order);
const char* name_of(FaceOrder order);

}  // namespace mmverify::proofs::attribute
