#pragma once

#include <string>

#include "somato/recording/recording.h"
#include "views/session/reading_sink.h"

namespace somato::program {

/// The reading of a system after a moment, as one line of JSON (docs/live.md) with its line break.
std::string moment_line(const live::SaidReading& said);

/// The reading of the whole exploration, with the label that the exploration has.
std::string final_line(const live::SaidReading& said, const Exploration& exploration);

/// The result of teaching the system a name, as one line of JSON.
std::string taught_line(const live::TaughtName& name);

/// A name that the system has forgotten, as one line of JSON.
std::string forgotten_line(const GivenName& name);

}  // namespace somato::program
