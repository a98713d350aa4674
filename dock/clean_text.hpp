// The one gate for text that a subject wrote: what comes out can be printed, put into JSON and read by a CI's log.
#pragma once

#include <string>
#include <string_view>

namespace mmverify::dock {

/// One line of UTF-8 that no terminal and no CI obeys.  Written out as \xNN, byte by byte:
///   control characters (C0, DEL, C1), line and paragraph separators, marks that change the direction of text,
///   bytes that are no UTF-8, and the `::` at the start and the second `#` of `##` by which CI commands begin.
/// Domain: any bytes.  Whatever else is UTF-8 stays as it is; cleaning twice changes nothing.
std::string clean_text(std::string_view bytes);

/// The same of several lines, which stay lines.
std::string clean_lines(std::string_view bytes);

}  // namespace mmverify::dock
