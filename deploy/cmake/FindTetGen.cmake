# Debian's libtet1.5-dev: the header tetgen.h and the library libtet, with no CMake package of its
# own. Defines TetGen_FOUND, TetGen_VERSION and the target TetGen::TetGen.
find_path(TetGen_INCLUDE_DIR tetgen.h)
find_library(TetGen_LIBRARY NAMES tet tetgen)
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)

if(TetGen_INCLUDE_DIR)
  # The header names its version in a comment only: "Version 1.5".
  file(STRINGS ${TetGen_INCLUDE_DIR}/tetgen.h tetgen_version REGEX "Version [0-9.]+" LIMIT_COUNT 1)
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" TetGen_VERSION "${tetgen_version}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR
                                  VERSION_VAR TetGen_VERSION)

if(TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(TetGen::TetGen PROPERTIES
    IMPORTED_LOCATION ${TetGen_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${TetGen_INCLUDE_DIR}
    # Without it the header declares a command-line program instead of functions that throw.
    INTERFACE_COMPILE_DEFINITIONS TETLIBRARY)
endif()
