#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "arrays.h"
#include "nanobind/nanobind.h"
#include "somato/core/samples.h"
#include "systems/signals/missing_values.h"

namespace somato::python {

/// Samples as Python passes them to a map, one per row: dense, or sparse in the format CSR. The
/// arrays are not copied and exist as long as this object.
class SampleRows {
 public:
  /// `missing` is the treatment of missing values, NaN; `is_moved`: the offsets of the map's
  /// columns have been subtracted (SomModel::scales()).
  explicit SampleRows(Rows dense, const std::string& missing, bool is_moved);

  /// Row i has the values from starts[i] to starts[i + 1]; `elements` are their columns, ascending
  /// in each row. Throws InvalidArgument for arrays that contradict each other.
  SampleRows(std::size_t columns, Numbers<std::int64_t> starts, Numbers<std::uint32_t> elements,
             Numbers<float> values);

  std::size_t count() const { return count_; }
  std::size_t columns() const { return columns_; }
  MissingFill missing() const { return missing_; }
  bool is_moved() const { return is_moved_; }

  /// The rows for a training that begins: missing values are filled as `somato som train` does, or
  /// remain if they are left out. Throws Failure if that is not possible.
  SampleRows filled() const;

  /// The means of the columns, if missing values were filled with them or are left out; otherwise
  /// empty.
  const std::vector<double>& means() const { return means_; }

  /// `count` rows from `first` on: a view of dense rows, a copy of sparse ones. Valid during the
  /// lifetime of this object.
  Samples part(std::size_t first, std::size_t count) const;

  /// Whether rows may hold missing values that training leaves out.
  bool leaves_out() const { return missing_ == MissingFill::kLeaveOut; }

  /// All rows.
  Samples all() const { return part(0, count_); }

 private:
  void check() const;
  SignalView sparse_row(std::size_t row) const;

  std::size_t count_ = 0;
  std::size_t columns_ = 0;
  MissingFill missing_ = MissingFill::kRefuse;
  bool is_moved_ = false;
  std::vector<double> means_;
  bool sparse_ = false;
  Rows dense_;
  Numbers<std::int64_t> starts_;
  Numbers<std::uint32_t> elements_;
  Numbers<float> values_;
};

/// Adds the class to the extension module.
void bind_sample_rows(nanobind::module_& module);

}  // namespace somato::python
