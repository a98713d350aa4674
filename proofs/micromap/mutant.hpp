// A subject with one thing broken on purpose: what a law's mutants are made of.
#pragma once

#include <functional>

#include "proofs/micromap/subject.hpp"

namespace mmverify::proofs::micromap {

/// What is changed in an answer; an empty function leaves the entry point alone.  Level and format are those
/// of the input.
struct Change {
  using OnBytes = std::function<void(Level, Format, std::span<const std::uint8_t> in, Bytes& out)>;
  std::function<void(Format, const States& in, Bytes& out)> pack = {};
  std::function<void(Format, States& out)> unpack = {};
  OnBytes force2 = {}, widen = {}, up = {}, down = {}, substitute = {};
  std::function<void(Level, Mode, std::span<const std::uint8_t> in, Bytes& out)> through = {};
  std::function<void(State, Encoding, std::uint32_t& code)> special_code = {};
  std::function<void(std::uint32_t code, Encoding, Meaning& meaning)> meaning = {};
  std::function<void(Level, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is, Kept&)>
      judge = {};
  std::function<void(std::span<const PackedMap>, Options&)> build_input = {};
  std::function<void(std::span<const PackedMap>, const Options&, Built&)> build = {};
  std::function<void(const Input&, std::vector<Violation>&)> validate = {};
};

/// The built-in subject `base` but for the change.
Mutant mutant(std::string name, const std::string& base, Levels levels, const Change& change);

}  // namespace mmverify::proofs::micromap
