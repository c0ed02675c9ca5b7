#pragma once
#include <string>

#include "verify/report.hpp"

namespace washtub {

/// verification.html: the report as one page that needs no other file, figures within, for light
/// and dark screens.
std::string report_page(const Report& report);

}  // namespace washtub
