// Reads the pictures of `attributes --pictures`, for a page.
#pragma once

#include "cli/report/input.hpp"

namespace mmverify::cli {

/// "pictures": for each picture that an input names, in order, {"file": input, "picture": number in it, and
/// "png": the picture in base64, its longest side at most 1,560 pixels, or "why": the reason why it is not
/// shown}. A path is resolved from the current folder, then from the result's folder. Only a file that
/// decodes as PNG or JPEG is shown, and it is encoded anew: a result cannot bring another file into a page.
nlohmann::ordered_json pictures_of(const std::vector<ReportInput>& inputs);

}  // namespace mmverify::cli
