#include "base/numbers/npy_source.h"

#include <algorithm>

namespace somato {
namespace {

// All that npy_layout() needs to see.
Result<std::string> header_of(const UnchangedFile& file) {
  std::string bytes(std::min(kNpyStart, file.size()), '\0');
  SOMATO_TRY_VOID(file.read(0, bytes.data(), bytes.size()));
  SOMATO_TRY(const auto size, npy_header_size(bytes, file.size(), file.path()));
  bytes.resize(std::max(size, bytes.size()));
  SOMATO_TRY_VOID(file.read(0, bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace

Result<std::unique_ptr<NumberSource>> NpySource::begin(UnchangedFile file,
                                                       const CsvOptions& options,
                                                       std::size_t part_bytes) {
  SOMATO_TRY(const std::string header, header_of(file));
  SOMATO_TRY(const NpyLayout layout, npy_layout(header, file.size(), file.path()));
  SOMATO_TRY(auto reading, npy_reading(layout, options, file.path()));
  const std::size_t rows = part_bytes / sizeof(float) / layout.columns;
  return std::make_unique<NpySource>(std::move(file), layout, std::move(reading),
                                     std::clamp<std::size_t>(rows, 1, layout.rows));
}

// A list that grows is there twice when it doubles.
double NpySource::memory_of_all() const {
  return 3.0 * static_cast<double>(end_ - begin_) * static_cast<double>(size()) * sizeof(float);
}

void NpySource::take_places(std::size_t begin, std::size_t end) {
  begin_ = first_row_at(begin, row_bytes());
  end_ = first_row_at(end, row_bytes());
  row_ = begin_;
}

double NpySource::share_read() const {
  if (begin_ == end_) return 1.0;
  return static_cast<double>(row_ - begin_) / static_cast<double>(end_ - begin_);
}

Result<void> NpySource::rewind() {
  row_ = begin_;
  precision_ = ColumnPrecision(reading_.columns.scales);
  return file_.check();
}

// In Fortran order these rows are a piece of every column.
Result<void> NpySource::fetch(std::size_t count, char* bytes) const {
  const std::size_t number = layout_.type->size;
  if (!layout_.fortran_order) {
    return file_.read(layout_.start + row_ * row_bytes(), bytes, count * row_bytes());
  }
  for (std::size_t column = 0; column < layout_.columns; ++column) {
    const std::size_t place = layout_.start + (column * layout_.rows + row_) * number;
    auto read = file_.read(place, bytes + column * count * number, count * number);
    if (!read) return read;
  }
  return {};
}

Result<Matrix<float>> NpySource::rows(std::size_t count) {
  bytes_.resize(count * row_bytes());
  SOMATO_TRY_VOID(fetch(count, bytes_.data()));
  Matrix<float> matrix(count, size());
  return read_npy_rows(bytes_, layout_, reading_, row_, matrix.values(), file_.path(),
                       is_known_ ? nullptr : &precision_)
      .map([&] { return std::move(matrix); });
}

Result<std::shared_ptr<const NumberPart>> NpySource::next_part() {
  const std::size_t count = std::min(part_rows_, end_ - row_);
  if (count == 0) {
    is_known_ = true;
    bytes_ = {};
    return file_.check().map([] { return std::shared_ptr<const NumberPart>(); });
  }
  Result<Matrix<float>> values = rows(count);
  if (!values) {
    SOMATO_TRY_VOID(file_.check());
    return fail(std::move(values.error()));
  }
  row_ += count;
  if (row_ == end_ && !is_known_) reading_.columns.rounded = precision_.notes({});
  return std::make_shared<const NumberPart>(NumberPart{Samples(std::move(*values)), {}});
}

}  // namespace somato
