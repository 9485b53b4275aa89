#include "study_data.h"

#include <utility>

namespace somato::program {

Error with_place(Error error, const std::string& path) {
  if (error.kind == ErrorKind::kData && error.where.empty()) error.where = path;
  return error;
}

Error how_to_go_on(Error error) {
  if (error.kind == ErrorKind::kInterrupted && error.advice.empty()) {
    error.advice = "what is done is kept; the same command goes on from there";
  }
  return error;
}

Result<Recording> read_study_data(RecordingFormat format, const std::string& path) {
  auto recording = load_recording(format, path);
  if (!recording) return fail(with_place(std::move(recording.error()), path));
  if (auto valid = validate(*recording); !valid) {
    return fail(with_place(std::move(valid.error()), path));
  }
  return recording;
}

}  // namespace somato::program
