#include "somato/files/number_file.h"

#include <utility>

#include "somato/files/npy.h"
#include "somato/files/whole_file.h"

namespace somato {
namespace {

Result<NumberTable> table_of_npy(const std::string& bytes, const std::string& path,
                                 const CsvOptions& options) {
  if (!options.label_column.empty()) {
    return fail(no_label_column_in_npy(path));
  }
  return decode_npy(bytes, path).map([](Matrix<float>&& values) {
    return NumberTable{{}, std::move(values), {}};
  });
}

}  // namespace

Error no_label_column_in_npy(const std::string& path) {
  return {ErrorKind::kUsage, "an NPY file has no label column", path,
          "give the labels in a file of their own, one a line"};
}

Result<NumberTable> read_numbers(const std::string& path, const CsvOptions& options,
                                 std::size_t limit) {
  return read_whole(path, limit).and_then([&](const std::string& bytes) {
    return is_npy(bytes) ? table_of_npy(bytes, path, options) : parse_csv(bytes, path, options);
  });
}

}  // namespace somato
