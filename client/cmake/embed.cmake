# remeshd_embed(SOURCE FUNCTION FILE...): writes a C++ source with the texts of files, which
# `FUNCTION` of client/cli/embedded.h returns. A file that changes is taken at the next build.
function(remeshd_embed source function)
  set(entries "")
  foreach(file ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    cmake_path(GET file FILENAME name)
    string(REGEX REPLACE "(\\.schema)?\\.json$" "" name ${name})
    file(READ ${file} text)
    string(APPEND entries "    {\"${name}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE ${source}.new "#include \"client/cli/embedded.h\"\n
namespace remeshd::cli {\n
const std::vector<EmbeddedText>& ${function}() {
  static const std::vector<EmbeddedText> texts{\n${entries}  };
  return texts;
}\n
}  // namespace remeshd::cli\n")
  file(COPY_FILE ${source}.new ${source} ONLY_IF_DIFFERENT)
  file(REMOVE ${source}.new)
endfunction()
