#include "somato/files/npy.h"

#include <fmt/format.h>

#include <utility>

#include "files/little_endian.h"
#include "files/npy_layout.h"
#include "files/whole_file.h"

namespace somato {
namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr std::size_t kNpyAlignment = 64;

std::string file_start(std::string_view type, std::string_view shape) {
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
  const std::size_t before = kNpyMagic.size() + 4;
  while ((before + header.size() + 1) % kNpyAlignment != 0) header += ' ';
  header += '\n';
  std::string bytes(kNpyMagic);
  bytes += '\1';
  bytes += '\0';
  append_little_endian(bytes, static_cast<std::uint16_t>(header.size()));
  return bytes + header;
}

template <typename T>
std::string with_numbers(std::string bytes, std::span<const T> numbers) {
  bytes.reserve(bytes.size() + numbers.size_bytes());
  for (const T number : numbers) append_little_endian(bytes, number);
  return bytes;
}

}  // namespace

bool is_npy(std::string_view bytes) {
  return bytes.starts_with(kNpyMagic);
}

Result<Matrix<float>> decode_npy(std::string_view bytes, std::string_view where) {
  SOMATO_TRY(const NpyLayout layout, npy_layout(bytes, bytes.size(), where));
  return npy_reading(layout, {}, std::string(where)).and_then([&](const NpyReading& all) {
    return npy_matrix(bytes, layout, all, where);
  });
}

Result<Matrix<float>> read_npy(const std::string& path) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return decode_npy(bytes, path); });
}

std::string npy_start(std::size_t rows, std::size_t columns) {
  return file_start("<f4", fmt::format("({}, {})", rows, columns));
}

std::string npy_numbers(std::span<const float> numbers) {
  return with_numbers({}, numbers);
}

std::string encode_npy(const Matrix<float>& matrix) {
  return with_numbers(npy_start(matrix.rows(), matrix.columns()), matrix.values());
}

std::string encode_npy(std::span<const std::int64_t> numbers) {
  return with_numbers(file_start("<i8", fmt::format("({},)", numbers.size())), numbers);
}

Result<void> write_npy(const std::string& path, const Matrix<float>& matrix) {
  return save_whole(path, encode_npy(matrix));
}

Result<void> write_npy(const std::string& path, std::span<const std::int64_t> numbers) {
  return save_whole(path, encode_npy(numbers));
}

}  // namespace somato
