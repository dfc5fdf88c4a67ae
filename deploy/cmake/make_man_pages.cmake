# cmake -DHELP2MAN=... -DREMESH=... -DREMESHD=... -DVERSION=... -DOUT=... -P make_man_pages.cmake
# writes OUT/man1 and OUT/man8: a page for each command that `remesh --help` lists.
function(write_page folder section command about)
  string(REPLACE " " "-" page ${command})
  set(file ${OUT}/${folder}/${page}.${section})
  execute_process(
    COMMAND ${HELP2MAN} --no-info --section=${section} --version-string=${VERSION}
            --name=${about} --source=remeshd --output=${file} ${command}
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "help2man failed for ${command}")
  endif()
  # A page is called as its file is.
  file(READ ${file} text)
  string(TOUPPER ${page} title)
  string(REGEX REPLACE "\n\\.TH [A-Z]+ " "\n.TH ${title} " text "${text}")
  string(REPLACE "\n.SH NAME\n${command} \\- " "\n.SH NAME\n${page} \\- " text "${text}")
  # Each example in a line of its own.
  string(REGEX REPLACE "\nremesh ([a-z])" "\n.br\nremesh \\1" text "${text}")
  file(WRITE ${file} "${text}")
endfunction()

file(REMOVE_RECURSE ${OUT}/man1 ${OUT}/man8)
file(MAKE_DIRECTORY ${OUT}/man1 ${OUT}/man8)
# What help2man runs is called as users call it.
get_filename_component(programs ${REMESH} DIRECTORY)
set(ENV{PATH} "${programs}:$ENV{PATH}")
execute_process(COMMAND ${REMESH} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," help "${help}")
string(REGEX MATCH "\nSubcommands:\n(  [^\n]*\n)+" list "${help}")
string(REGEX MATCHALL "\n  [a-z]+ +[^\n]+" lines "${list}")
write_page(man1 1 remesh "mesh feature models and remesh them after edits")
foreach(line ${lines})
  string(REGEX MATCH "  ([a-z]+) +(.*)" matched "${line}")
  write_page(man1 1 "remesh ${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
endforeach()
write_page(man8 8 remeshd "serve tetrahedral meshes of feature models")
