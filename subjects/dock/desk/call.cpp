#include "subjects/dock/desk/call.hpp"

#include <type_traits>

namespace mmverify::dock {
namespace {

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
  case Call::name:                                    \
    return answer_bytes_of([&] { return subject.name arguments; }, a.room);
    MMVERIFY_ENTRY_POINTS(MMVERIFY_CASE)
#undef MMVERIFY_CASE
  }
  return 0;
}

}  // namespace mmverify::dock
