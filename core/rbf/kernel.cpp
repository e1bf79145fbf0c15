#include "core/rbf/kernel.h"

namespace seesaw {

std::string_view name_of(Kernel kernel) {
  switch (kernel) {
    case Kernel::thin_plate_spline:
      return "thin_plate_spline";
    case Kernel::cubic:
      return "cubic";
    case Kernel::linear:
      return "linear";
  }
  return "?";
}

std::optional<Kernel> kernel_named(std::string_view name) {
  for (const Kernel kernel : all_kernels)
    if (name_of(kernel) == name) return kernel;
  return std::nullopt;
}

}  // namespace seesaw
