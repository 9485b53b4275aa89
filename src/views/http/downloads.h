#pragma once

#include <string>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// The bytes of the file that write_recording() and save_system() make. They are written to a
/// temporary folder that only this user can read, and that is removed. Errors: those of these
/// functions; kSystem without such a folder.
Result<std::string> recording_bytes(const Recording& recording);
Result<std::string> system_bytes(const SystemModel& model);

}  // namespace somato::live
