# What others build against, and a Debian package of it: the program, the header of subjects, the library.
include(CMakePackageConfigHelpers)

install(TARGETS mmverify RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS mmverify-worker RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/mmverify)
if(TARGET mmverify-shaders)
  install(TARGETS mmverify-shaders LIBRARY DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/mmverify)
endif()
if(TARGET mmverify-source)
  install(TARGETS mmverify-source RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/mmverify)
endif()
if(TARGET mmverify-described)
  set(described ${PROJECT_BINARY_DIR}/cli/described)
  install(FILES ${described}/mmverify.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${described}/mmverify DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${described}/_mmverify DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${described}/mmverify.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()
install(DIRECTORY shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/mmverify FILES_MATCHING PATTERN *.glsl PATTERN *.rchit
  PATTERN compile EXCLUDE PATTERN device EXCLUDE PATTERN speed EXCLUDE)
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
configure_file(sdk/mmverify_subject.h ${installed}/mmverify/mmverify_subject.h COPYONLY)
file(CONFIGURE OUTPUT ${installed}/mmverify_subject.h CONTENT "#include \"mmverify/mmverify_subject.h\"\n")
install(DIRECTORY ${installed}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h PATTERN *.hpp)
file(GLOB documents CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md ${PROJECT_SOURCE_DIR}/docs/*.svg ${PROJECT_SOURCE_DIR}/docs/*.png)
install(FILES ${documents} docs/result.schema.json docs/bench.schema.json docs/validate.schema.json docs/array.schema.json LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY proofs/statements examples docs/ci DESTINATION ${CMAKE_INSTALL_DOCDIR})

# find_package(mmverify)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/mmverify)
install(EXPORT mmverify NAMESPACE mmverify:: FILE mmverifyTargets.cmake DESTINATION ${package})
configure_package_config_file(cmake/mmverifyConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_BINDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/mmverifyConfigVersion.cmake
  cmake/mmverifyProof.cmake DESTINATION ${package})

# pkg-config mmverify
file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/mmverify.pc.in ${CMAKE_CURRENT_BINARY_DIR}/mmverify.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mmverify.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# cpack -G DEB
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "the mmverify authors")
set(CPACK_PACKAGE_CONTACT "the mmverify authors <mmverify@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# To link the library, and to draw what bench --plot draws.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS libhwy-dev)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "astcenc, gnuplot-nox")
include(CPack)
