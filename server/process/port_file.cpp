#include "server/process/port_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "server/transport/descriptor.h"

namespace remeshd {

PortFile::PortFile(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code ignored;
  if (!file_.empty()) std::filesystem::remove(file_, ignored);
}

PortFile::~PortFile() {
  std::error_code ignored;
  if (!file_.empty()) std::filesystem::remove(file_, ignored);
}

void PortFile::write(const std::vector<std::string>& addresses) const {
  if (file_.empty()) return;
  std::string text;
  for (const std::string& address : addresses) text += address + '\n';
  std::filesystem::path fresh = file_;
  fresh += ".new";
  const Descriptor out(
      ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644));
  // Whoever may know where the daemon is may read it: an address is no secret.
  if (!out.is_open() || ::fchmod(out.get(), 0644) != 0 ||
      ::write(out.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size()) ||
      ::rename(fresh.c_str(), file_.c_str()) != 0)
    throw std::system_error(errno, std::generic_category(), "port file " + file_.string());
}

}  // namespace remeshd
