# What others build against: the library and the header of subjects, for find_package and pkg-config.
include(CMakePackageConfigHelpers)

# cmake --install names what is not built before they copy a file.
set(needed "")
foreach(target mmverify_impl mmverify mmverify-worker mmverify-shaders mmverify-source mmverify-codec)
  if(TARGET ${target})
    list(APPEND needed $<TARGET_FILE:${target}>)
  endif()
endforeach()
if(TARGET mmverify-described)
  list(APPEND needed ${PROJECT_BINARY_DIR}/cli/described/mmverify.1 ${PROJECT_BINARY_DIR}/docs/bench.schema.json)
endif()
list(JOIN needed "\" \"" needed)
install(CODE "
unset(missing)
foreach(file IN ITEMS \"${needed}\")
  if(NOT EXISTS \"\${file}\")
    string(APPEND missing \"\\n  \${file}\")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR \"mmverify is not built to be installed; build all of it first, by ./run build or cmake --build. Missing:\${missing}\")
endif()")

install(TARGETS mmverify_impl EXPORT mmverify ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
file(STRINGS cmake/public_headers.txt public_headers REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt)
# Installed as <mmverify/...>: what is impl/ here is mmverify/ there.
set(installed ${CMAKE_CURRENT_BINARY_DIR}/include)
foreach(header IN LISTS public_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
  file(READ ${header} text)
  string(REPLACE "#include \"impl/" "#include \"mmverify/" text "${text}")
  string(REGEX REPLACE "^impl/" "mmverify/" name ${header})
  file(CONFIGURE OUTPUT ${installed}/${name} CONTENT "${text}" @ONLY)
endforeach()
# Subjects include it by its own name, too.
configure_file(subjects/sdk/mmverify_subject.h ${installed}/mmverify/mmverify_subject.h COPYONLY)
file(CONFIGURE OUTPUT ${installed}/mmverify_subject.h CONTENT "#include \"mmverify/mmverify_subject.h\"\n")
install(DIRECTORY ${installed}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h PATTERN *.hpp)

# find_package(mmverify)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mmverify)
install(EXPORT mmverify NAMESPACE mmverify:: FILE mmverifyTargets.cmake DESTINATION ${package})
# The libraries that the C++ compiler links and the C compiler does not, for projects of language C.
set(cxx_runtime ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM cxx_runtime ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_DUPLICATES cxx_runtime)
set(has_program OFF)
if(TARGET mmverify)
  set(has_program ON)
endif()
configure_package_config_file(cmake/mmverifyConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_BINDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfigVersion.cmake
  cmake/mmverifyProof.cmake DESTINATION ${package})

# pkg-config mmverify
list(TRANSFORM cxx_runtime PREPEND -l REGEX "^[^-/]" OUTPUT_VARIABLE private_libraries)
list(JOIN private_libraries " " private_libraries)
file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/mmverify.pc.in ${CMAKE_CURRENT_BINARY_DIR}/mmverify.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mmverify.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
