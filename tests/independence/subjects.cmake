# Right functions for every entry point, in one library that leaves one field unread, or records what it is asked.
mmverify_add_part(right_batched subjects/batched.cpp mmverify_subject_v1=right_batched DECLARED=MMVERIFY_CORNERS_OF_CHILDREN)
mmverify_add_part(right_several subjects/several.cpp mmverify_subject_v1=right_several)
mmverify_add_part(right_c_face subjects/c_face.c mmverify_subject_v1=right_c_face)
set(judged_by subjects_tests)
mmverify_add_wrong(ignoring nothing right_batched right_several right_c_face right_tree right_vq right_attribute
  right_attribute_bake right_traverse right_array right_array_changes right_dag right_mesh right_subdivision mmverify::impl m)
target_sources(subject_ignoring PRIVATE independence/ignoring.cpp independence/measure.cpp independence/right.cpp)
target_compile_options(subject_ignoring PRIVATE -O2)

find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND AND NOT MMVERIFY_SANITIZE)
  # mmverify_add_ignored(NAME ARGUMENT...): no subject among them is proved.
  function(mmverify_add_ignored name)
    add_test(NAME ${name} COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/scripts/ignored-fields $<TARGET_FILE:mmverify>
      $<TARGET_FILE:subject_ignoring> ${ARGN})
  endfunction()
  # A part is of every change; the whole takes an hour, and the night has it.
  mmverify_add_ignored(ignored_fields_of_codes --only array_resolve/words\(1\)/b2/)
  mmverify_add_ignored(ignored_fields_of_changes --only array_compact/blob/bmid/ --ways rest)
endif()
