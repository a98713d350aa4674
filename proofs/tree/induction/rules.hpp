// The turns of Algorithms 1, 2 and 3, so that a mutant can have one of them wrong: as the specification has
// them, here.
#pragma once

#include "spec/tree/tree.hpp"

namespace mmverify::proofs::tree::induction {

using spec::tree::Cursor;

struct Specified {
  template <class Child>
  static Child merged(const Child* child) {
    return spec::tree::merged(child);
  }
  template <class Stack, class Output>
  static bool succinct_turn(Stack& stack, Output& s) {
    return spec::tree::succinct_turn(stack, s);
  }
  template <class Tree, class Count>
  static bool bitscan_turn(const Tree& tree, Count& child, Cursor<Count>& at) {
    return spec::tree::bitscan_turn(tree, child, at);
  }
  template <class Sequences, class Count, class NextChild>
  static bool lookup_turn(const Sequences& s, Cursor<Count>& at, NextChild& next_child) {
    return spec::tree::lookup_turn(s, at, next_child);
  }
};

}  // namespace mmverify::proofs::tree::induction
