#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace remeshd::cli {

/// Rows of cells in columns as wide as their widest cell; the first row is the heading.
void write_table(std::ostream& out, const std::vector<std::vector<std::string>>& rows);

/// Rows with a tab between cells; tabs and line ends inside a cell become blanks.
void write_tsv_row(std::ostream& out, const std::vector<std::string>& cells);

/// A number in the fewest digits that read back to the same bits.
std::string exact(double value);
/// A number in about `digits` digits, for people.
std::string rounded(double value, int digits = 6);

}  // namespace remeshd::cli
