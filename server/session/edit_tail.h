#pragma once

#include <string>

namespace remeshd {

/// Puts the document of the edit that made a revision behind the revision's bytes.
void append_edit(std::string& bytes, const std::string& edit);

/// Takes it off them again. Throws Error(Internal) where it is not there.
std::string take_edit(std::string& bytes);

}  // namespace remeshd
