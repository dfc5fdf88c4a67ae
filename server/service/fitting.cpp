#include "server/service/fitting.h"

#include <algorithm>

#include "engine/base/utf8.h"

namespace remeshd {
std::string fitting(const std::string& text, std::size_t limit) {
  constexpr std::size_t kDots = 3;
  std::string out;
  std::size_t cut = 0;  // where the dots would go
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::size_t next = std::max<std::size_t>(length, 1);
    if (out.size() + next > limit) return out.substr(0, cut) + "...";
    if (length == 0) {
      out += '?';
    } else {
      out.append(text, at, length);
    }
    at += next;
    if (out.size() + kDots <= limit) cut = out.size();
  }
  return out;
}

}  // namespace remeshd
