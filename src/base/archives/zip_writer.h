#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "somato/core/result.h"

namespace somato {

/// Writes a ZIP archive of uncompressed members, in the format ZIP64 where sizes or numbers require
/// it. All dates are 1980-01-01, so that equal members give equal bytes. Source: PKWARE's
/// APPNOTE.TXT 6.3.10, sections 4.3 to 4.5.
class ZipWriter {
 public:
  /// Destination of the bytes.
  using Sink = std::function<Result<void>(std::string_view)>;

  explicit ZipWriter(Sink sink) : sink_(std::move(sink)) {}

  /// Adds a member with a name that has not been used, in UTF-8 and of at most 65535 bytes. Errors:
  /// kData for 4 GiB or more; those of the sink.
  Result<void> add(const std::string& name, std::string_view bytes);

  /// Writes the list of members. Errors: those of the sink.
  Result<void> finish();

 private:
  Result<void> put(std::string_view bytes);

  Sink sink_;
  std::uint64_t place_ = 0;
  std::uint64_t members_ = 0;
  std::string directory_;
};

}  // namespace somato
