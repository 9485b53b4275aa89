#include "views/http/downloads.h"

#include <functional>

#include "base/files/scratch_folder.h"
#include "base/files/whole_file.h"
#include "somato/recording/recording_file.h"

namespace somato::live {
namespace {

Result<std::string> content(const std::function<Result<void>(const std::string& path)>& write) {
  SOMATO_TRY(const auto folder, ScratchFolder::create());
  const std::string path = folder.path() + "/file";
  return write(path).and_then([&] { return read_whole(path); });
}

}  // namespace

Result<std::string> recording_bytes(const Recording& recording) {
  return content([&](const std::string& path) { return write_recording(path, recording); });
}

Result<std::string> system_bytes(const SystemModel& model) {
  return content([&](const std::string& path) { return save_system(path, model); });
}

}  // namespace somato::live
