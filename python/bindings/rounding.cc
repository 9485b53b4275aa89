#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "base/tables/column_precision.h"
#include "bindings.h"
#include "errors.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

// Rows in any order of memory.
using ExactRows = nb::ndarray<const double, nb::ndim<2>, nb::device::cpu>;

/// Rounds columns of numbers to float32, and checks that this keeps what differs in them.
class Rounding {
 public:
  Rounding() = default;
  explicit Rounding(ColumnPrecision precision) : precision_(std::move(precision)) {}

  /// The offset that is subtracted from each column, or none, and the least deviation of each
  /// column that matters, or none.
  void know(const std::vector<double>& offsets, const std::vector<double>& deviations) {
    offsets_ = offsets;
    std::vector<ColumnScale> scales(deviations.size());
    for (std::size_t d = 0; d < scales.size(); ++d) scales[d].deviation = deviations[d];
    precision_.know(std::move(scales));
  }

  /// The rows as float32; NaN stays NaN.
  nb::object rows(const ExactRows& exact) {
    const std::size_t columns = exact.shape(1);
    std::vector<float> rounded(exact.shape(0) * columns);
    {
      const nb::gil_scoped_release released;
      float* next = rounded.data();
      for (std::size_t row = 0; row < exact.shape(0); ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          *next++ = keep(column, exact(row, column));
        }
      }
    }
    const std::size_t shape[] = {exact.shape(0), columns};
    return array_of(std::move(rounded), shape);
  }

  /// The values of sparse rows as float32; all others of the `count` rows are 0.
  nb::object sparse(const Numbers<std::int64_t>& elements, const Numbers<double>& values,
                    std::size_t count, std::size_t columns) {
    std::vector<float> rounded(values.size());
    std::vector<std::size_t> zeros(columns, count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto column = static_cast<std::size_t>(elements.data()[i]);
      rounded[i] = keep(column, values.data()[i]);
      --zeros.at(column);
    }
    for (std::size_t column = 0; column < columns; ++column) {
      precision_.take_zeros(column, zeros[column]);
    }
    return array_of(std::move(rounded));
  }

  /// Throws Failure (kData) if a column loses precision; `text` is called with its number.
  void check(const nb::callable& text, const std::string& where) const {
    const auto of = [&](std::size_t column) { return nb::cast<std::string>(text(column)); };
    value_or_throw(precision_.check_as(of, where));
  }

  /// A sentence for each column of which rounding loses something; `text` is called with its
  /// number.
  std::vector<std::string> notes(const nb::callable& text) const {
    return precision_.notes_as(
        [&](std::size_t column) { return nb::cast<std::string>(text(column)); });
  }

  const ColumnPrecision& precision() const { return precision_; }

 private:
  float keep(std::size_t column, double exact) {
    const double moved = offsets_.empty() ? exact : exact - offsets_.at(column);
    const auto kept = static_cast<float>(moved);
    if (std::isfinite(kept)) precision_.take(column, moved, kept);
    return kept;
  }

  ColumnPrecision precision_;
  std::vector<double> offsets_;
};

}  // namespace

void bind_rounding(nb::module_& module) {
  nb::class_<Rounding>(module, "Rounding", "Rounds columns to float32, and checks what is lost.")
      .def(nb::init<>())
      .def("know", &Rounding::know, nb::arg("offsets"), nb::arg("deviations"))
      .def("rows", &Rounding::rows, nb::arg("exact").noconvert())
      .def("sparse", &Rounding::sparse, nb::arg("elements").noconvert(),
           nb::arg("values").noconvert(), nb::arg("count"), nb::arg("columns"))
      .def("check", &Rounding::check, nb::arg("text"), nb::arg("where"))
      .def("notes", &Rounding::notes, nb::arg("text"))
      .def("deviations", [](const Rounding& rounding) { return rounding.precision().deviations(); })
      .def("__getstate__",
           [](const Rounding& rounding) { return rounding.precision().statistics(); })
      .def("__setstate__", [](Rounding& rounding, const std::vector<double>& statistics) {
        new (&rounding) Rounding(ColumnPrecision::with(statistics));
      });
}

}  // namespace somato::python
