#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"

namespace somato::program {

/// What the parts of a sweep have found, in a folder for each of them that only this one writes
/// to: several machines may work at the same time. A file's name is a checksum of all that decides
/// what is in it, so that it does not matter which part found it, and how many there were.
class KeptStudies {
 public:
  /// Of the parts in `parts`, where this one is called `own`.
  KeptStudies(const std::filesystem::path& parts, const std::string& own)
      : parts_(parts), own_(parts / own) {}

  /// Makes the folder of this part, and one in it for what is unfinished. Errors: kSystem.
  Result<void> make_folder() const;
  const std::filesystem::path& own_folder() const { return own_; }
  std::filesystem::path unfinished() const { return own_ / "unfinished"; }

  /// Looks what all parts have found by now.
  void look();

  /// What is there under that name; nothing where it is not, or cut or damaged.
  std::optional<PartResults> find(const std::string& name) const;

  /// Errors: kSystem.
  Result<void> keep(const std::string& name, const PartResults& results);

 private:
  std::filesystem::path parts_;
  std::filesystem::path own_;
  std::map<std::string, std::filesystem::path> found_;
};

/// The name of what a text describes, 16 hexadecimal digits.
std::string checksum_name(const std::string& text);

}  // namespace somato::program
