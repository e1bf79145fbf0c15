#include "figures/figure.h"

#include <algorithm>

namespace seesaw {

bool Check::holds() const {
  switch (relation) {
    case Relation::at_most:
      return value <= bound;
    case Relation::at_least:
      return value >= bound;
    case Relation::equal:
      return value == bound;
  }
  return false;
}

Check at_most(std::string name, double value, double bound) {
  return {std::move(name), value, bound, Check::Relation::at_most};
}
Check at_least(std::string name, double value, double bound) {
  return {std::move(name), value, bound, Check::Relation::at_least};
}
Check equal(std::string name, double value, double wanted) {
  return {std::move(name), value, wanted, Check::Relation::equal};
}

bool Figure::holds() const {
  return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.holds(); });
}

}  // namespace seesaw
