#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Values in row-major order with a shape: 1 to 8 dimensions, each at least 1.
template <typename T>
struct Array {
  std::vector<std::uint64_t> shape;
  std::vector<T> values;

  bool operator==(const Array&) const = default;
};

/// The content of model files: a kind ("som"), and an ordered list of up to 1000 named texts and
/// arrays. docs/formats/model-file.md describes the bytes.
class Archive {
 public:
  using Content = std::variant<std::string, Array<float>, Array<double>, Array<std::int64_t>>;

  struct Entry {
    std::string name;
    Content content;
    bool operator==(const Entry&) const = default;
  };

  /// `kind`, like every name, has 1 to 255 bytes of UTF-8 without control characters; throws
  /// InvalidArgument otherwise.
  explicit Archive(std::string kind);

  const std::string& kind() const { return kind_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// Throws InvalidArgument if the name is in use or invalid, a text is not UTF-8, a shape does not
  /// match its values, or the archive is full.
  void add(std::string name, Content content);

  /// The content with that name, or nullptr.
  const Content* find(std::string_view name) const;

  /// The content with that name and type (std::string or Array<...>), valid during the lifetime of
  /// the archive. Errors (kData, at `where`): missing, or of another type.
  template <typename T>
  Result<const T*> get(std::string_view name, std::string_view where) const {
    const Content* content = find(name);
    const T* typed = content ? std::get_if<T>(content) : nullptr;
    if (!typed) return fail(not_there(name, where, content != nullptr));
    return typed;
  }

  bool operator==(const Archive&) const = default;

 private:
  static Error not_there(std::string_view name, std::string_view where, bool other_type);

  std::string kind_;
  std::vector<Entry> entries_;
};

/// Whether `bytes` begin like an archive.
bool is_archive(std::string_view bytes);

/// The archive as bytes, identical for equal archives.
std::string encode_archive(const Archive& archive);

/// The archive in `bytes`, from the source `where`. Bytes that encode_archive() cannot have written
/// are refused (kData), before more memory is allocated than the bytes themselves have.
Result<Archive> decode_archive(std::string_view bytes, std::string_view where);

/// Saves atomically; see save_whole().
Result<void> save_archive(const std::string& path, const Archive& archive);

/// Errors: see read_whole() and decode_archive().
Result<Archive> load_archive(const std::string& path);

}  // namespace somato
