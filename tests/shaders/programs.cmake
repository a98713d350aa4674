# Shaders on a Vulkan device; where none is, skipped, and so said.
mmverify_add_test(shader_compile_test mmverify::shaders)
mmverify_add_test(shader_device_test)
mmverify_add_test(shader_bench_test nlohmann_json::nlohmann_json)
foreach(test shader_bench_test shader_compile_test shader_device_test)
  target_compile_definitions(${test} PRIVATE MMVERIFY_PROGRAM="$<TARGET_FILE:mmverify>" MMVERIFY_SUBJECTS="${subjects_dir}"
    MMVERIFY_ROOT="${PROJECT_SOURCE_DIR}" MMVERIFY_SCRIPTS="${PROJECT_SOURCE_DIR}/scripts"
    MMVERIFY_SHADER_SUBJECTS="${PROJECT_SOURCE_DIR}/subjects/shaders/subjects")
  add_dependencies(${test} mmverify mmverify-worker)
endforeach()
if(TEST shader_bench_test)
  set_tests_properties(shader_bench_test PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED.*times_each_kernel")
endif()
if(TEST shader_device_test)
  set_tests_properties(shader_device_test PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED.*our_index_is_proved")
endif()

if(TARGET mmverify-shaders)
  mmverify_add_test(shader_program_test mmverify::shaders mmverify::device mmverify::impl)
  target_compile_definitions(shader_program_test PRIVATE MMVERIFY_ROOT="${PROJECT_SOURCE_DIR}")
  if(TEST shader_program_test)
    set_tests_properties(shader_program_test PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED.*level_of_detail")
  endif()

  mmverify_add_test(shader_frame_test mmverify::shaders mmverify::device mmverify::scene_render)
  target_compile_definitions(shader_frame_test PRIVATE MMVERIFY_ROOT="${PROJECT_SOURCE_DIR}")
  if(TEST shader_frame_test)
    set_tests_properties(shader_frame_test PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED.*shades_every_hit")
  endif()

  # The figures of docs/SHADERS.md.
  add_executable(shader_figures EXCLUDE_FROM_ALL shaders/shader_figures.cpp)
  target_link_libraries(shader_figures PRIVATE mmverify::proofs mmverify::impl mmverify::shaders mmverify::device fmt::fmt)
  target_compile_definitions(shader_figures PRIVATE MMVERIFY_ROOT="${PROJECT_SOURCE_DIR}")
else()
  set_property(DIRECTORY APPEND PROPERTY tests_of_a_line shader_program_test shader_frame_test)
endif()
