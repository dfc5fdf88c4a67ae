#pragma once

#include <cstddef>

namespace remeshd {

/// Lets this process open as many files as its hard limit allows.
void raise_descriptor_limit();

/// As many connections as wanted, or as this process may open beside the files of its own: then the
/// limit of connections is met first, and refuses, while one of descriptors would let them hang.
std::size_t connections_within_descriptors(std::size_t wanted);

}  // namespace remeshd
