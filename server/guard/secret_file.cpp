#include "server/guard/secret_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include "server/limits.h"

namespace remeshd {
namespace {

struct OpenFile {
  int descriptor;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

}  // namespace

std::string read_secret_file(const std::filesystem::path& file) {
  const auto fail = [&](const std::string& why) {
    return SecretFileError(file.string() + ": " + why);
  };
  const OpenFile in{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  struct stat status {};
  if (in.descriptor < 0 || ::fstat(in.descriptor, &status) != 0) throw fail(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) throw fail("is no file");
  if (status.st_uid != 0 && status.st_uid != ::geteuid()) throw fail("belongs to another user");
  if ((status.st_mode & (S_IROTH | S_IWOTH | S_IWGRP)) != 0)
    throw fail("others may read or change it; chmod 600 keeps them out");
  std::string text(limits::kSecretFileBytes + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t got = ::read(in.descriptor, text.data() + size, text.size() - size);
    if (got < 0) throw fail(std::strerror(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size > limits::kSecretFileBytes) throw fail("has more than a mebibyte");
  text.resize(size);
  return text;
}

}  // namespace remeshd
