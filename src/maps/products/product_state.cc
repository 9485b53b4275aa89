#include "maps/products/product_state.h"

// Training on few samples of many elements. Every weight vector remains a combination of its
// initial value and the samples,
//
//     w_j = c_j w_j(0) + sum_s A_js x_s,
//
// so it is sufficient to store the coefficients, the squared lengths n_j and, once for all, the
// products G_js(0) = w_j(0) . x_s and K_st = x_s . x_t. The products with the sample i of an
// iteration are
//
//     G_ji = c_j G_ji(0) + sum_s A_js K_si,
//
// and with the gain a (learning rate times neighbourhood)
//
//     n_j <- (1-a)^2 n_j + 2 a (1-a) G_ji + a^2 K_ii,
//     c_j <- (1-a) c_j,    A_j <- (1-a) A_j,    A_ji <- A_ji + a,
//
// where a normalization divides n_j by itself, the others by its root. A row A_j is kept as a
// factor f_j and values, so that shrinking it is one operation. An iteration reads neurons x
// samples numbers, whatever the number of elements. Everything is in double precision.

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/som/initial_weights.h"
#include "somato/core/check.h"

namespace somato {
namespace {

bool are_all(const std::vector<std::size_t>& training, std::size_t samples) {
  if (training.size() != samples) return false;
  for (std::size_t i = 0; i < samples; ++i) {
    if (training[i] != i) return false;
  }
  return true;
}

Matrix<double> products_of(const std::vector<std::size_t>& training, const Matrix<double>& all) {
  if (are_all(training, all.rows())) return {};
  Matrix<double> products(training.size(), training.size());
  for (std::size_t i = 0; i < training.size(); ++i) {
    for (std::size_t k = 0; k < training.size(); ++k) {
      products(i, k) = all(training[i], training[k]);
    }
  }
  return products;
}

}  // namespace

ProductState::ProductState(std::shared_ptr<const ProductProblem> problem, std::size_t threads)
    : problem_(std::move(problem)),
      grid_(problem_->parameters().grid()),
      padded_(problem_->padded()),
      item_products_(std::make_shared<const Matrix<double>>(
          products_of(problem_->training(), problem_->known().products()))),
      of_start_(padded_),
      factors_(padded_, 1.0),
      squared_lengths_(padded_),
      coefficients_(problem_->training().size() * padded_),
      neighbourhood_(grid_, problem_->parameters().neighbourhood),
      gains_(padded_),
      products_(padded_),
      scores_(padded_),
      zeros_(padded_) {
  if (problem_->starts_at_random()) {
    start_at_random(threads);
  } else {
    start_at_combinations(threads);
  }
  if (!dot_product()) return;
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) scale_to_length_one(neuron);
}

void ProductState::scale_to_length_one(std::size_t neuron) {
  if (!(squared_lengths_[neuron] > 0.0)) return;  // zeros have no direction
  const double factor = 1.0 / std::sqrt(squared_lengths_[neuron]);
  of_start_[neuron] *= factor;
  factors_[neuron] *= factor;
  squared_lengths_[neuron] = 1.0;
}

bool ProductState::dot_product() const {
  return problem_->parameters().similarity == Similarity::kDotProduct;
}

void ProductState::start_at_random(std::size_t threads) {
  start_ = std::make_shared<const ProductStart>(problem_->start(threads));
  std::copy_n(start_->squared_lengths.begin(), neurons(), squared_lengths_.begin());
  std::fill_n(of_start_.begin(), neurons(), 1.0);
}

void ProductState::start_at_combinations(std::size_t threads) {
  // Zeros for any sample.
  start_ = std::make_shared<const ProductStart>(ProductStart{AlignedVector<double>(padded_), {}});
  if (problem_->parameters().initial_weights == InitialWeights::kLinear) {
    start_on_plane(threads);
  } else {
    start_at_samples();
  }
}

void ProductState::start_on_plane(std::size_t threads) {
  const Matrix<double> factors = problem_->factors_on_plane(threads);
  std::copy(factors.values().begin(), factors.values().end(), coefficients_.begin());
  AlignedVector<double> products(padded_);
  for (std::size_t item = 0; item < factors.rows(); ++item) {
    products_with_item(item, products);
    for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
      squared_lengths_[neuron] += factors(item, neuron) * products[neuron];
    }
  }
}

void ProductState::start_at_samples() {
  const auto samples = initial_samples(problem_->parameters(), problem_->training().size());
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    coefficients_[samples[neuron] * padded_ + neuron] = 1.0;
    squared_lengths_[neuron] = item_products(samples[neuron])[samples[neuron]];
  }
}

kernels::ProductMap ProductState::map() {
  return {padded_,         problem_->training().size(), of_start_.data(),
          factors_.data(), squared_lengths_.data(),     coefficients_.data()};
}

const double* ProductState::item_products(std::size_t item) const {
  const Matrix<double>& products =
      item_products_->empty() ? problem_->known().products() : *item_products_;
  return products.row(item).data();
}

const double* ProductState::initial_products(std::size_t sample) const {
  return start_->products.data() + (problem_->starts_at_random() ? sample * padded_ : 0);
}

void ProductState::products_with_item(std::size_t item, std::span<double> out) {
  kernels::product_table().products_with(map(), initial_products(problem_->training()[item]),
                                         item_products(item), out.data());
}

void ProductState::products_with(std::size_t sample, std::span<double> out) {
  std::vector<double> with_items;
  with_items.reserve(problem_->training().size());
  for (const std::size_t item : problem_->training()) {
    with_items.push_back(problem_->known().products()(sample, item));
  }
  kernels::product_table().products_with(map(), initial_products(sample), with_items.data(),
                                         out.data());
}

// The first of the nearest neurons, as in Som::winner: by the squared distance without the sample's
// own length, or the negative inner product.
std::size_t ProductState::winner(const double* products) {
  const double* offsets = dot_product() ? zeros_.data() : squared_lengths_.data();
  return kernels::product_table().least(offsets, products, dot_product() ? 1.0 : 2.0, neurons(),
                                        scores_.data());
}

std::size_t ProductState::learn(std::size_t item, double learning_rate, double radius) {
  products_with_item(item, products_);
  const std::size_t nearest = winner(products_.data());
  neighbourhood_.around(nearest, radius, gains_);
  for (double& gain : gains_) gain *= learning_rate;
  kernels::product_table().move(map(), item, item_products(item)[item], products_.data(),
                                gains_.data(), dot_product());
  return nearest;
}

void ProductState::learn_all(double radius) {
  const std::size_t items = problem_->training().size();
  const Matrix<double> shares = neighbourhoods(winners(), radius);
  AlignedVector<double> totals(padded_);
  for (std::size_t item = 0; item < items; ++item) {
    const auto row = shares.row(item);
    for (std::size_t j = 0; j < padded_; ++j) totals[j] += row[j];
  }
  become_means(shares, totals);
  measure_means(totals);
}

double ProductState::mean_distance() {
  const std::vector<std::size_t> found = winners();
  double sum = 0.0;
  for (std::size_t item = 0; item < found.size(); ++item) {
    const std::size_t sample = problem_->training()[item];
    const std::span<const double> products(&all_products_[item * padded_], padded_);
    sum += distance(problem_->reading(sample, products, squared_lengths_), found[item]);
  }
  return sum / static_cast<double>(found.size());
}

// The winners of all inputs.
std::vector<std::size_t> ProductState::winners() {
  const std::size_t items = problem_->training().size();
  const bool known = !all_products_.empty();
  all_products_.resize(items * padded_);
  std::vector<std::size_t> found;
  found.reserve(items);
  for (std::size_t item = 0; item < items; ++item) {
    const std::span<double> products(&all_products_[item * padded_], padded_);
    if (!known) products_with_item(item, products);
    found.push_back(winner(products.data()));
  }
  return found;
}

// Around each winner: winners x padded neurons.
Matrix<double> ProductState::neighbourhoods(const std::vector<std::size_t>& winners,
                                            double radius) {
  Matrix<double> around(winners.size(), padded_);
  std::vector<std::size_t> first(neurons(), winners.size());
  for (std::size_t i = 0; i < winners.size(); ++i) {
    std::size_t& same = first[winners[i]];
    if (same == winners.size()) {
      neighbourhood_.around(winners[i], radius, around.row(i));
      same = i;
    } else {
      std::copy_n(around.row(same).begin(), padded_, around.row(i).begin());
    }
  }
  return around;
}

// A neuron that no winner reaches keeps its weights.
void ProductState::become_means(const Matrix<double>& shares, std::span<const double> totals) {
  for (std::size_t item = 0; item < shares.rows(); ++item) {
    double* values = &coefficients_[item * padded_];
    const auto row = shares.row(item);
    for (std::size_t j = 0; j < padded_; ++j) {
      values[j] = totals[j] > 0.0 ? row[j] / totals[j] : factors_[j] * values[j];
    }
  }
  std::fill(factors_.begin(), factors_.end(), 1.0);
  for (std::size_t j = 0; j < padded_; ++j) {
    if (totals[j] > 0.0) of_start_[j] = 0.0;
  }
}

void ProductState::measure_means(std::span<const double> totals) {
  const std::size_t items = problem_->training().size();
  AlignedVector<double> squares(padded_);
  for (std::size_t item = 0; item < items; ++item) {
    const std::span<double> products(&all_products_[item * padded_], padded_);
    products_with_item(item, products);
    const double* values = &coefficients_[item * padded_];
    for (std::size_t j = 0; j < padded_; ++j) {
      squares[j] = std::fma(values[j], products[j], squares[j]);
    }
  }
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    if (!(totals[neuron] > 0.0)) continue;
    squared_lengths_[neuron] = squares[neuron];
    if (!dot_product()) continue;
    scale_to_length_one(neuron);
    for (std::size_t item = 0; item < items; ++item) {
      all_products_[item * padded_ + neuron] *= factors_[neuron];
    }
  }
}

LaneMatrix<float> ProductState::form(std::size_t threads) const {
  const auto& training = problem_->training();
  AlignedVector<double> coefficients(problem_->known().samples().count() * padded_);
  for (std::size_t item = 0; item < training.size(); ++item) {
    for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
      coefficients[training[item] * padded_ + neuron] +=
          factors_[neuron] * coefficients_[item * padded_ + neuron];
    }
  }
  return problem_->form(of_start_, coefficients, threads);
}

}  // namespace somato
