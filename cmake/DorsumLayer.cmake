# SPDX-License-Identifier: Apache-2.0
# dorsum_layer(NAME
#   [DEPENDS layer...]         layers that its sources and headers include; passed on to whoever links it
#   [LINK target...]           other people's libraries that its headers show
#   [LINK_PRIVATE target...]   other people's libraries that only its sources use
#   [TEST_DEPENDS layer...]    further layers, earlier or later, that only its tests include
#   [TEST_LINK target...]      other people's libraries that only its tests use
#   [TEST_ALONE filter]        tests (GoogleTest's filter) that run one at a time: each keeps a processor busy
#   [APPLICATION])             part of a program: not installed as a library
#
# Makes the library dorsum_<name>, alias Dorsum::<name>, of all *.cc in the folder, and the test program
# dorsum_<name>_test of all *_test.cc. A *_main.cc belongs to dorsum_program(), a *_benchmark.cc to nobody here.
#
# A layer sees headers through <build>/layers/<name>/, which holds one link <name> to its folder, so that an
# #include of a layer that it does not list finds no file.

# A layer may depend on those before it only.
set(DORSUM_LAYER_ORDER
  base geometry captures imaging stripes calibration surface report simulator device biometrics gallery jobs
  cli service studio)
set(DORSUM_STRANGERS cli service studio)  # know nothing of each other

function(_dorsum_check_dependency name dependency)
  list(FIND DORSUM_LAYER_ORDER "${name}" own)
  list(FIND DORSUM_LAYER_ORDER "${dependency}" other)
  if(own LESS 0)
    message(FATAL_ERROR "'${name}' is not in DORSUM_LAYER_ORDER (cmake/DorsumLayer.cmake)")
  elseif(other LESS 0)
    message(FATAL_ERROR "Layer '${name}' depends on '${dependency}', which is no layer")
  elseif(NOT other LESS own)
    message(FATAL_ERROR "Layer '${name}' may not depend on '${dependency}': only on layers before it in "
      "DORSUM_LAYER_ORDER (cmake/DorsumLayer.cmake)")
  elseif(name IN_LIST DORSUM_STRANGERS AND dependency IN_LIST DORSUM_STRANGERS)
    message(FATAL_ERROR "Layer '${name}' may not depend on '${dependency}': they know nothing of each other")
  elseif(NOT TARGET dorsum_${dependency})
    message(FATAL_ERROR "Layer '${name}' depends on '${dependency}', which has no CMakeLists.txt yet")
  endif()
endfunction()

function(_dorsum_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ALONE" "SOURCES;DEPENDS;LINK")
  list(TRANSFORM arg_DEPENDS PREPEND "Dorsum::")
  add_executable(dorsum_${name}_test ${arg_SOURCES})
  target_link_libraries(dorsum_${name}_test PRIVATE
    Dorsum::${name} ${arg_DEPENDS} ${arg_LINK} GTest::gmock GTest::gmock_main)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # At -O3 it takes members of temporary aggregates, of which tests make many, for uninitialised.
    target_compile_options(dorsum_${name}_test PRIVATE $<$<CONFIG:Release>:-Wno-maybe-uninitialized>)
  endif()
  set(timeout 300)
  if(DORSUM_SANITIZE)
    set(timeout 1800)  # up to twenty times as slow
  endif()
  # Run from the source folder, so that a test may name a file of the repository by its relative path.
  set(common
    TEST_PREFIX "${name}."
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 120)
  if(arg_ALONE)
    gtest_discover_tests(dorsum_${name}_test ${common} TEST_FILTER "${arg_ALONE}"
      PROPERTIES TIMEOUT ${timeout} LABELS ${name} RESOURCE_LOCK simulated_controller)
    gtest_discover_tests(dorsum_${name}_test ${common} TEST_FILTER "-${arg_ALONE}"
      PROPERTIES TIMEOUT ${timeout} LABELS ${name})
  else()
    gtest_discover_tests(dorsum_${name}_test ${common} PROPERTIES TIMEOUT ${timeout} LABELS ${name})
  endif()
endfunction()

function(_dorsum_install_layer name headers)
  set_target_properties(dorsum_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS dorsum_${name} EXPORT DorsumTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES ${headers} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/dorsum/${name}")
  set_property(GLOBAL APPEND PROPERTY DORSUM_INSTALLED_LAYERS ${name})
endfunction()

function(dorsum_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "APPLICATION" "TEST_ALONE" "DEPENDS;LINK;LINK_PRIVATE;TEST_DEPENDS;TEST_LINK")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "dorsum_layer(${name}): what is '${arg_UNPARSED_ARGUMENTS}'?")
  endif()
  foreach(dependency IN LISTS arg_DEPENDS)
    _dorsum_check_dependency(${name} ${dependency})
  endforeach()
  foreach(library IN LISTS arg_LINK arg_LINK_PRIVATE)
    if(library MATCHES "^(dorsum_|Dorsum::)")
      message(FATAL_ERROR "dorsum_layer(${name}): list '${library}' under DEPENDS, where its order is checked")
    endif()
  endforeach()

  set(folder "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cc")
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cc$")
  list(FILTER sources EXCLUDE REGEX "_(test|main|benchmark)\\.cc$")
  file(GLOB headers CONFIGURE_DEPENDS "${folder}/*.h")
  list(FILTER headers EXCLUDE REGEX "_test[^/]*\\.h$")

  set(include_folder "${PROJECT_BINARY_DIR}/layers/${name}")
  file(MAKE_DIRECTORY "${include_folder}")
  file(CREATE_LINK "${folder}" "${include_folder}/${name}" SYMBOLIC)

  if(sources)
    add_library(dorsum_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(dorsum_${name} PRIVATE ${arg_LINK_PRIVATE})
  else()
    add_library(dorsum_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(Dorsum::${name} ALIAS dorsum_${name})
  target_compile_features(dorsum_${name} ${scope} cxx_std_20)
  target_include_directories(dorsum_${name} ${scope}
    "$<BUILD_INTERFACE:${include_folder}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/dorsum>")
  set(layers ${arg_DEPENDS})
  list(TRANSFORM layers PREPEND "dorsum_")
  target_link_libraries(dorsum_${name} ${scope} ${layers} ${arg_LINK})
  set_property(GLOBAL APPEND PROPERTY DORSUM_LAYERS ${name})

  if(NOT arg_APPLICATION)
    _dorsum_install_layer(${name} "${headers}")
  endif()
  if(DORSUM_TESTS AND tests)
    _dorsum_add_test(${name} ALONE "${arg_TEST_ALONE}"
      SOURCES ${tests} DEPENDS ${arg_TEST_DEPENDS} LINK ${arg_TEST_LINK})
  endif()
endfunction()

# dorsum_program(NAME LAYER layer [LINK target...]): the installed program NAME of NAME_main.cc in that layer's folder.
function(dorsum_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LAYER" "LINK")
  file(GLOB main CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}_main.cc")
  if(main)
    add_executable(${name} ${main})
    target_link_libraries(${name} PRIVATE Dorsum::${arg_LAYER} ${arg_LINK})
    install(TARGETS ${name} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  endif()
endfunction()
