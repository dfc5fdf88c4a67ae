# The files of client/report that `remesh report` makes its page from, as a C++ source. They are
# committed; deploy/report-page.sh makes the bundle, and the build needs no npm.
set(report_folder ${CMAKE_CURRENT_SOURCE_DIR}/report)
set(report_page_source ${CMAKE_CURRENT_BINARY_DIR}/report/page_parts.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${report_folder}/page.html ${report_folder}/bundle/report.css ${report_folder}/bundle/report.js)
file(READ ${report_folder}/page.html page_template)
file(READ ${report_folder}/bundle/report.css page_style)
file(READ ${report_folder}/bundle/report.js page_script)
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/cli/report/page_parts.cpp.in ${report_page_source} @ONLY)
# Long text, which clang-tidy and a unity build would read for nothing.
set_source_files_properties(${report_page_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
