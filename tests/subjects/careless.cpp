// The examples but for one thing, chosen when it is linked, that shows only by the caller: where its memory lies and how
// long it is there, what its thread did before, what another thread writes beside the output, how many threads call at
// once, and what it finds in its registers and in the subject's struct afterwards.
#include <sys/mman.h>

#include <atomic>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdint>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_traverse(void);
extern "C" const mmverify_subject_t* right_tree(void);
extern "C" const mmverify_subject_t* right_attribute(void);

namespace {

mmverify_subject_t subject;
mmverify_subject_t* page_of_struct = nullptr;

bool is_below(const void* at, unsigned bits) { return reinterpret_cast<std::uintptr_t>(at) >> bits == 0; }

/// Whether some of `bytes` bytes of the stack below, which nobody has set, are the worker's garbage.
template <std::size_t bytes>
[[gnu::noinline]] bool stack_holds_garbage() {
  volatile unsigned char room[bytes];
  asm volatile("" : "=m"(room));  // the compiler takes it for set
  bool found = false;
  for (std::size_t k = 0; k + 4 < bytes; k += bytes / 512)
    found = found || (room[k] == 0xA5 && room[k + 1] == 0x5A && room[k + 2] == 0xA5 && room[k + 3] == 0x5A) ||
            (room[k] == 0x5A && room[k + 1] == 0xA5 && room[k + 2] == 0x5A && room[k + 3] == 0xA5);
  return found;
}

/// The whole words that an output touches.
class Words {
 public:
  Words(void* out, std::size_t bytes)
      : at_(reinterpret_cast<std::uint64_t*>(reinterpret_cast<std::uintptr_t>(out) & ~std::uintptr_t{7})),
        end_(reinterpret_cast<std::uint64_t*>((reinterpret_cast<std::uintptr_t>(out) + bytes + 7) &
                                              ~std::uintptr_t{7})) {}
  /// Reads each, and writes it as it was some moments later.
  void write_back() const {
    for (volatile std::uint64_t* word = at_; word != end_; ++word) {
      const std::uint64_t before = *word;
      for (volatile int k = 0; k < 20;) k = k + 1;
      *word = before;
    }
  }

 private:
  std::uint64_t *at_, *end_;
};

/// Whether the caller's state makes the answer wrong.
bool is_disturbed() {
  const int error = errno;
  return (wrong_is("decide_errno_range") && error == ERANGE) ||
         (wrong_is("decide_errno_invalid") && error == EINVAL) ||
         (wrong_is("decide_flags") && std::fetestexcept(FE_DIVBYZERO) != 0) ||
         (wrong_is("decide_characters") && MB_CUR_MAX > 1) ||
         (wrong_is("decide_deep_stack") && stack_holds_garbage<500'000>()) ||
         (wrong_is("decide_shallow_stack") && stack_holds_garbage<3000>());
}

void leave_something() {
#if defined(__x86_64__)
  if (wrong_is("decide_x87")) asm volatile("fninit\n fld1\n fld1\n fld1\n fld1\n fld1\n fld1\n fld1\n fld1");
  if (wrong_is("decide_mmx")) asm volatile("pxor %%mm0, %%mm0" ::: "mm0");
#endif
  if (wrong_is("decide_signals")) {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
  }
  if (wrong_is("decide_changes_struct")) subject.traverse_decide = right_traverse()->traverse_decide;
  if (wrong_is("decide_takes_struct_back") && page_of_struct != nullptr) {
    munmap(page_of_struct, 4096);
    page_of_struct = nullptr;
  }
}

void decide(std::uint32_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
            const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  static std::atomic<unsigned> callers = 0;
  const bool disturbed = is_disturbed();
  const unsigned at_once = ++callers;
  right_traverse()->traverse_decide(api, candidate, instance, ray, outcome, count);
  --callers;
  if (disturbed || (wrong_is("decide_for_2") && at_once > 2) || (wrong_is("decide_for_19") && at_once > 19) ||
      (wrong_is("decide_below_4_gib") && is_below(ray, 32)) ||
      (wrong_is("decide_one_array") && instance == ray))
    outcome[0] ^= 1;
  if (wrong_is("decide_writes_words")) Words(outcome, count).write_back();
  leave_something();
}

void decide_wide(std::uint64_t api, const std::uint32_t* candidate, const std::uint32_t* instance,
                 const std::uint32_t* ray, std::uint8_t* outcome, std::size_t count) {
  decide(static_cast<std::uint32_t>(api), candidate, instance, ray, outcome, count);
  if (api >> 32 != 0) outcome[0] ^= 1;
}

std::size_t encode(std::uint32_t level, std::uint32_t format, const std::uint8_t* map, std::uint8_t* code,
                   std::size_t capacity) {
  const std::size_t size = right_tree()->tree_encode(level, format, map, code, capacity);
  if (size > capacity) return size;
  if (wrong_is("encode_above_64_kib") && capacity >= 1u << 16) code[0] ^= 1;
  if (wrong_is("encode_above_1_mib") && capacity > 1u << 20) code[0] ^= 1;
  return size;
}

int decode(std::uint32_t level, std::uint32_t format, const std::uint8_t* code, std::size_t size,
           std::uint8_t* map) {
  static thread_local const volatile std::uint8_t* last = nullptr;
  if (wrong_is("decode_reads_on")) {
    if (last != nullptr) static_cast<void>(*last);
    last = size != 0 ? code : nullptr;
  }
  const int taken = right_tree()->tree_decode(level, format, code, size, map);
  if (taken == 0) return taken;
  if (wrong_is("decode_below_2_gib") && is_below(code, 31)) map[0] ^= 1;
  if (wrong_is("decode_errno") && errno == ERANGE) map[0] ^= 1;
  if (wrong_is("decode_writes_words")) Words(map, ((std::size_t{format} << 2 * level) + 7) / 8).write_back();
  return taken;
}

void decimate(std::uint32_t level, std::uint32_t flags, const std::uint32_t* i, const std::uint32_t* j,
              std::uint32_t* place, std::size_t count) {
  right_attribute()->attribute_decimate(level, flags, i, j, place, count);
  if (wrong_is("decimate_one_array") && i == j) place[0] ^= 1;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static unsigned calls = 0;
  if (calls++ == 0) {
    subject = *right_traverse();
    subject.name = "careless";
    subject.max_level = 12;
    subject.traverse_decide =
        wrong_is("decide_wide")
            ? reinterpret_cast<decltype(subject.traverse_decide)>(reinterpret_cast<void (*)()>(decide_wide))
            : decide;
    subject.flags |= MMVERIFY_TREE_STREAM;
    subject.tree_encode = encode;
    subject.tree_decode = decode;
    subject.attribute_decimate = decimate;
  } else if (wrong_is("decide_another_time")) {
    subject.traverse_decide = right_traverse()->traverse_decide;
  }
  if (!wrong_is("decide_takes_struct_back")) return &subject;
  void* const page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  page_of_struct = static_cast<mmverify_subject_t*>(page);
  *page_of_struct = subject;
  return page_of_struct;
}
