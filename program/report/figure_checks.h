#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"
#include "report/figure_page.h"
#include "somato/core/result.h"

namespace somato::program {

/// The ending of a file, such as "pdf"; empty without one.
std::string ending_of(const std::string& path);

/// Errors (kUsage): flags without effect where names are listed.
Result<void> check_listing(const Arguments& arguments);

/// Errors (kUsage): no file, a file of an unknown format, flags without effect on its format.
Result<void> check_saving(const Arguments& arguments);

/// Errors (kUsage): none of the figures has that name and can be saved in that format.
Result<void> check_known(const std::vector<ListedFigure>& figures, const FigureRequest& request);

}  // namespace somato::program
