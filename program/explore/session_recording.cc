#include "explore/session_recording.h"

#include <fmt/format.h>

#include "terminal/wording.h"

namespace somato::program {

Result<void> SessionRecording::begin() {
  if (path_.empty()) return {};
  SOMATO_TRY(file_, GrowingRecording::begin(path_));
  return {};
}

Result<std::string> SessionRecording::finish() {
  if (!file_) return std::string();
  SOMATO_TRY_VOID(file_->finish());
  if (file_->count() > 0) return saved_text(*file_) + "\n";
  return fmt::format("{}: not written, because the body explored nothing\n", path_);
}

std::string saved_text(const GrowingRecording& file) {
  return fmt::format("{} saved in {}", counted(file.count(), "exploration"), file.path());
}

}  // namespace somato::program
