// index.html: all figures on one page, each with its picture, what the paper says, the facts and the checks.
#pragma once

#include "figures/figure.h"

namespace seesaw {

/// The page for descriptions as figures/output.h gives them; the pictures lie beside it.
std::string gallery_page(const std::vector<Facts>& descriptions);

}  // namespace seesaw
