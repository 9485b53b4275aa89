#include "somato/files/npy.h"

#include <array>
#include <utility>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "base/arrays/npy_layout.h"
#include "base/files/whole_file.h"

namespace somato {
namespace {

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
  return npy_reading(layout, {}, std::string(where)).and_then([&](NpyReading&& all) {
    return npy_matrix(bytes, layout, all, where);
  });
}

Result<Matrix<float>> read_npy(const std::string& path) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return decode_npy(bytes, path); });
}

std::string npy_start(std::size_t rows, std::size_t columns) {
  return npy_file_start("<f4", std::array{rows, columns});
}

std::string npy_numbers(std::span<const float> numbers) {
  return with_numbers({}, numbers);
}

std::string encode_npy(const Matrix<float>& matrix) {
  return with_numbers(npy_start(matrix.rows(), matrix.columns()), matrix.values());
}

std::string encode_npy(std::span<const std::int64_t> numbers) {
  return with_numbers(npy_file_start("<i8", std::array{numbers.size()}), numbers);
}

Result<void> write_npy(const std::string& path, const Matrix<float>& matrix) {
  return save_whole(path, encode_npy(matrix));
}

Result<void> write_npy(const std::string& path, std::span<const std::int64_t> numbers) {
  return save_whole(path, encode_npy(numbers));
}

}  // namespace somato
