#include "somato/core/result.h"

namespace somato {

std::string to_string(const Error& error) {
  std::string line = error.where.empty() ? error.what : error.where + ": " + error.what;
  if (!error.advice.empty()) line += "; " + error.advice;
  return line;
}

}  // namespace somato
