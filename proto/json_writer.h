// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace remeshd {

struct JsonStyle {
  bool camel_case = false;  ///< names as in documents (`zAxis`), else as in the .proto (`z_axis`)
  bool write_zeros = true;  ///< fields that have their default, and empty lists and maps
  /// Parameters and groups as objects by name, in their order, each as its value or selector alone
  /// where it has no more.
  bool short_forms = false;
  int width = 100;  ///< columns; lists and objects that fit stay on one line
};

/// The canonical JSON of a message: fields in the order of their numbers, map keys sorted, every
/// number (64-bit integers too) as a JSON number in the fewest digits that read back to the same
/// bits, times as RFC 3339, enumerators by name; equal messages give equal text. Ends with a
/// newline. Non-finite numbers, which no checked message has, come out as null.
std::string write_json(const google::protobuf::Message& message, const JsonStyle& style = {});

/// A model or edit message as a document: `parse_model` and `parse_edit` give it back, order
/// included.
std::string write_document(const google::protobuf::Message& message);

}  // namespace remeshd
