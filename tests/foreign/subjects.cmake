# Subjects of another hand for laws that no shared library reaches; their own loops are most of the work.
if(NOT MMVERIFY_SANITIZE)
  file(GLOB foreign_inside CONFIGURE_DEPENDS foreign/inside_*.cpp)
  add_executable(foreign_inside_test foreign/foreign_inside_test.cpp ${foreign_inside})
  target_include_directories(foreign_inside_test PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(foreign_inside_test PRIVATE mmverify::proofs GTest::gmock GTest::gtest_main)
  target_compile_options(foreign_inside_test PRIVATE -O2)
  target_precompile_headers(foreign_inside_test PRIVATE <gtest/gtest.h> <spec/rational.hpp>
    <proofs/engine/law.hpp> <string> <vector>)
  mmverify_run_test(foreign_inside_test)
  target_compile_definitions(foreign_inside_test PRIVATE MMVERIFY_STATEMENTS="${PROJECT_SOURCE_DIR}/proofs/statements")
endif()

# Subjects of another hand: each right but for one fault, which the environment names.
if(NOT MMVERIFY_SANITIZE)
  mmverify_add_test(foreign_test mmverify::proofs)
  target_compile_definitions(foreign_test PRIVATE MMVERIFY_SUBJECTS="${subjects_dir}"
    MMVERIFY_WORKER_PROGRAM="$<TARGET_FILE:mmverify-worker>" MMVERIFY_SOUNDNESS="${PROJECT_SOURCE_DIR}/docs/SOUNDNESS.md")
  add_dependencies(foreign_test mmverify-worker)
  set(judged_by foreign_test)
  foreach(topic index micromap tree vq bake traverse)
    file(GLOB sources CONFIGURE_DEPENDS foreign/${topic}.cpp foreign/${topic}/*.cpp)
    mmverify_add_subject(foreign_${topic} "${sources}")
    mmverify_unite(subject_foreign_${topic})
  endforeach()
  # Attribute micromaps, in this program: no library can offer all that their laws ask.  Their own loops are the work.
  file(GLOB sources CONFIGURE_DEPENDS foreign/attribute/*.cpp)
  add_library(foreign_attribute STATIC ${sources})
  target_include_directories(foreign_attribute PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(foreign_attribute PUBLIC mmverify::proofs)
  target_compile_options(foreign_attribute PRIVATE -O2)
  target_link_libraries(foreign_test PRIVATE foreign_attribute)
endif()
