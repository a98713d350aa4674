// Loads a library, in the process that may die of it.
#pragma once

#include <string>

#include "subjects/dock/desk/promised.hpp"
#include "subjects/dock/mailbox.hpp"

namespace mmverify::dock {

/// Loads the library and writes its subject, with null for entry points that its header does not have, and
/// its description, which the tool checks (subjects/dock/description.hpp). Returns the reason why it is no subject, or
/// nothing. `promised` is the library's own struct. `outcome`: ready, cannot_open, cannot_load, or not_here if the library says that it cannot run
/// here.
std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject,
                        Promised& promised, Outcome& outcome);

}  // namespace mmverify::dock
