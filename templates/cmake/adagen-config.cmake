# Solvers of robots as part of a CMake project: find_package(adagen) with adagen_DIR set to what
# `adagen --cmake-dir` prints, or with adagen on the PATH.
#
#   adagen_add_solver(TARGET MODEL robot.urdf [PROCS P] [OPTIONS --floating ...])
#
# emits a solver by adagen when the project is configured, anew where the model changes, and makes
# it a library. Targets that link TARGET find NAME_pP.h, NAME being TARGET. Unlike on the command
# line P is 1 if it is not given. OPTIONS are those of the command line. ADAGEN_FLAGS are the
# compiler's options for solvers, ADAGEN_PROGRAM is the command. Of --target embedded, TARGET is a
# static library.
cmake_minimum_required(VERSION 3.16)

find_program(ADAGEN_PROGRAM adagen HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../../../../bin"
  DOC "the command adagen")
if(NOT ADAGEN_PROGRAM)
  set(adagen_FOUND FALSE)
  set(adagen_NOT_FOUND_MESSAGE "the command adagen is not on the PATH: say -DADAGEN_PROGRAM=/path/to/adagen")
  return()
endif()

function(adagen_add_solver target)
  cmake_parse_arguments(PARSE_ARGV 1 own "" "MODEL;PROCS" "OPTIONS")
  if(NOT own_MODEL OR own_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR
      "adagen_add_solver(TARGET MODEL robot.urdf [PROCS P] [OPTIONS ...]): ${own_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT target MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    message(FATAL_ERROR "adagen_add_solver: ${target} is no name of C functions")
  endif()
  if(NOT own_PROCS)
    set(own_PROCS 1)
  endif()
  get_filename_component(model "${own_MODEL}" ABSOLUTE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${model}")

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}")
  execute_process(
    COMMAND "${ADAGEN_PROGRAM}" "${model}" --procs "${own_PROCS}" --name "${target}"
      --out "${folder}" ${own_OPTIONS}
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    RESULT_VARIABLE status OUTPUT_VARIABLE messages ERROR_VARIABLE messages)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "adagen ${own_MODEL}: ${messages}")
  endif()
  string(REPLACE ";" "," messages "${messages}")
  string(REGEX MATCHALL "[^\n]*warning: [^\n]*" warnings "${messages}")
  foreach(line IN LISTS warnings)
    message(WARNING "${line}")
  endforeach()

  if("embedded" IN_LIST own_OPTIONS OR "--target=embedded" IN_LIST own_OPTIONS)
    add_library(${target} STATIC "${folder}/${target}_p1.cpp")
    target_include_directories(${target} PUBLIC "${folder}")
    target_compile_features(${target} PRIVATE cxx_std_17)
    target_compile_options(${target} PRIVATE  # as in the CMakeLists.txt of other solvers
      -fno-delete-null-pointer-checks -fno-fast-math ${ADAGEN_FLAGS})
    return()
  endif()
  add_subdirectory("${folder}" "${folder}/build")
  add_library(${target} INTERFACE)
  target_link_libraries(${target} INTERFACE adagen::${target}_p${own_PROCS})
endfunction()
