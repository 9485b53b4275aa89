#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato::program {

/// Fails (kUsage) unless the extension of a file is one that save_picture() writes: .svg, .png or
/// .pdf in lower or upper case, or another text that does not name a picture.
Result<void> check_picture_ending(const std::string& path);

/// Saves an SVG picture: as it is, or with the extension .png or .pdf as drawn by Chromium. A PNG
/// file has 2 pixels for each unit of the picture, a PDF file one page of 1/96 inch for each unit.
/// Errors: kSystem, also if no Chromium is installed.
Result<void> save_picture(const std::string& path, const std::string& svg);

}  // namespace somato::program
