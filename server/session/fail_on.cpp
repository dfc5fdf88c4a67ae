#include "server/session/fail_on.h"

#include <algorithm>

#include "server/session/session_error.h"

namespace remeshd {

void check_warnings(std::span<const Warning> warnings, std::span<const WarningCode> fail_on) {
  for (const Warning& warning : warnings)
    if (std::ranges::find(fail_on, warning.code) != fail_on.end())
      throw error::warning_is_error(warning);
}

}  // namespace remeshd
