#include "base/arrays/npy_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "base/archives/little_endian.h"
#include "base/text/flag_hint.h"
#include "base/text/text.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

tl::unexpected<Error> refuse(std::string_view where, std::string what, std::string advice) {
  return fail(ErrorKind::kData, std::move(what), std::string(where), std::move(advice));
}

template <typename T>
double read_little(const char* bytes) {
  return static_cast<double>(little_endian<T>(bytes));
}

template <typename T>
double read_big(const char* bytes) {
  return static_cast<double>(big_endian<T>(bytes));
}

// The number with the bits of a float16 (IEEE 754 binary16): a sign, 5 bits of exponent and 10 of
// fraction. All of them are floats.
double half(std::uint16_t bits) {
  constexpr int kFractionBits = 10;
  constexpr int kBias = 15;
  constexpr int kNotFinite = 31;
  const int exponent = (bits >> kFractionBits) & 31;
  const int fraction = bits & 1023;
  double number = 0.0;
  if (exponent == kNotFinite) {
    number = fraction == 0 ? std::numeric_limits<double>::infinity()
                           : std::numeric_limits<double>::quiet_NaN();
  } else if (exponent == 0) {
    number = std::ldexp(fraction, 1 - kBias - kFractionBits);
  } else {
    number = std::ldexp(1024 + fraction, exponent - kBias - kFractionBits);
  }
  return (bits >> 15) != 0 ? -number : number;
}

double read_little_half(const char* bytes) {
  return half(little_endian<std::uint16_t>(bytes));
}

double read_big_half(const char* bytes) {
  return half(big_endian<std::uint16_t>(bytes));
}

// A byte of a boolean that is neither 0 nor 1 is invalid, and not a missing value.
double read_bool(const char* byte) {
  return *byte == 0 || *byte == 1 ? *byte : std::numeric_limits<double>::infinity();
}

constexpr NpyType kTypes[] = {
    {"<f2", 2, read_little_half},
    {">f2", 2, read_big_half},
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

tl::unexpected<Error> cut_within_header(std::string_view where) {
  return refuse(where, "the file ends within its header", "copy or save it again");
}

struct Size {
  std::size_t rows;
  std::size_t columns;
};

tl::unexpected<Error> empty_array(const NpyHeader& header, std::string_view where) {
  const std::string_view column = header.shape.size() == 1 ? " x 1" : "";
  return refuse(where,
                fmt::format("the array is empty: {}{}", fmt::join(header.shape, " x "), column),
                "save an array with at least one row and one column");
}

// An array of several dimensions as a table of its last dimension.
Result<Size> size_of(const NpyHeader& header, std::string_view where) {
  Size size{1, 1};
  for (std::size_t i = 0; i < header.shape.size(); ++i) {
    const std::uint64_t sides = header.shape[i];
    if (sides == 0) return empty_array(header, where);
    std::size_t& product = i > 0 && i + 1 == header.shape.size() ? size.columns : size.rows;
    if (sides > std::numeric_limits<std::size_t>::max() / product) {
      return refuse(where, "the array has more numbers than a file", "save it again");
    }
    product *= sides;
  }
  return size;
}

Result<void> check_table(const NpyHeader& header, std::string_view where) {
  const std::size_t dimensions = header.shape.size();
  if (dimensions >= 1 && dimensions <= 2) return {};
  return refuse(where, fmt::format("the array has {} dimensions instead of 1 or 2", dimensions),
                "reshape it to one row per sample: array.reshape(samples, -1)");
}

Result<void> check_type(const NpyHeader& header, std::string_view where) {
  if (npy_type(header.type) != nullptr) return {};
  return refuse(where, fmt::format("arrays of type {} are not supported", shown(header.type)),
                "convert it first: array.astype('float32')");
}

// Compares the shape with the bytes that are there, without multiplying past the largest number.
Result<void> check_length(const Size& size, std::size_t number_size, std::size_t available,
                          std::string_view where) {
  const std::size_t most = available / number_size;
  if (size.columns > most / size.rows) {
    return refuse(where,
                  fmt::format("the file is truncated: {} bytes for {} x {} numbers", available,
                              size.rows, size.columns),
                  "copy or save it again");
  }
  const std::size_t trailing = available - size.rows * size.columns * number_size;
  if (trailing > 0) {
    return refuse(where, fmt::format("{} bytes follow the last number", trailing),
                  "save only the array, with numpy.save");
  }
  return {};
}

Result<NpyLayout> layout_of(const NpyStart& start, std::size_t file_size, std::string_view where) {
  const NpyType* type = npy_type(start.header.type);
  SOMATO_TRY(const auto size, size_of(start.header, where));
  SOMATO_TRY_VOID(check_length(size, type->size, file_size - start.size, where));
  return NpyLayout{type,       size.rows,         size.columns, start.header.fortran_order,
                   start.size, start.header.shape};
}

tl::unexpected<Error> not_a_float(double value, std::size_t row, std::size_t column,
                                  std::string_view where) {
  return refuse(
      where,
      fmt::format("{} in row {}, column {} (counted from 1) is not a finite 32-bit number", value,
                  row + 1, column + 1),
      std::isnan(value) ? "leave the row out, fill in a number, or keep missing values" +
                              flag_hint("missing", "mean or nearest")
                        : "leave the row out or fill in a number");
}

// Data in the machine's own format can be copied.
bool is_plain(const NpyLayout& layout) {
  return std::endian::native == std::endian::little && layout.type->name == "<f4" &&
         !layout.fortran_order;
}

bool copy_if_finite(std::string_view bytes, std::span<float> out) {
  std::memcpy(out.data(), bytes.data(), out.size_bytes());
  bool finite = true;
  for (const float value : out) finite &= std::isfinite(value);
  return finite;
}

}  // namespace

const NpyType* npy_type(std::string_view name) {
  for (const NpyType& type : kTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

Result<std::size_t> npy_header_size(std::string_view bytes, std::size_t file_size,
                                    std::string_view where) {
  if (!is_npy(bytes)) {
    return refuse(where, "this is not an NPY file", "save the array with numpy.save");
  }
  if (bytes.size() < kNpyStart) return cut_within_header(where);
  const int version = static_cast<unsigned char>(bytes[6]);
  if (version < 1 || version > 3 || bytes[7] != 0) {
    return refuse(where,
                  fmt::format("NPY version {}.{} is unknown", version,
                              static_cast<unsigned>(static_cast<unsigned char>(bytes[7]))),
                  "save the array with numpy.save");
  }
  const std::size_t length = version == 1 ? little_endian<std::uint16_t>(bytes.data() + 8)
                                          : little_endian<std::uint32_t>(bytes.data() + 8);
  const std::size_t before = version == 1 ? 10 : 12;
  if (length > file_size - before) return cut_within_header(where);
  return before + length;
}

Result<NpyStart> npy_start_of(std::string_view bytes, std::size_t file_size,
                              std::string_view where) {
  SOMATO_TRY(const std::size_t start, npy_header_size(bytes, file_size, where));
  if (start > bytes.size()) return cut_within_header(where);
  const std::size_t before = bytes[6] == 1 ? 10 : 12;
  return parse_npy_header(bytes.substr(before, start - before), where).map([&](NpyHeader&& header) {
    return NpyStart{std::move(header), start};
  });
}

Result<NpyLayout> npy_layout(std::string_view bytes, std::size_t file_size,
                             std::string_view where) {
  SOMATO_TRY(const NpyStart start, npy_start_of(bytes, file_size, where));
  SOMATO_TRY_VOID(check_type(start.header, where));
  SOMATO_TRY_VOID(check_table(start.header, where));
  return layout_of(start, file_size, where);
}

Result<NpyLayout> npy_layout_of_any(std::string_view bytes, std::size_t file_size,
                                    std::string_view where) {
  SOMATO_TRY(const NpyStart start, npy_start_of(bytes, file_size, where));
  SOMATO_TRY_VOID(check_type(start.header, where));
  return layout_of(start, file_size, where);
}

Result<NpyReading> npy_reading(const NpyLayout& layout, const CsvOptions& options,
                               const std::string& where) {
  if (!options.label_column.empty()) {
    return fail(ErrorKind::kUsage, "an NPY file has no label column", where,
                "write the labels to a text file, one per line" + flag_hint("labels"));
  }
  if (options.decimal != DecimalMark::kPoint) {
    return fail(
        ErrorKind::kUsage, "an NPY file has no decimal comma", where,
        "read decimal points; the mark applies to text files" + flag_hint("decimal", "point"));
  }
  TableColumns columns;
  columns.width = layout.columns;
  return choose_columns(options.columns, std::move(columns), where).map([&](TableColumns&& chosen) {
    return NpyReading{std::move(chosen), options.keeps_missing};
  });
}

Result<void> read_npy_rows(std::string_view bytes, const NpyLayout& layout,
                           const NpyReading& reading, std::size_t first, std::span<float> out,
                           std::string_view where, ColumnPrecision* precision) {
  const std::vector<std::size_t>& chosen = reading.columns.features;
  const bool all = chosen.size() == layout.columns;
  const bool moved = has_offsets(reading.columns);
  if (all && !moved && is_plain(layout) && copy_if_finite(bytes, out)) return {};
  const std::size_t columns = layout.columns;
  const std::size_t rows = out.size() / chosen.size();
  float* next = out.data();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const std::size_t column : chosen) {
      const std::size_t place = layout.fortran_order ? column * rows + row : row * columns + column;
      const double value = without_offset(
          reading.columns, column, layout.type->read(bytes.data() + place * layout.type->size));
      const auto rounded = static_cast<float>(value);
      *next++ = rounded;
      if (std::isnan(value) && reading.keeps_missing) continue;
      if (!std::isfinite(rounded)) return not_a_float(value, first + row, column, where);
      if (precision != nullptr) precision->take(column, value, rounded);
    }
  }
  const bool is_end = precision != nullptr && first + rows == layout.rows;
  return is_end ? precision->check({}, where) : Result<void>();
}

Result<Matrix<float>> npy_matrix(std::string_view bytes, const NpyLayout& layout,
                                 NpyReading& reading, std::string_view where) {
  Matrix<float> matrix(layout.rows, reading.columns.features.size());
  ColumnPrecision precision(reading.columns.scales);
  SOMATO_TRY_VOID(read_npy_rows(bytes.substr(layout.start), layout, reading, 0, matrix.values(),
                                where, &precision));
  reading.columns.rounded = precision.notes({});
  return matrix;
}

}  // namespace somato
