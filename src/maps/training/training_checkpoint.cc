#include "maps/training/training_checkpoint.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/archives/archive.h"
#include "base/archives/checksum.h"
#include "base/text/flag_hint.h"
#include "maps/som/layer_parts.h"
#include "maps/som/map_parts.h"
#include "maps/som/som_archive.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

const std::string kCheckpointKind = "som checkpoint";
const std::string kCheckpointPrefix = "som.";

std::string_view bytes_of(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

Result<LengthChecks::State> read_checks(const Archive& archive, const std::string& path) {
  SOMATO_TRY(const auto counts, archive.get<Array<std::int64_t>>("checks", path));
  SOMATO_TRY(const auto error, archive.get<Array<double>>("least_error", path));
  const auto& values = counts->values;
  if (values.size() != 2 || values[0] < 0 || values[1] < 0 || error->values.size() != 1) {
    return damaged_model("'checks' and 'least_error' are not those of a training", path);
  }
  return LengthChecks::State{static_cast<std::uint64_t>(values[0]),
                             static_cast<std::uint64_t>(values[1]), error->values[0]};
}

std::uint64_t most_epochs(const SomParameters& parameters) {
  return parameters.epochs + (parameters.is_length_automatic() ? parameters.most_checks : 0);
}

}  // namespace

std::string training_identity(const SomParameters& parameters, const SampleSurvey& survey) {
  const std::uint64_t ranges = fnv1a64(bytes_of(survey.high), fnv1a64(bytes_of(survey.low)));
  return fmt::format("{}{}samples = {}\nfeatures = {}\nranges = {:016x}\n",
                     parameters_to_toml(parameters), layers_to_toml(parameters.layers),
                     survey.count, survey.low.size(), ranges);
}

Result<void> save_checkpoint(const std::string& path, const std::string& identity,
                             const TrainingCheckpoint& checkpoint) {
  Archive archive(kCheckpointKind);
  archive.add("training", identity);
  archive.add("epochs", Array<std::int64_t>{{1}, {static_cast<std::int64_t>(checkpoint.epochs)}});
  add_som(archive, kCheckpointPrefix, checkpoint.som);
  if (checkpoint.som.parameters().is_length_automatic()) {
    const auto& [checks, without_improvement, least_error] = checkpoint.checks;
    archive.add("checks", Array<std::int64_t>{{2},
                                              {static_cast<std::int64_t>(checks),
                                               static_cast<std::int64_t>(without_improvement)}});
    archive.add("least_error", Array<double>{{1}, {least_error}});
  }
  return save_archive(path, archive);
}

Result<std::optional<TrainingCheckpoint>> load_checkpoint(const std::string& path,
                                                          const std::string& identity) {
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) return std::optional<TrainingCheckpoint>{};
  SOMATO_TRY(const auto archive, load_archive(path));
  if (archive.kind() != kCheckpointKind) {
    return damaged_model("the file is not a checkpoint of training", path);
  }
  SOMATO_TRY(const auto training, archive.get<std::string>("training", path));
  if (*training != identity) {
    return fail(
        ErrorKind::kUsage,
        "the checkpoint, of format 1, is that of a training with other parameters or data, or of "
        "another version of Somato",
        path,
        fmt::format("complete that training, use another checkpoint{}, or remove the file",
                    flag_hint("checkpoint")));
  }
  SOMATO_TRY(const auto epochs, archive.get<Array<std::int64_t>>("epochs", path));
  SOMATO_TRY(auto som, som_from(archive, kCheckpointPrefix, path));
  if (epochs->values.size() != 1 || epochs->values[0] < 0 ||
      std::cmp_greater(epochs->values[0], most_epochs(som.parameters()))) {
    return damaged_model("'epochs' is not a number of epochs", path);
  }
  TrainingCheckpoint checkpoint{static_cast<std::uint64_t>(epochs->values[0]), std::move(som)};
  if (!checkpoint.som.parameters().is_length_automatic()) return checkpoint;
  SOMATO_TRY(checkpoint.checks, read_checks(archive, path));
  return checkpoint;
}

}  // namespace somato
