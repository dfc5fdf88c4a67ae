// SPDX-License-Identifier: Apache-2.0
#include "proto/document.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "proto/document_edit.h"
#include "proto/document_error.h"
#include "proto/document_model.h"

namespace remeshd {

namespace v1 = remesh::v1;

namespace {

template <typename Message>
Message message_of(const Json& json, void (*read)(const Entry&, Message&)) {
  Message message;
  read(Entry(json, {}), message);
  return message;
}

}  // namespace

std::string read_document(const std::filesystem::path& file, const DocumentLimits& limits) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure))
    throw error::document_unreadable(file.string(), "it is a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw error::document_unreadable(file.string(), std::strerror(errno));
  const auto size = std::filesystem::file_size(file, failure);
  if (!failure && size > limits.bytes) throw error::document_too_large(size, limits.bytes);
  return read_document(in, file.string(), limits);
}

std::string read_document(std::istream& in, const std::string& name, const DocumentLimits& limits) {
  // A pipe tells no size: never take more than one byte over the limit.
  std::string text(limits.bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw error::document_unreadable(name, std::strerror(errno));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > limits.bytes) throw error::document_too_large(text.size(), limits.bytes);
  return text;
}

v1::FeatureModel parse_model(std::string_view text, const DocumentLimits& limits) {
  return message_of(read_json(text, limits), read_model);
}

v1::ModelEdit parse_edit(std::string_view text, const DocumentLimits& limits) {
  return message_of(read_json(text, limits), read_edits);
}

std::variant<v1::FeatureModel, v1::ModelEdit> parse_document(std::string_view text,
                                                             const DocumentLimits& limits) {
  const Json json = read_json(text, limits);
  if (Entry(json, {}).find("edits")) return message_of(json, read_edits);
  return message_of(json, read_model);
}

}  // namespace remeshd
