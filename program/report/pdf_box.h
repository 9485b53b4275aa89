#pragma once

#include <string>

namespace somato::program {

/// mm, by which the paper is larger than a picture that it must contain as a whole.
constexpr double kAroundPicture = 1.0;

/// A PDF file of one page, cut to `width` x `height` mm from its upper left corner. Chromium makes
/// paper of whole pixels of 1/96 inch. A file that is written in another way than Chromium's is
/// returned as it is.
std::string cut_page(std::string pdf, double width, double height);

}  // namespace somato::program
