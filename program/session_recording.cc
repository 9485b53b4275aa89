#include "session_recording.h"

#include <fmt/format.h>

#include <utility>

#include "wording.h"

namespace somato::program {

Result<void> SessionRecording::begin(ViewSource& source) {
  if (path_.empty()) return {};
  SOMATO_TRY(auto file, RecordingFile::begin(path_));
  file_.emplace(std::move(file));
  source.sink = [this](Exploration&& exploration) {
    return file_->add(std::move(exploration)).map([this] { ++explorations_; });
  };
  return {};
}

Result<std::string> SessionRecording::finish() {
  if (!file_) return std::string();
  if (explorations_ == 0) {
    return fmt::format("{}: not written, because the body explored nothing\n", path_);
  }
  return file_->finish().map(
      [this] { return fmt::format("{}: {}\n", path_, counted(explorations_, "exploration")); });
}

}  // namespace somato::program
