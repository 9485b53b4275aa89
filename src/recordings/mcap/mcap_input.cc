#include "recordings/mcap/mcap_input.h"

#include <algorithm>
#include <utility>

namespace somato {
namespace {

constexpr std::size_t kLeastWindow = std::size_t{1} << 16;

}  // namespace

Result<McapInput> McapInput::open(FileSystem& files, const std::string& path) {
  SOMATO_TRY(auto opened, open_to_read(files, path));
  if (opened.status.kind != FileStatus::Kind::kRegular) {
    return fail(ErrorKind::kUsage, "not a regular file", path, "copy it to a regular file first");
  }
  return McapInput(std::move(opened.file), path, opened.status.size);
}

Result<std::string_view> McapInput::view(std::size_t place, std::size_t count) {
  count = std::min(count, size_ - std::min(place, size_));
  const bool inside = place >= window_place_ && place + count <= window_place_ + window_.size();
  if (!inside) {
    const std::size_t wanted = std::min(std::max(count, kLeastWindow), size_ - place);
    if (window_.capacity() > kLeastWindow) std::string().swap(window_);
    window_.resize(wanted);
    window_place_ = place;
    const Outcome<std::size_t> got = file_.read_all_at(place, window_.data(), wanted);
    window_.resize(got ? *got : 0);
    if (!got) return system_failure("cannot read", path_, got.error());
  }
  const std::size_t offset = place - window_place_;
  return std::string_view(window_).substr(std::min(offset, window_.size()), count);
}

}  // namespace somato
