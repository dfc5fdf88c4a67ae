#pragma once

#include <string_view>

namespace remeshd::cli {

// The files of client/report that the page is made from, built into the program.
extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< bundle/report.css
extern const std::string_view kPageScript;    ///< bundle/report.js

}  // namespace remeshd::cli
