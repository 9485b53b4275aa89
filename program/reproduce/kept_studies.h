#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"

namespace somato::program {

/// The bits of explorations, trainings and statistics, by the version that computed them first. The
/// names of kept recordings and results contain it, so that those with other bits are not used. It
/// changes when such bits change, and not with each version, so that days of computing are kept.
inline constexpr std::string_view kVersionOfBits = "0.1.0";

/// The results of a sweep's parts. Each part writes only to its own folder, so that several
/// machines can work at the same time. A file's name is a checksum of everything that determines
/// its content, so that it does not depend on the division into parts.
class KeptStudies {
 public:
  /// Reads all parts in the folder `parts` and writes to that named `own`.
  KeptStudies(const std::filesystem::path& parts, const std::string& own)
      : parts_(parts), own_(parts / own) {}

  /// Creates the folder of this part, and one in it for unfinished studies. Errors: kSystem.
  Result<void> make_folders() const;
  const std::filesystem::path& own_folder() const { return own_; }
  std::filesystem::path unfinished() const { return own_ / "unfinished"; }

  /// Lists the results that all parts have saved so far.
  void look();

  /// The result of that name; nothing if it is missing, truncated or damaged. Errors: kData if
  /// another version of Somato wrote it in another format.
  Result<std::optional<PartResults>> find(const std::string& name) const;

  /// Errors: kSystem.
  Result<void> keep(const std::string& name, const PartResults& results);

  /// The same for results that the caller writes as text and checks.
  std::optional<std::string> find_text(const std::string& name) const;
  Result<void> keep_text(const std::string& name, const std::string& text);

 private:
  std::filesystem::path parts_;
  std::filesystem::path own_;
  std::map<std::string, std::filesystem::path> found_;
};

}  // namespace somato::program
