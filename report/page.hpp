// The page that report/ is bundled into, as the program has it inside.
#pragma once

#include <string_view>

namespace mmverify::report {

/// One HTML file with {data} where its data goes; empty where the program was built without it.
std::string_view page();

/// Why there is no page, and what to do about it; empty where there is one.
std::string_view why_no_page();

}  // namespace mmverify::report
