#include "base/files/scratch_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace somato {
namespace {

tl::unexpected<Error> no_folder(const std::string& reason, const std::string& where) {
  return fail(ErrorKind::kSystem, "cannot make a temporary folder: " + reason, where,
              "set TMPDIR to a folder that can be written to");
}

}  // namespace

Result<ScratchFolder> ScratchFolder::create() {
  std::error_code error;
  const std::filesystem::path base = std::filesystem::temp_directory_path(error);
  if (error) return no_folder(error.message(), "TMPDIR");
  std::string path = (base / "somato-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) return no_folder(std::strerror(errno), base.string());
  return ScratchFolder(std::move(path));
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace somato
