#pragma once
#include "subjects/dock/mailbox.hpp"
namespace mmverify::dock {
constexpr Outcome left_registers = static_cast<Outcome>(15), changed_signals = static_cast<Outcome>(16), changed_struct = static_cast<Outcome>(17);
}
