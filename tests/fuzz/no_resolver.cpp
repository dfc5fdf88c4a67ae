// Stands in for the C library's resolver: an input is no reason to ask the network for a name.
#include <netdb.h>

#include <cstring>

extern "C" int getaddrinfo(const char* host, const char* /*service*/, const addrinfo* /*wanted*/,
                           addrinfo** /*found*/) {
  return host != nullptr && std::strlen(host) > 1000 ? EAI_MEMORY : EAI_NONAME;
}
