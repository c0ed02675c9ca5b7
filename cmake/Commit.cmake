# Writes OUTPUT, a source that holds the commit of the tree SOURCE: its first twelve digits, with
# "-dirty" where what the program is made of differs from it; "unknown" without git or outside a
# repository. Leaves OUTPUT alone where it is right already.
cmake_minimum_required(VERSION 3.25)
get_filename_component(above ${SOURCE} DIRECTORY)
set(ENV{GIT_CEILING_DIRECTORIES} ${above})  # not that of a project that this one lies in
set(commit unknown)
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(
    COMMAND ${GIT} status --porcelain -- CMakeLists.txt CMakePresets.json cmake src viewer
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes ERROR_QUIET)
endif()
if(head)
  set(commit ${head})
  if(changes)
    string(APPEND commit -dirty)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
  "namespace washtub {\nextern const char* const commit;\nconst char* const commit = \"@commit@\";\n}\n")
