#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/recording/csv_import.h"

namespace somato {

/// A channel of these columns.
inline CsvChannel channel_of(std::string name, std::vector<std::string> columns) {
  CsvChannel channel;
  channel.name = std::move(name);
  channel.columns = std::move(columns);
  return channel;
}

}  // namespace somato
