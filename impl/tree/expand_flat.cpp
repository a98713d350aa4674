
#include "impl/tree/bits.hpp"
#include "impl/tree/form.hpp"
#include "impl/tree/layout.hpp"
#include "impl/tree/nodes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "impl/tree/expand_flat.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#if HWY_ARCH_X86_64
#include <immintrin.h>
#endif

// If all nodes are of one depth, they lie in the order of the map, and eight of them become their states at once: bits
// are deposited at the places of a mask.  AVX-512 processors have one instruction for that, some with AVX2 alone
// microcode.
HWY_BEFORE_NAMESPACE();
namespace mmverify::impl::tree::detail {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86_64 && HWY_TARGET <= HWY_AVX3

template <std::uint32_t b>
HWY_INLINE void expand(const Layout& layout, std::span<const std::uint8_t> all, std::uint8_t* map) {
  constexpr std::uint32_t width = 4 * b;  // bits of a block
  constexpr std::uint64_t firsts = b == 1 ? 0x11111111 : 0x0101010101010101, ones = (1u << width) - 1,
                          copies = b == 1 ? 0xf : 0x55;
  NodeReader nodes(all.data() + Layout::nodes_at, layout.per_word());
  BitReader blocks(all, 8 * layout.blocks_at()), leaves(all, layout.leaves_at());
  for (std::uint64_t left = layout.nodes(); left > 0; left -= 8, map += width) {
    const std::uint64_t flags = nodes.take(8), of_blocks = _pdep_u64(flags, firsts) * ones;
    const std::uint64_t of_leaves = firsts * low_bits(b) & ~of_blocks;
    const std::uint64_t states =
        _pdep_u64(blocks.peek(), of_blocks) | _pdep_u64(leaves.peek(), of_leaves) * copies;
    std::memcpy(map, &states, width);
    const auto internal = static_cast<std::uint32_t>(_mm_popcnt_u64(flags));
    blocks.skip(width * internal);
    leaves.skip(b * (8 - internal));
  }
}

bool expand_flat(const Layout& layout, std::span<const std::uint8_t> all, std::uint8_t* map) {
  // The form must have groups of eight nodes, and blocks of a byte at most.
  if (layout.steps() != 0 || layout.nodes() < 16 || layout.in_block != 2) return false;
  if (layout.b == 1)
    expand<1>(layout, all, map);
  else
    expand<2>(layout, all, map);
  return true;
}

#else

bool expand_flat(const Layout&, std::span<const std::uint8_t>, std::uint8_t*) { return false; }

#endif

}  // namespace HWY_NAMESPACE
}  // namespace mmverify::impl::tree::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mmverify::impl::tree::detail {

HWY_EXPORT(expand_flat);

bool decode_without_steps(const Layout& layout, std::span<const std::uint8_t> all, std::uint8_t* map) {
  return HWY_DYNAMIC_DISPATCH(expand_flat)(layout, all, map);
}

}  // namespace mmverify::impl::tree::detail
#endif  // HWY_ONCE
