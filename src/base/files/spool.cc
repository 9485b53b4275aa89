#include "base/files/spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 20;

std::string temporary_folder() {
  const char* folder = std::getenv("TMPDIR");
  return folder && *folder != '\0' ? folder : "/var/tmp";
}

tl::unexpected<Error> failure(const std::string& what, int error) {
  auto failed = system_failure(what, temporary_folder(), error);
  failed.value().advice = "set TMPDIR to a folder with enough space";
  return failed;
}

Result<OpenFile> open_temporary() {
  std::string path = temporary_folder() + "/somato-XXXXXX";
  const int file = ::mkostemp(path.data(), O_CLOEXEC);
  if (file < 0) return failure("cannot create a temporary file", errno);
  (void)::unlink(path.c_str());
  return OpenFile(operating_system(), file);
}

}  // namespace

Result<void> Spool::write(std::string_view bytes) {
  buffer_ += bytes;
  return buffer_.size() > most_memory_ ? store() : Result<void>();
}

Result<void> Spool::store() {
  if (!file_) {
    SOMATO_TRY(OpenFile file, open_temporary());
    file_.emplace(std::move(file));
  }
  const Outcome<void> written = file_->write_all(buffer_);
  if (!written) return failure("cannot write a temporary file", written.error());
  stored_ += buffer_.size();
  buffer_.clear();
  return {};
}

Result<void> Spool::read(char* bytes, std::size_t count) {
  require(count <= unread(), "a spool has fewer bytes");
  while (count > 0) {
    std::string_view source = buffer_;
    std::size_t first = place_ - std::min(place_, stored_);
    if (place_ < stored_) {
      if (place_ >= window_place_ + window_.size()) {
        window_.resize(std::min(kWindow, stored_ - place_));
        const auto got = file_->read_all_at(place_, window_.data(), window_.size());
        if (!got) return failure("cannot read a temporary file", got.error());
        if (*got < window_.size()) return failure("cannot read a temporary file", EIO);
        window_place_ = place_;
      }
      source = window_;
      first = place_ - window_place_;
    }
    const std::size_t copied = source.copy(bytes, count, first);
    bytes += copied;
    count -= copied;
    place_ += copied;
  }
  return {};
}

void Spool::clear() {
  file_.reset();
  buffer_.clear();
  window_.clear();
  stored_ = place_ = window_place_ = 0;
}

}  // namespace somato
