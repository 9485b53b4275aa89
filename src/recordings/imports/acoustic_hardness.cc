#include "recordings/imports/acoustic_hardness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "base/text/json_text.h"
#include "base/text/text.h"
#include "recordings/tables/files_below.h"

namespace somato {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

constexpr std::size_t kLargestSample = std::size_t{64} << 20;
constexpr std::string_view kAdvice = "repair or remove the file";

// The required members of one file; every error has its location.
class SampleReader {
 public:
  SampleReader(const Json& json, const std::string& file) : json_(json), file_(file) {}

  Result<std::string> sample_id() const { return text("/metadata/sample_id"); }

  Result<std::vector<Label>> labels() const {
    SOMATO_TRY(auto hardness, text("/metadata/class"));
    SOMATO_TRY(auto material, text("/metadata/material"));
    SOMATO_TRY(auto release, this->release());
    return std::vector<Label>{{"hardness", hardness}, {"material", material}, {"release", release}};
  }

  Result<Channel> sound() const {
    SOMATO_TRY_VOID(refuse_overflow());
    SOMATO_TRY(auto rate, sample_rate());
    SOMATO_TRY(auto values, samples());
    Channel channel{"sound", "counts", {}, {}, {}};
    const std::size_t count = values.size();
    channel.frames = Matrix<float>(count, 1, std::move(values));
    channel.rate = rate;
    return channel;
  }

 private:
  tl::unexpected<Error> bad(std::string what, const std::string& path) const {
    return fail(ErrorKind::kData, std::move(what), fmt::format("{}:{}", file_, path),
                std::string(kAdvice));
  }

  // The member at `path`, or null where there is none.
  const Json& at(const std::string& path) const {
    static const Json missing;
    const Pointer pointer(path);
    return json_.contains(pointer) ? json_.at(pointer) : missing;
  }

  Result<std::string> text(const std::string& path) const {
    const Json& member = at(path);
    if (!member.is_string()) return bad("a text is missing", path);
    auto content = member.get<std::string>();
    if (is_name(content)) return content;
    return bad("the text is empty, longer than 255 bytes or not on one line", path);
  }

  Result<std::string> release() const {
    const std::string path = "/metadata/comment";
    const Json& comment = at(path);
    if (comment.is_null() || (comment.is_string() && comment.get_ref<const std::string&>().empty()))
      return std::string("device");
    return text(path);
  }

  Result<void> refuse_overflow() const {
    const std::string path = "/audio/overflow";
    const Json& overflow = at(path);
    if (overflow.is_null() || overflow == false || overflow == 0) return {};
    if (overflow.is_boolean() || overflow.is_number()) {
      return bad("the recorder overflowed: samples are lost", path);
    }
    return bad("it must be true or false", path);
  }

  Result<double> sample_rate() const {
    const std::string path = "/audio/sample_rate";
    const Json& rate = at(path);
    if (!rate.is_number()) return bad("a number is missing", path);
    const double hertz = rate.get<double>();
    if (std::isfinite(hertz) && hertz > 0.0) return hertz;
    return bad(fmt::format("{} Hz is not a valid sampling rate", hertz), path);
  }

  Result<std::vector<float>> samples() const {
    const std::string path = "/audio/values";
    const Json& values = at(path);
    if (!values.is_array() || values.empty()) return bad("a list of samples is missing", path);
    const Json& count = at("/audio/num_samples");
    if (count != values.size()) {
      return bad(fmt::format("there are {} samples, but num_samples is {}", values.size(),
                             shown(count.dump())),
                 path);
    }
    std::vector<float> samples;
    samples.reserve(values.size());
    for (const Json& value : values) {
      if (!is_sample(value)) {
        return bad(fmt::format("{} is not a 16-bit integer", shown(value.dump())),
                   fmt::format("{}/{}", path, samples.size()));
      }
      samples.push_back(value.get<float>());
    }
    return samples;
  }

  static bool is_sample(const Json& value) {
    return value.is_number_integer() && value >= INT16_MIN && value <= INT16_MAX;
  }

  const Json& json_;
  const std::string& file_;
};

struct Impact {
  std::string id;
  Exploration exploration;
};

Result<Impact> read_impact(const std::string& file) {
  SOMATO_TRY(const std::string bytes, read_whole(file, kLargestSample));
  const auto json = text_of(bytes, file).and_then([&](std::string_view text) {
    return parse_json<Json>(text, file, std::string(kAdvice));
  });
  if (!json) return fail(json.error());
  const SampleReader reader(*json, file);
  SOMATO_TRY(auto id, reader.sample_id());
  SOMATO_TRY(auto labels, reader.labels());
  SOMATO_TRY(auto sound, reader.sound());
  return Impact{std::move(id), {std::move(labels), file, {std::move(sound)}}};
}

}  // namespace

Result<Recording> import_acoustic_hardness(const std::filesystem::path& folder) {
  SOMATO_TRY(const auto files, files_below(folder, ".json"));
  if (files.empty()) {
    return fail(ErrorKind::kData, "there are no JSON files", folder.string(),
                "use the folder of the data set, or one of its phases");
  }
  Recording recording;
  recording.explorations.reserve(files.size());
  std::map<std::string, std::string> seen;
  for (const std::string& name : files) {
    const std::string file = (folder / name).string();
    SOMATO_TRY(auto impact, read_impact(file));
    const auto [twin, is_new] = seen.emplace(impact.id, file);
    if (!is_new) {
      return fail(ErrorKind::kData,
                  fmt::format("the file has the same sample_id as {}", twin->second), file,
                  "remove one of them");
    }
    recording.explorations.push_back(std::move(impact.exploration));
  }
  return recording;
}

}  // namespace somato
