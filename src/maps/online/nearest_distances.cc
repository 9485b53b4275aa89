#include "maps/online/nearest_distances.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "base/core/dense_rows.h"
#include "maps/online/growing_map.h"
#include "maps/som/map_parts.h"

namespace somato {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// The score of the nearest row that differs.
double nearest_row(std::span<const float> sample, const Matrix<float>& rows,
                   Similarity similarity) {
  double nearest = kNone;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const double score = distance_score(similarity, sample, rows.row(row));
    if (score > 0.0) nearest = std::min(nearest, score);
  }
  return nearest;
}

}  // namespace

void NearestDistances::see(const Samples& samples, const Matrix<float>& kept,
                           Similarity similarity) {
  const bool knows_few = count_ < static_cast<double>(kFewDistances);
  if (samples.count() < 2 && !knows_few) return;
  const Matrix<float> rows = dense_rows(samples);
  const std::size_t queries = std::min(rows.rows(), kMostQueries);
  for (std::size_t query = 0; query < queries; ++query) {
    const auto sample = rows.row(query * rows.rows() / queries);
    double nearest = nearest_row(sample, rows, similarity);
    if (knows_few) nearest = std::min(nearest, nearest_row(sample, kept, similarity));
    if (nearest == kNone) continue;
    sum_ += distance_of_score(similarity, nearest);
    count_ += 1.0;
  }
}

void NearestDistances::save(Archive& archive, const std::string& name) const {
  archive.add(name, Array<double>{{2}, {sum_, count_}});
}

Result<void> NearestDistances::load(const Archive& archive, const std::string& name,
                                    const std::string& where) {
  SOMATO_TRY(const auto found,
             numbers_from(archive, name, 2, 0.0, std::numeric_limits<double>::max(), where));
  const bool is_empty = found[1] == 0.0 && found[0] == 0.0;
  const bool has_mean = found[1] >= 1.0 && found[0] > 0.0;
  if (!is_empty && !has_mean) {
    return damaged_model("'" + name + "' has no sum of distances with their number", where);
  }
  sum_ = found[0];
  count_ = found[1];
  return {};
}

}  // namespace somato
