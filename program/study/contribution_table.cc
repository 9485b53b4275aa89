#include "study/contribution_table.h"

#include <fmt/format.h>

#include <utility>

#include "base/files/file_writer.h"
#include "somato/files/csv.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

std::string unit_of(const ContributionReader& reader) {
  if (!reader.unit().empty()) return reader.unit();
  const SomParameters& parameters = reader.som().parameters();
  const bool multiplies =
      parameters.layers.empty() && parameters.similarity == Similarity::kDotProduct;
  return multiplies ? "inner product" : "distance";
}

std::string header_of(const ContributionReader& reader, const std::string& label) {
  return fmt::format("exploration,source,{},{},distance,other_distance,channel,element,{}\n",
                     csv_field("nearest_" + label), csv_field("other_" + label),
                     csv_field(fmt::format("contribution ({})", unit_of(reader))));
}

// `beginning` is that of all rows of the exploration.
std::string rows_of(const std::vector<ContributionSource>& sources, const InputContributions& read,
                    const std::string& beginning) {
  std::string rows;
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const std::string name = csv_field(sources[s].name);
    for (std::size_t i = 0; i < read.values[s].size(); ++i) {
      const double value = read.values[s][i];
      if (!sources[s].is_channel && value == 0.0) continue;
      rows += fmt::format("{},{},{},{:.9g}\n", beginning, name, csv_field(sources[s].elements[i]),
                          value);
    }
  }
  return rows;
}

}  // namespace

Result<void> save_contributions(const std::string& path,
                                const std::shared_ptr<const SystemModel>& model,
                                const Recording& recording, const Samples& inputs,
                                std::size_t threads) {
  SOMATO_TRY(const auto reader, ContributionReader::build(model));
  SOMATO_TRY(FileWriter file, FileWriter::begin(path));
  const Progress progress = terminal_progress("contributions");
  const std::vector<DecidingNeurons> deciding = reader.deciding(inputs, threads);
  const SystemAnswer& answer = *model->answer;
  SOMATO_TRY_VOID(file.write(header_of(reader, answer.label)));
  for (std::size_t i = 0; i < inputs.count(); ++i) {
    if (!progress(i, inputs.count())) {
      return fail(ErrorKind::kInterrupted, "the contributions were not saved", path);
    }
    const InputContributions read = reader.read(inputs[i], deciding[i]);
    const std::string beginning =
        fmt::format("{},{},{},{},{:.9g},{:.9g}", i + 1, csv_field(recording.explorations[i].source),
                    csv_field(answer.classes[read.nearest]), csv_field(answer.classes[read.other]),
                    read.of_nearest, read.of_other);
    SOMATO_TRY_VOID(file.write(rows_of(reader.sources(), read, beginning)));
  }
  progress(inputs.count(), inputs.count());
  return file.commit();
}

}  // namespace somato::program
