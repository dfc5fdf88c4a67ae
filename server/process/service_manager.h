#pragma once

#include <string>

namespace remeshd {

/// Tells the service manager that started this process (systemd, Type=notify) a state: `READY=1`,
/// `STOPPING=1`, as sd_notify(3) has them. Does nothing where there is none (no NOTIFY_SOCKET), and
/// returns false where it cannot be told.
bool notify_service_manager(const std::string& state);

}  // namespace remeshd
