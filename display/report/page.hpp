// The page that display/report/ is bundled into, built into the program.
#pragma once

#include <string_view>

namespace mmverify::report {

/// One HTML file with {data} in place of its data; empty if the program was built without it.
std::string_view page();

/// The reason why there is no page, and its remedy; empty if there is a page.
std::string_view why_no_page();

}  // namespace mmverify::report
