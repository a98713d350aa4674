#include "subjects/dock/desk/call.hpp"

#include <cstdint>
#include <type_traits>

#include "subjects/dock/desk/manner.hpp"

namespace mmverify::dock {
namespace {

/// An argument as a register holds it: garbage fills the upper half of a 32-bit one, which no ABI of these
/// defines. Other ABIs extend such arguments.
template <class P>
auto in_whole_register(P p) {
#if defined(__x86_64__) || defined(__aarch64__)
  constexpr std::uint64_t garbage = std::uint64_t{0xA5C3965Au} << 32;
  if constexpr (std::is_same_v<P, std::uint32_t>)
    return garbage | p;
  else
    return p;
#else
  return p;
#endif
}

/// A function of the subject, called in a manner. Its arguments are computed before the surroundings are set.
template <class R, class... P>
class Called {
 public:
  Called(R (*function)(P...), Manner manner) : function_(function), manner_(manner) {}

#if defined(__clang__)
  __attribute__((no_sanitize("function")))  // the wide call has another type
#endif
  R operator()(P... p) const {
    if (manner_ == Manner::plain) return function_(p...);
    if (manner_ == Manner::upper_halves) {
      using Wide = R (*)(decltype(in_whole_register(p))...);
      return reinterpret_cast<Wide>(reinterpret_cast<void (*)()>(function_))(in_whole_register(p)...);
    }
    const Surroundings surroundings(manner_);
    return function_(p...);
  }

 private:
  R (*function_)(P...);
  Manner manner_;
};

/// Calls the entry point and returns the number of answered bytes: the size that it returns; 0 if it returns
/// an int of 0, a refusal; else `room`.
template <class F>
std::uint64_t answer_bytes_of(F called, std::uint64_t room) {
  using Result = decltype(called());
  if constexpr (std::is_void_v<Result>) {
    called();
    return room;
  } else if constexpr (std::is_same_v<Result, std::size_t>) {
    return called();
  } else {
    static_assert(std::is_same_v<Result, int>);
    return called() != 0 ? room : 0;
  }
}

}  // namespace

std::uint64_t call(const mmverify_subject_t& subject, Call entry, const Arguments& a) {
  switch (entry) {
#define MMVERIFY_CASE(name, topic, values, arguments) \
  case Call::name: return answer_bytes_of([&] { return Called(subject.name, a.manner) arguments; }, a.room);
    MMVERIFY_ENTRY_POINTS(MMVERIFY_CASE)
#undef MMVERIFY_CASE
  }
  return 0;
}

}  // namespace mmverify::dock
