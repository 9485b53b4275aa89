#pragma once

namespace somato {

/// A number rounded to four significant digits, towards zero, for settings that are read by people.
double rounded(double value);

/// The number with the fewest digits that is read as that float.
double plain(float value);

}  // namespace somato
