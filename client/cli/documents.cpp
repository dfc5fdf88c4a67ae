#include "client/cli/documents.h"

#include "proto/document.h"

namespace remeshd::cli {

const std::string& Documents::text(const std::string& name) {
  if (const std::string* known = find(name)) return *known;
  std::string text =
      name == kStandardStream ? read_document(in_, shown(name)) : read_document(name);
  return texts_.emplace(name, std::move(text)).first->second;
}

const std::string* Documents::find(const std::string& name) const {
  const auto found = texts_.find(name);
  return found == texts_.end() ? nullptr : &found->second;
}

std::string Documents::shown(const std::string& name) {
  return name == kStandardStream ? "<stdin>" : name;
}

}  // namespace remeshd::cli
