#include "base/archives/archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/archives/checksum.h"
#include "base/archives/little_endian.h"
#include "base/files/whole_file.h"
#include "base/text/format_version.h"
#include "base/text/text.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// A byte that is no ASCII, the name, and the ends of lines and files that careless copying changes.
constexpr std::string_view kMagic(
    "\x8F"
    "SOMATO\r\n\x1A\n\0",
    12);
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeaderSize = 32;
constexpr std::size_t kChecksumSize = 4;
constexpr std::size_t kEntryAlignment = 8;
constexpr std::size_t kMostEntries = 1000;  // Keeps the memory for names and shapes small.
constexpr std::size_t kMostDimensions = 8;

enum class Type : std::uint16_t { kText = 1, kFloat32 = 2, kFloat64 = 3, kInt64 = 4 };

template <typename T>
constexpr Type type_of() {
  if constexpr (std::is_same_v<T, float>) return Type::kFloat32;
  if constexpr (std::is_same_v<T, double>) return Type::kFloat64;
  return Type::kInt64;
}

std::size_t padding_after(std::size_t size) {
  return (kEntryAlignment - size % kEntryAlignment) % kEntryAlignment;
}

// The number of values of a shape, or nothing when it is out of range.
std::optional<std::uint64_t> product(const std::vector<std::uint64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t size : shape) {
    if (size == 0 || count > std::numeric_limits<std::uint64_t>::max() / size) return {};
    count *= size;
  }
  return count;
}

// Whether an archive may contain the content.
struct Validity {
  bool operator()(const std::string& text) const { return is_utf8(text); }

  template <typename T>
  bool operator()(const Array<T>& array) const {
    return !array.shape.empty() && array.shape.size() <= kMostDimensions &&
           product(array.shape) == array.values.size();
  }
};

void append_padded(std::string& out, std::string_view bytes) {
  out += bytes;
  out.append(padding_after(bytes.size()), '\0');
}

class EntryWriter {
 public:
  EntryWriter(std::string& out, const std::string& name) : out_(out), name_(name) {}

  void operator()(const std::string& text) {
    write_head(Type::kText, {text.size()});
    append_padded(out_, text);
  }

  template <typename T>
  void operator()(const Array<T>& array) {
    write_head(type_of<T>(), array.shape);
    for (const T value : array.values) append_little_endian(out_, value);
    out_.append(padding_after(out_.size()), '\0');
  }

 private:
  void write_head(Type type, const std::vector<std::uint64_t>& shape) {
    append_little_endian(out_, static_cast<std::uint16_t>(type));
    append_little_endian(out_, static_cast<std::uint16_t>(shape.size()));
    append_little_endian(out_, static_cast<std::uint32_t>(name_.size()));
    append_padded(out_, name_);
    for (const std::uint64_t size : shape) append_little_endian(out_, size);
  }

  std::string& out_;
  const std::string& name_;
};

struct SizeOfContent {
  std::size_t operator()(const std::string& text) const { return text.size(); }

  template <typename T>
  std::size_t operator()(const Array<T>& array) const {
    return array.values.size() * sizeof(T);
  }
};

// Enough room for the encoded archive, so that it is not moved while it grows.
std::size_t room_for(const Archive& archive) {
  std::size_t room = 1024;
  for (const Archive::Entry& entry : archive.entries()) {
    room += std::visit(SizeOfContent{}, entry.content) + 512;
  }
  return room;
}

// Takes an archive's bytes apart from front to back. The first failure wins; after it everything
// that is read is zero or empty.
class Reader {
 public:
  Reader(std::string_view bytes, std::string_view where) : rest_(bytes), where_(where) {}

  bool failed() const { return error_.has_value(); }
  Error error() && { return std::move(*error_); }
  std::size_t remaining() const { return rest_.size(); }

  void set_place(std::string place) { place_ = std::move(place); }

  void refuse(std::string what) {
    if (failed()) return;
    const std::string where = place_.empty() ? where_ : where_ + ": " + place_;
    error_ = Error{ErrorKind::kData, std::move(what), where,
                   "the file was not written by Somato; save the model again"};
    rest_ = {};
  }

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) {
      refuse("the content extends beyond the end of the file");
      return {};
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <typename T>
  T number() {
    const std::string_view bytes = take(sizeof(T));
    return failed() ? T{0} : little_endian<T>(bytes.data());
  }

  std::string_view padded(std::uint64_t count) {
    const std::string_view taken = take(count);
    if (take(padding_after(taken.size())).find_first_not_of('\0') != std::string_view::npos) {
      refuse("the padding is not zero");
    }
    return taken;
  }

  std::string_view name(std::uint32_t length) {
    const std::string_view taken = padded(length);
    if (!is_name(taken)) refuse("a name is not a text of 1 to 255 bytes");
    return taken;
  }

 private:
  std::string_view rest_;
  std::string where_;
  std::string place_;
  std::optional<Error> error_;
};

std::string read_text(Reader& reader, const std::vector<std::uint64_t>& shape) {
  if (shape.size() != 1) {
    reader.refuse("a text has one dimension");
    return {};
  }
  const std::string_view text = reader.padded(shape[0]);
  if (!is_utf8(text)) reader.refuse("the text is not UTF-8");
  return std::string(text);
}

template <typename T>
Array<T> read_array(Reader& reader, std::vector<std::uint64_t> shape) {
  const std::optional<std::uint64_t> count = product(shape);
  if (!count || *count > reader.remaining() / sizeof(T)) {
    reader.refuse("the array has no values, or more than the file");
    return {};
  }
  const std::string_view bytes = reader.padded(*count * sizeof(T));
  if (reader.failed()) return {};
  std::vector<T> values(*count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = little_endian<T>(bytes.data() + i * sizeof(T));
  }
  return {std::move(shape), std::move(values)};
}

Archive::Content read_content(Reader& reader, Type type, std::vector<std::uint64_t> shape) {
  switch (type) {
    case Type::kText:
      return read_text(reader, shape);
    case Type::kFloat32:
      return read_array<float>(reader, std::move(shape));
    case Type::kFloat64:
      return read_array<double>(reader, std::move(shape));
    case Type::kInt64:
      return read_array<std::int64_t>(reader, std::move(shape));
  }
  reader.refuse(fmt::format("the type {} is unknown", static_cast<unsigned>(type)));
  return {};
}

std::vector<std::uint64_t> read_shape(Reader& reader, std::uint16_t dimensions) {
  if (dimensions < 1 || dimensions > kMostDimensions) {
    reader.refuse(fmt::format("{} dimensions are not between 1 and 8", dimensions));
    return {};
  }
  std::vector<std::uint64_t> shape(dimensions);
  for (std::uint64_t& size : shape) size = reader.number<std::uint64_t>();
  return shape;
}

void read_entry(Reader& reader, Archive& archive) {
  // A type that is none of them is refused below.
  // NOLINTNEXTLINE(clang-analyzer-optin.core.EnumCastOutOfRange)
  const auto type = static_cast<Type>(reader.number<std::uint16_t>());
  const auto dimensions = reader.number<std::uint16_t>();
  const std::string name(reader.name(reader.number<std::uint32_t>()));
  if (reader.failed()) return;
  reader.set_place(fmt::format("entry {}", shown(name)));
  if (archive.find(name)) reader.refuse("the entry occurs twice");
  Archive::Content content = read_content(reader, type, read_shape(reader, dimensions));
  if (!reader.failed()) archive.add(name, std::move(content));
}

Result<Archive> read_body(std::string_view body, std::uint32_t count, std::uint32_t kind_length,
                          std::string_view where) {
  Reader reader(body, where);
  const std::string_view kind = reader.name(kind_length);
  if (count > kMostEntries) reader.refuse(fmt::format("{} entries are too many", count));
  if (reader.failed()) return fail(std::move(reader).error());
  Archive archive{std::string(kind)};
  for (std::uint32_t i = 0; i < count && !reader.failed(); ++i) {
    reader.set_place(fmt::format("entry {} of {}", i + 1, count));
    read_entry(reader, archive);
  }
  reader.set_place({});
  if (reader.remaining() > 0) reader.refuse("there is data after the last entry");
  if (reader.failed()) return fail(std::move(reader).error());
  return archive;
}

tl::unexpected<Error> refuse_file(std::string_view where, std::string what, std::string advice) {
  return fail(ErrorKind::kData, std::move(what), std::string(where), std::move(advice));
}

std::uint32_t stored_checksum(std::string_view bytes) {
  return little_endian<std::uint32_t>(bytes.data() + bytes.size() - kChecksumSize);
}

// Conditions that are checked before the content is read.
Result<void> check_whole(std::string_view bytes, std::string_view where) {
  if (!bytes.starts_with(kMagic)) {
    return refuse_file(where, "this is not a model file of Somato", "check the path");
  }
  const std::string again = "the file is damaged; copy or save it again";
  if (bytes.size() < kHeaderSize + kChecksumSize) {
    return refuse_file(where, fmt::format("the file ends after {} bytes", bytes.size()), again);
  }
  const auto version = little_endian<std::uint32_t>(bytes.data() + 12);
  if (version > kVersion) {
    return unsupported_format(version, kVersion, std::string(where), again);
  }
  if (version != kVersion) {
    return refuse_file(where, fmt::format("format {} does not exist", version), again);
  }
  const auto length = little_endian<std::uint64_t>(bytes.data() + 16);
  if (length != bytes.size()) {
    return refuse_file(
        where, fmt::format("the file has {} bytes instead of {}", bytes.size(), length), again);
  }
  if (stored_checksum(bytes) != crc32c(bytes.substr(0, bytes.size() - kChecksumSize))) {
    return refuse_file(where, "the checksum does not match", again);
  }
  return {};
}

}  // namespace

Archive::Archive(std::string kind) : kind_(std::move(kind)) {
  require(is_name(kind_), "an archive's kind is a text of 1 to 255 bytes");
}

void Archive::add(std::string name, Content content) {
  require(is_name(name), "an entry's name is a text of 1 to 255 bytes");
  require(!find(name), fmt::format("the entry '{}' exists already", name));
  require(entries_.size() < kMostEntries, "an archive has at most 1000 entries");
  require(std::visit(Validity{}, content),
          fmt::format("the entry '{}' is not UTF-8 text, or its shape does not fit", name));
  entries_.push_back({std::move(name), std::move(content)});
}

const Archive::Content* Archive::find(std::string_view name) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &found->content;
}

Error Archive::not_there(std::string_view name, std::string_view where, bool other_type) {
  return {
      ErrorKind::kData,
      other_type ? fmt::format("the entry '{}' is of another type", name)
                 : fmt::format("the entry '{}' is missing", name),
      std::string(where),
      fmt::format("check that it is the right file; one that another version of Somato wrote in "
                  "format {} has to be trained again",
                  kVersion)};
}

bool is_archive(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

std::string encode_archive(const Archive& archive) {
  std::string out(kMagic);
  out.reserve(room_for(archive));
  append_little_endian(out, kVersion);
  append_little_endian(out, std::uint64_t{0});  // The length, known at the end.
  append_little_endian(out, static_cast<std::uint32_t>(archive.entries().size()));
  append_little_endian(out, static_cast<std::uint32_t>(archive.kind().size()));
  append_padded(out, archive.kind());
  for (const Archive::Entry& entry : archive.entries()) {
    std::visit(EntryWriter(out, entry.name), entry.content);
  }
  std::string length;
  append_little_endian(length, std::uint64_t{out.size() + kChecksumSize});
  out.replace(16, length.size(), length);
  append_little_endian(out, crc32c(out));
  return out;
}

Result<Archive> decode_archive(std::string_view bytes, std::string_view where) {
  SOMATO_TRY_VOID(check_whole(bytes, where));
  const auto count = little_endian<std::uint32_t>(bytes.data() + 24);
  const auto kind_length = little_endian<std::uint32_t>(bytes.data() + 28);
  bytes.remove_prefix(kHeaderSize);
  bytes.remove_suffix(kChecksumSize);
  return read_body(bytes, count, kind_length, where);
}

Result<void> save_archive(const std::string& path, const Archive& archive) {
  return save_whole(path, encode_archive(archive));
}

Result<Archive> load_archive(const std::string& path) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return decode_archive(bytes, path); });
}

}  // namespace somato
