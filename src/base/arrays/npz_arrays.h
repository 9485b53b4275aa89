#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/archives/zip_reader.h"
#include "base/arrays/npy_layout.h"
#include "somato/core/result.h"

namespace somato {

/// The arrays of an NPZ archive by their names, which are those of its members without `.npy`.
class NpzArrays {
 public:
  /// `bytes` must outlive this object. Errors (kData, at `where`): those of ZipReader.
  static Result<NpzArrays> open(std::string_view bytes, const std::string& where);

  std::vector<std::string> names() const;

  /// Whether the archive has members that are not arrays.
  bool has_others() const { return names().size() != archive_.members().size(); }

  bool has(const std::string& name) const { return find(name) != nullptr; }

  /// The bytes of the array's NPY file. Errors (kData): it is missing or damaged.
  Result<std::string> read(const std::string& name) const;

  /// The numbers of an array of any number of dimensions, in the order of the file. Errors (kData):
  /// it is missing, damaged or not of numbers.
  Result<std::vector<double>> numbers(const std::string& name) const;

  /// The place of an array in a message.
  std::string place_of(const std::string& name) const { return where_ + ": " + name; }

 private:
  NpzArrays(ZipReader archive, std::string where)
      : archive_(std::move(archive)), where_(std::move(where)) {}

  const ZipReader::Member* find(const std::string& name) const;

  ZipReader archive_;
  std::string where_;
};

}  // namespace somato
