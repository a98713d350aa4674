# mmverify_opened(TARGET WORD IMPORTED): the headers of a shared library that the program opens where it is needed, and does
# not need to start.  The soname of the library that has these headers is MMVERIFY_WORD_SONAME.
function(mmverify_opened target word imported)
  get_target_property(configurations ${imported} IMPORTED_CONFIGURATIONS)
  list(GET configurations 0 configuration)
  get_target_property(soname ${imported} IMPORTED_SONAME_${configuration})
  add_library(${target} INTERFACE)
  target_include_directories(${target} SYSTEM INTERFACE $<TARGET_PROPERTY:${imported},INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_definitions(${target} INTERFACE MMVERIFY_${word}_SONAME="${soname}")
  target_link_libraries(${target} INTERFACE ${CMAKE_DL_LIBS})
endfunction()
