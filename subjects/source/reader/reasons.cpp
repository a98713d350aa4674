#include "subjects/source/reader/reasons.hpp"

namespace mmverify::source {

const char* said(Outside what) {
  switch (what) {
    case Outside::of_table: return "a read outside of a table's row, of a member or of the whole";
    case Outside::of_lifetime: return "an access of a variable whose block has ended, or not begun";
    case Outside::of_type: return "a value that its type does not have, such as a bool of 2";
    case Outside::of_step:
      return "a pointer that leaves what it points into, or a null pointer that is moved";
    case Outside::of_set: return "a pointer that was never set";
    case Outside::of_null:
      return "a null pointer as an argument, a result or a reference that is said to be none";
    case Outside::of_promise:
      return "a pointer or reference to fewer bytes, or at another place, than is said of it";
    default: return "an access outside of a variable";
  }
}

const char* said(Refusal why) {
  switch (why) {
    case Refusal::types:
      return "a number taken for one of another type by a pointer, which C leaves undefined; use memcpy or a "
             "union";
    case Refusal::restricted: return "a call whose restricted pointer may lead to what another one leads to";
    case Refusal::scopes: return "an access that is said to be apart from others (noalias)";
    case Refusal::alignment: return "a pointer that is said to be a multiple of more than its variable is";
    default: return "an access through a pointer of which it is not known where it leads";
  }
}

}  // namespace mmverify::source
