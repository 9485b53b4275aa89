#include "base/files/whole_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files/open_file.h"
#include "base/files/replacement.h"

namespace somato {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;

tl::unexpected<Error> too_large(const std::string& path, std::size_t limit) {
  return fail(ErrorKind::kData, fmt::format("the file is larger than {} bytes", limit), path,
              "split it, or check that it is the right file");
}

}  // namespace

namespace detail {

Result<std::string> read_whole(FileSystem& files, const std::string& path, std::size_t limit) {
  SOMATO_TRY(const auto opened, open_to_read(files, path));
  if (opened.status.size > limit) return too_large(path, limit);

  // The size is a hint (0 for a pipe); the end is where nothing more comes.
  std::string bytes(opened.status.size, '\0');
  std::size_t count = 0;
  for (;;) {
    char probe[4096];
    const bool full = count == bytes.size();
    char* const place = full ? probe : bytes.data() + count;
    const std::size_t room = full ? sizeof probe : std::min(kReadAtOnce, bytes.size() - count);
    const auto got = opened.file.read(place, room);
    if (!got) return system_failure("cannot read", path, got.error());
    if (*got == 0) break;
    count += *got;
    if (count > limit) return too_large(path, limit);
    if (full) bytes.append(probe, *got);
  }
  bytes.resize(count);
  return bytes;
}

Result<void> save_whole(FileSystem& files, const std::string& path, std::string_view bytes) {
  return Replacement::begin(files, path).and_then([&](Replacement&& replacement) {
    return replacement.write(bytes).and_then([&] { return replacement.commit(); });
  });
}

}  // namespace detail

Result<std::string> read_whole(const std::string& path, std::size_t limit) {
  return detail::read_whole(operating_system(), path, limit);
}

Result<void> save_whole(const std::string& path, std::string_view bytes) {
  return detail::save_whole(operating_system(), path, bytes);
}

}  // namespace somato
