#include "views/report/deciding_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "recordings/explorations/recording_json.h"
#include "somato/graph/system_contributions.h"
#include "views/report/confused_samples.h"
#include "views/report/packed_json.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostConfused = 8;
constexpr std::size_t kMostAmbiguous = 4;
constexpr std::size_t kMostListed = 1024;  // of a source whose contributions are listed

// A sample and the two neurons that are compared.
struct Decision {
  TestedSample tested;
  std::string label;       // the true class
  std::size_t answer = 0;  // the class of the most similar neuron
  InputContributions read;
};

class DecisionReader {
 public:
  DecisionReader(const Evidence& evidence, const ContributionReader& reader, std::size_t threads)
      : evidence_(evidence), reader_(reader), deciding_(reader.deciding(inputs(), threads)) {}

  std::vector<Decision> decisions() const {
    std::vector<Decision> all;
    for (TestedSample& one : confused_samples(evidence_, kMostConfused)) {
      const DecidingNeurons neurons = of_confusion(one).value_or(deciding_[one.sample]);
      all.push_back(decision(std::move(one), neurons));
    }
    for (const std::size_t sample : ambiguous(all)) {
      all.push_back(decision(tests_of(evidence_, sample), deciding_[sample]));
    }
    return all;
  }

 private:
  const Samples& inputs() const { return *evidence_.inputs; }
  const SystemAnswer& answer() const { return *evidence_.model->model.answer; }

  std::string label_of(std::size_t sample) const {
    const std::size_t number = evidence_.explorations[sample];
    return find_label(evidence_.recording->explorations[number], answer().label)
        .value_or(std::string());
  }

  Decision decision(TestedSample tested, DecidingNeurons neurons) const {
    const std::size_t sample = tested.sample;
    const std::size_t nearest = answer().labels[deciding_[sample].nearest].value();
    return {std::move(tested), label_of(sample), nearest, reader_.read(inputs()[sample], neurons)};
  }

  // The nearest neurons of the true and the predicted class, if the saved map has both.
  std::optional<DecidingNeurons> of_confusion(const TestedSample& tested) const {
    const std::string label = label_of(tested.sample);
    std::vector<std::optional<std::size_t>> classes(answer().labels.neurons());
    bool has_label = false;
    bool has_predicted = false;
    for (const std::size_t neuron : answer().labels.labelled()) {
      const std::string& name = answer().classes[*answer().labels[neuron]];
      if (name != label && name != tested.predicted) continue;
      classes[neuron] = answer().labels[neuron];
      (name == label ? has_label : has_predicted) = true;
    }
    if (!has_label || !has_predicted) return {};
    SampleCollector one;
    one.add(inputs()[tested.sample]);
    return deciding_neurons(reader_.som(), NeuronLabels(std::move(classes)), one.samples()).front();
  }

  // How much the two distances differ, from 0 to 1.
  double margin(std::size_t sample) const {
    const Contributions two = contributions(reader_.som(), inputs()[sample], deciding_[sample]);
    const double sum = std::fabs(two.of_nearest) + std::fabs(two.of_other);
    return sum > 0.0 ? std::fabs(two.of_nearest - two.of_other) / sum : 0.0;
  }

  // The samples with the least margins, except those that are listed already.
  std::vector<std::size_t> ambiguous(const std::vector<Decision>& listed) const {
    std::vector<std::pair<double, std::size_t>> margins;
    for (std::size_t sample = 0; sample < inputs().count(); ++sample) {
      const bool is_listed = std::any_of(listed.begin(), listed.end(), [&](const Decision& one) {
        return one.tested.sample == sample;
      });
      if (!is_listed) margins.emplace_back(margin(sample), sample);
    }
    std::sort(margins.begin(), margins.end());
    margins.resize(std::min(margins.size(), kMostAmbiguous));
    std::vector<std::size_t> samples;
    samples.reserve(margins.size());
    for (const auto& [margin, sample] : margins) samples.push_back(sample);
    return samples;
  }

  const Evidence& evidence_;
  const ContributionReader& reader_;
  std::vector<DecidingNeurons> deciding_;
};

std::size_t size_of(const ContributionSource& source) {
  return std::accumulate(source.shape.begin(), source.shape.end(), std::size_t{1},
                         std::multiplies<>());
}

// A channel as in the recording, so that its elements have their places on the skin.
Json channel_of(const ContributionSource& source, std::size_t size, const Recording& recording) {
  const auto channel = find_channel(recording.explorations.front(), source.name);
  Json json = source.is_channel && channel ? channel_json(**channel)
                                           : channel_json(source.name, "", {}, source.shape);
  if (size > kMostListed) json["elements"] = Json::array();
  return json;
}

Json values_json(const ContributionSource& source, std::size_t number, std::size_t size,
                 const std::vector<Decision>& decisions) {
  if (size > kMostListed) return packed_rows({}, 0, PackedBits::k16);
  std::vector<double> values;
  for (const Decision& one : decisions) {
    std::vector<double> row(size, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < source.places.size(); ++i) {
      row[source.places[i]] = one.read.values[number][i];
    }
    values.insert(values.end(), row.begin(), row.end());
  }
  return packed_rows(values, size, PackedBits::k16);
}

Json sources_json(const ContributionReader& reader, const Recording& recording,
                  const std::vector<Decision>& decisions) {
  Json json = Json::array();
  for (std::size_t i = 0; i < reader.sources().size(); ++i) {
    const ContributionSource& source = reader.sources()[i];
    const std::size_t size = size_of(source);
    json.push_back({{"channel", channel_of(source, size, recording)},
                    {"is_channel", source.is_channel},
                    {"values", values_json(source, i, size, decisions)}});
  }
  return json;
}

Json decision_json(const Decision& one, const std::vector<std::string>& classes) {
  Json sums = Json::array();
  for (const std::vector<double>& values : one.read.values) {
    sums.push_back(std::accumulate(values.begin(), values.end(), 0.0));
  }
  return {{"sample", one.tested.sample},
          {"label", one.label},
          {"tests", one.tested.tests},
          {"predicted", one.tested.predicted},
          {"confused", one.tested.confused},
          {"answer", classes[one.answer]},
          {"nearest", classes[one.read.nearest]},
          {"other", classes[one.read.other]},
          {"of_nearest", one.read.of_nearest},
          {"of_other", one.read.of_other},
          {"sums", std::move(sums)}};
}

bool compares_products(const Som& som) {
  const SomParameters& parameters = som.parameters();
  return parameters.layers.empty() && parameters.similarity == Similarity::kDotProduct;
}

}  // namespace

Json deciding_json(const Evidence& evidence, std::size_t threads) {
  if (!evidence.inputs || evidence.inputs->count() == 0) return nullptr;
  // The reader does not outlive the evidence.
  const auto model =
      std::shared_ptr<const SystemModel>(std::shared_ptr<void>(), &evidence.model->model);
  const auto reader = ContributionReader::build(model);
  if (!reader) return nullptr;
  const std::vector<Decision> decisions = DecisionReader(evidence, *reader, threads).decisions();
  Json list = Json::array();
  for (const Decision& one : decisions) {
    list.push_back(decision_json(one, model->answer->classes));
  }
  return {{"label", model->answer->label},
          {"unit", reader->unit()},
          {"products", compares_products(reader->som())},
          {"sources", sources_json(*reader, *evidence.recording, decisions)},
          {"decisions", std::move(list)}};
}

}  // namespace somato::detail
