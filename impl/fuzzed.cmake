# How files that a harness of fuzz/ calls all day are compiled for libFuzzer.  No harness calls what bakes attributes.
file(GLOB fuzzed CONFIGURE_DEPENDS */*.cpp attribute/compress/*.cpp bake/*/*.cpp vq/*/*.cpp)
list(FILTER fuzzed EXCLUDE REGEX "/attribute/[^/]*[.]cpp$")
list(APPEND fuzzed ${CMAKE_CURRENT_SOURCE_DIR}/attribute/container.cpp)
if(NOT MMVERIFY_ONLY_FUZZ AND NOT MMVERIFY_BRIEF)
  # clang inlines nothing at -O1.
  set(at_o2 ${fuzzed})
  list(FILTER at_o2 EXCLUDE REGEX "/sixteen[.]cpp$")
  set_property(SOURCE ${at_o2} APPEND PROPERTY COMPILE_OPTIONS -O2)
endif()
# The fuzzer takes the operands of comparisons into its inputs, which finds magic numbers, lengths and limits.  Files
# that read none of these would spend two thirds of their time on that.
list(FILTER fuzzed EXCLUDE REGEX "/container[.]cpp$|/compress/|/validate[.]cpp$|/stream[.]cpp$")
set_property(SOURCE ${fuzzed} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize-coverage=trace-cmp)
