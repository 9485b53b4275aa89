#pragma once

#include <string>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::program {

/// Selects the system with which the simulated body of --body begins, and has it trained when the
/// view starts, on explorations that differ from those of the view. Without effect for a real body
/// and for a source with fewer than two things. Errors: those of body_session().
Result<void> prepare_system(const Arguments& arguments, const std::string& body,
                            ViewSource& source);

/// The plan of --demo with that body: each thing of the source in turn; the last one is a thing
/// that the system has not learned, which is explored a second time after it has been named.
void plan_demonstration(const std::string& body, ViewSource& source);

/// The speed at which a demonstration of that body is shown.
double demonstration_speed(const std::string& body);

}  // namespace somato::program
