#pragma once

#include <string>

#include "client/cli/report/content.h"

namespace remeshd::cli {

/// One HTML page that needs nothing else: style, script, figures as JSON, and arrays, compressed.
/// Whoever opens it in a browser loads nothing from anywhere.
std::string report_page(const ReportContent& content);

}  // namespace remeshd::cli
