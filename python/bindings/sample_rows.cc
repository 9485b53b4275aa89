#include "sample_rows.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include "errors.h"
#include "interrupts.h"
#include "nanobind/stl/string.h"
#include "somato/core/check.h"
#include "somato/core/parameter.h"

namespace somato::python {

namespace nb = nanobind;

SampleRows::SampleRows(Rows dense, const std::string& missing, bool is_moved)
    : count_(dense.shape(0)),
      columns_(dense.shape(1)),
      missing_(value_or_throw(choice_named<MissingFill>("missing", missing, "SOM(missing)"))),
      is_moved_(is_moved),
      dense_(std::move(dense)) {}

SampleRows::SampleRows(std::size_t columns, Numbers<std::int64_t> starts,
                       Numbers<std::uint32_t> elements, Numbers<float> values)
    : columns_(columns),
      sparse_(true),
      starts_(std::move(starts)),
      elements_(std::move(elements)),
      values_(std::move(values)) {
  require(starts_.size() > 0, "sparse rows need the start of the first row");
  count_ = starts_.size() - 1;
  check();
}

void SampleRows::check() const {
  const std::span<const std::int64_t> starts(starts_.data(), starts_.size());
  require(starts.front() == 0 && std::is_sorted(starts.begin(), starts.end()) &&
              static_cast<std::size_t>(starts.back()) == elements_.size() &&
              elements_.size() == values_.size(),
          "sparse rows need one column for each value");
  for (std::size_t i = 0; i < count_; ++i) {
    const auto elements = sparse_row(i).indices;
    require(std::adjacent_find(elements.begin(), elements.end(), std::greater_equal<>()) ==
                    elements.end() &&
                (elements.empty() || elements.back() < columns_),
            "the columns of a sparse row must be ascending and exist");
  }
}

SignalView SampleRows::sparse_row(std::size_t row) const {
  const auto begin = static_cast<std::size_t>(starts_.data()[row]);
  const std::size_t count = static_cast<std::size_t>(starts_.data()[row + 1]) - begin;
  return {columns_, true, {elements_.data() + begin, count}, {values_.data() + begin, count}};
}

Samples SampleRows::part(std::size_t first, std::size_t count) const {
  if (!sparse_) return samples_of(dense_, first, count);
  SampleCollector rows;
  for (std::size_t i = first; i < first + count; ++i) rows.add(sparse_row(i));
  return rows.samples();
}

namespace {

Result<Samples> from_nearest(const Samples& samples) {
  Result<Samples> filled;
  unlocked([&](Interrupts& interrupts) {
    filled = filled_from_nearest(samples, {}, interrupts.progress());
  });
  return filled;
}

Rows rows_of(const Samples& samples) {
  std::vector<float> values(samples.count() * samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], std::span(values).subspan(i * samples.size(), samples.size()));
  }
  const std::size_t shape[] = {samples.count(), samples.size()};
  return nb::cast<Rows>(array_of(std::move(values), shape));
}

}  // namespace

SampleRows SampleRows::filled() const {
  SampleRows whole = *this;
  whole.missing_ = MissingFill::kRefuse;
  if (missing_ == MissingFill::kRefuse) return whole;
  const Samples samples = all();
  KnownValues known;
  value_or_throw(known.take(samples));
  const std::vector<double> means = value_or_throw(known.means({}));
  if (missing_ != MissingFill::kNearest) whole.means_ = means;
  if (known.missing() == 0) return whole;
  if (leaves_out()) {
    whole.missing_ = missing_;
    return whole;
  }
  whole.dense_ = rows_of(missing_ == MissingFill::kMean ? filled_with(means, samples)
                                                        : value_or_throw(from_nearest(samples)));
  return whole;
}

void bind_sample_rows(nb::module_& module) {
  nb::class_<SampleRows>(module, "SampleRows", "Samples of a map, dense or sparse, not copied.")
      .def("__len__", &SampleRows::count)
      .def("filled", &SampleRows::filled)
      .def(nb::init<Rows, const std::string&, bool>(), nb::arg("rows").noconvert(),
           nb::arg("missing") = "refuse", nb::arg("is_moved") = false)
      .def(nb::init<std::size_t, Numbers<std::int64_t>, Numbers<std::uint32_t>, Numbers<float>>(),
           nb::arg("columns"), nb::arg("starts").noconvert(), nb::arg("elements").noconvert(),
           nb::arg("values").noconvert());
}

}  // namespace somato::python
