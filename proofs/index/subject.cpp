#include "proofs/index/subject.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace mmverify::proofs::index {
namespace {
[[noreturn]] void absent(const IndexSubject& s, const char* entry) {
  throw std::logic_error(fmt::format("{} has no entry point {}", s.name(), entry));
}
}  // namespace

std::string to_string(Arithmetic a) {
  switch (a) {
    case Arithmetic::exact:
      return "exact";
    case Arithmetic::binary16:
      return "binary16";
    case Arithmetic::binary32:
      return "binary32";
    case Arithmetic::binary64:
      return "binary64";
  }
  return "?";
}

void IndexSubject::index(Level, Batch, std::span<std::uint32_t>) const { absent(*this, "index"); }
void IndexSubject::index(Level, FloatBatch, std::span<std::uint32_t>) const { absent(*this, "index"); }
std::uint32_t IndexSubject::index(Level, const RationalPoint&) const { absent(*this, "index"); }
void IndexSubject::corners(Level, std::span<const std::uint32_t>, std::span<Corners>) const {
  absent(*this, "corners");
}
void IndexSubject::row_index(Level, Batch, std::span<std::uint32_t>) const { absent(*this, "row_index"); }
void IndexSubject::row_corners(Level, std::span<const std::uint32_t>, std::span<Corners>) const {
  absent(*this, "row_corners");
}

}  // namespace mmverify::proofs::index
