#include "study_data.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "somato/files/toml_file.h"
#include "somato/studies/own_systems.h"

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

Result<Table> read_file_or_own(const std::string& name) {
  std::error_code unknown;
  const auto own = find_own_file(name);
  const bool is_file =
      std::filesystem::exists(name, unknown) && !std::filesystem::is_directory(name, unknown);
  return own && !is_file ? parse_toml(own->text, own->path) : read_toml(name);
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
