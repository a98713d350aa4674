// Cleans text that a subject wrote: the result can be printed, put into JSON and read by a CI's log. All
// text of subjects goes through it.
#pragma once

#include <string>
#include <string_view>

namespace mmverify::dock {

/// One line of UTF-8 without effect on terminals and CIs. These are written as \xNN, byte by byte:
///   control characters (C0, DEL, C1), line and paragraph separators, marks that set the direction of text,
///   invalid UTF-8, and the `::` at the start and the second `#` of `##`, with which CI commands begin.
/// Domain: any bytes. Other UTF-8 stays as it is; cleaning twice changes nothing.
std::string clean_text(std::string_view bytes);

/// Cleans each line of a text; the lines stay apart.
std::string clean_lines(std::string_view bytes);

}  // namespace mmverify::dock
