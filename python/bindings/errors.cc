#include "errors.h"

#include <exception>
#include <string>

#include "somato/core/check.h"

namespace somato::python {
namespace {

// No function of the module uses devices, or saves a part of its work.
const char* name_of(ErrorKind kind) {
  if (kind == ErrorKind::kUsage) return "UsageError";
  return kind == ErrorKind::kData ? "DataError" : "OperatingSystemError";
}

// A damaged file may have bytes in its names that are no text.
nanobind::object text_of(const std::string& text) {
  return nanobind::steal(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
}

void raise(const Error& error) {
  const nanobind::object type =
      nanobind::module_::import_(SOMATO_PYTHON_PACKAGE ".errors").attr(name_of(error.kind));
  const nanobind::object raised =
      type(text_of(error.what), text_of(error.where), text_of(error.advice));
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void register_failures() {
  nanobind::register_exception_translator([](const std::exception_ptr& thrown, void* /*unused*/) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
      raise(failure.error);
    } catch (const InvalidArgument& error) {
      raise({ErrorKind::kUsage, error.what(), {}, {}});
    }
  });
}

}  // namespace somato::python
