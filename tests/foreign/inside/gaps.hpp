// Faults that their law does not refute: each stands in docs/SOUNDNESS.md by name, or waits for a better
// law.  A law that comes to refute one makes the test ask for its row here to go.
#pragma once

namespace mmverify::tests::foreign {

struct InsideGap {
  const char *law, *name, *why;
};

inline constexpr InsideGap inside_gaps[] = {
    {"lossy.judges", "first_byte_alone", "no map of level 2 or above is judged"},
    {"micromap.build", "padding_is_written", "padding bits are always zero"},
    {"micromap.build_on_samples", "padding_tells_maps_apart", "padding bits are always zero"},
    {"micromap.build_on_samples", "offset_of_12_bits", "no record of the fast tier lies beyond 4 KiB"},
    {"micromap.build_on_samples", "indices_of_a_byte", "23 maps have no index beyond 22"},
    {"micromap.validate", "limit_in_32_bits", "no counts add up to 2^32"},
    {"paper.tree_bits_read", "reads_data_of_four_states", "the tree is a 2-state one"},
    {"vq.codes", "palette_of_the_majority", "what cannot be written has one O and one T, and C elsewhere"},
    {"vq2.optimum", "no_half_turn_in_br", "no map of the sample needs it"},
    {"vq2.optimum", "own_in_turn", "no map of the sample needs another pair"},
    {"vq2.effort", "no_half_turn_in_br", "no map of the sample needs it"},
    {"vq2.effort", "promises_itself", "what is promised is the subject's own word, not Algorithm 1's number"},
    {"vq4.effort", "no_270_in_br", "no map of the sample needs it"},
    {"vq4.effort", "promises_itself",
     "what is promised is the subject's own word, not a lesser effort's number"},
    {"vq4.bound", "its_own_is_the_least", "the bound is held against the subject's own encoder alone"},
    {"vq4.bound", "no_vertical_in_tr", "no map of the sample needs it"},
    {"vq4.bound", "promises_itself",
     "what is promised is the subject's own word, not the most effort's number"},
};

}  // namespace mmverify::tests::foreign
