#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// Whether a text is a `traceparent` of W3C Trace Context, of version 00 or a later one: version,
/// trace id, parent id and flags in lower-case hexadecimal digits, neither id all zeros. A later
/// version may have more behind another dash.
bool is_trace_parent(std::string_view text);

}  // namespace remeshd
