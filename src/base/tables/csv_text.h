#pragma once

#include <string>

namespace somato {

/// The text with an apostrophe before it if a spreadsheet would evaluate it; see csv_field().
std::string guarded_text(std::string text);

/// The text without the apostrophe that guarded_text() adds: the inverse function, which leaves a
/// text without one unchanged.
std::string unguarded_text(std::string text);

}  // namespace somato
