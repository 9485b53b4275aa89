#include "somato/recording/recording.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "nanobind/stl/pair.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "parameters.h"
#include "somato/core/parameter.h"
#include "somato/recording/format.h"
#include "somato/recording/recording_file.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

Recording checked(Result<Recording> read, const std::string& path) {
  if (read) {
    if (auto valid = validate(*read); !valid) read = fail(std::move(valid.error()));
  }
  if (!read && read.error().where.empty()) read.error().where = path;
  return value_or_throw(std::move(read));
}

Recording read(const std::string& path, const nb::dict& settings) {
  const auto chosen = parameters_of<RecordingParameters>(settings, "read");
  Result<Recording> recording;
  {
    const nb::gil_scoped_release released;
    recording = load_recording(chosen, path);
  }
  return checked(std::move(recording), path);
}

void write(const Recording& recording, const std::string& path) {
  const nb::gil_scoped_release released;
  value_or_throw(write_recording(path, recording));
}

// An array of the memory of the recording, which is immutable.
template <typename T>
nb::object view_of(const nb::object& owner, const Matrix<T>& matrix,
                   const std::vector<std::size_t>& frame_shape) {
  std::vector<std::size_t> shape{matrix.rows()};
  shape.insert(shape.end(), frame_shape.begin(), frame_shape.end());
  return nb::cast(
      nb::ndarray<nb::numpy, const T>(matrix.values().data(), shape.size(), shape.data(), owner));
}

nb::dict description_of_channel(const Channel& channel) {
  nb::dict described;
  described["name"] = channel.name;
  described["unit"] = channel.unit;
  described["element_names"] = channel.element_names;
  described["shape"] = channel.frame_shape();
  return described;
}

const Channel& channel_of(const Recording& recording, const std::string& name,
                          std::size_t exploration) {
  return *value_or_throw(find_channel(recording.explorations.at(exploration), name));
}

// Calls `part` for the channel of each exploration; a list of what it returns.
template <typename Part>
nb::list of_each(const Recording& recording, const std::string& name, const Part& part) {
  nb::list parts;
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    parts.append(part(channel_of(recording, name, i)));
  }
  return parts;
}

nb::list frames(const nb::object& self, const std::string& name) {
  return of_each(nb::cast<const Recording&>(self), name, [&](const Channel& channel) {
    return view_of(self, channel.frames, channel.frame_shape());
  });
}

nb::list valid(const nb::object& self, const std::string& name) {
  return of_each(nb::cast<const Recording&>(self), name, [&](const Channel& channel) -> nb::object {
    if (channel.valid.empty()) return nb::none();
    return view_of(self, channel.valid, channel.frame_shape());
  });
}

nb::list times(const nb::object& self, const std::string& name) {
  return of_each(nb::cast<const Recording&>(self), name, [&](const Channel& channel) -> nb::object {
    if (!channel.times.empty()) {
      const std::size_t shape[] = {channel.times.size()};
      return nb::cast(nb::ndarray<nb::numpy, const double>(channel.times.data(), 1, shape, self));
    }
    if (channel.rate == 0.0) return nb::none();
    std::vector<double> even(channel.frames.rows());
    for (std::size_t i = 0; i < even.size(); ++i) even[i] = static_cast<double>(i) / channel.rate;
    return array_of(std::move(even));
  });
}

nb::list labels(const Recording& recording) {
  nb::list all;
  for (const Exploration& exploration : recording.explorations) {
    nb::dict named;
    for (const Label& label : exploration.labels) named[label.name.c_str()] = label.value;
    all.append(std::move(named));
  }
  return all;
}

// Marks of missing values, (frames x elements); without elements if no value is missing.
using Marks = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

Channel filled(const ChannelDescription& description, const Rows& frames,
               const std::vector<double>& times, const Marks& valid) {
  Channel channel =
      channel_of(description, Matrix<float>(frames.shape(0), frames.shape(1),
                                            {frames.data(), frames.data() + frames.size()}));
  channel.times = times;
  if (valid.size() > 0) {
    channel.valid = Matrix<std::uint8_t>(valid.shape(0), valid.shape(1),
                                         {valid.data(), valid.data() + valid.size()});
  }
  return channel;
}

/// Explorations from arrays, one after the other.
class RecordingMaker {
 public:
  void begin(const std::vector<std::pair<std::string, std::string>>& labels,
             const std::string& source) {
    Exploration exploration;
    exploration.source = source;
    for (const auto& [name, value] : labels) exploration.labels.push_back({name, value});
    recording_.explorations.push_back(std::move(exploration));
  }

  void add(const nb::dict& description, const Rows& frames, const std::vector<double>& times,
           const Marks& valid) {
    const ChannelDescription channel{
        nb::cast<std::string>(description["name"]), nb::cast<std::string>(description["unit"]),
        nb::cast<std::vector<std::string>>(description["element_names"]),
        nb::cast<std::vector<std::size_t>>(description["shape"]),
        nb::cast<double>(description["rate"])};
    recording_.explorations.back().channels.push_back(filled(channel, frames, times, valid));
  }

  Recording finish() { return checked(std::move(recording_), "from_arrays"); }

 private:
  Recording recording_;
};

}  // namespace

void bind_recording(nb::module_& module) {
  nb::class_<Recording>(module, "Recording", "Explorations, immutable.")
      .def("__len__", [](const Recording& recording) { return recording.explorations.size(); })
      .def("write", &write, nb::arg("path"))
      .def("labels", &labels)
      .def("sources",
           [](const Recording& recording) {
             std::vector<std::string> sources;
             for (const auto& exploration : recording.explorations)
               sources.push_back(exploration.source);
             return sources;
           })
      .def("channels",
           [](const Recording& recording) {
             nb::list all;
             for (const Channel& channel : recording.explorations.front().channels) {
               all.append(description_of_channel(channel));
             }
             return all;
           })
      .def(
          "rates",
          [](const Recording& recording, const std::string& name) {
            return of_each(recording, name,
                           [](const Channel& channel) { return nb::float_(channel.frame_rate()); });
          },
          nb::arg("channel"))
      .def("__eq__", [](const Recording& a, const Recording& b) { return a == b; });
  // They take the object that the arrays keep alive.
  module.def("frames", &frames, nb::arg("recording"), nb::arg("channel"));
  module.def("valid", &valid, nb::arg("recording"), nb::arg("channel"));
  module.def("times", &times, nb::arg("recording"), nb::arg("channel"));
  module.def("read", &read, nb::arg("path"), nb::arg("settings"));
  nb::class_<RecordingMaker>(module, "RecordingMaker", "Explorations from arrays.")
      .def(nb::init<>())
      .def("begin", &RecordingMaker::begin, nb::arg("labels"), nb::arg("source"))
      .def("add", &RecordingMaker::add, nb::arg("description"), nb::arg("frames").noconvert(),
           nb::arg("times"), nb::arg("valid").noconvert())
      .def("finish", &RecordingMaker::finish);
}

}  // namespace somato::python
