#include "client/cli/terminal.h"

#include <unistd.h>

#include <string_view>

namespace remeshd::cli {

bool can_draw(int descriptor, const char* kind) {
  return ::isatty(descriptor) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

}  // namespace remeshd::cli
