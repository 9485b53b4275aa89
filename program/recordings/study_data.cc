#include "recordings/study_data.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "flags/left_out.h"
#include "somato/core/value.h"
#include "somato/recording/recording_file.h"
#include "somato/studies/own_systems.h"
#include "version.h"

namespace somato::program {
namespace {

// A file that cannot be opened may be the misspelt name of a built-in file.
Error with_nearest_own_file(Error error, const std::string& name) {
  const std::string nearest =
      nearest_name(std::filesystem::path(name).stem().string(), own_file_names());
  if (!nearest.empty()) error.advice += fmt::format(", or use the built-in '{}'", nearest);
  return error;
}

// Without importers only our own files are read.
Result<Recording> load(const RecordingParameters& parameters, const std::string& path) {
  if constexpr (kHasImporters) return load_recording(parameters, path);
  if (is_mcap_file(path)) return read_recording(path);
  return fail(without_importers(path));
}

}  // namespace

Error with_place(Error error, const std::string& path) {
  if (error.kind == ErrorKind::kData && error.where.empty()) error.where = path;
  return error;
}

Error how_to_go_on(Error error) {
  if (error.kind == ErrorKind::kInterrupted && error.advice.empty()) {
    error.advice = "completed work is kept; the same command resumes it";
  }
  return error;
}

Result<NamedFile> read_file_or_own(const std::string& name) {
  std::error_code unknown;
  const auto own = find_own_file(name);
  const bool is_file =
      std::filesystem::exists(name, unknown) && !std::filesystem::is_directory(name, unknown);
  const std::string where(own && !is_file ? own->path : name);
  const auto text = own && !is_file ? Result<std::string>(std::string(own->text))
                                    : read_whole(name, kLargestToml);
  if (!text) return fail(with_nearest_own_file(text.error(), name));
  return parse_toml(*text, where).map([&](Table content) {
    return NamedFile{name, std::move(content), *text};
  });
}

Result<Recording> read_study_data(const RecordingParameters& parameters, const std::string& path) {
  auto recording = load(parameters, path);
  if (!recording) return fail(with_place(std::move(recording.error()), path));
  if (auto valid = validate(*recording); !valid) {
    return fail(with_place(std::move(valid.error()), path));
  }
  return recording;
}

}  // namespace somato::program
