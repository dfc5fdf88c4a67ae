#pragma once

#include <cstddef>

namespace remeshd {

/// Lets this process open as many files as its hard limit allows.
void raise_descriptor_limit();

/// `wanted`, or as many connections as this process may open beside its own files, if that is less:
/// so the limit of connections, at which further ones are closed, is met before the limit of
/// descriptors, at which they would hang.
std::size_t connections_within_descriptors(std::size_t wanted);

}  // namespace remeshd
