// The pictures that runs of `scene --attributes --pictures` wrote, for a page to show.
#pragma once

#include "cli/report_input.hpp"

namespace mmverify::cli {

/// "pictures": for each picture that an input names, in order, {"file": input, "picture": number in it, and "png": the
/// picture in base64, its longest side at most 1,560 pixels, or "why": what keeps it from being shown}.  A path is
/// looked for from the folder that the program was called in, then beside the result.  Only what decodes as a PNG or
/// JPEG is shown, and is written anew: a result cannot carry another file into a page.
nlohmann::ordered_json pictures_of(const std::vector<ReportInput>& inputs);

}  // namespace mmverify::cli
