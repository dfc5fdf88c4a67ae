# Pages of the manual, remesh(1), remesh-COMMAND(1) and remeshd(8), made by help2man of what the
# programs say of themselves. Where it is absent, or nothing is meshed, there are none.
find_program(HELP2MAN help2man)
if(HELP2MAN AND TARGET remesh AND TARGET remeshd)
  set(man ${PROJECT_BINARY_DIR}/man)
  add_custom_command(
    OUTPUT ${man}/man1/remesh.1 ${man}/man8/remeshd.8
    COMMAND ${CMAKE_COMMAND} -DHELP2MAN=${HELP2MAN} -DREMESH=$<TARGET_FILE:remesh>
            -DREMESHD=$<TARGET_FILE:remeshd> -DVERSION=${PROJECT_VERSION} -DOUT=${man}
            -P ${CMAKE_CURRENT_LIST_DIR}/make_man_pages.cmake
    DEPENDS remesh remeshd ${CMAKE_CURRENT_LIST_DIR}/make_man_pages.cmake
    VERBATIM)
  add_custom_target(man_pages ALL DEPENDS ${man}/man1/remesh.1 ${man}/man8/remeshd.8)
  # The folder is there also where only programs were built.
  file(MAKE_DIRECTORY ${man})
  install(DIRECTORY ${man}/ DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT documentation)
endif()
