#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/spectrum.h"
#include "somato/codes/tensor_product.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

// An array with a row for each of `rows`, which `code` fills. Errors name the row.
nb::object coded(
    const Rows& rows, std::size_t elements,
    const std::function<Result<void>(std::span<const float>, std::span<float>)>& code) {
  const std::size_t size = rows.shape(1);
  std::vector<float> out(rows.shape(0) * elements);
  {
    const nb::gil_scoped_release released;
    for (std::size_t i = 0; i < rows.shape(0); ++i) {
      Result<void> done =
          code({rows.data() + i * size, size}, {out.data() + i * elements, elements});
      if (done) continue;
      std::string& where = done.error().where;
      where = "row " + std::to_string(i) + (where.empty() ? "" : ", " + where);
      throw Failure{std::move(done.error())};
    }
  }
  const std::size_t shape[] = {rows.shape(0), elements};
  return array_of(std::move(out), shape);
}

// One dictionary of parameters for each column.
nb::object one_hot(const std::vector<nb::dict>& columns, const Rows& rows) {
  std::vector<OneHotParameters> joints;
  joints.reserve(columns.size());
  for (const nb::dict& column : columns) {
    joints.push_back(parameters_of<OneHotParameters>(column, "OneHot"));
  }
  const OneHotSequence sequence(joints);
  SignalBuffer buffer;
  return coded(rows, joints.size() * joints.front().elements,
               [&](std::span<const float> row, std::span<float> out) {
                 return sequence.encode(row, buffer).map([&] { write_dense(buffer.view(), out); });
               });
}

SpectrumParameters spectrum_parameters(const nb::dict& values) {
  const auto parameters = parameters_of<SpectrumParameters>(values, "Spectrum");
  value_or_throw(parameters.validate());
  return parameters;
}

// The spectrum of each row, whose columns are frames.
nb::object spectra(const nb::dict& values, const Rows& rows, double rate) {
  const Spectrum spectrum(spectrum_parameters(values));
  const auto apply = [&](std::span<const float> row) {
    return spectrum.apply(Matrix<float>(row.size(), 1, {row.begin(), row.end()}), rate);
  };
  const std::size_t size = rows.shape(1);
  const std::size_t bands = value_or_throw(apply({rows.data(), size})).size();
  return coded(rows, bands, [&](std::span<const float> row, std::span<float> out) {
    return apply(row).map([&](const Signal& found) { write_dense(found.view(), out); });
  });
}

// The spectrum of each element of frames x elements.
nb::object spectrum_of(const nb::dict& values, const Rows& frames, double rate) {
  const Matrix<float> copied(frames.shape(0), frames.shape(1),
                             {frames.data(), frames.data() + frames.size()});
  const Signal found = value_or_throw(Spectrum(spectrum_parameters(values)).apply(copied, rate));
  const std::size_t shape[] = {found.shape().front(), found.size() / found.shape().front()};
  return array_of(found.to_dense(), shape);
}

// The tensor product of the parts of each row, which have the given sizes.
nb::object products(const std::vector<std::size_t>& sizes, const Rows& rows) {
  std::size_t elements = 1;
  for (const std::size_t size : sizes) elements *= size;
  SignalBuffer scratch;
  SignalBuffer product;
  std::vector<SignalView> inputs(sizes.size());
  return coded(rows, elements,
               [&](std::span<const float> row, std::span<float> out) -> Result<void> {
                 std::size_t first = 0;
                 for (std::size_t i = 0; i < sizes.size(); ++i) {
                   inputs[i] = SignalView::dense(row.subspan(first, sizes[i]));
                   first += sizes[i];
                 }
                 tensor_product(inputs, scratch, product);
                 write_dense(product.view(), out);
                 return {};
               });
}

}  // namespace

void bind_codes(nb::module_& module) {
  module.def("one_hot_parameters",
             [] { return descriptions_of(OneHotParameters::declarations().infos()); });
  module.def("spectrum_parameters",
             [] { return descriptions_of(SpectrumParameters::declarations().infos()); });
  module.def("one_hot", &one_hot, nb::arg("columns"), nb::arg("rows").noconvert());
  module.def("spectra", &spectra, nb::arg("parameters"), nb::arg("rows").noconvert(),
             nb::arg("rate"));
  module.def("spectrum_of", &spectrum_of, nb::arg("parameters"), nb::arg("frames").noconvert(),
             nb::arg("rate"));
  module.def("tensor_products", &products, nb::arg("sizes"), nb::arg("rows").noconvert());
}

}  // namespace somato::python
