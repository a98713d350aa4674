// Loading a library, in the process that may die of it.
#pragma once

#include <string>

#include "dock/mailbox.hpp"

namespace mmverify::dock {

/// Loads the library; writes its subject, entry points that its header did not have yet null, and what it says
/// of itself; the tool looks whether that can be (dock/description.hpp).  Returns why it is no subject, or nothing.
/// `outcome`: ready, cannot_open, cannot_load, or not_here where the library says that it cannot run in this place.
std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject,
                        Outcome& outcome);

}  // namespace mmverify::dock
