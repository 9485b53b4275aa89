#include "somato/files/npy.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "files/little_endian.h"
#include "files/npy_header.h"
#include "files/text.h"
#include "somato/files/whole_file.h"

namespace somato {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kAlignment = 64;

tl::unexpected<Error> refuse(std::string_view where, std::string what, std::string advice) {
  return fail(ErrorKind::kData, std::move(what), std::string(where), std::move(advice));
}

// Turns a number's bytes into the nearest double.
using Reading = double (*)(const char*);

template <typename T>
double read_little(const char* bytes) {
  return static_cast<double>(little_endian<T>(bytes));
}

template <typename T>
double read_big(const char* bytes) {
  return static_cast<double>(big_endian<T>(bytes));
}

// A byte of a boolean that is neither 0 nor 1 is no number.
double read_bool(const char* byte) {
  return *byte == 0 || *byte == 1 ? *byte : std::numeric_limits<double>::quiet_NaN();
}

struct NumberType {
  std::string_view name;
  std::size_t size;
  Reading read;
};

constexpr NumberType kTypes[] = {
    {"<f4", 4, read_little<float>},
    {">f4", 4, read_big<float>},
    {"<f8", 8, read_little<double>},
    {">f8", 8, read_big<double>},
    {"|i1", 1, read_little<std::int8_t>},
    {"|u1", 1, read_little<std::uint8_t>},
    {"<i2", 2, read_little<std::int16_t>},
    {">i2", 2, read_big<std::int16_t>},
    {"<u2", 2, read_little<std::uint16_t>},
    {">u2", 2, read_big<std::uint16_t>},
    {"<i4", 4, read_little<std::int32_t>},
    {">i4", 4, read_big<std::int32_t>},
    {"<u4", 4, read_little<std::uint32_t>},
    {">u4", 4, read_big<std::uint32_t>},
    {"<i8", 8, read_little<std::int64_t>},
    {">i8", 8, read_big<std::int64_t>},
    {"<u8", 8, read_little<std::uint64_t>},
    {">u8", 8, read_big<std::uint64_t>},
    {"|b1", 1, read_bool},
};

const NumberType* find_type(std::string_view name) {
  for (const NumberType& type : kTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

// Takes the header's text off the front of `bytes`, and leaves the values.
Result<std::string_view> take_header(std::string_view& bytes, std::string_view where) {
  const std::string cut = "the file ends within its header";
  const std::string again = "copy or save it again";
  if (!is_npy(bytes)) {
    return refuse(where, "this is not an NPY file", "save the array with numpy.save");
  }
  if (bytes.size() < 12) return refuse(where, cut, again);
  const int version = static_cast<unsigned char>(bytes[6]);
  if (version < 1 || version > 3 || bytes[7] != 0) {
    return refuse(where,
                  fmt::format("NPY version {}.{} is unknown", version,
                              static_cast<unsigned>(static_cast<unsigned char>(bytes[7]))),
                  "save the array with numpy.save");
  }
  const std::size_t length = version == 1 ? little_endian<std::uint16_t>(bytes.data() + 8)
                                          : little_endian<std::uint32_t>(bytes.data() + 8);
  bytes.remove_prefix(version == 1 ? 10 : 12);
  if (length > bytes.size()) return refuse(where, cut, again);
  const std::string_view header = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return header;
}

struct Size {
  std::size_t rows;
  std::size_t columns;
};

Result<Size> size_of(const NpyHeader& header, std::string_view where) {
  const std::size_t dimensions = header.shape.size();
  if (dimensions < 1 || dimensions > 2) {
    return refuse(where, fmt::format("the array has {} dimensions instead of 1 or 2", dimensions),
                  "reshape it to one row a sample: array.reshape(samples, -1)");
  }
  const Size size{header.shape[0], dimensions == 2 ? header.shape[1] : 1};
  if (size.rows == 0 || size.columns == 0) {
    return refuse(where, fmt::format("the array is empty: {} x {}", size.rows, size.columns),
                  "save an array with at least one row and one column");
  }
  return size;
}

// Compares the shape with the bytes that are there, without multiplying past the largest number.
Result<void> check_length(const Size& size, std::size_t number_size, std::size_t available,
                          std::string_view where) {
  const std::size_t most = available / number_size;
  if (size.columns > most / size.rows) {
    return refuse(where,
                  fmt::format("the file is cut short: {} bytes for {} x {} numbers", available,
                              size.rows, size.columns),
                  "copy or save it again");
  }
  const std::size_t trailing = available - size.rows * size.columns * number_size;
  if (trailing > 0) {
    return refuse(where, fmt::format("{} bytes follow the last number", trailing),
                  "save the array alone, with numpy.save");
  }
  return {};
}

tl::unexpected<Error> not_a_float(double value, std::size_t row, std::size_t column,
                                  std::string_view where) {
  return refuse(where,
                fmt::format("{} in row {}, column {} (counted from 1) is no finite 32-bit number",
                            value, row + 1, column + 1),
                "leave the row out or fill in a number");
}

Result<Matrix<float>> read_values(std::string_view bytes, const NumberType& type, const Size& size,
                                  bool fortran_order, std::string_view where) {
  Matrix<float> matrix(size.rows, size.columns);
  for (std::size_t row = 0; row < size.rows; ++row) {
    for (std::size_t column = 0; column < size.columns; ++column) {
      const std::size_t place =
          fortran_order ? column * size.rows + row : row * size.columns + column;
      const double value = type.read(bytes.data() + place * type.size);
      const auto rounded = static_cast<float>(value);
      if (!std::isfinite(rounded)) return not_a_float(value, row, column, where);
      matrix(row, column) = rounded;
    }
  }
  return matrix;
}

std::string file_start(std::string_view type, std::string_view shape) {
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape);
  const std::size_t before = kMagic.size() + 4;
  while ((before + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string bytes(kMagic);
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
  return bytes.starts_with(kMagic);
}

Result<Matrix<float>> decode_npy(std::string_view bytes, std::string_view where) {
  const Result<std::string_view> text = take_header(bytes, where);
  if (!text) return fail(text.error());
  const Result<NpyHeader> header = parse_npy_header(*text, where);
  if (!header) return fail(header.error());
  const NumberType* type = find_type(header->type);
  if (!type) {
    return refuse(where, fmt::format("arrays of type {} are not read", shown(header->type)),
                  "convert it first: array.astype('float32')");
  }
  const Result<Size> size = size_of(*header, where);
  if (!size) return fail(size.error());
  const Result<void> fits = check_length(*size, type->size, bytes.size(), where);
  if (!fits) return fail(fits.error());
  return read_values(bytes, *type, *size, header->fortran_order, where);
}

Result<Matrix<float>> read_npy(const std::string& path) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return decode_npy(bytes, path); });
}

std::string encode_npy(const Matrix<float>& matrix) {
  const std::string shape = fmt::format("({}, {})", matrix.rows(), matrix.columns());
  return with_numbers(file_start("<f4", shape), matrix.values());
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
