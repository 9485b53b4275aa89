#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "maps/svg/svg.h"

namespace somato {

/// The markers of classes with their names, in as many columns as fit.
class Legend {
 public:
  Legend(const std::vector<std::string>& names, double width);

  double height() const;
  void draw(SvgWriter& svg, Point corner) const;

 private:
  std::vector<std::string> names_;
  double width_ = 0.0;
  std::size_t shown_ = 0;
  std::size_t columns_ = 1;
};

/// The displayed name of a class; an empty or blank name is described.
std::string shown_name(const std::string& name);

}  // namespace somato
