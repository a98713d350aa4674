/* Laws of the two sequences of impl/tree, from level to level.  LEVEL: of the map.
 *
 * The functions of impl/tree/recursion.hpp see the sequences through BitWriter::put, BitReader::peek and within_byte, and
 * bit_at.  The steps `step_of_put` and `step_of_bits` show that these write and read the bits at any place of memory of
 * any size.  The other steps take them by that contract, and show for an internal node with SIZE levels below, given the
 * same for its children:
 *   write_node appends 4 j + 1 nodes, the first a 1, and 3 j + 1 leaves, j being the number of its internal nodes;
 *   from these bits, wherever they are, read_node makes its states and changes no others, a loop of pass_one moves over
 *   the node, and find_leaf finds a leaf with the state at any index.
 * Sixteen states, SIZE 2, are run as they are.  The map is a whole one, any, and Pyramid's answers are the library's. */
#define WATCHES 7
#include <stdlib.h>
#include <string.h>

#include <new>
extern "C" {
#include "proofs/codecs/contract.h"
}
#include "impl/tree/recursion.hpp"

namespace {

namespace impl = mmverify::impl::tree::detail;
using impl::BitReader, impl::BitWriter, impl::Pyramid, impl::SequenceReader, impl::SequenceWriter;
using mmverify::impl::tree::Format, mmverify::impl::tree::Level;

constexpr Level depth = LEVEL - SIZE;
constexpr bool sixteen = SIZE == 2;

/// Member functions by their names in bitcode.
void put(BitWriter*, uint64_t, uint32_t) asm("_ZN8mmverify4impl4tree6detail9BitWriter3putEmj");
uint64_t peek(const BitReader*) asm("_ZNK8mmverify4impl4tree6detail9BitReader4peekEv");
uint32_t within_byte(const BitReader*,
                     uint32_t) asm("_ZNK8mmverify4impl4tree6detail9BitReader11within_byteEj");
uint64_t place(const BitReader*) asm("_ZNK8mmverify4impl4tree6detail9BitReader5placeEv");
uint32_t children(const Pyramid*, Level, uint64_t) asm("_ZNK8mmverify4impl4tree6detail7Pyramid8childrenEjm");

/* ---- the node at hand */

/// The map, and its flags.
uint8_t states[MAP_BYTES];
const Pyramid* pyramid;
/// The node's number in its depth; which of its children are internal; their places, from the node's own on.
size_t node_number;
int internal[4];
/// A byte of the map, any.
size_t asked_byte;
uint8_t asked_states;
/// The state at asked_index of the node, any, and its leaf.
uint32_t asked_state;
size_t asked_leaf;

int is_internal(Level d, size_t k) { return (int)(pyramid->mixed(d)[k / 64] >> k % 64 & 1); }

/// Any length of a child: it has `count` internal nodes.
Place any_length_of(int is_internal_child) {
  constexpr size_t most = (((size_t)1 << 2 * (SIZE - 1)) - 1) / 3;
  size_t count = (size_t)is_internal_child;
  if (!sixteen && is_internal_child) {
    count = any(2 * SIZE);
    assume(count >= 1 && count <= most);
  }
  return {4 * count + 1, 3 * count + 1};
}

/// Nothing changes the map and its flags.
void make_only_read(const Pyramid& flags) {
  only_read(states);
  only_read(&flags);
  only_read(flags.mixed(0).data());
}

/// Any internal node of any map.
void any_node(const Pyramid& flags) {
  pyramid = &flags;
  const size_t index = any_below(STATES);
  asked_state = state_of(states, FORMAT, index);
  asked_index = index % INSIDE;
  node_number = index / INSIDE;
  first_state = node_number * INSIDE;
  assume(is_internal(depth, node_number));
  asked_byte = any_below(MAP_BYTES);
  asked_states = states[asked_byte];
}

/// Its children, of any length.  `which`: bit c is set if child c is internal.
void place_children(uint32_t which) {
  parts = 4;
  part_level = SIZE - 1;
  end = {1, 0};
  for (uint32_t c = 0; c < 4; ++c) {
    internal[c] = (int)(which >> c & 1);
    part[c].length = any_length_of(internal[c]);
    part[c].at = end;
    move_over(&end, part + c);
  }
}

/* ---- the sequences at hand: the bits that were appended, from the node's own place on */

/// Sixteen states: all bits.
uint64_t tree_word, data_word;
/// More of them: of a child that is a leaf, its node and its state.
uint32_t leaf_node[4], leaf_state[4];
/// The writer, and the next node and leaf, which its two parts hold as their words: who copies a part copies them.
SequenceWriter* writer;
Place next;

uint32_t child_at_node(size_t node) {
  for (uint32_t c = 0; c < 4; ++c)
    if (node == part[c].at.nodes) return c;
  check(0);
  return 0;
}

uint32_t child_at_leaf(size_t leaf) {
  for (uint32_t c = 0; c < 4; ++c)
    if (leaf == part[c].at.leaves && !internal[c]) return c;
  check(0);
  return 0;
}

/// A node's bit, by its place from the node at hand on.
uint32_t node_at(size_t node) {
  if (sixteen) {
    check(node < end.nodes);
    return tree_word >> node & 1;
  }
  if (node == 0) return 1;
  const uint32_t c = child_at_node(node);
  return internal[c] ? 1 : leaf_node[c];
}

/// A leaf's state, likewise.
uint32_t leaf_at(size_t leaf) {
  if (sixteen) {
    check(leaf < end.leaves);
    return data_word >> leaf * FORMAT & ((1u << FORMAT) - 1);
  }
  return leaf_state[child_at_leaf(leaf)];
}

void append(BitWriter* to, uint64_t value, uint32_t count) noexcept {
  check(to == &writer->tree || to == &writer->data);
  check(count <= 56 && value >> count == 0);
  const bool nodes = to == &writer->tree;
  size_t& at = nodes ? next.nodes : next.leaves;
  check(to->word_ == at);
  if (sixteen) {
    check((nodes ? at : at * FORMAT) + count <= 56);
    (nodes ? tree_word : data_word) |= value << (nodes ? at : at * FORMAT);
  } else if (nodes && at == 0) {
    check(value == 1);
  } else if (nodes) {
    leaf_node[child_at_node(at)] = (uint32_t)value;
  } else {
    leaf_state[child_at_leaf(at)] = (uint32_t)value;
  }
  check(sixteen || count == (nodes ? 1 : FORMAT));
  at += nodes ? count : count / FORMAT;
  to->word_ = at;
}

/* ---- reading them, at any place of sequences of any length */

/// The reader, whose places are those from the node's own on.
SequenceReader* reader;
/// Nodes of the whole sequence.
size_t all_nodes;
uint8_t* tree_memory;

bool is_tree(const BitReader* from) {
  check(from == &reader->tree || from == &reader->data);
  return from == &reader->tree;
}

uint64_t place_in_tree(const BitReader* from) noexcept {
  check(is_tree(from));
  return start.nodes + from->place_;
}

/// All bits that a reader may see: behind the node they may be any.
uint64_t peek_at(const BitReader* from) noexcept {
  const bool nodes = is_tree(from);
  const size_t at = from->place_, bits = nodes ? end.nodes : end.leaves * FORMAT;
  check(sixteen && at < bits);
  return ((nodes ? tree_word : data_word) | any(64) << bits) >> at;
}

uint32_t read_within_byte(const BitReader* from, uint32_t count) noexcept {
  const bool nodes = is_tree(from);
  check(count == (nodes ? 1 : FORMAT) && from->place_ % count == 0);
  return nodes ? node_at(from->place_) : leaf_at(from->place_ / FORMAT);
}

bool read_bit(const uint8_t* bytes, uint64_t k) noexcept {
  check(bytes == tree_memory && k < all_nodes);
  return node_at(k - start.nodes) != 0;
}

/* ---- a child, by contract */

/// The memory of the writer and of the reader: what stands for each access needs none.
uint8_t nowhere[16];
/// Bytes that the reader is told of.
size_t told_tree, told_data;

/// Each field is named, so that a class with one more is not judged.
int same_writer(const BitWriter& a, const BitWriter& b) {
  const auto& [bytes, used, word] = a;
  const auto& [bytes_2, used_2, word_2] = b;
  return bytes == bytes_2 && used == used_2 && word == word_2;
}
int same_reader(const BitReader& from, const uint8_t* memory, size_t size, size_t at) {
  const auto& [bytes, place] = from;
  return bytes.data() == memory && bytes.size() == size && place == at;
}
[[maybe_unused]] void require_no_more_fields(const SequenceWriter& to, const SequenceReader& from,
                                             const Pyramid& flags, const impl::Place& at) {
  const auto& [w1, w2, w3, w4, w5, w6] = to;
  const auto& [r1, r2, r3, r4, r5, r6, r7] = from;
  const auto& [p1, p2, p3, p4, p5] = flags;
  const auto& [a1, a2] = at;
}

int is_part(const BitWriter& to, const uint8_t* memory, size_t at) {
  const auto& [bytes, used, word] = to;
  return bytes == memory && used == 0 && word == at;
}

int is_whole(const SequenceWriter& to) {
  return &to == writer && to.n == LEVEL && to.b == FORMAT && &to.pyramid == pyramid &&
         to.map.data() == states && to.map.size() == MAP_BYTES && is_part(to.tree, nowhere, next.nodes) &&
         is_part(to.data, nowhere + 8, next.leaves);
}

int is_whole(const SequenceReader& from, size_t node, size_t leaf) {
  return &from == reader && from.n == LEVEL && from.b == FORMAT && from.nodes == all_nodes &&
         from.map == out && !from.fault && same_reader(from.tree, nowhere, told_tree, node) &&
         same_reader(from.data, nowhere + 8, told_data, leaf * FORMAT);
}

void write_child(SequenceWriter& to, Level d, uint64_t k) noexcept {
  check(is_whole(to) && d == depth + 1 && k / 4 == node_number && internal[k % 4]);
  Subtree* p = part + k % 4;
  check(same_place(&next, &p->at));
  p->written = 1;
  next = end_of(p);
  to.tree.word_ = next.nodes;
  to.data.word_ = next.leaves;
}

bool read_child(SequenceReader& from, Level d, uint64_t bit) noexcept {
  const size_t inside = states_of_part(), first = bit / FORMAT, c = first / inside % 4;
  const Subtree* p = part + c;
  check(is_whole(from, p->at.nodes + 1, p->at.leaves));
  check(d == depth + 1 && bit % FORMAT == 0 && first == first_state + c * inside);
  check(internal[c] && p->written);
  if (in(asked_byte, first * FORMAT / 8, (first + inside) * FORMAT / 8)) {
    check(out[asked_byte] == 0);
    out[asked_byte] = asked_states;
  }
  from.tree.place_ += p->length.nodes - 1;
  from.data.place_ += p->length.leaves * FORMAT;
  return true;
}

/// The child at a place.
uint32_t child_at(const uint8_t* bytes, uint64_t nodes, const impl::Place& at) {
  check(bytes == tree_memory && nodes == all_nodes);
  const uint32_t c = child_at_node(at.node - start.nodes);
  check(at.leaf - start.leaves == part[c].at.leaves);
  check(internal[c] ? part[c].written : !leaf_node[c]);
  return c;
}

/// All steps over a child at once.
bool pass_child(const uint8_t* bytes, uint64_t nodes, impl::Place& at, uint64_t& to_come) noexcept {
  const uint32_t c = child_at(bytes, nodes, at);
  at = {at.node + part[c].length.nodes, at.leaf + part[c].length.leaves};
  --to_come;
  return true;
}

bool find_child(const uint8_t* bytes, uint64_t nodes, Level levels, uint64_t index,
                impl::Place& at) noexcept {
  check(levels == part_level);
  const uint32_t c = child_at(bytes, nodes, at);
  check(c == asked_index / states_of_part() && index % states_of_part() == asked_index % states_of_part());
  at = {any(64), internal[c] ? start.leaves + asked_leaf : at.leaf};
  return true;
}

void by_contract() {
  stands_for((const void*)put, (const void*)append);
  stands_for((const void*)peek, (const void*)peek_at);
  stands_for((const void*)place, (const void*)place_in_tree);
  stands_for((const void*)within_byte, (const void*)read_within_byte);
  stands_for((const void*)impl::bit_at, (const void*)read_bit);
  if (sixteen) return;
  stands_for((const void*)impl::write_node, (const void*)write_child);
  stands_for((const void*)impl::read_node, (const void*)read_child);
  stands_for((const void*)impl::pass_one, (const void*)pass_child);
  stands_for((const void*)impl::find_leaf, (const void*)find_child);
}

/* ---- the steps of a node */

/// Which children are internal, while that is known.
uint32_t known_children;

uint32_t answer_known_children(const Pyramid* flags, Level d, uint64_t k) {
  check(flags == pyramid && d == depth + 1 && k == node_number);
  return known_children;
}

/// Runs a step on any internal node of any map.  Of sixteen states, each choice of internal children is a run of its own,
/// in which the code has a known shape.
template <class Step>
void on_any_node(Step step) {
  any_map(LEVEL, FORMAT, states);
  const Pyramid flags(LEVEL, Format(FORMAT), {states, MAP_BYTES});
  any_node(flags);
  make_only_read(flags);
  const uint32_t which = flags.children(depth + 1, node_number);
  by_contract();
  if (!sixteen) {
    place_children(which);
    step();
    return;
  }
  stands_for((const void*)children, (const void*)answer_known_children);
  for (known_children = 0; known_children < 16; ++known_children)
    if (which == known_children) {
      place_children(known_children);
      step();
      return;
    }
}

void write_the_node() {
  SequenceWriter to{*pyramid, {states, MAP_BYTES}, LEVEL, FORMAT, BitWriter(nowhere), BitWriter(nowhere + 8)};
  writer = &to;
  next = {0, 0};
  impl::write_node(to, depth, node_number);
  check(is_whole(to) && same_place(&next, &end));
  check(!sixteen || (tree_word & 1) == 1);
}

/// Any place that it is read from.
void any_place_of_node() {
  start = {any(PLACE_BITS), any(PLACE_BITS)};
  all_nodes = any(PLACE_BITS);
  assume(all_nodes >= start.nodes + end.nodes);
}

int is_inside(size_t byte) { return in(byte, first_state * FORMAT / 8, (first_state + INSIDE) * FORMAT / 8); }

void the_reading() {
  write_the_node();
  any_place_of_node();
  out = watched_memory(MAP_BYTES, &asked_byte, 1);
  if (is_inside(asked_byte)) out[asked_byte] = 0;
  const uint8_t before = out[asked_byte];
  told_tree = any(PLACE_BITS), told_data = any(PLACE_BITS);
  SequenceReader from{
      LEVEL, FORMAT, BitReader({nowhere, told_tree}, 1), BitReader({nowhere + 8, told_data}), all_nodes,
      out,   {}};
  reader = &from;
  check(impl::read_node(from, depth, first_state * FORMAT));
  check(is_whole(from, end.nodes, end.leaves));
  check(out[asked_byte] == (is_inside(asked_byte) ? asked_states : before));
}

void the_finding() {
  write_the_node();
  any_place_of_node();
  uint8_t memory;
  tree_memory = &memory;
  asked_leaf = any(PLACE_BITS);
  const size_t c = asked_index / states_of_part();
  const int by_child = !sixteen && internal[c];
  assume(!by_child || in(asked_leaf, part[c].at.leaves, end_of(part + c).leaves));
  impl::Place at = {start.nodes, start.leaves};
  const uint64_t index = asked_index | any(PLACE_BITS) << 2 * SIZE;  // its low bits count
  check(impl::find_leaf(tree_memory, all_nodes, SIZE, index, at));
  const size_t leaf = at.leaf - start.leaves;
  check(leaf < end.leaves);
  if (by_child)
    check(leaf == asked_leaf);
  else
    check(leaf_at(leaf) == asked_state);
}

/// A node's bit, any, where pass_one or find_leaf is.
uint32_t any_bit;
bool read_any_bit(const uint8_t* bytes, uint64_t k) noexcept {
  check(bytes == tree_memory && k == start.nodes);
  return any_bit;
}

unsigned uniform_state(size_t first, size_t count, int* is_uniform) {
  const unsigned state = state_of(states, FORMAT, first);
  int same = 1;
  for (size_t k = 1; k < count; ++k) same &= state_of(states, FORMAT, first + k) == state;
  *is_uniform = same;
  return state;
}

/// Algorithm 2: a node's bit, then its leaf or its four children.
void the_writing() {
  write_the_node();
  const size_t inside = states_of_part();
  uint64_t nodes = 1, leaves = 0;
  for (uint32_t c = 0; c < 4; ++c) {
    const size_t first = first_state + c * inside;
    int is_uniform;
    const unsigned state = uniform_state(first, inside, &is_uniform);
    check(is_uniform == !internal[c]);
    if (!sixteen) {
      check(internal[c] ? part[c].written : leaf_node[c] == 0 && leaf_state[c] == state);
      continue;
    }
    nodes |= (uint64_t)internal[c] << part[c].at.nodes;
    for (size_t k = 0; k < part[c].length.leaves; ++k)
      leaves |= (uint64_t)state_of(states, FORMAT, first + k) << (part[c].at.leaves + k) * FORMAT;
  }
  check(!sixteen || (tree_word == nodes && data_word == leaves));
}

/* ---- the entry points, given the contract of the root */

int root_is_internal;
/// The library's own sequences, from which the code is copied.
Sequence made_tree, made_data;
/// The indices that are looked up, and a leaf of each one's state.
enum { ASKED = 3 };
size_t lookup_index[ASKED], lookup_leaf[ASKED];
unsigned lookup_state[ASKED];

/// Memory for Pyramid, then for either sequence.
unsigned asked_memory;
void* given[3];
void* new_memory(size_t size) {
  const unsigned which = asked_memory++;
  if (which == 0) return given[0] = malloc(size);
  check(which < 3);
  Sequence* s = which == 1 ? &made_tree : &made_data;
  s->size = size;
  s->bytes = watched_memory(size, s->watch, WATCHES);
  return given[which] = s->bytes;
}
void delete_memory(void* p) {
  check(p == nullptr || p == given[0] || p == given[1] || p == given[2] || p == pyramid->mixed(0).data());
  free(p);
}

void watch_items(Sequence* s, uint32_t bits, size_t length) {
  s->bits = bits;
  s->item = any_below(2 * STATES);
  assume(s->item < length);
  for (size_t w = 0; w < WATCHES; ++w) s->watch[w] = 0;
  s->watch[1] = s->item * bits / 8;
  s->watch[2] = (length - 1) * bits / 8;
}

/// Any map, any length of its code, and what is watched of it.
void any_root(const Pyramid& flags) {
  pyramid = &flags;
  root_is_internal = is_internal(0, 0);
  const size_t count = flags.internal();
  part[0].length = {4 * count + 1, 3 * count + 1};
  part[0].at = {0, 0};
  tree_bytes = bytes_for(part[0].length.nodes, 1);
  code_size = tree_bytes + bytes_for(part[0].length.leaves, FORMAT);
  watch_items(&tree, 1, part[0].length.nodes);
  watch_items(&data, FORMAT, part[0].length.leaves);
  for (size_t k = 0; k < ASKED; ++k) {
    lookup_leaf[k] = any_below(2 * STATES);
    assume(lookup_leaf[k] < part[0].length.leaves);
    data.watch[3 + k] = lookup_leaf[k] * FORMAT / 8;
  }
  made_tree = tree;
  made_data = data;
}

void write_root(SequenceWriter& to, Level d, uint64_t k) noexcept {
  check(d == 0 && k == 0 && root_is_internal && to.n == LEVEL && to.b == FORMAT);
  check(to.map.data() == states && to.map.size() == MAP_BYTES);
  for (Level below = 1; below < LEVEL; ++below) {
    const size_t any_node = any_below((size_t)1 << 2 * (below - 1));
    check(to.pyramid.children(below, any_node) == pyramid->children(below, any_node));
    check(to.pyramid.first_states(below, any_node) == pyramid->first_states(below, any_node));
  }
  const Place last = part[0].length;
  check(same_writer(to.tree, BitWriter(made_tree.bytes, 0)));
  check(same_writer(to.data, BitWriter(made_data.bytes, 0)));
  check(made_tree.size >= bytes_for(last.nodes, 1) + 8);
  check(made_data.size >= bytes_for(last.leaves, FORMAT) + 8);
  check(item_of(&made_tree, made_tree.item) == 0 && item_of(&made_data, made_data.item) == 0);
  become_any(&made_tree, 0, last.nodes);
  become_any(&made_data, 0, last.leaves);
  assume(item_of(&made_tree, 0) == 1);
  for (size_t q = 0; q < ASKED; ++q) assume(item_of(&made_data, lookup_leaf[q]) == lookup_state[q]);
  part[0].node = item_of(&made_tree, made_tree.item);
  part[0].state = item_of(&made_data, made_data.item);
  part[0].written = 1;
  to.tree = BitWriter(made_tree.bytes, last.nodes);
  to.data = BitWriter(made_data.bytes, last.leaves * FORMAT);
}

void open_whole_code(size_t capacity) {
  size_t places[2 * WATCHES + 1];
  for (size_t w = 0; w < WATCHES; ++w) {
    places[w] = tree.watch[w];
    places[WATCHES + w] = tree_bytes + data.watch[w];
  }
  places[2 * WATCHES] = other;
  tree.bytes = watched_memory(capacity, places, 2 * WATCHES + 1);
  data.bytes = tree.bytes + (capacity < code_size ? 0 : tree_bytes);
  tree.size = tree_bytes;
  data.size = code_size - tree_bytes;
}

/// The code is the two sequences, each from a whole byte on, and zeros behind them.
void require_both_sequences() {
  const Place length = part[0].length;
  if (root_is_internal) {
    check(part[0].written);
    check(item_of(&tree, tree.item) == part[0].node && item_of(&data, data.item) == part[0].state);
  } else {
    check(length.nodes == 1 && item_of(&tree, 0) == 0 && item_of(&data, 0) == state_of(states, FORMAT, 0));
  }
  for (size_t k = length.nodes; k < 8 * tree_bytes; ++k) check(item_of(&tree, k) == 0);
  for (size_t k = length.leaves; k * FORMAT < 8 * (code_size - tree_bytes); ++k)
    check(item_of(&data, k) == 0);
}

void encoding_by_contract() {
  stands_for((const void*)impl::write_node, (const void*)write_root);
  stands_for((const void*)static_cast<void* (*)(size_t)>(operator new), (const void*)new_memory);
  stands_for((const void*)static_cast<void (*)(void*) noexcept>(operator delete), (const void*)delete_memory);
}

/// The code of any map, of exactly its size; from then on it is only read.
void encode_any(const Pyramid& flags) {
  any_root(flags);
  encoding_by_contract();
  other = any(PLACE_BITS);
  open_whole_code(code_size);
  check(codec()->tree_encode(LEVEL, FORMAT, states, tree.bytes, code_size) == code_size);
  only_read(tree.bytes);
}

/// All steps over the tree at once.
bool pass_root(const uint8_t* bytes, uint64_t nodes, impl::Place& at, uint64_t& to_come) noexcept {
  check(bytes == tree.bytes && nodes >= part[0].length.nodes && is_small(nodes));
  check(at.node == 0 && at.leaf == 0);
  check(root_is_internal || item_of(&tree, 0) == 0);
  at = {part[0].length.nodes, part[0].length.leaves};
  --to_come;
  return true;
}

bool read_root(SequenceReader& from, Level d, uint64_t bit) noexcept {
  check(d == 0 && bit == 0 && root_is_internal && from.n == LEVEL && from.b == FORMAT && from.map == out);
  check(same_reader(from.tree, tree.bytes, tree.size, 1) && same_reader(from.data, data.bytes, data.size, 0));
  check(from.nodes >= part[0].length.nodes);
  check(is_small(from.nodes) && !from.fault);
  for (size_t k = 0; k < MAP_BYTES; ++k) {
    check(out[k] == 0);
    out[k] = states[k];
  }
  from.tree.skip((uint32_t)part[0].length.nodes - 1);
  from.data.skip((uint32_t)part[0].length.leaves * FORMAT);
  return true;
}

bool find_root(const uint8_t* bytes, uint64_t nodes, Level levels, uint64_t index, impl::Place& at) noexcept {
  check(bytes == tree.bytes && nodes >= part[0].length.nodes && nodes <= 8 * tree_bytes);
  check(levels == LEVEL && at.node == 0 && at.leaf == 0);
  if (!root_is_internal) {
    check(item_of(&tree, 0) == 0);
    at.node = any(64);
    return true;
  }
  for (size_t k = 0; k < ASKED; ++k)
    if (index == lookup_index[k]) {
      at = {any(64), lookup_leaf[k]};
      return true;
    }
  check(0);
  return false;
}

template <class Law>
void on_any_map(Law law) {
  any_map(LEVEL, FORMAT, states);
  // Chosen first, as a solver finds it easier.
  for (size_t k = 0; k < ASKED; ++k) {
    lookup_index[k] = any_below(STATES);
    lookup_state[k] = state_of(states, FORMAT, lookup_index[k]);
  }
  const Pyramid flags(LEVEL, Format(FORMAT), {states, MAP_BYTES});
  make_only_read(flags);
  law(flags);
}

}  // namespace

extern "C" {

/* The bits of memory of any size. */

void step_of_put() {
  const size_t at = any(PLACE_BITS);
  const uint32_t count = (uint32_t)any(6);
  const uint64_t value = any(56);
  assume(count <= 56 && value >> count == 0);
  Sequence s;
  s.bits = 1;
  s.item = any(PLACE_BITS);
  s.size = bytes_for(at + count, 1) + 8;
  const size_t places[3] = {at / 8, (at + count) / 8, s.item / 8};
  for (size_t w = 0; w < WATCHES; ++w) s.watch[w] = places[w < 3 ? w : 0];
  assume(s.item / 8 < s.size);
  s.bytes = watched_memory(s.size, s.watch, WATCHES);
  become_zero(&s, at, 8 * s.size);
  const unsigned before = item_of(&s, s.item);
  BitWriter to(s.bytes, at);
  to.put(value, count);
  check(same_writer(to, BitWriter(s.bytes, at + count)));
  check(item_of(&s, s.item) == (in(s.item, at, at + count) ? value >> (s.item - at) & 1 : before));
}

void step_of_bits() {
  const size_t at = any(PLACE_BITS), size = any(PLACE_BITS - 3), ahead = any(6);
  assume(ahead < 57);
  const size_t places[2] = {(at + ahead) / 8, at / 8};
  uint8_t* bytes = watched_memory(size, places, 2);
  only_read(bytes);
  const auto bit = [bytes](size_t k) { return (unsigned)(bytes[k / 8] >> k % 8 & 1); };
  BitReader from({bytes, size}, at);
  check((from.peek() >> ahead & 1) == (at + ahead < 8 * size ? bit(at + ahead) : 0));
  check(from.place() == at);
  const uint32_t count = (uint32_t)any(2);
  if (at / 8 < size) {
    check(impl::bit_at(bytes, at) == bit(at));
    if (count >= 1 && at % 8 + count <= 8)
      check(from.within_byte(count) == (unsigned)(bytes[at / 8] >> at % 8 & ((1u << count) - 1)));
  }
  const uint32_t more = (uint32_t)any(PLACE_BITS);
  from.skip(more);
  check(same_reader(from, bytes, size, at + more) && from.place() == at + more);
}

/* A node, given its children. */

void step_of_read() { on_any_node(the_reading); }
void step_of_find() { on_any_node(the_finding); }
void step_of_spec() { on_any_node(the_writing); }

/* A loop of pass_one over j + 1 subtrees comes to the end of the first with j to come: from a leaf at once; from an
 * internal node at its first child with j + 4, and then over its four children. */
void step_of_pass() {
  stands_for((const void*)impl::bit_at, (const void*)read_any_bit);
  uint8_t memory;
  tree_memory = &memory;
  start = {any(PLACE_BITS), any(PLACE_BITS)};
  any_bit = (uint32_t)any(1);
  const uint64_t more = any(PLACE_BITS);
  uint64_t to_come = more + 1;
  impl::Place at = {start.nodes, start.leaves};
  all_nodes = any(PLACE_BITS);
  assume(all_nodes > start.nodes);
  check(impl::pass_one(tree_memory, all_nodes, at, to_come));
  check(at.node == start.nodes + 1 && at.leaf == start.leaves + !any_bit);
  check(to_come == more + (any_bit ? 4 : 0));
  /* find_leaf stays at a leaf. */
  any_bit = 0;
  for (Level levels = 0; levels <= LEVEL; ++levels) {
    at = {start.nodes, start.leaves};
    check(impl::find_leaf(tree_memory, all_nodes, levels, any(32), at));
    check(at.leaf == start.leaves);
  }
}

/* Pyramid counts the flags that are set.  None is set beyond those of a depth, or below a node whose own is not. */
void step_of_count() {
  on_any_map([](const Pyramid& flags) {
    pyramid = &flags;
    size_t all = 0;
    for (Level d = 0; d < LEVEL; ++d) {
      size_t ones = 0;
      for (const uint64_t word : flags.mixed(d)) ones += (size_t)__builtin_popcountll(word);
      check(flags.internal(d) == ones && flags.mixed(d).size() == ((size_t)1 << 2 * d) / 64 + (d < 3));
      if (d < 3) check(flags.mixed(d)[0] >> (1 << 2 * d) == 0);
      all += ones;
      if (d == 0) continue;
      const size_t k = any_below((size_t)1 << 2 * (d - 1));
      const uint32_t four = flags.children(d, k);
      check(four == (flags.mixed(d)[k / 16] >> k % 16 * 4 & 15));
      check(four == 0 || is_internal(d - 1, k));
    }
    check(flags.internal() == all && (flags.mixed(0)[0] == 1) == (all > 0));
  });
}

void encode_by_contract() {
  on_any_map([](const Pyramid& flags) {
    any_root(flags);
    encoding_by_contract();
    const size_t capacity = any(PLACE_BITS);
    other = any(PLACE_BITS);
    open_whole_code(capacity);
    const uint8_t before = other < capacity ? tree.bytes[other] : 0;
    check(codec()->tree_encode(LEVEL, FORMAT, states, tree.bytes, capacity) == code_size);
    if (other < capacity && (capacity < code_size || other >= code_size)) check(tree.bytes[other] == before);
    if (capacity >= code_size) require_both_sequences();
  });
}

void spec_by_contract() {
  on_any_map([](const Pyramid& flags) {
    encode_any(flags);
    require_both_sequences();
    int is_uniform;
    uniform_state(0, STATES, &is_uniform);
    check(is_uniform == !root_is_internal);
  });
}

void decode_by_contract() {
  on_any_map([](const Pyramid& flags) {
    encode_any(flags);
    uint8_t back[MAP_BYTES];
    out = back;
    stands_for((const void*)impl::pass_one, (const void*)pass_root);
    stands_for((const void*)impl::read_node, (const void*)read_root);
    check(codec()->tree_decode(LEVEL, FORMAT, tree.bytes, code_size, back));
    check(equal(states, back, MAP_BYTES));
  });
}

/* Any three indices in a batch, and one alone. */
void lookup_by_contract() {
  on_any_map([](const Pyramid& flags) {
    encode_any(flags);
    require_both_sequences();
    stands_for((const void*)impl::pass_one, (const void*)pass_root);
    stands_for((const void*)impl::find_leaf, (const void*)find_root);
    uint32_t batch[ASKED];
    uint8_t state[ASKED];
    for (size_t k = 0; k < ASKED; ++k) batch[k] = (uint32_t)lookup_index[k];
    codec()->tree_lookup(LEVEL, FORMAT, tree.bytes, code_size, batch, state, ASKED);
    for (size_t k = 0; k < ASKED; ++k) check(state[k] == lookup_state[k] && batch[k] == lookup_index[k]);
    const uint32_t alone = (uint32_t)lookup_index[0];
    codec()->tree_lookup(LEVEL, FORMAT, tree.bytes, code_size, &alone, state, 1);
    check(state[0] == lookup_state[0] && alone == lookup_index[0]);
  });
}
}
